#include <algorithm>
#include <numeric>
#include <queue>

#include "geometry/soil.h"

namespace vbgpd {
namespace {

struct Neighbour {
  Index root = -1;      // the seed that would take the sliver, -1 = none
  bool sliver = true;   // is that one less than half full itself
  Real contact = 0;     // length of the common soil edge
  Real volume = 0;
};

class Merger {
 public:
  Merger(const Grid& grid, const Vec2& spacing, Real slack, Soil& soil)
      : grid_(grid), soil_(soil), index_(soil.seeds), into_(soil.seeds.size()), next_(soil.seeds.size()),
        h_(spacing.minCoeff()), half_(0.5 * spacing.prod() * (1 - slack)) {
    std::iota(into_.begin(), into_.end(), 0);
    std::iota(next_.begin(), next_.end(), 0);
  }

  void run() {
    using Entry = std::pair<Real, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> smallest;
    for (std::size_t i = 0; i < into_.size(); ++i)
      if (is_sliver(static_cast<Index>(i))) smallest.emplace(soil_.seeds[i].volume, static_cast<Index>(i));
    while (!smallest.empty()) {
      const auto [volume, i] = smallest.top();
      smallest.pop();
      if (into_[i] != i || soil_.seeds[i].volume != volume) continue;  // changed since it was queued
      const Index target = best_neighbour(i);
      if (target < 0) continue;
      absorb(i, target);
      if (is_sliver(target)) smallest.emplace(soil_.seeds[target].volume, target);
    }
    compact();
  }

 private:
  bool is_sliver(Index i) const { return soil_.seeds[i].volume < half_; }

  Index root(Index i) const {
    while (into_[i] != i) i = into_[i];
    return i;
  }

  // Length of soil along one side of a cell: 0 left, 1 right, 2 bottom, 3 top.
  Real contact(Index i, int side) const {
    if (soil_.cut_of[i] >= 0) return soil_.cut[soil_.cut_of[i]].contact[side];
    const Index column = soil_.seeds[i].ix - grid_.ix0, row = soil_.seeds[i].iy - grid_.iy0;
    return side < 2 ? grid_.y[row + 1] - grid_.y[row] : grid_.x[column + 1] - grid_.x[column];
  }

  // What the group led by `leader` finds beside its member i.
  Neighbour look(Index leader, Index i, Index dx, Index dy) const {
    const Seed& seed = soil_.seeds[i];
    const Index j = index_.find(seed.ix + dx, seed.iy + dy);
    if (j < 0) return {};
    Neighbour result;
    if (dx == 0 || dy == 0) {
      const int side = dx < 0 ? 0 : dx > 0 ? 1 : dy < 0 ? 2 : 3;
      result.contact = std::min(contact(i, side), contact(j, side ^ 1));
      if (result.contact <= 1e-9 * h_) return {};
    }
    const Index r = root(j);
    if (r == leader) return {};
    result.root = r;
    result.sliver = is_sliver(r);
    result.volume = soil_.seeds[r].volume;
    return result;
  }

  // Lengths and volumes within round-off tie, so that a moved or mirrored section merges alike.
  bool better(const Neighbour& a, const Neighbour& b) const {
    if (a.root < 0 || b.root < 0) return b.root < 0 && a.root >= 0;
    if (a.sliver != b.sliver) return !a.sliver;
    if (a.contact > b.contact + 1e-7 * h_) return true;
    if (a.contact < b.contact - 1e-7 * h_) return false;
    return a.volume > b.volume + 1e-7 * h_ * h_;
  }

  Index best_neighbour(Index leader) const {
    static constexpr Index kSides[4][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}};
    static constexpr Index kCorners[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    Neighbour best;
    for (const auto* around : {kSides, kCorners}) {
      Index i = leader;
      do {
        for (int k = 0; k < 4; ++k) {
          const Neighbour candidate = look(leader, i, around[k][0], around[k][1]);
          if (better(candidate, best)) best = candidate;
        }
        i = next_[i];
      } while (i != leader);
      if (best.root >= 0) break;
    }
    return best.root;
  }

  void absorb(Index i, Index target) {
    Seed &from = soil_.seeds[i], &to = soil_.seeds[target];
    const Real volume = from.volume + to.volume;
    to.centroid += from.volume / volume * (from.centroid - to.centroid);
    to.volume = volume;
    into_[i] = target;
    std::swap(next_[i], next_[target]);  // joins the two rings of members
  }

  void compact() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < into_.size(); ++i) {
      if (into_[i] != static_cast<Index>(i)) continue;
      soil_.seeds[kept] = soil_.seeds[i];
      soil_.cut_of[kept++] = soil_.cut_of[i];
    }
    soil_.seeds.resize(kept);
    soil_.cut_of.resize(kept);
  }

  const Grid& grid_;
  Soil& soil_;
  CellIndex index_;
  std::vector<Index> into_;  // per seed: itself, or the seed it was merged into
  std::vector<Index> next_;  // per seed: the next of its group, in a ring
  Real h_, half_;
};

}  // namespace

void merge_slivers(const Grid& grid, const Vec2& spacing, Real slack, Soil& soil) {
  Merger(grid, spacing, slack, soil).run();
}

}  // namespace vbgpd
