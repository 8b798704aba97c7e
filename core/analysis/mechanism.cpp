#include "analysis/mechanism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "analysis/cell_grid.h"
#include "geometry/outline.h"
#include "geometry/polygon.h"

namespace vbgpd {

namespace {

std::vector<double> shearing(const Instant& before, const Instant& after) {
  std::vector<double> out(after.plastic_strain.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::max(0.0, after.plastic_strain[i] - before.plastic_strain[i]);
  return out;
}

/// One component of the displacement between two instants, by id.
std::vector<double> moved_along(int axis, const Instant& before, const Instant& after) {
  std::vector<double> out(after.plastic_strain.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t k = 2 * i + static_cast<std::size_t>(axis);
    out[i] = after.displacement[k] - before.displacement[k];
  }
  return out;
}

/// The value that a share of the soil cells stays below.
double quantile(const CellGrid& grid, double share) {
  std::vector<double> soil;
  for (double v : grid.values())
    if (v == v) soil.push_back(v);
  if (soil.empty()) return 0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(soil.size() - 1));
  std::nth_element(soil.begin(), soil.begin() + k, soil.end());
  return soil[static_cast<std::size_t>(k)];
}

/// Cells of the component that holds (i, j), among those with a value of at least `least`; marks them in `seen`.
std::vector<std::pair<Index, Index>> component(const CellGrid& grid, double least, Index i, Index j,
                                               std::vector<bool>& seen) {
  std::vector<std::pair<Index, Index>> cells{{i, j}};
  const auto key = [&](Index a, Index b) {
    return static_cast<std::size_t>(b) * static_cast<std::size_t>(grid.width()) + static_cast<std::size_t>(a);
  };
  seen[key(i, j)] = true;
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (Index a = cells[k].first - 1; a <= cells[k].first + 1; ++a)
      for (Index b = cells[k].second - 1; b <= cells[k].second + 1; ++b)
        if (grid.soil(a, b) && !seen[key(a, b)] && grid.at(a, b) >= least)
          seen[key(a, b)] = true, cells.emplace_back(a, b);
  return cells;
}

bool on_outline(const CellGrid& grid, Index i, Index j) {
  return !grid.soil(i - 1, j) || !grid.soil(i + 1, j) || !grid.soil(i, j - 1) || !grid.soil(i, j + 1);
}

/// The largest connected set of cells that move at least half as much as the mass does.
std::vector<bool> moving_mass(const CellGrid& grid, double least) {
  std::vector<bool> seen(grid.values().size(), false), best(seen.size(), false);
  std::size_t most = 0;
  for (Index j = 0; j < grid.height(); ++j)
    for (Index i = 0; i < grid.width(); ++i) {
      const auto key =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width()) + static_cast<std::size_t>(i);
      if (!grid.soil(i, j) || seen[key] || grid.at(i, j) < least) continue;
      const auto cells = component(grid, least, i, j, seen);
      if (cells.size() <= most) continue;
      most = cells.size();
      std::fill(best.begin(), best.end(), false);
      for (auto [a, b] : cells)
        best[static_cast<std::size_t>(b) * static_cast<std::size_t>(grid.width()) + static_cast<std::size_t>(a)] = true;
    }
  return best;
}

/// Which of two slides moves more, -1 the left one or 1 the right one, where soil that moves at least `least` slides
/// down to both sides; 0 where there are no two. Soil pressed apart, as below a footing, rises on its way to a side.
int side_of_slide(const CellGrid& moved, const CellGrid& right, const CellGrid& up, double least) {
  constexpr double kNoSlide = 0.2, kAlike = 0.02;  // of the larger one
  double way[2] = {0, 0}, rise[2] = {0, 0};        // to the left, to the right
  for (std::size_t k = 0; k < moved.values().size(); ++k) {
    if (!(moved.values()[k] >= least)) continue;
    const double u = right.values()[k];
    way[u > 0] += std::fabs(u), rise[u > 0] += std::fabs(u) * up.values()[k];
  }
  if (std::min(way[0], way[1]) < kNoSlide * std::max(way[0], way[1]) || rise[0] >= 0 || rise[1] >= 0) return 0;
  return way[1] > (1 + kAlike) * way[0] ? 1 : -1;
}

/// Polylines of the level set value = level by marching squares through the cell centres; only squares wholly of soil.
std::vector<std::vector<Vec2>> contour(const CellGrid& grid, double level) {
  struct Piece {
    std::array<Index, 3> from, to;  // lattice edges: cell and direction
    Vec2 a, b;
  };
  std::vector<Piece> pieces;
  const auto crossing = [&](Index i, Index j, Index k, Index l) {
    const double t = (level - grid.at(i, j)) / (grid.at(k, l) - grid.at(i, j));
    return Vec2(grid.center(i, j) + t * (grid.center(k, l) - grid.center(i, j)));
  };
  for (Index j = 0; j + 1 < grid.height(); ++j)
    for (Index i = 0; i + 1 < grid.width(); ++i) {
      if (!grid.soil(i, j) || !grid.soil(i + 1, j) || !grid.soil(i, j + 1) || !grid.soil(i + 1, j + 1)) continue;
      std::vector<std::pair<std::array<Index, 3>, Vec2>> cuts;
      const auto look = [&](Index a, Index b, Index c, Index d, std::array<Index, 3> edge) {
        if ((grid.at(a, b) >= level) != (grid.at(c, d) >= level)) cuts.emplace_back(edge, crossing(a, b, c, d));
      };
      look(i, j, i + 1, j, {i, j, 0}), look(i + 1, j, i + 1, j + 1, {i + 1, j, 1});
      look(i, j + 1, i + 1, j + 1, {i, j + 1, 0}), look(i, j, i, j + 1, {i, j, 1});
      for (std::size_t k = 0; k + 1 < cuts.size(); k += 2)
        pieces.push_back({cuts[k].first, cuts[k + 1].first, cuts[k].second, cuts[k + 1].second});
    }
  // join pieces that share an edge
  std::map<std::array<Index, 3>, std::vector<std::size_t>> ends;
  for (std::size_t p = 0; p < pieces.size(); ++p) ends[pieces[p].from].push_back(p), ends[pieces[p].to].push_back(p);
  std::vector<bool> used(pieces.size(), false);
  std::vector<std::vector<Vec2>> lines;
  const auto follow = [&](std::size_t p, std::array<Index, 3> at, std::vector<Vec2>& line) {
    for (;;) {
      const auto& candidates = ends[at];
      const auto next = std::find_if(candidates.begin(), candidates.end(), [&](std::size_t q) { return !used[q]; });
      if (next == candidates.end()) return;
      p = *next;
      used[p] = true;
      const bool forward = pieces[p].from == at;
      line.push_back(forward ? pieces[p].b : pieces[p].a);
      at = forward ? pieces[p].to : pieces[p].from;
    }
  };
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (used[p]) continue;
    used[p] = true;
    std::vector<Vec2> ahead{pieces[p].b}, behind{pieces[p].a};
    follow(p, pieces[p].to, ahead);
    follow(p, pieces[p].from, behind);
    std::reverse(behind.begin(), behind.end());
    behind.insert(behind.end(), ahead.begin(), ahead.end());
    lines.push_back(std::move(behind));
  }
  return lines;
}

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += (line[k] - line[k - 1]).norm();
  return sum;
}

