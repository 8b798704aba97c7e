#include "state/flow_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vbgpd {

namespace {

/// Cells as large as the reach, wrapped around: a particle that flies off costs no memory, and a pair that only meets
/// around the wrap is too far apart to count.
class Cells {
 public:
  Cells(const FlowModel& m, const Array& xy, Real reach) : inverse_(1 / reach) {
    Real low[2] = {kInfinity, kInfinity}, high[2] = {-kInfinity, -kInfinity};
    const auto n = static_cast<std::size_t>(m.particles);
    for (std::size_t i = 0; i < 2 * n; ++i)
      low[i % 2] = std::min(low[i % 2], xy[i]), high[i % 2] = std::max(high[i % 2], xy[i]);
    for (int k = 0; k < 2; ++k) {
      const Real cells = std::ceil((high[k] - low[k]) * inverse_) + 3;
      count_[k] = static_cast<std::int64_t>(std::clamp<Real>(cells, 4, static_cast<Real>(n) + 4));
    }
    while (count_[0] * count_[1] > 8 * m.particles + 64) {
      std::int64_t& longer = count_[0] > count_[1] ? count_[0] : count_[1];
      longer = std::max<std::int64_t>(4, longer / 2);
    }
  }
  std::int64_t column(Real x) const {
    const Real k = std::floor(x * inverse_);
    return std::fabs(k) < 1e15 ? static_cast<std::int64_t>(k) : 0;  // a state that diverged has no place
  }
  std::int64_t cell(std::int64_t column, std::int64_t row) const {
    return wrapped(column, count_[0]) * count_[1] + wrapped(row, count_[1]);
  }
  std::int64_t cell_at(Real x, Real y) const { return cell(column(x), column(y)); }
  std::int64_t size() const { return count_[0] * count_[1]; }

 private:
  static std::int64_t wrapped(std::int64_t k, std::int64_t n) { return ((k % n) + n) % n; }
  Real inverse_;
  std::int64_t count_[2] = {4, 4};
};

/// Items of each cell, in the order of their numbers.
struct Bins {
  std::vector<std::int32_t> begin, items;
  Bins(const Cells& cells, std::size_t n, auto&& cell_of) {
    begin.assign(static_cast<std::size_t>(cells.size()) + 1, 0);
    std::vector<std::int64_t> where(n);
    for (std::size_t i = 0; i < n; ++i) where[i] = cell_of(i), ++begin[static_cast<std::size_t>(where[i]) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    items.resize(n);
    std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
      items[static_cast<std::size_t>(next[static_cast<std::size_t>(where[i])]++)] = static_cast<std::int32_t>(i);
  }
};

void permute(Array& a, const std::vector<std::int32_t>& order, std::size_t width) {
  if (!a.present()) return;
  const Array old = a;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = 0; k < width; ++k) a[width * i + k] = old[width * static_cast<std::size_t>(order[i]) + k];
}

Real along(const FlowWall& w, Real x, Real y) { return (x - w.x) * w.ny - (y - w.y) * w.nx; }
Real before(const FlowWall& w, Real x, Real y) { return (x - w.x) * w.nx + (y - w.y) * w.ny; }

void mirror(const FlowWall& w, Real& x, Real& y) {
  const Real twice = 2 * before(w, x, y);
  x -= twice * w.nx, y -= twice * w.ny;
}

/// Two walls at a right angle with the soil in the corner: the image behind the corner mirrors at both.
bool right_corner(const FlowWall& a, const FlowWall& b) {
  if (std::fabs(a.nx * b.nx + a.ny * b.ny) > 1e-6) return false;
  for (const Real end_a : {a.low, a.high})
    for (const Real end_b : {b.low, b.high}) {
      if (!std::isfinite(end_a) || !std::isfinite(end_b)) continue;
      const Real x = a.x + end_a * a.ny, y = a.y - end_a * a.nx;
      const Real dx = b.x + end_b * b.ny - x, dy = b.y - end_b * b.nx - y;
      const Real size = std::fabs(a.x) + std::fabs(a.y) + std::fabs(b.x) + std::fabs(b.y) + 1;
      if (std::fabs(dx) + std::fabs(dy) > 1e-9 * size) continue;
      const Real way = end_b == b.low ? 1 : -1;
      return way * (b.ny * a.nx - b.nx * a.ny) > 0;
    }
  return false;
}

/// Images of all particles near walls; answers how many there are, of which it keeps `most`.
std::size_t find_ghosts(const FlowModel& m, const Array& xy, Real reach, FlowLists& lists,
                        std::size_t most = std::numeric_limits<std::size_t>::max()) {
  lists.ghosts.clear();
  std::size_t count = 0;
  const auto add = [&](const FlowGhost& ghost) {
    if (++count <= most) lists.ghosts.push_back(ghost);
  };
  const auto walls = static_cast<std::int32_t>(m.walls.size());
  for (std::int32_t i = 0; i < m.particles; ++i) {
    const Real x = xy[2 * static_cast<std::size_t>(i)], y = xy[2 * static_cast<std::size_t>(i) + 1];
    std::int32_t near_wall = 0;
    for (std::int32_t k = 0; k < walls; ++k) {
      const FlowWall& w = m.walls[static_cast<std::size_t>(k)];
      const Real s = along(w, x, y);
      const auto close = [&](const FlowWall& wall) { return std::fabs(before(wall, x, y)) < reach; };
      if (!close(w) || s < w.low - reach || s > w.high + reach) continue;
      near_wall = std::max(near_wall, w.friction >= 0 ? 2 : 1);
      add({i, k, -1});
      for (std::int32_t l = k + 1; l < walls; ++l) {
        const FlowWall& second = m.walls[static_cast<std::size_t>(l)];
        if (close(second) && right_corner(w, second)) add({i, k, l});
      }
    }
    lists.rows[static_cast<std::size_t>(i)].near_wall = near_wall;
  }
  return count;
}

/// Does a particle see an image through the wall itself, or past its end? The answer is the same for the partner and
/// the particle's own image.
bool seen(const FlowWall& w, Real x, Real y, Real image_x, Real image_y) {
  const Real front = before(w, x, y), back = -before(w, image_x, image_y);
  if (!(front + back > 0)) return false;
  const Real a = along(w, x, y), b = along(w, image_x, image_y), s = a + front / (front + back) * (b - a);
  return s >= w.low && s <= w.high;
}

class Lister {
 public:
  Lister(const FlowModel& m, const FlowState& s, FlowLists& lists)
      : m_(m),
        xy_(s.listed),
        lists_(lists),
        reach_(m.support + m.options.skin * m.spacing),
        reach2_(reach_ * reach_),
        support2_(m.support * m.support),
        cells_(m, xy_, reach_) {}

