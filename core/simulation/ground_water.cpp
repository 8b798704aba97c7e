#include "simulation/ground_water.h"

#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "geometry/polygon.h"
#include "simulation/outside.h"

namespace vbgpd {

namespace {

Vec2 vector_of(const Point& p) { return {p.x, p.y}; }

Vec2 nearest_ground(const std::vector<Point>& ground, const Vec2& x) {
  Vec2 nearest = vector_of(ground.front());
  for (std::size_t k = 1; k < ground.size(); ++k) {
    const Vec2 candidate = nearest_on_segment(x, vector_of(ground[k - 1]), vector_of(ground[k]));
    if ((candidate - x).squaredNorm() < (nearest - x).squaredNorm()) nearest = candidate;
  }
  return nearest;
}

bool has_ratio(const SceneDef& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const MaterialDef& m) { return m.pore_pressure_ratio > 0; });
}

/// r_u times the weight of what lies above, for the cells of one column, which come from the bottom up.
void press_column(const SceneDef& scene, const Section& section, std::size_t first, std::size_t last,
                  std::vector<Real>& pressure) {
  Real above = 0;  // Pa
  for (std::size_t k = last; k-- > first;) {
    const Seed& seed = section.seeds[k];
    if (!seed.active) continue;
    const Real own = unit_weight_at(scene, seed.material, section.place(k)) * seed.volume / section.lattice.spacing.x();
    const Real ratio = scene.materials[static_cast<std::size_t>(seed.material)].pore_pressure_ratio;
    if (ratio > 0) pressure[k] = ratio * (above + own / 2);
    above += own;
  }
}

}  // namespace

Real water_level(const SceneDef& scene, Real x) {
  return scene.water_table.empty() ? -kInfinity : height_at(scene.water_table, x);
}

Real unit_weight_at(const SceneDef& scene, Index material, const Vec2& place) {
  const MaterialDef& m = scene.materials[static_cast<std::size_t>(material)];
  const bool wet = !std::isnan(m.saturated_unit_weight) && place.y() < water_level(scene, place.x());
  return wet ? m.saturated_unit_weight : m.unit_weight;
}

bool water_stands(const SceneDef& scene, const Section& section) {
  const std::vector<Point>& ground = section.ground;
  if (scene.water_table.empty() || ground.size() < 2) return false;
  const Real slack = 1e-6 * section.height;  // a table drawn along the ground does not stand on it
  const auto covers = [&](const Point& p) { return water_level(scene, p.x) > p.y + slack; };
  if (std::any_of(ground.begin(), ground.end(), covers)) return true;
  return std::any_of(scene.water_table.begin(), scene.water_table.end(), [&](const Point& w) {
    for (std::size_t k = 1; k < ground.size(); ++k) {
      const Point &a = ground[k - 1], &b = ground[k];
      if (a.x < w.x && w.x < b.x && w.y > a.y + (b.y - a.y) * (w.x - a.x) / (b.x - a.x) + slack) return true;
    }
    return false;
  });
}

bool has_ground_water(const SceneDef& scene) { return !scene.water_table.empty() || has_ratio(scene); }

std::vector<double> scene_pore_pressure(const SceneDef& scene, const Section& section) {
  if (!has_ground_water(scene)) return {};
  const std::vector<Seed>& seeds = section.seeds;
  std::vector<Real> pressure(seeds.size(), 0);
  for (std::size_t k = 0; k < seeds.size() && !scene.water_table.empty(); ++k) {
    const Vec2 place = section.place(k);
    pressure[k] = scene.water_unit_weight * std::max<Real>(0, water_level(scene, place.x()) - place.y());
  }
  for (std::size_t first = 0; first < seeds.size() && has_ratio(scene);) {
    std::size_t last = first;
    while (last < seeds.size() && seeds[last].ix == seeds[first].ix) ++last;
    press_column(scene, section, first, last, pressure);
    first = last;
  }
  std::vector<double> rows;  // particle ids count the soil first, then the walls
  for (const bool soil : {true, false})
    for (std::size_t k = 0; k < seeds.size(); ++k)
      if ((seeds[k].hold == Hold::kFree) == soil) rows.push_back(pressure[k]);
  return rows;
}

StandingWater::StandingWater(const SceneDef& scene, const Section& section, const Model& m) {
  if (!water_stands(scene, section)) return;
  // what a pressure of 1 everywhere pushes a particle by is its surface, outwards
  Array one;
  const auto n = static_cast<std::size_t>(m.storage);
  one.allocate(n, 4, m.heap), x.allocate(n, 5, m.heap), y.allocate(n, 6, m.heap);
  for (std::size_t i = 0; i < n; ++i) one[i] = m.seed_of[i] >= 0 ? 1 : 0;
  for_each_flux_force(m, PoreFlux(m, one).nodal(),
                      [&](std::size_t i, std::size_t, const Vec2& force) { x[i] += force.x(), y[i] += force.y(); });
  const Real least = 1e-9 * section.lattice.spacing.maxCoeff();
  for (std::size_t i = 0; i < n; ++i) {
    Real pressure = 0;
    if (m.seed_of[i] >= 0 && std::hypot(x[i], y[i]) > least) {
      const Vec2 ground = nearest_ground(section.ground, section.place(static_cast<std::size_t>(m.seed_of[i])));
      pressure = scene.water_unit_weight * std::max<Real>(0, water_level(scene, ground.x()) - ground.y());
    }
    x[i] *= -pressure, y[i] *= -pressure;
  }
}

}  // namespace vbgpd