/// Points at equal distances along a line.
std::vector<Vec2> resampled(const std::vector<Vec2>& line, double step) {
  const double total = length_of(line);
  const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(total / step)) + 1);
  std::vector<Vec2> out{line.front()};
  std::size_t k = 1;
  double passed = 0;
  for (std::size_t n = 1; n + 1 < count; ++n) {
    const double target = total * static_cast<double>(n) / static_cast<double>(count - 1);
    while (k + 1 < line.size() && passed + (line[k] - line[k - 1]).norm() < target)
      passed += (line[k] - line[k - 1]).norm(), ++k;
    const double piece = (line[k] - line[k - 1]).norm();
    out.push_back(piece > 0 ? Vec2(line[k - 1] + (target - passed) / piece * (line[k] - line[k - 1])) : line[k]);
  }
  out.push_back(line.back());
  return out;
}

/// The edge of the mass from one side to the other. Where the mass slides on a held base its edge is in pieces: those
/// that follow one another from left to right are joined along the base; specks are left out.
std::vector<Vec2> main_line(std::vector<std::vector<Vec2>> pieces) {
  double longest = 0;
  for (const auto& piece : pieces) longest = std::max(longest, length_of(piece));
  std::erase_if(pieces, [&](const auto& piece) { return length_of(piece) < 0.2 * longest; });
  for (auto& piece : pieces)
    if (piece.front().x() > piece.back().x()) std::reverse(piece.begin(), piece.end());
  const auto principal = std::max_element(pieces.begin(), pieces.end(),
                                          [](const auto& a, const auto& b) { return length_of(a) < length_of(b); });
  if (principal == pieces.end()) return {};
  std::vector<Vec2> line = *principal;
  for (bool grown = true; grown;) {
    grown = false;
    for (auto& piece : pieces) {
      if (piece.empty()) continue;
      if (piece.front().x() > line.back().x()) line.insert(line.end(), piece.begin(), piece.end()), grown = true;
      else if (piece.back().x() < line.front().x()) line.insert(line.begin(), piece.begin(), piece.end()), grown = true;
      else continue;
      piece.clear();
    }
  }
  return line;
}

