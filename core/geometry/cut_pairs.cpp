#include "geometry/cut_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vbgpd {
namespace {

constexpr Real kAir = 0.25;  // of the smaller spacing: a shorter piece outside is no gap
constexpr Real kSoil = 0.1;  // of the smaller spacing: less soil than this at an end only grazes

// Where along p-q (0..1) the segment a-b meets it.
std::optional<Real> crossing(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  const Vec2 r = q - p, s = b - a;
  const Real det = cross(r, s);
  if (det == 0) return std::nullopt;
  const Real t = cross(a - p, s) / det, u = cross(a - p, r) / det;
  if (t < 0 || t > 1 || u < -1e-9 || u > 1 + 1e-9) return std::nullopt;
  return t;
}

class AirFinder {
 public:
  AirFinder(const Vertices& exterior, const std::vector<HeldEdge>& held, const std::vector<Seed>& seeds,
            const Vertices& places, const Vec2& spacing, Real support)
      : exterior_(exterior),
        held_(held),
        seeds_(seeds),
        places_(places),
        index_(seeds),
        spacing_(spacing),
        h_(spacing.minCoeff()),
        support_(support),
        reach_(static_cast<Index>(std::ceil(support + 2 * farthest(seeds, places, spacing)))) {}

  std::vector<CutPair> run() {
    collect_near();
    std::vector<CutPair> result;
    for (std::size_t begin = 0, end = 0; begin < near_.size(); begin = end) {
      while (end < near_.size() && near_[end].first == near_[begin].first) ++end;
      test_seed(near_[begin].first, begin, end, result);
    }
    std::sort(result.begin(), result.end(),
              [](const CutPair& a, const CutPair& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; });
    return result;
  }

 private:
  using Near = std::pair<Index, Index>;  // seed, edge of the exterior

  const Vec2& vertex(std::size_t i) const { return exterior_[i % exterior_.size()]; }
  // How far, in spacings, particles are from the centres of their cells.
  static Real farthest(const std::vector<Seed>& seeds, const Vertices& places, const Vec2& spacing) {
    Real most = 0;
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      const Vec2 center(seeds[k].ix + 0.5, seeds[k].iy + 0.5);
      most = std::max(most, (places[k].cwiseQuotient(spacing) - center).cwiseAbs().maxCoeff());
    }
    return most > 1e-9 ? most : 0;
  }
  Index cell(Real at, int axis) const { return static_cast<Index>(std::floor(at / spacing_[axis])); }

  // Seeds within reach of each edge: cells along its longer axis (in cells), with room for the slant.
  void collect_near() {
    for (std::size_t e = 0; e < exterior_.size(); ++e) {
      const Vec2 &a = vertex(e), &b = vertex(e + 1);
      const Vec2 cells = (b - a).cwiseQuotient(spacing_).cwiseAbs();
      const int axis = cells.x() >= cells.y() ? 0 : 1, other = 1 - axis;
      if (!(cells[axis] > 0)) continue;
      const Real slope = (b[other] - a[other]) / (b[axis] - a[axis]);
      const Real low = std::min(a[axis], b[axis]), high = std::max(a[axis], b[axis]);
      for (Index i = cell(low, axis) - reach_; i <= cell(high, axis) + reach_; ++i) {
        const Real at = std::clamp((i + 0.5) * spacing_[axis], low, high);
        const Index middle = cell(a[other] + slope * (at - a[axis]), other);
        for (Index j = middle - reach_ - 1; j <= middle + reach_ + 1; ++j) {
          const Index seed = axis == 0 ? index_.find(i, j) : index_.find(j, i);
          if (seed >= 0) near_.emplace_back(seed, static_cast<Index>(e));
        }
      }
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

  void test_seed(Index i, std::size_t begin, std::size_t end, std::vector<CutPair>& result) {
    const Seed& seed = seeds_[i];
    for (Index dx = 0; dx <= reach_; ++dx)
      for (Index dy = dx == 0 ? 1 : -reach_; dy <= reach_; ++dy) {
        const Index j = index_.find(seed.ix + dx, seed.iy + dy);
        if (j < 0 || (seed.hold != Hold::kFree && seeds_[j].hold != Hold::kFree)) continue;
        const Vec2 &p = places_[i], &q = places_[j];
        if (!((q - p).cwiseQuotient(spacing_).squaredNorm() < support_ * support_)) continue;
        if (through_air(p, q, begin, end)) result.push_back({i, j});
      }
  }

  bool through_air(const Vec2& p, const Vec2& q, std::size_t begin, std::size_t end) {
    at_.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t e = near_[k].second;
      if (const auto t = crossing(p, q, vertex(e), vertex(e + 1))) at_.push_back(*t);
    }
    if (at_.size() < 2) return false;
    std::sort(at_.begin(), at_.end());
    const Real length = (q - p).norm(), air = kAir * h_, soil = kSoil * h_;
    for (std::size_t k = 0; k + 1 < at_.size(); ++k) {
      const Real t0 = at_[k], t1 = at_[k + 1];
      if ((t1 - t0) * length <= air || t0 * length <= soil || (1 - t1) * length <= soil) continue;
      if (contains(exterior_, p + (t0 + t1) / 2 * (q - p))) continue;
      if (!is_held(p + t0 * (q - p)) && !is_held(p + t1 * (q - p))) return true;
    }
    return false;
  }

  bool is_held(const Vec2& p) const {
    return std::any_of(held_.begin(), held_.end(),
                       [&](const HeldEdge& e) { return distance_to_segment(p, e.a, e.b) <= 1e-6 * h_; });
  }

  const Vertices& exterior_;
  const std::vector<HeldEdge>& held_;
  const std::vector<Seed>& seeds_;
  const Vertices& places_;
  CellIndex index_;
  Vec2 spacing_;
  Real h_, support_;
  Index reach_;  // cells: longer than any pair
  std::vector<Near> near_;
  std::vector<Real> at_;
};

}  // namespace

std::vector<CutPair> cut_pairs(const Vertices& exterior, const std::vector<HeldEdge>& held,
                               const std::vector<Seed>& seeds, const Vertices& places, const Vec2& spacing,
                               Real support) {
  if (is_convex(exterior)) return {};
  return AirFinder(exterior, held, seeds, places, spacing, support).run();
}

}  // namespace vbgpd
