#include "simulation/placement.h"

#include <algorithm>

#include "simulation/bond_records.h"
#include "simulation/buckets.h"
#include "simulation/observe.h"

namespace vbgpd {

namespace {

using observe_detail::deviator, observe_detail::Three;

/// What a bond brings along: records, and the strain it had.
struct Carried {
  std::size_t i, j;
  Three plastic{}, placed{}, strain{};
  bool operator<(const Carried& o) const { return i != o.i ? i < o.i : j < o.j; }
};

Three load(const Array& records, std::size_t r, std::size_t width) {
  if (!records.present()) return {};
  return {records[r], records[r + width], records[r + 2 * width]};
}

void store(Array& records, std::size_t r, std::size_t width, const Three& e) {
  for (std::size_t c = 0; c < 3; ++c) records[r + c * width] = e[c];
}

/// VB2 by plain sums.
void find_gradients(const Model& m, const State& s, Scratch& out) {
  for (Array* a : {&out.gradient_xx, &out.gradient_xy, &out.gradient_yx, &out.gradient_yy}) a->fill_zero();
  for (const Block& block : m.blocks)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(block.first + l);
      if (m.seed_of[i] < 0) continue;
      Mat2 sum = Mat2::Zero();
      for (std::int32_t k = block.neighbours_begin; k < block.neighbours_end; ++k) {
        const NeighbourPack& p = m.neighbours[static_cast<std::size_t>(k)];
        const auto j = static_cast<std::size_t>(p.j + l);
        if (((p.lanes >> l) & 1) == 0 || m.seed_of[j] < 0) continue;
        const Offset o = m.offset(k, block, l);
        const Vec2 du(s.displacement_x[j] - s.displacement_x[i], s.displacement_y[j] - s.displacement_y[i]);
        sum += m.volume[j] * du * Vec2(o.g_x, o.g_y).transpose();
      }
      Mat2 inverse;
      inverse << m.moment_xx[i], m.moment_xy[i], m.moment_xy[i], m.moment_yy[i];
      const Mat2 gradient = sum * inverse;
      out.gradient_xx[i] = gradient(0, 0), out.gradient_xy[i] = gradient(0, 1);
      out.gradient_yx[i] = gradient(1, 0), out.gradient_yy[i] = gradient(1, 1);
    }
}

/// Displacements of what is placed: those of the nearest particle of the same kind that was there.
void move_along(const Section& section, const Model& from, const Model& to, State& s) {
  for (Index boundary = -1; boundary < static_cast<Index>(section.boundaries.size()); ++boundary) {
    std::vector<Point> places;
    std::vector<std::size_t> there, placed;
    for (std::size_t k = 0; k < section.seeds.size(); ++k) {
      const Seed& seed = section.seeds[k];
      if ((seed.hold == Hold::kFree ? -1 : seed.boundary) != boundary) continue;
      const auto i = static_cast<std::size_t>(from.storage_of[k]);
      const Vec2 x = section.place(k);
      if (from.seed_of[i] >= 0) places.push_back({x.x(), x.y()}), there.push_back(i);
      else if (to.seed_of[i] >= 0) placed.push_back(k);
    }
    if (places.empty()) continue;
    const Buckets buckets(places, section.lattice.spacing.maxCoeff());
    for (std::size_t k : placed) {
      const Vec2 x = section.place(k);
      const std::size_t like = there[buckets.nearest(places, x.x(), x.y())];
      const auto i = static_cast<std::size_t>(from.storage_of[k]);
      s.displacement_x[i] = s.displacement_x[like], s.displacement_y[i] = s.displacement_y[like];
    }
  }
}

}  // namespace

bool has_moved(const State& state) {
  bool moved = false;
  State::for_each_array(state, [&](const char*, const Array& a) {
    for (std::size_t i = 0; i < a.size() && !moved; ++i) moved = a[i] != 0;
  });
  return moved;
}

State carried_over(const Section& section, const Model& from, const State& state, const Scratch& gradients,
                   const Model& to, bool places, Scratch& scratch) {
  State s;
  s.allocate(to);
  for (std::size_t i = 0; i < static_cast<std::size_t>(to.storage); ++i) {
    if (from.seed_of[i] < 0 || to.seed_of[i] < 0) continue;
    s.displacement_x[i] = state.displacement_x[i], s.displacement_y[i] = state.displacement_y[i];
    s.velocity_x[i] = state.velocity_x[i], s.velocity_y[i] = state.velocity_y[i];
    if (state.plastic_volume.present()) s.plastic_volume[i] = state.plastic_volume[i], s.gap[i] = state.gap[i];
  }
  const auto width = static_cast<std::size_t>(to.width);
  if (places) {
    move_along(section, from, to, s);
    find_gradients(to, s, scratch);
    for (std::size_t i = 0; i < static_cast<std::size_t>(to.storage); ++i) {
      if (to.seed_of[i] < 0) continue;
      s.plastic_volume[i] += scratch.gradient_xx[i] + scratch.gradient_yy[i];
      if (from.seed_of[i] >= 0) s.plastic_volume[i] -= gradients.gradient_xx[i] + gradients.gradient_yy[i];
    }
  }
  if (!to.features.plastic) return s;
  std::vector<Carried> before;
  for_each_record(from, [&](const BondPack& p, int l, std::size_t i, std::size_t j, std::size_t r) {
    Carried c{i, j};
    c.plastic = load(state.plastic_strain, r, width), c.placed = load(state.placed_strain, r, width);
    if (places) c.strain = deviator(observe_detail::strain(state, gradients, from.offset(p, l), i, j));
    if (places || c.plastic != Three{}) before.push_back(c);
  });
  std::sort(before.begin(), before.end());
  for_each_record(to, [&](const BondPack& p, int l, std::size_t i, std::size_t j, std::size_t r) {
    Carried c{i, j};
    if (const auto at = std::lower_bound(before.begin(), before.end(), c); at != before.end() && !(c < *at)) c = *at;
    if (places) {
      const Three now = deviator(observe_detail::strain(s, scratch, to.offset(p, l), i, j));
      for (std::size_t k = 0; k < 3; ++k) {
        const double shape = now[k] - c.strain[k], yielded = c.plastic[k] - c.placed[k];
        c.placed[k] += shape;
        c.plastic[k] = c.placed[k] + yielded;
      }
    }
    if (s.placed_strain.present()) store(s.placed_strain, r, width, c.placed);
    store(s.plastic_strain, r, width, c.plastic);
  });
  return s;
}

}  // namespace vbgpd
