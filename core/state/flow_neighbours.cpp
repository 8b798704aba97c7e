#include "state/flow_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "state/flow_drift.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace vbgpd {

namespace {

/// Rows of kWidth values in another order; `old` is room for a copy and asks for none where it has enough.
template <std::size_t kWidth>
void permute(Array& a, const std::vector<std::int32_t>& order, std::vector<Real>& old) {
  if (!a.present()) return;
  old.assign(a.data(), a.data() + kWidth * order.size());
  Real* to = a.data();
  for (const std::int32_t from : order)
    to = std::copy_n(old.data() + kWidth * static_cast<std::size_t>(from), kWidth, to);
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

/// Squares of the distances from (x, y), and the numbers of those below `reach2`; answers how many these are. `near`
/// has room for one more than there are points.
std::size_t pick_near(const Real* px, const Real* py, std::size_t points, Real x, Real y, Real reach2, Real* distance2,
                      std::int32_t* near) {
  std::size_t count = 0, k = 0;
#if defined(__SSE2__)
  // two at a time, without branches: what the comparison says picks the numbers to write and how many of them count
  static constexpr std::int32_t kPicked[4][2] = {{0, 0}, {0, 0}, {1, 0}, {0, 1}};
  static constexpr std::uint8_t kCount[4] = {0, 1, 1, 2};
  const __m128d x2 = _mm_set1_pd(x), y2 = _mm_set1_pd(y), limit = _mm_set1_pd(reach2);
  __m128i number = _mm_setzero_si128();
  for (; k + 1 < points; k += 2) {
    const __m128d dx = _mm_sub_pd(_mm_loadu_pd(px + k), x2), dy = _mm_sub_pd(_mm_loadu_pd(py + k), y2);
    const __m128d d2 = _mm_add_pd(_mm_mul_pd(dx, dx), _mm_mul_pd(dy, dy));
    _mm_storeu_pd(distance2 + k, d2);
    const int which = _mm_movemask_pd(_mm_cmplt_pd(d2, limit));
    const __m128i picked = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPicked[which]));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(near + count), _mm_add_epi32(picked, number));
    count += kCount[which];
    number = _mm_add_epi32(number, _mm_set1_epi32(2));
  }
#endif
  for (; k < points; ++k) {
    const Real dx = px[k] - x, dy = py[k] - y;
    distance2[k] = dx * dx + dy * dy;
    near[count] = static_cast<std::int32_t>(k);
    count += distance2[k] < reach2;
  }
  return count;
}

class Lister {
 public:
  Lister(const FlowModel& m, const FlowState& s, FlowLists& lists)
      : m_(m),
        state_(s),
        xy_(s.listed),
        lists_(lists),
        reach_(m.support + m.options.skin * m.spacing),
        reach2_(reach_ * reach_),
        support2_(m.support * m.support),
        middle2_((m.support + reach_) * (m.support + reach_) / 4),
        cells_(m, xy_, cell_size(m)) {}

  void list() {
    const auto n = static_cast<std::size_t>(m_.particles);
    lists_.rows.assign(n, {});
    find_ghosts(m_, xy_, reach_, lists_);
    place_images();
    const Bins soil(cells_, xy_.data(), n), ghosts(cells_, images_.data(), lists_.ghosts.size());
    group_by_cell(m_, state_, cells_, soil, ghosts, lists_);
    for (std::size_t i = 0; i < n; ++i) {
      FlowRow& row = lists_.rows[i];
      row.begin = packs();
      list_soil(i, soil);
      fill_pack();
      row.ghosts = packs();
      if (row.near_wall != 0) list_ghosts(i, ghosts);
      fill_pack();
      row.end = packs();
    }
    lists_.neighbours.resize(listed_);
  }