/// Binomial smoothing with the ends kept.
void smooth(std::vector<Vec2>& line, int times) {
  for (int t = 0; t < times; ++t) {
    const std::vector<Vec2> old = line;
    for (std::size_t k = 1; k + 1 < line.size(); ++k) line[k] = 0.25 * old[k - 1] + 0.5 * old[k] + 0.25 * old[k + 1];
  }
}

/// Value between cell centres; 0 outside the soil.
double sampled(const CellGrid& grid, const Vec2& x) {
  const Vec2 corner = grid.center(0, 0), d = grid.lattice().spacing;
  const double a = (x.x() - corner.x()) / d.x(), b = (x.y() - corner.y()) / d.y();
  const auto i = static_cast<Index>(std::floor(a)), j = static_cast<Index>(std::floor(b));
  double sum = 0;
  for (Index p = 0; p < 2; ++p)
    for (Index q = 0; q < 2; ++q)
      if (grid.soil(i + p, j + q)) sum += grid.at(i + p, j + q) * (p ? a - i : 1 - (a - i)) * (q ? b - j : 1 - (b - j));
  return sum;
}

/// Each point to the centre of the shear band across the line, as far as neither side is above the ground: looked at
/// on one side only, the band would seem to lie there.
void draw_to_band(std::vector<Vec2>& line, const CellGrid& rate, const std::vector<Point>& ground, double reach) {
  const std::vector<Vec2> old = line;
  const auto above = [&](const Vec2& x) { return x.y() > height_at(ground, x.x()); };
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vec2 along = (old[std::min(k + 1, old.size() - 1)] - old[k > 0 ? k - 1 : 0]).normalized();
    const Vec2 across(-along.y(), along.x());
    double weight = sampled(rate, old[k]), moment = 0;
    constexpr int kSamples = 12;
    for (int n = 1; n <= kSamples; ++n) {
      const double t = reach * n / kSamples;
      const Vec2 left = old[k] + t * across, right = old[k] - t * across;
      if (above(left) || above(right)) break;
      const double l = sampled(rate, left), r = sampled(rate, right);
      weight += l + r, moment += (l - r) * t;
    }
    if (weight > 0) line[k] += moment / weight * across;
  }
}

/// Where a ray first meets the exterior.
struct Hit {
  double way = INFINITY;  ///< as a multiple of the direction; infinity when it does not meet it
  bool level = false;     ///< on a piece of it that rises or falls by less than one in ten
};
Hit first_hit(const Polygon& exterior, const Vec2& from, const Vec2& direction) {
  Hit nearest;
  for (std::size_t k = 0; k < exterior.size(); ++k) {
    const Point &p = exterior[k], &q = exterior[(k + 1) % exterior.size()];
    const Vec2 a(p.x, p.y), e = Vec2(q.x, q.y) - a, d = a - from;
    const double det = direction.y() * e.x() - direction.x() * e.y();
    if (det == 0) continue;
    const double t = (d.y() * e.x() - d.x() * e.y()) / det, s = (direction.x() * d.y() - direction.y() * d.x()) / det;
    if (t >= 0 && t < nearest.way && s >= -1e-9 && s <= 1 + 1e-9)
      nearest = {t, std::fabs(e.y()) < 0.1 * std::fabs(e.x())};
  }
  return nearest;
}

Vec2 nearest_on(const Polygon& exterior, const Vec2& x) {
  Vec2 best = x;
  double least = INFINITY;
  for (std::size_t k = 0; k < exterior.size(); ++k) {
    const Point &p = exterior[k], &q = exterior[(k + 1) % exterior.size()];
    const Vec2 near = nearest_on_segment(x, {p.x, p.y}, {q.x, q.y});
    if ((near - x).norm() < least) least = (near - x).norm(), best = near;
  }
  return best;
}

