#include "analysis/convergence.h"

#include <algorithm>
#include <cmath>

#include "geometry/thickness.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

constexpr double kTwice = 1.8;  // "twice as coarse": lattices that fit key lines differ from that by up to 10 %

double half_bracket(const Level& l) { return (l.srf_unstable - l.srf_stable) / 2; }

/// The finest level at least twice as coarse as `than`, else the coarsest of all if that is coarser; may be null.
const Level* coarser(std::span<const Level> levels, const Level& than) {
  for (auto l = levels.rbegin(); l != levels.rend(); ++l)
    if (spacing_of(*l) >= kTwice * spacing_of(than)) return &*l;
  return spacing_of(levels.front()) > spacing_of(than) ? &levels.front() : nullptr;
}

/// p such that (f1 - f2) / (f2 - f3) = (h1^p - h2^p) / (h2^p - h3^p) for h1 > h2 > h3; the right side grows with p.
double order_of(double ratio, double h1, double h2, double h3) {
  constexpr double kLowest = 0.1, kHighest = 5;
  const auto excess = [&](double p) {
    return (std::pow(h1, p) - std::pow(h2, p)) / (std::pow(h2, p) - std::pow(h3, p)) - ratio;
  };
  double low = kLowest, high = kHighest;
  if (!(excess(low) < 0 && excess(high) > 0)) return kNone;
  for (int n = 0; n < 50; ++n) (excess((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

double extrapolated(const Level& coarse, const Level& fine, double order) {
  const double r = std::pow(spacing_of(coarse) / spacing_of(fine), order);
  return fine.factor_of_safety - (coarse.factor_of_safety - fine.factor_of_safety) / (r - 1);
}

/// What the three grids say about the order, brackets taken at their worst.
struct Order {
  bool known = false, monotonic = true, first = true;
  double value = kNone, ratio = kNone;  ///< the order; of the differences
  bool slow = false;                    ///< the differences shrink less than at first order
};

Order observed(const Level& a, const Level& b, const Level& c) {
  Order o;
  const double d1 = a.factor_of_safety - b.factor_of_safety, d2 = b.factor_of_safety - c.factor_of_safety;
  const double noise1 = half_bracket(a) + half_bracket(b), noise2 = half_bracket(b) + half_bracket(c);
  if (std::fabs(d1) <= noise1 && std::fabs(d2) <= noise2) return o;  // nothing but brackets
  o.known = true;
  o.ratio = d2 != 0 ? d1 / d2 : kNone;
  const double h1 = spacing_of(a), h2 = spacing_of(b), h3 = spacing_of(c);
  // a difference has a sign when it exceeds its noise
  o.monotonic = d1 * d2 > 0 || std::fabs(d1) <= noise1 || std::fabs(d2) <= noise2;
  if (d1 * d2 > 0) o.value = order_of(o.ratio, h1, h2, h3);
  // first order: d1 (h2 - h3) = d2 (h1 - h2), within a third and within the brackets
  const double misfit = std::fabs(d1 * (h2 - h3) - d2 * (h1 - h2));
  const double slack = noise1 * (h2 - h3) + noise2 * (h1 - h2);
  o.slow = o.ratio < (h1 - h2) / (h2 - h3);
  constexpr double kThird = 0.3;
  o.first = misfit <= slack + kThird * std::fabs(d2) * (h1 - h2);
  return o;
}

void refuse(Estimate& e, const Level& fine, const char* status, double error, const std::string& reason) {
  e.status = status, e.value = fine.factor_of_safety, e.error = error;
  e.reason = reason + ": the value of the finest grid is given, not extrapolated";
}

std::string grids_text(std::size_t count) { return "bracketed on " + std::to_string(count) + " grids"; }

void take_third_grid(const Level& third, const Level& coarse, const Level& fine, double noise, Estimate& e) {
  const bool between = spacing_of(third) < spacing_of(coarse);
  const Order order = between ? observed(coarse, third, fine) : observed(third, coarse, fine);
  constexpr double kLow = 0.5, kHigh = 2;  // orders outside say more about the brackets than about the grids
  const double difference = std::fabs(e.value - fine.factor_of_safety);
  const double spread = std::max({third.factor_of_safety, coarse.factor_of_safety, fine.factor_of_safety}) -
                        std::min({third.factor_of_safety, coarse.factor_of_safety, fine.factor_of_safety});
  e.observed_order = order.value;
  if (!order.known) {
    e.error = noise + difference / 2;
    e.reason += "; the grids differ by less than their brackets";
  } else if (!order.monotonic) {
    refuse(e, fine, "NOT_MONOTONIC", spread + noise, "the factors of safety of the grids go up and down");
  } else if (!order.first) {
    // slower than first order, the finest grid is further off than first order says
    const double p = order.slow ? std::max(std::isnan(order.value) ? kLow : order.value, kLow) : 1;
    refuse(e, fine, "NOT_FIRST_ORDER", std::fabs(extrapolated(coarse, fine, p) - fine.factor_of_safety) + noise,
           "the three grids do not differ at first order (ratio of differences " + number_text(order.ratio, 3) + ")");
  } else if (std::isnan(order.value)) {  // differences of other signs within the brackets, or orders next to nothing
    const double slow = order.slow ? std::fabs(extrapolated(coarse, fine, kLow) - e.value) : 0;
    e.error = noise + std::max(difference / 2, slow);
    e.reason += "; what a third grid says of the order cannot be read";
  } else {
    const double p = std::clamp(order.value, kLow, kHigh);
    const double change = std::fabs(extrapolated(coarse, fine, p) - e.value);
    e.error = noise + std::min(change, difference / 2);
    e.reason += ", the order checked on a third grid (" + number_text(order.value, 2) + " observed)";
  }
}

/// What speaks against the extrapolation though the factors of safety do not.
std::string doubt_of(const Level& coarse, const Level& fine) {
  constexpr double kOff = 0.1, kOther = 0.3;
  if (fine.misfit > kOff)
    return "key lines lie up to " + number_text(fine.misfit, 2) +
           " of a coarse cell off the cell edges, so the estimate is widened";
  if (std::fabs(coarse.sliding_area / fine.sliding_area - 1) > kOther)
    return "the mechanism changes (sliding area " + number_text(coarse.sliding_area, 3) + " m2, then " +
           number_text(fine.sliding_area, 3) + " m2), so the estimate is widened";
  return {};
}

}  // namespace

std::vector<Grid> closed_ladder(int levels) {
  const Real half_octave = std::sqrt(Real(2));
  const std::vector<Grid> all = {{4, 1, 1}, {2 * half_octave, 1, 1}, {1, 2, 2}, {half_octave, 1, 1}, {1, 2, 1}};
  if (levels == 1) return {all[4]};
  if (levels == 2) return {all[2], all[4]};
  return {all.end() - levels, all.end()};
}

Grid open_ladder(int n) {
  if (n == 0) return {1, 2, 2};
  // 2, 3, 4, 6, 8, 12, 16 ...
  const int parts = n % 2 == 1 ? 2 << (n / 2) : 3 << (n / 2 - 1);
  return {Real(2) / parts, parts, 1};
}

double spacing_of(const Level& level) { return std::sqrt(level.spacing_x * level.spacing_y); }

Estimate estimate(std::span<const Level> levels, const ThinLayer& thinnest) {
  const Level& fine = levels.back();
  const double half = half_bracket(fine), cells = thinnest.thickness / spacing_of(fine);
  Estimate e;
  // non-associated soil may flow in jerks: the factor strays with them
  const double strays = fine.unsteadiness;
  e.status = "OK", e.value = fine.factor_of_safety, e.error = half + strays;
  e.reason = "bracketed on one grid; the discretisation error is not estimated";
  const Level* const coarse = coarser(levels, fine);
  double difference = 0, noise = half;
  bool rises = false;
  if (coarse != nullptr) {
    e.value = extrapolated(*coarse, fine, 1);
    difference = std::fabs(e.value - fine.factor_of_safety);
    // the brackets enter the extrapolated value: half of each, magnified like the value itself
    const double magnified = 1 / (spacing_of(*coarse) / spacing_of(fine) - 1);
    noise = half * (1 + magnified) + half_bracket(*coarse) * magnified + strays;
    e.error = noise + difference / 2;
    e.reason = grids_text(levels.size()) + " and extrapolated at first order";
    const Level* third = coarser(levels, *coarse);
    for (const Level& l : levels)
      if (third == nullptr && &l != coarse && &l != &fine) third = &l;
    if (third != nullptr) take_third_grid(*third, *coarse, fine, noise, e);
    // Nearly always the finer grid reads lower. Where it reads higher the coarse one has missed something, and there is
    // no order to go by. Carried on upwards at first order, values were up to 2.4 % above rigorous upper bounds.
    const double rise = fine.factor_of_safety - coarse->factor_of_safety;
    rises = third == nullptr && rise > half + half_bracket(*coarse);
    if (rises) {
      e.value = fine.factor_of_safety, e.error = std::max(difference, rise) + noise;
      e.reason =
          grids_text(levels.size()) +
          "; the finer one reads higher, which first order does not explain: its value is given, not extrapolated";
    }
    e.discretisation = true;
    const std::string doubt = e.status == "OK" && !rises ? doubt_of(*coarse, fine) : std::string();
    if (!doubt.empty()) e.error = std::max(e.error, difference + noise), e.reason += "; " + doubt;
  }
  // Bonds as long as a layer is thick know both its sides and nothing of itself. Differences to a grid whose support
  // radius (2.6 spacings) is that long follow no order: the limit may lie anywhere between the value of the finest grid
  // (a high order) and that of first order. The coarse grid has hardly seen the layer and stands too near: below first
  // order lies half as much again.
  constexpr double kSupport = 2.6, kAgain = 1.5;
  if (e.status == "OK" && !rises && coarse != nullptr && cells >= kResolvedCells &&
      thinnest.thickness / spacing_of(*coarse) < kSupport) {
    e.value = (fine.factor_of_safety + e.value) / 2;
    e.error = (kAgain - 0.5) * difference + noise;
    e.reason = grids_text(levels.size()) + "; bonds of the coarser one reach across the layer of '" +
               thinnest.material + "' (" + number_text(thinnest.thickness, 3) +
               " m), so that the order is unknown: the middle between its limits, and the estimate reaches beyond both";
  }
  if (cells < kResolvedCells) {
    refuse(e, fine, "THIN_LAYER", kNone,
           "the layer of '" + thinnest.material + "' is " + number_text(thinnest.thickness, 3) + " m thick, only " +
               number_text(cells, 2) + " spacings of the finest grid (" + number_text(kResolvedCells) +
               " are needed), which hardly sees it: if it is weak, the factor of safety may be far too high");
    e.discretisation = false;
  }
  // The face of soil with next to no cohesion fails as a skin, as thin as the grid allows: half the spacing, half the
  // skin, and nothing that could be extrapolated.
  constexpr double kThinner = 0.85;
  if (e.status != "THIN_LAYER" && fine.sliding_thickness < kSupport * spacing_of(fine)) {
    const std::string only = number_text(fine.sliding_thickness / spacing_of(fine), 2) + " spacings";
    if (coarse == nullptr) e.reason += "; the sliding mass is only " + only + " thick";
    else if (fine.sliding_thickness < kThinner * coarse->sliding_thickness)
      refuse(e, fine, "THIN_SLIDE", std::max(e.error, kAgain * difference + noise),
             "the sliding mass is " + number_text(coarse->sliding_thickness, 2) + " m thick, then " +
                 number_text(fine.sliding_thickness, 2) + " m, only " + only + ": a skin as thin as the grid allows");
  }
  // F_e is a ratio of powers: what the books of the flow leave out may be missing from it
  constexpr double kBooks = 0.01;
  if (fine.energy_residual > kBooks)
    refuse(e, fine, "ENERGY_UNBALANCED", std::max(e.error, fine.energy_residual * fine.factor_of_safety),
           "the energy books of the flow do not close (residual " + number_text(fine.energy_residual, 3) + ")");
  e.error = e.status == "THIN_LAYER" ? kNone : std::max(e.error, half);
  return e;
}

double predicted_seconds(std::span<const Level> levels, double spacing) {
  constexpr double kUsual = 3, kFastest = 4;
  const Level& last = levels.back();
  double power = kUsual;
  if (levels.size() > 1) {
    const Level& before = levels[levels.size() - 2];
    const double seen =
        std::log(last.wall_seconds / before.wall_seconds) / std::log(spacing_of(before) / spacing_of(last));
    if (std::isfinite(seen)) power = std::clamp(seen, kUsual, kFastest);
  }
  return last.wall_seconds * std::pow(spacing_of(last) / spacing, power);
}

}  // namespace vbgpd