  /// Pairs that list() would look at; `most` once there are more images than that.
  std::int64_t work(std::int64_t most) {
    const auto n = static_cast<std::size_t>(m_.particles);
    lists_.rows.assign(n, {});
    if (find_ghosts(m_, xy_, reach_, lists_, static_cast<std::size_t>(most)) >= static_cast<std::size_t>(most))
      return most;
    place_images();
    const Bins soil(cells_, xy_.data(), n), ghosts(cells_, images_.data(), lists_.ghosts.size());
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      cells_.around(xy_[2 * i], xy_[2 * i + 1], [&](std::int64_t first, std::int64_t last) {
        sum += soil.first_of(last) - soil.first_of(first);
        if (lists_.rows[i].near_wall != 0) sum += ghosts.first_of(last) - ghosts.first_of(first);
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
  std::int32_t packs() const { return static_cast<std::int32_t>(listed_ / 4); }
  /// Where the next neighbours go, with room for so many.
  std::int32_t* place_for(std::size_t most) {
    List<std::int32_t>& all = lists_.neighbours;
    if (all.size() < listed_ + most) all.resize(std::max(2 * listed_, kUsual * lists_.rows.size()) + most);
    return all.data() + listed_;
  }
  void add(std::int32_t neighbour) { *place_for(1) = neighbour, ++listed_; }
  void fill_pack() {
    while (listed_ % 4 != 0) add(static_cast<std::int32_t>(m_.particles));
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
    add(static_cast<std::int32_t>(m_.particles) + 1 + g);
  }
  /// Everything in the cell of particle i and the eight around it; the same for all particles of the cell.
  void look_around(std::size_t i, const Bins& soil) {
    if (soil.cell[i] == seen_from_) return;
    seen_from_ = soil.cell[i];
    around_.clear(), around_x_.clear(), around_y_.clear();
    cells_.around(xy_[2 * i], xy_[2 * i + 1], [&](std::int64_t first, std::int64_t last) {
      const std::int32_t begin = soil.first_of(first), end = soil.first_of(last);
      around_.insert(around_.end(), soil.items.begin() + begin, soil.items.begin() + end);
      around_x_.insert(around_x_.end(), soil.x.begin() + begin, soil.x.begin() + end);
      around_y_.insert(around_y_.end(), soil.y.begin() + begin, soil.y.begin() + end);
    });
    distance2_.resize(around_.size()), found_.resize(around_.size() + 1);
    middle_.resize(around_.size()), far_.resize(around_.size());
  }
  /// Soil around particle i by distance: within the support, a little beyond, farther. The step leaves out the packs
  /// behind the last one with a particle within the support. Without branches: every candidate is written, and counted
  /// where it belongs.
  void list_soil(std::size_t i, const Bins& soil) {
    look_around(i, soil);
    const Real x = xy_[2 * i], y = xy_[2 * i + 1], reach2 = reach2_, support2 = support2_, middle2 = middle2_;
    const std::size_t candidates = around_.size();
    Real* const distance2 = distance2_.data();
    std::int32_t* const found = found_.data();
    const std::size_t within_reach =
        pick_near(around_x_.data(), around_y_.data(), candidates, x, y, reach2, distance2, found);
    std::int32_t *const near = place_for(within_reach + 1), *const middle = middle_.data(), *const far = far_.data();
    const auto self = static_cast<std::int32_t>(i);
    std::size_t nears = 0, middles = 0, fars = 0;
    for (std::size_t n = 0; n < within_reach; ++n) {
      const auto k = static_cast<std::size_t>(found[n]);
      const std::int32_t j = around_[k];
      const bool inside = distance2[k] < support2, within = distance2[k] < middle2;
      near[nears] = middle[middles] = far[fars] = j;
      nears += inside & (j != self), middles += within & !inside, fars += !within;
    }
    std::copy_n(middle, middles, near + nears);
    std::copy_n(far, fars, near + nears + middles);
    listed_ += nears + middles + fars;
  }
  void list_ghosts(std::size_t i, const Bins& ghosts) {
    cells_.around(xy_[2 * i], xy_[2 * i + 1], [&](std::int64_t first, std::int64_t last) {
      for (std::int32_t k = ghosts.first_of(first); k < ghosts.first_of(last); ++k)
        try_ghost(i, ghosts.items[static_cast<std::size_t>(k)]);
    });
  }

  const FlowModel& m_;
  const FlowState& state_;
  const Array& xy_;
  FlowLists& lists_;
  Real reach_, reach2_, support2_, middle2_;
  Cells cells_;
  static constexpr std::size_t kUsual = 36;  // a row of the bulk, filled up to packs
  std::size_t listed_ = 0;
  std::vector<Real> images_;
  std::int64_t seen_from_ = -1;
  std::vector<std::int32_t> around_, found_, middle_, far_;
  std::vector<Real> around_x_, around_y_, distance2_;
};

}  // namespace

void place_forces(const FlowModel& m, const FlowState& s, FlowLists& lists) {
  const bool wet = m.pore_pressure.present();
  if (lists.pore_pressure.size() != m.pore_pressure.size())
    lists.pore_pressure.allocate(m.pore_pressure.size(), 5, m.heap);
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.particles); ++i) {
    const auto id = static_cast<std::size_t>(s.particle[i]);
    lists.force[2 * i] = m.force_x[id], lists.force[2 * i + 1] = m.force_y[id];
    if (wet) lists.pore_pressure[i] = m.pore_pressure[id];
  }
}