/// Lengthens the line at both ends to the outline, with as little turn towards it as brings it there within `most`, and
/// at the lower end to level ground within 2.5 times the shortest way: soil comes out of it at 45 degrees less half the
/// friction angle.
void reach_surface(std::vector<Vec2>& line, const Polygon& exterior, double most) {
  constexpr double kSlant = 2.5;
  const auto extend = [&](const Vec2& end, const Vec2& other, const Vec2& direction) {
    const Vec2 nearest = nearest_on(exterior, end), towards = nearest - end;
    const double most_to_level = end.y() < other.y() ? kSlant * towards.norm() : most;
    const double turn = std::atan2(cross(direction, towards), direction.dot(towards));
    constexpr int kParts = 36;
    for (int k = 0; k < kParts; ++k) {
      const double a = turn * k / kParts;
      const Vec2 ray(std::cos(a) * direction.x() - std::sin(a) * direction.y(),
                     std::sin(a) * direction.x() + std::cos(a) * direction.y());
      const Hit hit = first_hit(exterior, end, ray);
      if (hit.way <= most && !(hit.level && hit.way > most_to_level)) return Vec2(end + hit.way * ray);
    }
    return nearest;
  };
  const std::size_t n = line.size(), span = std::min<std::size_t>(3, n - 1);
  const Vec2 head = extend(line.front(), line.back(), (line.front() - line[span]).normalized());
  const Vec2 tail = extend(line.back(), line.front(), (line.back() - line[n - 1 - span]).normalized());
  line.insert(line.begin(), head);
  line.push_back(tail);
}

}  // namespace

Instant instant(const Simulation& simulation) {
  Instant now;
  simulation.read(find_field("displacement"), now.displacement);
  simulation.read(find_field("plastic_strain"), now.plastic_strain);
  return now;
}

bool band_connected(const Simulation& simulation, const Instant& before, const Instant& after) {
  const CellGrid rate(simulation.section(), shearing(before, after));
  const double strongest = quantile(rate, 0.99);
  if (!(strongest > 0)) return false;
  const double least = 0.1 * strongest, apart = 0.25 * simulation.section().height;
  std::vector<bool> seen(rate.values().size(), false);
  for (Index j = 0; j < rate.height(); ++j)
    for (Index i = 0; i < rate.width(); ++i) {
      const auto key =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(rate.width()) + static_cast<std::size_t>(i);
      if (!rate.soil(i, j) || seen[key] || rate.at(i, j) < least) continue;
      Vec2 low = Vec2::Constant(INFINITY), high = -low;
      for (auto [a, b] : component(rate, least, i, j, seen))
        if (on_outline(rate, a, b)) low = low.cwiseMin(rate.center(a, b)), high = high.cwiseMax(rate.center(a, b));
      if (high.x() >= low.x() && (high - low).norm() >= apart) return true;
    }
  return false;
}

SlipSurface slip_surface(const Simulation& simulation, const Instant& before, const Instant& after) {
  SlipSurface out;
  const Section& section = simulation.section();
  const CellGrid right(section, moved_along(0, before, after)), up(section, moved_along(1, before, after));
  CellGrid moved = right;
  for (std::size_t k = 0; k < moved.values().size(); ++k)
    moved.values()[k] = std::hypot(right.values()[k], up.values()[k]);
  CellGrid rate(section, shearing(before, after));
  const double fastest = quantile(moved, 0.995);
  if (!(fastest > 0)) return out;
  // the mass moves like its own median, not like its fastest corner
  std::vector<double> fast;
  for (double v : moved.values())
    if (v >= 0.3 * fastest) fast.push_back(v);
  std::nth_element(fast.begin(), fast.begin() + static_cast<std::ptrdiff_t>(fast.size() / 2), fast.end());
  const double level = 0.5 * fast[fast.size() / 2];
  out.side = side_of_slide(moved, right, up, level);
  for (std::size_t k = 0; k < moved.values().size(); ++k)
    if (out.side * right.values()[k] < 0) moved.values()[k] = rate.values()[k] = 0;
  const std::vector<bool> mass = moving_mass(moved, level);
  std::vector<double> areas;
  for (const Seed& s : section.seeds)
    if (s.hold == Hold::kFree) areas.push_back(s.volume);
  const CellGrid area(section, areas);
  for (std::size_t k = 0; k < mass.size(); ++k) {
    if (mass[k]) out.sliding_area += area.values()[k];
    else if (moved.values()[k] >= level) moved.values()[k] = 0;  // other places that move are not this mass
  }
  std::vector<Vec2> line = main_line(contour(moved, level));
  const double spacing = section.lattice.spacing.minCoeff();
  if (line.size() < 3) return out;
  line = resampled(line, spacing);
  smooth(line, 4);
  draw_to_band(line, rate, section.ground, 2.5 * spacing);
  smooth(line, 4);
  reach_surface(line, section.exterior, std::max(4 * spacing, 0.3 * section.height));
  if (line.front().x() > line.back().x()) std::reverse(line.begin(), line.end());
  for (const Vec2& p : line) out.line.push_back({p.x(), p.y()});
  return out;
}

}  // namespace vbgpd
