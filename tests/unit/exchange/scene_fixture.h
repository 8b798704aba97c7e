// A scene that uses every field, and files, for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

inline SceneDef full_scene() {
  SceneDef scene;
  scene.name = "every field";
  scene.source = "B\xC3\xB6schung 7";  // UTF-8
  scene.exterior = {{500000.25, 5.8e6}, {500032, 5.8e6}, {500012, 5800010}, {500000.25, 5800010}};
  MaterialDef sand{.name = "sand", .unit_weight = 19500, .saturated_unit_weight = 20500, .young_modulus = 3e7};
  sand.poisson_ratio = 0.25, sand.cohesion = 0, sand.friction_angle = 38, sand.dilatancy_angle = 8;
  sand.tension_cutoff = 0;
  MaterialDef clay{.name = "soft clay", .law = "undrained", .unit_weight = 16000, .pore_pressure_ratio = 0.35};
  clay.young_modulus = 5e6, clay.poisson_ratio = 0.49, clay.cohesion = 15000;
  clay.cohesion_gradient = 3750, clay.cohesion_datum = 4;
  scene.materials = {sand, clay};
  scene.layers = {{"soft clay", {}}, {"sand", {{500000, 5800005}, {500040, 5800005}, {500000, 5800020}}}};
  scene.boundaries = {{"floor", "base", {}, BoundaryKind::kFixed, 0, 0, 24},
                      {"", "left", {}, BoundaryKind::kRoller, 0, 0},
                      {"wall", "", {{1, 2}, {3, 4}, {5, 6}}, BoundaryKind::kVelocity, 0.5, -0.25},
                      {"", "right", {}, BoundaryKind::kFree, 0, 0}};
  scene.water_table = {{500000, 5800002}, {500040, 5800003}}, scene.water_unit_weight = 10000;
  scene.loads = {{500000, 500006, 20000, 40000}, {500007, 500008, 10000, 10000}};
  scene.kh = -0.15, scene.kv = 0.05, scene.gravity = 9.80665, scene.spacing = 0.5;
  scene.bond = "none", scene.kernel = "cubic_spline", scene.smoothing_ratio = 1.5, scene.jitter = 0.2;
  scene.strength_reduction = {0.25, 8, 0.001};
  scene.published = {{"Bishop", "a paper", 1.4, kNone}, {"band", "two papers", 1.3, 1.5}};
  return scene;
}

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Names of the JSON files of a folder without the ".json", sorted.
inline std::vector<std::string> scene_names(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace vbgpd