  void list() {
    const auto n = static_cast<std::size_t>(m_.particles);
    lists_.rows.assign(n, {});
    find_ghosts(m_, xy_, reach_, lists_);
    place_images();
    const Bins soil(cells_, n, [&](std::size_t i) { return cells_.cell_at(xy_[2 * i], xy_[2 * i + 1]); });
    const Bins ghosts(cells_, lists_.ghosts.size(),
                      [&](std::size_t g) { return cells_.cell_at(images_[2 * g], images_[2 * g + 1]); });
    lists_.neighbours.clear();
    for (std::size_t i = 0; i < n; ++i) {
      FlowRow& row = lists_.rows[i];
      row.begin = packs();
      around(i, soil, [&](std::int32_t j) {
        const auto k = static_cast<std::size_t>(j);
        if (k == i) return;
        const Real distance2 = square_distance(i, xy_[2 * k], xy_[2 * k + 1]);
        if (distance2 < support2_) lists_.neighbours.push_back(j);
        else if (distance2 < reach2_) beyond_.push_back(j);
      });
      lists_.neighbours.insert(lists_.neighbours.end(), beyond_.begin(), beyond_.end());  // packs of these are skipped
      beyond_.clear();
      fill_pack();
      row.ghosts = packs();
      if (row.near_wall != 0) around(i, ghosts, [&](std::int32_t g) { try_ghost(i, g); });
      fill_pack();
      row.end = packs();
    }
  }

  /// Pairs that list() would look at; `most` once there are more images than that.
  std::int64_t work(std::int64_t most) {
    const auto n = static_cast<std::size_t>(m_.particles);
    lists_.rows.assign(n, {});
    if (find_ghosts(m_, xy_, reach_, lists_, static_cast<std::size_t>(most)) >= static_cast<std::size_t>(most))
      return most;
    place_images();
    const Bins soil(cells_, n, [&](std::size_t i) { return cells_.cell_at(xy_[2 * i], xy_[2 * i + 1]); });
    const Bins ghosts(cells_, lists_.ghosts.size(),
                      [&](std::size_t g) { return cells_.cell_at(images_[2 * g], images_[2 * g + 1]); });
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      for_each_cell(i, [&](std::size_t cell) {
        sum += soil.begin[cell + 1] - soil.begin[cell];
        if (lists_.rows[i].near_wall != 0) sum += ghosts.begin[cell + 1] - ghosts.begin[cell];
      });
    return sum;
  }