namespace {

/// Constants of the particles at their present places.
void place_constants(const FlowModel& m, const FlowState& s, FlowLists& lists) {
  const auto n = static_cast<std::size_t>(m.particles), ghosts = lists.ghosts.size();
  lists.soil.resize(n);
  lists.constants.allocate_for_overwrite(4 * (n + 1), 1, m.heap);
  lists.volume.allocate_for_overwrite(n + ghosts + 1, 2, m.heap);
  lists.force.allocate_for_overwrite(2 * n, 3, m.heap);
  lists.extra_cohesion.allocate_for_overwrite(m.extra_cohesion.size(), 4, m.heap);
  lists.volume[n] = 0;
  for (std::size_t k = 0; k < 4; ++k) lists.constants[4 * n + k] = 0;
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

/// Hands the bonds that live on from the old list to the new one, whose other bonds have no traction. order: old place
/// of each particle.
void hand_over(const FlowModel& m, const FlowLists& old, const Array& from, const std::vector<std::int32_t>& order,
               const FlowLists& lists, Array& to) {
  const auto n = static_cast<std::size_t>(m.particles);
  const auto blank = static_cast<std::int32_t>(m.particles);
  std::vector<std::int32_t> slot_of(n, -1);  // where an old neighbour stands in the old row; older rows are told apart
  for (std::size_t i = 0; i < n; ++i) {
    const auto was = static_cast<std::size_t>(order[i]);
    const FlowRow row = lists.rows[i], before = was < old.rows.size() ? old.rows[was] : FlowRow{};
    const std::int32_t first = 4 * before.begin, last = 4 * before.ghosts;
    for (std::int32_t k = first; k < last; ++k) {
      const std::int32_t j = old.neighbours[static_cast<std::size_t>(k)];
      if (j < blank) slot_of[static_cast<std::size_t>(j)] = k;
    }
    std::fill(to.data() + 8l * row.ghosts, to.data() + 8l * row.end, 0.0);
    for (auto k = 4 * static_cast<std::size_t>(row.begin); k < 4 * static_cast<std::size_t>(row.ghosts); ++k) {
      const std::int32_t j = lists.neighbours[k];
      const std::int32_t slot = j < blank ? slot_of[static_cast<std::size_t>(order[static_cast<std::size_t>(j)])] : -1;
      const bool lives = slot >= first && slot < last;
      const auto found = static_cast<std::size_t>(lives ? slot : 0);
      for (std::size_t part = 0; part < 8; part += 4)
        to[8 * (k / 4) + part + k % 4] = lives ? from[8 * (found / 4) + part + found % 4] : 0;
    }
  }
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

bool search_neighbours(const FlowModel& m, FlowState& s, FlowLists& lists,
                       const std::function<void(const FlowLists&)>& prepare) {
  const auto n = static_cast<std::size_t>(m.particles);
  FlowState sorted;  // places, ids and tractions alone: what a listing needs
  sorted.listed = s.listed, sorted.particle = s.particle;
  for (std::size_t i = 0; i < n; ++i)
    sorted.listed[2 * i] = s.motion[4 * i], sorted.listed[2 * i + 1] = s.motion[4 * i + 1];
  const Cells cells(m, sorted.listed, cell_size(m));
  const Bins bins(cells, sorted.listed.data(), n);
  const std::vector<std::int32_t>& order = bins.items;  // new place -> old place
  const bool reordered = !std::is_sorted(order.begin(), order.end());
  std::vector<Real> room;
  room.reserve(4 * n);
  if (reordered) permute<2>(sorted.listed, order, room), permute<1>(sorted.particle, order, room);
  FlowLists found;
  list_neighbours(m, sorted, found);
  if (m.keeps_bonds()) {
    sorted.traction.allocate_for_overwrite(2 * found.neighbours.size(), 8, m.heap);
    if (s.traction.present()) hand_over(m, lists, s.traction, order, found, sorted.traction);
    else sorted.traction.fill_zero();
  }
  if (prepare) prepare(found);
  // nothing is taken from the heap from here on
  if (reordered) {
    permute<4>(s.motion, order, room), permute<4>(s.stress, order, room);
    for (Array* a : {&s.gap, &s.plastic_strain, &s.wall_shear, &s.wall_limit, &s.dead}) permute<1>(*a, order, room);
  }
  s.listed = std::move(sorted.listed), s.particle = std::move(sorted.particle);
  s.traction = std::move(sorted.traction);
  lists = std::move(found);
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
