#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

#include "geometry/soil.h"

namespace vbgpd {
namespace {

struct Neighbour {
  Index root = -1;     // the seed that would take the sliver, -1 = none
  bool sliver = true;  // is that one less than half full itself
  Real contact = 0;    // length of the common soil edge
  Real volume = 0;
};

class Merger {
 public:
  Merger(const GridLines& grid, const Vec2& spacing, Real slack, Soil& soil)
      : grid_(grid),
        soil_(soil),
        index_(soil.seeds),
        into_(soil.seeds.size()),
        next_(soil.seeds.size()),
        changed_(soil.seeds.size(), 0),
        h_(spacing.minCoeff()),
        half_(0.5 * spacing.prod() * (1 - slack)) {
    std::iota(into_.begin(), into_.end(), 0);
    std::iota(next_.begin(), next_.end(), 0);
  }

  void run() {
    for (std::size_t i = 0; i < into_.size(); ++i) enqueue(static_cast<Index>(i));
    while (!smallest_.empty()) merge_batch();
    compact();
  }

 private:
  using Entry = std::tuple<std::int64_t, Index, Index>;  // volume in steps, row, seed

  // Volumes equal but for round-off are taken row by row, wherever the section lies and whatever its size.
  Entry entry(Index i) const {
    constexpr Real kSteps = 1 << 20;
    return {std::llround(soil_.seeds[i].volume / half_ * kSteps), soil_.seeds[i].iy, i};
  }

  void enqueue(Index i) {
    if (is_sliver(i)) smallest_.push(entry(i));
  }

  // Slivers of one size choose before any of them is merged, so that the choice does not depend on their order (nor on
  // which way the slope faces). Two slivers that grew in this round wait for the next.
  void merge_batch() {
    std::vector<std::pair<Index, Neighbour>> batch;
    for (const std::int64_t size = std::get<0>(smallest_.top());
         !smallest_.empty() && std::get<0>(smallest_.top()) == size; smallest_.pop()) {
      const Index i = std::get<2>(smallest_.top());
      if (into_[i] == i && entry(i) == smallest_.top())
        batch.emplace_back(i, best_neighbour(i));  // else it has changed
    }
    ++round_;
    for (const auto& [i, choice] : batch) {
      if (into_[i] != i || choice.root < 0) continue;
      const bool stale = changed_[i] == round_ || (choice.sliver && changed_[choice.root] == round_);
      if (!stale) absorb(i, choice.root);
      enqueue(stale ? i : choice.root);
    }
  }

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
    if (a.volume < b.volume - 1e-7 * h_ * h_) return true;
    if (a.volume > b.volume + 1e-7 * h_ * h_) return false;
    return a.contact > b.contact + 1e-7 * h_;
  }

  Neighbour best_neighbour(Index leader) const {
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
    return best;
  }

  void absorb(Index i, Index target) {
    Seed &from = soil_.seeds[i], &to = soil_.seeds[target];
    const Real volume = from.volume + to.volume;
    to.centroid += from.volume / volume * (from.centroid - to.centroid);
    to.volume = volume;
    into_[i] = target;
    changed_[i] = changed_[target] = round_;
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

  const GridLines& grid_;
  Soil& soil_;
  CellIndex index_;
  std::vector<Index> into_;     // per seed: itself, or the seed it was merged into
  std::vector<Index> next_;     // per seed: the next of its group, in a ring
  std::vector<Index> changed_;  // per seed: the round in which it last took or was taken
  Index round_ = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> smallest_;
  Real h_, half_;
};

}  // namespace

void merge_slivers(const GridLines& grid, const Vec2& spacing, Real slack, Soil& soil) {
  Merger(grid, spacing, slack, soil).run();
}

}  // namespace vbgpd
