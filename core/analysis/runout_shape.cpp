#include "analysis/runout_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "geometry/outline.h"

namespace vbgpd {

namespace {

constexpr Real kLink = 1.6;  // spacings: particles nearer than that hang together
constexpr Real kNear = 1.5;  // spacings: what counts as at the toe, at the crest, at the end of the section
constexpr Real kPit = 2.5;   // spacings: columns that are neighbours, or have one empty between them

struct Soil {
  std::vector<double> now, before, volume, plastic;  ///< of the soil particles
  Real spacing = 0;
  std::size_t size() const { return volume.size(); }
  Vec2 position(std::size_t i) const { return {now[2 * i], now[2 * i + 1]}; }
  Vec2 start(std::size_t i) const { return {before[2 * i], before[2 * i + 1]}; }
  Vec2 way(std::size_t i) const { return position(i) - start(i); }
};

Soil soil_of(const Simulation& simulation) {
  Soil soil;
  const auto read = [&](const char* name, std::vector<double>& values) { simulation.read(find_field(name), values); };
  std::vector<double> boundary;
  read("position", soil.now), read("reference_position", soil.before), read("volume", soil.volume);
  read("plastic_strain", soil.plastic), read("boundary", boundary);
  const auto n = static_cast<std::size_t>(std::count(boundary.begin(), boundary.end(), -1));  // soil comes first
  soil.now.resize(2 * n), soil.before.resize(2 * n), soil.volume.resize(n), soil.plastic.resize(n);
  soil.spacing = std::sqrt(simulation.section().lattice.spacing.prod());
  return soil;
}

/// For every particle whether it belongs to the largest mass that hangs together.
std::vector<bool> largest_mass(const Soil& soil) {
  const Real reach = kLink * soil.spacing;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells;
  const auto cell = [&](std::size_t i) {
    const Vec2 c = soil.position(i) / reach;
    return std::pair(static_cast<std::int64_t>(std::floor(c.x())), static_cast<std::int64_t>(std::floor(c.y())));
  };
  for (std::size_t i = 0; i < soil.size(); ++i) cells[cell(i)].push_back(i);
  std::vector<std::size_t> mass_of(soil.size(), 0), count{0}, open;
  for (std::size_t seed = 0; seed < soil.size(); ++seed) {
    if (mass_of[seed] != 0) continue;
    const std::size_t mass = count.size();
    count.push_back(0);
    mass_of[seed] = mass, open.push_back(seed);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      ++count[mass];
      const auto [cx, cy] = cell(i);
      for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          const auto found = cells.find({cx + dx, cy + dy});
          if (found == cells.end()) continue;
          for (const std::size_t j : found->second)
            if (mass_of[j] == 0 && (soil.position(j) - soil.position(i)).norm() < reach)
              mass_of[j] = mass, open.push_back(j);
        }
    }
  }
  const auto largest = static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin());
  std::vector<bool> inside(soil.size());
  for (std::size_t i = 0; i < soil.size(); ++i) inside[i] = mass_of[i] == largest;
  return inside;
}

/// The free outline from the highest ground to one side: way 1 to the right, -1 to the left, down a free face too.
std::vector<Vec2> free_outline(const Section& section, const SceneDef& scene, int way) {
  const Vec2 origin = section.lattice.origin;
  const Vertices whole = local(counter_clockwise(scene.exterior), origin);
  const Vertices outline = local(counter_clockwise(section.exterior), origin);
  const std::vector<HeldEdge> held = held_edges(section.boundaries, whole, origin);
  const Real same = 1e-9 * box_of(whole).extent();
  const auto is_held = [&](const Vec2& a, const Vec2& b) {
    return std::any_of(held.begin(), held.end(),
                       [&](const HeldEdge& e) { return distance_to_segment((a + b) / 2, e.a, e.b) <= same; });
  };
  const std::size_t n = outline.size();
  std::size_t at = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const Real higher = outline[k].y() - outline[at].y();
    if (higher > same || (higher >= -same && way * (outline[k].x() - outline[at].x()) > 0)) at = k;
  }
  std::vector<Vec2> line{outline[at] + origin};
  for (std::size_t steps = 1; steps < n; ++steps) {
    const std::size_t next = way > 0 ? (at + n - 1) % n : (at + 1) % n;
    if (is_held(outline[at], outline[next])) break;
    line.push_back(outline[next] + origin);
    at = next;
  }
  return line;
}