 private:
  void place_images() {
    images_.clear();
    for (const FlowGhost& g : lists_.ghosts) {
      Real x = xy_[2 * static_cast<std::size_t>(g.parent)], y = xy_[2 * static_cast<std::size_t>(g.parent) + 1];
      mirror(m_.walls[static_cast<std::size_t>(g.wall)], x, y);
      if (g.second >= 0) mirror(m_.walls[static_cast<std::size_t>(g.second)], x, y);
      images_.push_back(x), images_.push_back(y);
    }
  }
  std::int32_t packs() const { return static_cast<std::int32_t>(lists_.neighbours.size() / 4); }
  void fill_pack() {
    while (lists_.neighbours.size() % 4 != 0) lists_.neighbours.push_back(static_cast<std::int32_t>(m_.particles));
  }
  Real square_distance(std::size_t i, Real x, Real y) const {
    const Real dx = x - xy_[2 * i], dy = y - xy_[2 * i + 1];
    return dx * dx + dy * dy;
  }
  void try_ghost(std::size_t i, std::int32_t g) {
    const FlowGhost& ghost = lists_.ghosts[static_cast<std::size_t>(g)];
    const Real x = images_[2 * static_cast<std::size_t>(g)], y = images_[2 * static_cast<std::size_t>(g) + 1];
    if (square_distance(i, x, y) >= reach2_) return;
    const FlowWall& wall = m_.walls[static_cast<std::size_t>(ghost.wall)];
    if (ghost.second < 0 && !seen(wall, xy_[2 * i], xy_[2 * i + 1], x, y)) return;
    lists_.neighbours.push_back(static_cast<std::int32_t>(m_.particles) + 1 + g);
  }
  void for_each_cell(std::size_t i, auto&& use) const {
    const std::int64_t cx = cells_.column(xy_[2 * i]), cy = cells_.column(xy_[2 * i + 1]);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) use(static_cast<std::size_t>(cells_.cell(cx + dx, cy + dy)));
  }
  void around(std::size_t i, const Bins& bins, auto&& use) const {
    for_each_cell(i, [&](std::size_t cell) {
      for (std::int32_t k = bins.begin[cell]; k < bins.begin[cell + 1]; ++k)
        use(bins.items[static_cast<std::size_t>(k)]);
    });
  }

  const FlowModel& m_;
  const Array& xy_;
  FlowLists& lists_;
  Real reach_, reach2_, support2_;
  Cells cells_;
  std::vector<Real> images_;
  std::vector<std::int32_t> beyond_;
};

}  // namespace

void place_forces(const FlowModel& m, const FlowState& s, FlowLists& lists) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.particles); ++i) {
    const auto id = static_cast<std::size_t>(s.particle[i]);
    lists.force[2 * i] = m.force_x[id], lists.force[2 * i + 1] = m.force_y[id];
  }
}

namespace {

/// Constants of the particles at their present places.
void place_constants(const FlowModel& m, const FlowState& s, FlowLists& lists) {
  const auto n = static_cast<std::size_t>(m.particles), ghosts = lists.ghosts.size();
  lists.soil.resize(n);
  lists.constants.allocate(4 * (n + 1), 1, m.heap);
  lists.volume.allocate(n + ghosts + 1, 2, m.heap);
  lists.force.allocate(2 * n, 3, m.heap);
  lists.extra_cohesion.allocate(m.extra_cohesion.size(), 4, m.heap);
  for (std::size_t i = 0; i < n; ++i) {
    const auto id = static_cast<std::size_t>(s.particle[i]);
    const LawConstants& moduli = m.moduli[static_cast<std::size_t>(m.material[id])];
    const Real wave = moduli.bulk_modulus + 4 * moduli.shear_modulus / 3;
    lists.soil[i] = m.material[id];
    lists.volume[i] = lists.constants[4 * i] = m.volume[id];
    lists.constants[4 * i + 1] = m.mass[id];
    lists.constants[4 * i + 2] = wave;
    lists.constants[4 * i + 3] = m.size[id];
    if (m.extra_cohesion.present()) lists.extra_cohesion[i] = m.extra_cohesion[id];
  }
  place_forces(m, s, lists);
  for (std::size_t g = 0; g < ghosts; ++g) {
    const auto parent = static_cast<std::size_t>(lists.ghosts[g].parent);
    lists.volume[n + 1 + g] = lists.volume[parent];
  }
}

/// Traction of the bond from old place i to old place j, zero where there was none.
const double* traction_between(const FlowLists& lists, const Array& traction, std::int32_t i, std::int32_t j) {
  const FlowRow& row = lists.rows[static_cast<std::size_t>(i)];
  const auto first = lists.neighbours.begin() + 4l * row.begin, last = lists.neighbours.begin() + 4l * row.ghosts;
  const auto found = std::find(first, last, j);
  if (found == last) return nullptr;
  const auto slot = static_cast<std::size_t>(found - lists.neighbours.begin());
  return traction.data() + 8 * (slot / 4) + slot % 4;
}

}  // namespace

