// Sections shared by the geometry tests.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "geometry/section.h"

namespace vbgpd::geometry_test {

inline SceneDef scene_of(Polygon exterior) {
  SceneDef scene;
  scene.exterior = std::move(exterior);
  scene.materials.resize(1);
  scene.materials[0].name = "soil";
  scene.layers = {{"soil", {}}};
  return scene;
}

inline void add_layer(SceneDef& scene, const std::string& material, Polygon polygon) {
  const auto same = [&](const MaterialDef& m) { return m.name == material; };
  if (std::none_of(scene.materials.begin(), scene.materials.end(), same)) {
    scene.materials.emplace_back();
    scene.materials.back().name = material;
  }
  scene.layers.push_back({material, std::move(polygon)});
}

/// Griffiths & Lane (1999), example 1: 2:1 slope, H = 10 m, base at the toe.
inline Polygon slope() { return {{0, 10}, {12, 10}, {32, 0}, {0, 0}}; }
/// The same on a foundation 5 m thick.
inline Polygon slope_on_foundation() { return {{0, 10}, {12, 10}, {32, 0}, {52, 0}, {52, -5}, {0, -5}}; }
/// Floor at y = 5 left of a vertical face 5 m high at x = 10.
inline Polygon vertical_cut() { return {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 5}, {0, 5}}; }
/// The face leans out over the floor.
inline Polygon overhang() { return {{0, 0}, {20, 0}, {20, 10}, {7.3, 10}, {10.1, 5.2}, {0, 5.2}}; }
/// Benches with a drain between them.
inline Polygon benches() {
  return {{0, 0},       {40, 0},    {40, 21}, {31, 20.3}, {24, 13.1}, {20.2, 12.9},
          {19.5, 11.2}, {18.7, 13}, {15, 13}, {8, 5.1},   {0, 4.7}};
}

inline Polygon moved(Polygon polygon, double dx, double dy) {
  for (Point& p : polygon) p = {p.x + dx, p.y + dy};
  return polygon;
}
inline Polygon mirrored(Polygon polygon) {
  for (Point& p : polygon) p.x = -p.x;
  return polygon;
}
inline Polygon scaled(Polygon polygon, double factor) {
  for (Point& p : polygon) p = {p.x * factor, p.y * factor};
  return polygon;
}
inline Polygon reversed(Polygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

using CellPair = std::tuple<Index, Index, Index, Index>;

/// The cut pairs by the lattice cells of both ends.
inline std::set<CellPair> cut_cells(const Section& section) {
  std::set<CellPair> result;
  for (const CutPair& pair : section.cut_pairs) {
    const Seed &a = section.seeds[pair.a], &b = section.seeds[pair.b];
    result.insert({a.ix, a.iy, b.ix, b.iy});
  }
  return result;
}

inline double soil_volume(const Section& section) {
  double sum = 0;
  for (const Seed& seed : section.seeds)
    if (seed.hold == Hold::kFree) sum += seed.volume;
  return sum;
}

inline Section cut(const SceneDef& scene, double spacing, int multiple = 1, int reach = 3) {
  return discretise(scene, fit_lattice(scene, spacing, multiple), reach, 0);
}

inline const Seed* seed_at(const Section& section, Index ix, Index iy) {
  for (const Seed& seed : section.seeds)
    if (seed.ix == ix && seed.iy == iy) return &seed;
  return nullptr;
}

inline long count(const Section& section, Hold hold) {
  return std::count_if(section.seeds.begin(), section.seeds.end(), [&](const Seed& s) { return s.hold == hold; });
}

}  // namespace vbgpd::geometry_test
