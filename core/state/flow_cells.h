// Particles and images of a run-out sorted by cell.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "state/flow_model.h"

namespace vbgpd {

/// Square cells, wrapped around: a particle that flies off costs no memory, and a pair that only meets around the wrap
/// is too far apart to count.
class Cells {
 public:
  Cells(const FlowModel& m, const Array& xy, Real size) : inverse_(1 / size) {
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

  /// use(first, last): the cell of a point and the eight around it, as ranges of cells.
  void around(Real x, Real y, auto&& use) const {
    const std::int64_t cx = wrapped(column(x), count_[0]), cy = wrapped(column(y), count_[1]);
    const auto next_to = [](std::int64_t k, std::int64_t n) { return k < 0 ? k + n : k < n ? k : k - n; };
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      const std::int64_t first = next_to(cx + dx, count_[0]) * count_[1];
      if (cy > 0 && cy + 1 < count_[1]) use(first + cy - 1, first + cy + 2);
      else
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          const std::int64_t one = first + next_to(cy + dy, count_[1]);
          use(one, one + 1);
        }
    }
  }

 private:
  static std::int64_t wrapped(std::int64_t k, std::int64_t n) { return ((k % n) + n) % n; }
  Real inverse_;
  std::int64_t count_[2] = {4, 4};
};

/// Items of each cell, in the order of their numbers, and where they are; the cell of each item.
struct Bins {
  std::vector<std::int32_t> begin, items;
  std::vector<std::int64_t> cell;
  std::vector<Real> x, y;
  Bins(const Cells& cells, const Real* xy, std::size_t n) : items(n), cell(n), x(n), y(n) {
    begin.assign(static_cast<std::size_t>(cells.size()) + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      cell[i] = cells.cell_at(xy[2 * i], xy[2 * i + 1]);
      ++begin[static_cast<std::size_t>(cell[i]) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < n; ++i) {
      const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(cell[i])]++);
      items[place] = static_cast<std::int32_t>(i), x[place] = xy[2 * i], y[place] = xy[2 * i + 1];
    }
  }
  /// Of a range of cells.
  std::int32_t first_of(std::int64_t cell) const { return begin[static_cast<std::size_t>(cell)]; }
};

}  // namespace vbgpd