void list_neighbours(const FlowModel& m, const FlowState& s, FlowLists& lists) {
  use(lists.neighbours, m.heap);
  Lister(m, s, lists).list();
  place_constants(m, s, lists);
}

std::int64_t listing_work(const FlowModel& m, const FlowState& s) {
  FlowLists lists;
  return Lister(m, s, lists).work(1000 * m.particles + 1000000);
}

bool search_neighbours(const FlowModel& m, FlowState& s, FlowLists& lists) {
  const auto n = static_cast<std::size_t>(m.particles);
  for (std::size_t i = 0; i < n; ++i) s.listed[2 * i] = s.motion[4 * i], s.listed[2 * i + 1] = s.motion[4 * i + 1];
  const Cells cells(m, s.listed, m.support + m.options.skin * m.spacing);
  const Bins sorted(cells, n, [&](std::size_t i) { return cells.cell_at(s.listed[2 * i], s.listed[2 * i + 1]); });
  const std::vector<std::int32_t>& order = sorted.items;  // new place -> old place
  const bool reordered = !std::is_sorted(order.begin(), order.end());
  permute(s.motion, order, 4), permute(s.stress, order, 4), permute(s.listed, order, 2);
  for (Array* a : {&s.gap, &s.plastic_strain, &s.wall_shear, &s.wall_limit, &s.particle, &s.dead})
    permute(*a, order, 1);
  const FlowLists old = std::move(lists);
  const Array traction = std::move(s.traction);
  list_neighbours(m, s, lists = FlowLists{});
  s.traction = Array{};
  if (!m.keeps_bonds()) return reordered;
  s.traction.allocate(2 * lists.neighbours.size(), 8, m.heap);
  if (!traction.present()) return reordered;
  for (std::size_t i = 0; i < n; ++i)
    for (auto k = 4 * static_cast<std::size_t>(lists.rows[i].begin);
         k < 4 * static_cast<std::size_t>(lists.rows[i].ghosts); ++k) {
      const std::int32_t j = lists.neighbours[k];
      if (j >= m.particles) continue;
      const double* const t = traction_between(old, traction, order[i], order[static_cast<std::size_t>(j)]);
      if (t == nullptr) continue;
      s.traction[8 * (k / 4) + k % 4] = t[0], s.traction[8 * (k / 4) + 4 + k % 4] = t[4];
    }
  return reordered;
}

void join_neighbours(const FlowModel& m, FlowState& s, const FlowLists& lists) {
  const Real reach = m.options.spring_reach * m.spacing;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.particles); ++i)
    for (auto k = 4 * static_cast<std::size_t>(lists.rows[i].begin);
         k < 4 * static_cast<std::size_t>(lists.rows[i].ghosts); ++k) {
      const auto j = static_cast<std::size_t>(lists.neighbours[k]);
      Real length = 0;
      if (lists.neighbours[k] < m.particles) {
        const Real dx = s.motion[4 * j] - s.motion[4 * i], dy = s.motion[4 * j + 1] - s.motion[4 * i + 1];
        length = std::sqrt(dx * dx + dy * dy);
      }
      const bool joined = length > 0 && length < reach;
      s.traction[8 * (k / 4) + k % 4] = joined ? length : 0;
      s.traction[8 * (k / 4) + 4 + k % 4] = joined ? 1 : 0;
    }
}

}  // namespace vbgpd