/// Where an upright wall ends the section on that side, m; NaN without one.
Real wall_at_end(const Section& section, const SceneDef& scene, int way) {
  const Vec2 origin = section.lattice.origin;
  const Vertices outline = local(counter_clockwise(scene.exterior), origin);
  const Box box = box_of(outline);
  const Real end = way > 0 ? box.high.x() : box.low.x(), same = 1e-9 * box.extent();
  for (const HeldEdge& e : held_edges(section.boundaries, outline, origin))
    if (std::fabs(e.a.x() - end) <= same && std::fabs(e.b.x() - end) <= same) return end + origin.x();
  return kNone;
}

/// The foot of the slope: the point farthest below the straight line from the highest ground to the end of the free
/// outline; that end where none is below it.
Vec2 toe_of(const std::vector<Vec2>& line, int way) {
  const Vec2 chord = line.back() - line.front();
  Vec2 toe = line.back();
  Real deepest = 1e-9 * chord.squaredNorm();
  for (const Vec2& p : line) {
    const Real below = -way * cross(chord, p - line.front());
    if (below > deepest) deepest = below, toe = p;
  }
  return toe;
}

}  // namespace

RunoutShape runout_shape(const Simulation& simulation) {
  const Soil soil = soil_of(simulation);
  const Section& section = simulation.section();
  Real top = -std::numeric_limits<Real>::infinity();
  for (const Point& p : section.ground) top = std::max(top, p.y);
  const std::vector<bool> inside = largest_mass(soil);
  const auto moved = [&](std::size_t i) { return soil.way(i).norm() >= soil.spacing; };
  RunoutShape shape;
  Real total = 0;
  for (std::size_t i = 0; i < soil.size(); ++i) {
    total += soil.volume[i];
    if (soil.plastic[i] > 0) shape.plastic_fraction += soil.volume[i];
    if (top - soil.start(i).y() < kNear * soil.spacing)
      shape.crest_settlement = std::max(shape.crest_settlement, -soil.way(i).y());
    if (moved(i)) shape.moved_area += soil.volume[i];
  }
  if (total > 0) shape.plastic_fraction /= total;
  Real lowest = std::numeric_limits<Real>::infinity();
  for (const int way : {1, -1}) {
    const Vec2 toe = toe_of(free_outline(section, simulation.scene(), way), way);
    Real at_toe = 0, front = 0;
    for (std::size_t i = 0; i < soil.size(); ++i) {
      if ((soil.start(i) - toe).norm() < kNear * soil.spacing) at_toe = std::max(at_toe, soil.way(i).norm());
      const bool behind = way * (soil.start(i).x() - toe.x()) < soil.spacing / 2;
      if (inside[i] && moved(i) && behind && way * soil.way(i).x() > 0)
        front = std::max(front, way * (soil.position(i).x() - toe.x()) + soil.spacing / 2);
    }
    const bool farther = front > shape.runout_distance;
    if (!farther && (front < shape.runout_distance || toe.y() >= lowest)) continue;
    lowest = toe.y(), shape.toe_displacement = at_toe, shape.runout_distance = front;
    const Real end = wall_at_end(section, simulation.scene(), way);
    shape.stopped_at = front > 0 && way * (end - toe.x()) - front < kNear * soil.spacing ? end : kNone;
  }
  return shape;
}

std::vector<Point> ground_surface(const Simulation& simulation) {
  const Soil soil = soil_of(simulation);
  const std::vector<bool> inside = largest_mass(soil);
  std::map<std::int64_t, Real> columns;
  const Real origin = simulation.section().lattice.origin.x();
  for (std::size_t i = 0; i < soil.size(); ++i) {
    if (!inside[i]) continue;
    const Vec2 p = soil.position(i);
    const auto column = static_cast<std::int64_t>(std::floor((p.x() - origin) / soil.spacing));
    const Real y = p.y() + soil.spacing / 2;
    const auto [at, fresh] = columns.try_emplace(column, y);
    if (!fresh) at->second = std::max(at->second, y);
  }
  std::vector<Point> line;
  for (const auto& [column, y] : columns)
    line.push_back({origin + (static_cast<Real>(column) + 0.5) * soil.spacing, y});
  // stretched soil misses columns: a pit no wider than the particles are apart is none
  std::vector<Point> filled = line;
  const auto joined = [&](std::size_t k) { return line[k + 1].x - line[k].x < kPit * soil.spacing; };
  for (std::size_t k = 1; k + 1 < line.size(); ++k)
    if (joined(k - 1) && joined(k)) filled[k].y = std::max(line[k].y, std::min(line[k - 1].y, line[k + 1].y));
  return filled;
}

}  // namespace vbgpd
