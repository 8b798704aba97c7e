#include "simulation/surface_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace vbgpd {

std::vector<Real> normal_areas(const Model& m) {
  std::vector<Real> area(static_cast<std::size_t>(m.storage), 0);
  for (const Block& block : m.blocks)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(block.first + l);
      if (m.seed_of[i] < 0) continue;
      for (std::int32_t k = block.neighbours_begin; k < block.neighbours_end; ++k) {
        const NeighbourPack& p = m.neighbours[static_cast<std::size_t>(k)];
        const auto j = static_cast<std::size_t>(p.j + l);
        if (((p.lanes >> l) & 1) == 0 || m.seed_of[j] < 0) continue;
        const Offset o = m.offset(k, block, l);
        const Real sum_xy = m.moment_xy[i] + m.moment_xy[j], sum_yy = m.moment_yy[i] + m.moment_yy[j];
        area[i] -= o.weight * m.volume[i] * m.volume[j] * (sum_xy * o.xi_x + sum_yy * o.xi_y);
      }
    }
  return area;
}

namespace {

/// Elevation of the ground at x.
Real ground_level(const std::vector<Point>& ground, Real x) {
  for (std::size_t k = 1; k < ground.size(); ++k) {
    const Point &a = ground[k - 1], &b = ground[k];
    if (x > b.x && k + 1 < ground.size()) continue;
    if (b.x <= a.x) return std::max(a.y, b.y);
    return a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0);
  }
  return ground.empty() ? 0 : ground.front().y;
}

/// A roller at the side is a mirror: what loads the soil loads its image. Without that the wall particles, which slide
/// with the soil, would carry part of a load that reaches the side.
void load_images(const Section& section, const std::vector<Real>& on_soil,
                 const std::function<void(std::size_t, Real)>& push) {
  std::map<std::pair<Index, Index>, std::size_t> soil;
  Index low = std::numeric_limits<Index>::max(), high = std::numeric_limits<Index>::min();
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (seed.hold == Hold::kFree && seed.active)
      soil[{seed.ix, seed.iy}] = k, low = std::min(low, seed.ix), high = std::max(high, seed.ix);
  }
  constexpr Real kUpright = 1 - 1e-9;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& wall = section.seeds[k];
    if (wall.hold != Hold::kRoller || std::fabs(wall.normal.x()) < kUpright) continue;
    const Index inward = wall.normal.x() > 0 ? -1 : 1;
    Index first = wall.ix + inward;
    while ((inward > 0 ? first <= high : first >= low) && soil.count({first, wall.iy}) == 0) first += inward;
    const auto image = soil.find({2 * first - inward - wall.ix, wall.iy});
    if (image != soil.end() && on_soil[image->second] != 0) push(k, on_soil[image->second]);
  }
}

}  // namespace

void spread_surface_loads(const std::vector<LoadDef>& loads, const Section& section, Real smoothing_ratio,
                          const std::function<Real(std::size_t)>& area,
                          const std::function<void(std::size_t, Real)>& push) {
  const Real dx = section.lattice.spacing.x(), dy = section.lattice.spacing.y();
  const bool whole =
      std::all_of(section.seeds.begin(), section.seeds.end(), [](const Seed& seed) { return seed.active; });
  const Real depth = (2 * smoothing_ratio + 0.9) * dy;  // the rows whose support can miss a part
  for (const LoadDef& load : loads) {
    const Real end = std::isnan(load.pressure_end) ? load.pressure : load.pressure_end;
    const auto pressure = [&](Real x) {
      return load.pressure + (end - load.pressure) * std::clamp((x - load.x0) / (load.x1 - load.x0), 0.0, 1.0);
    };
    std::vector<std::pair<std::size_t, Real>> shares;
    std::set<Index> columns;
    Real total = 0, carried = 0, covered = 0, met = 0;
    for (std::size_t k = 0; k < section.seeds.size(); ++k) {
      const Seed& seed = section.seeds[k];
      if (seed.hold != Hold::kFree || !seed.active) continue;
      const Vec2 center = section.lattice.center(seed.ix, seed.iy);
      const Real left = std::max(center.x() - dx / 2, load.x0), right = std::min(center.x() + dx / 2, load.x1);
      if (right <= left || ground_level(section.ground, center.x()) - center.y() > depth) continue;
      const Real mean = pressure((left + right) / 2);
      const Real f = mean * area(k) * (right - left) / dx;
      if (columns.insert(seed.ix).second) carried += mean * (right - left), covered += right - left;
      met += area(k) * (right - left) / dx;
      shares.emplace_back(k, f);
      total += f;
    }
    // where soil was taken away down to the base there is nothing left to stand on
    const Real asked = whole ? (load.pressure + end) / 2 * (load.x1 - load.x0) : carried;
    // pressures of both signs may add up to nothing: then the widths tell what the discrete surface is off by
    const bool one_sign = load.pressure * end >= 0;
    if ((one_sign ? total : met) == 0) continue;
    const Real factor = one_sign ? asked / total : covered / met;
    for (const auto& [k, f] : shares) push(k, -(f * factor));
  }
}

void add_surface_loads(const std::vector<LoadDef>& loads, const Section& section, Real smoothing_ratio, Model& m) {
  if (loads.empty()) return;
  const std::vector<Real> area = normal_areas(m);
  const auto place = [&](std::size_t seed) { return static_cast<std::size_t>(m.storage_of[seed]); };
  std::vector<Real> on_soil(section.seeds.size(), 0);
  spread_surface_loads(
      loads, section, smoothing_ratio, [&](std::size_t seed) { return area[place(seed)]; },
      [&](std::size_t seed, Real force) { on_soil[seed] += force; });
  for (std::size_t k = 0; k < on_soil.size(); ++k)
    if (on_soil[k] != 0) m.force_y[place(k)] += on_soil[k];
  load_images(section, on_soil, [&](std::size_t wall, Real force) { m.force_y[place(wall)] += force; });
}

}  // namespace vbgpd
