#include "state/flow_drift.h"

#include <algorithm>
#include <cmath>

namespace vbgpd {

namespace {

/// Numbers the cells that hold something, from `next` on; answers the number of each cell, -1 = empty.
std::vector<std::int32_t> number_cells(const Cells& cells, const Bins& bins, std::int32_t& next,
                                       std::int32_t* group_of_item) {
  std::vector<std::int32_t> number(static_cast<std::size_t>(cells.size()), -1);
  for (std::int64_t cell = 0; cell < cells.size(); ++cell) {
    const std::int32_t first = bins.first_of(cell), last = bins.first_of(cell + 1);
    if (first == last) continue;
    number[static_cast<std::size_t>(cell)] = next;
    for (std::int32_t k = first; k < last; ++k) group_of_item[bins.items[static_cast<std::size_t>(k)]] = next;
    ++next;
  }
  return number;
}

/// Displacements of a group: the smallest box around them.
struct Box {
  Real low[2] = {kInfinity, kInfinity}, high[2] = {-kInfinity, -kInfinity};
  void add(Real x, Real y) {
    low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
    low[1] = std::min(low[1], y), high[1] = std::max(high[1], y);
  }
};
Real square_of_difference(const Box& a, const Box& b) {
  const Real x = std::max(a.high[0] - b.low[0], b.high[0] - a.low[0]);
  const Real y = std::max(a.high[1] - b.low[1], b.high[1] - a.low[1]);
  return x * x + y * y;
}

void mirror_vector(const FlowWall& w, Real& x, Real& y) {
  const Real twice = 2 * (x * w.nx + y * w.ny);
  x -= twice * w.nx, y -= twice * w.ny;
}

}  // namespace

void group_by_cell(const FlowModel& m, const FlowState& s, const Cells& cells, const Bins& soil, const Bins& images,
                   FlowLists& lists) {
  const auto n = static_cast<std::size_t>(m.particles);
  lists.group.resize(n + lists.ghosts.size());
  lists.groups = 0;
  const std::vector<std::int32_t> soil_in = number_cells(cells, soil, lists.groups, lists.group.data());
  const std::vector<std::int32_t> images_in = number_cells(cells, images, lists.groups, lists.group.data() + n);
  lists.touching.clear();
  for (std::int64_t cell = 0; cell < cells.size(); ++cell) {
    const std::int32_t own = soil_in[static_cast<std::size_t>(cell)];
    if (own < 0) continue;
    const auto one = static_cast<std::size_t>(soil.items[static_cast<std::size_t>(soil.first_of(cell))]);
    cells.around(s.listed[2 * one], s.listed[2 * one + 1], [&](std::int64_t first, std::int64_t last) {
      for (auto other = static_cast<std::size_t>(first); other < static_cast<std::size_t>(last); ++other) {
        if (soil_in[other] >= own) lists.touching.push_back({own, soil_in[other]});
        if (images_in[other] >= 0) lists.touching.push_back({own, images_in[other]});
      }
    });
  }
}

Real room_left(const FlowModel& m, const FlowState& s, const FlowLists& lists) {
  const auto n = static_cast<std::size_t>(m.particles);
  const Real skin = m.options.skin * m.spacing, farthest = kFarthest * skin;
  std::vector<Box> boxes(static_cast<std::size_t>(lists.groups));
  const auto moved = [&](std::size_t i, int axis) {
    const auto c = static_cast<std::size_t>(axis);
    return s.motion[4 * i + c] - s.listed[2 * i + c];
  };
  Real square = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Real x = moved(i, 0), y = moved(i, 1);
    square = std::max(square, x * x + y * y);
    boxes[static_cast<std::size_t>(lists.group[i])].add(x, y);
  }
  const Real own_room = farthest - std::sqrt(square);
  if (!(own_room >= 0)) return own_room;
  for (std::size_t g = 0; g < lists.ghosts.size(); ++g) {
    const FlowGhost& ghost = lists.ghosts[g];
    Real x = moved(static_cast<std::size_t>(ghost.parent), 0), y = moved(static_cast<std::size_t>(ghost.parent), 1);
    mirror_vector(m.walls[static_cast<std::size_t>(ghost.wall)], x, y);
    if (ghost.second >= 0) mirror_vector(m.walls[static_cast<std::size_t>(ghost.second)], x, y);
    boxes[static_cast<std::size_t>(lists.group[n + g])].add(x, y);
  }
  Real apart = 0;
  for (const FlowTouch& t : lists.touching)
    apart = std::max(apart,
                     square_of_difference(boxes[static_cast<std::size_t>(t.a)], boxes[static_cast<std::size_t>(t.b)]));
  return std::min(own_room, (skin - std::sqrt(apart)) / 2);
}

}  // namespace vbgpd
