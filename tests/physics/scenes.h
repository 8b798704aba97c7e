// Small scenes for the tests of physics.
#pragma once

#include "scene/scene_def.h"

namespace vbgpd::test {

inline MaterialDef soil(const std::string& law, double cohesion, double friction, double dilatancy = 0) {
  MaterialDef m;
  m.name = "soil", m.law = law, m.unit_weight = 20e3, m.young_modulus = 1e8, m.poisson_ratio = 0.3;
  m.cohesion = cohesion, m.friction_angle = friction, m.dilatancy_angle = dilatancy;
  return m;
}

inline SceneDef slope(const MaterialDef& material, double spacing) {
  SceneDef s;
  s.name = "slope";
  s.exterior = {{0, 0}, {32, 0}, {12, 10}, {0, 10}};
  s.materials = {material};
  s.layers = {{material.name, {}}};
  BoundaryDef base, left;
  base.side = "base", left.side = "left", left.kind = BoundaryKind::kRoller;
  s.boundaries = {base, left};
  s.spacing = spacing;
  return s;
}

inline SceneDef block(const MaterialDef& material, double width, double height, double spacing) {
  SceneDef s = slope(material, spacing);
  s.name = "block";
  s.exterior = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  BoundaryDef right = s.boundaries[1];
  right.side = "right";
  s.boundaries.push_back(right);
  return s;
}

}  // namespace vbgpd::test
