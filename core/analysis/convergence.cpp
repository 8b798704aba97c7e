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

/// What the rules below look at: the finest grid, the one it is extrapolated from and a third one, where they are
/// there.
struct Grids {
  std::size_t count;
  const Level& fine;
  const Level* coarse = nullptr;
  const Level* third = nullptr;
  const SectionFacts& section;
  Real cells;                                  ///< thickness of the thinnest layer, spacings of the finest grid
  double half;                                 ///< half the bracket of the finest grid
  double first_order = kNone, difference = 0;  ///< extrapolated; how far from the value of the finest grid
  /// What the brackets leave open: half of each, magnified as they enter the extrapolated value. Non-associated soil
  /// may flow in jerks: the factor strays with them.
  double noise;
  double rise = 0;  ///< of the finest grid above the coarse one

  Grids(std::span<const Level> levels, const SectionFacts& facts)
      : count(levels.size()),
        fine(levels.back()),
        coarse(coarser(levels, fine)),
        section(facts),
        cells(facts.thinnest.thickness / spacing_of(fine)),
        half(half_bracket(fine)),
        noise(half) {
    if (coarse == nullptr) return;
    third = coarser(levels, *coarse);
    for (const Level& l : levels)
      if (third == nullptr && &l != coarse && &l != &fine) third = &l;
    first_order = extrapolated(*coarse, fine, 1);
    difference = std::fabs(first_order - fine.factor_of_safety);
    const double magnified = 1 / (spacing_of(*coarse) / spacing_of(fine) - 1);
    noise = half * (1 + magnified) + half_bracket(*coarse) * magnified + fine.unsteadiness;
    rise = fine.factor_of_safety - coarse->factor_of_safety;
  }
  /// Grids that agree within their brackets show no order. That two coarse ones do may be luck: 1 % at twenty spacings
  /// over the height, which is what published cases stray by there, and in proportion on finer grids.
  double unseen() const {
    constexpr double kShare = 0.2;
    const double share = !(section.height > 0) ? 0 : kShare * spacing_of(fine) / section.height;
    return difference < noise ? share * fine.factor_of_safety : 0;
  }
  std::string text() const { return "bracketed on " + std::to_string(count) + " grids"; }
};

Estimate of_one_grid(const Grids& g) {
  Estimate e;
  e.status = "OK", e.value = g.fine.factor_of_safety, e.error = g.half + g.fine.unsteadiness;
  e.reason = "bracketed on one grid; the discretisation error is not estimated";
  return e;
}

Estimate of_two_grids(const Grids& g) {
  Estimate e;
  e.status = "OK", e.value = g.first_order, e.error = g.noise + std::max(g.difference / 2, g.unseen());
  e.discretisation = true;
  e.reason = g.text() + " and extrapolated at first order";
  return e;
}

/// Nearly always the finer grid reads lower. Where it reads higher the coarse one has missed something, and there is no
/// order to go by. Carried on upwards at first order, values were up to 2.4 % above rigorous upper bounds.
bool rises(const Grids& g) { return g.rise > g.half + half_bracket(*g.coarse); }
Estimate of_rising_grids(const Grids& g) {
  Estimate e = of_two_grids(g);
  e.value = g.fine.factor_of_safety, e.error = std::max(g.difference, g.rise) + g.noise;
  e.reason = g.text() +
             "; the finer one reads higher, which first order does not explain: its value is given, not extrapolated";
  return e;
}

/// An estimate of two grids, with what the third says of the order.
void take_third_grid(const Grids& g, Estimate& e) {
  const Level &third = *g.third, &coarse = *g.coarse, &fine = g.fine;
  const bool between = spacing_of(third) < spacing_of(coarse);
  const Order order = between ? observed(coarse, third, fine) : observed(third, coarse, fine);
  constexpr double kLow = 0.5, kHigh = 2;  // orders outside say more about the brackets than about the grids
  const double spread = std::max({third.factor_of_safety, coarse.factor_of_safety, fine.factor_of_safety}) -
                        std::min({third.factor_of_safety, coarse.factor_of_safety, fine.factor_of_safety});
  e.observed_order = order.value;
  if (!order.known) {
    e.error = g.noise + std::max(g.difference / 2, g.unseen());
    e.reason += "; the grids differ by less than their brackets";
  } else if (!order.monotonic) {
    refuse(e, fine, "NOT_MONOTONIC", spread + g.noise, "the factors of safety of the grids go up and down");
  } else if (!order.first) {
    // slower than first order, the finest grid is further off than first order says
    const double p = order.slow ? std::max(std::isnan(order.value) ? kLow : order.value, kLow) : 1;
    refuse(e, fine, "NOT_FIRST_ORDER", std::fabs(extrapolated(coarse, fine, p) - fine.factor_of_safety) + g.noise,
           "the three grids do not differ at first order (ratio of differences " + number_text(order.ratio, 3) + ")");
  } else if (std::isnan(order.value)) {  // differences of other signs within the brackets, or orders next to nothing
    const double slow = order.slow ? std::fabs(extrapolated(coarse, fine, kLow) - e.value) : 0;
    e.error = g.noise + std::max(g.difference / 2, slow);
    e.reason += "; what a third grid says of the order cannot be read";
  } else {
    const double p = std::clamp(order.value, kLow, kHigh);
    const double change = std::fabs(extrapolated(coarse, fine, p) - e.value);
    e.error = g.noise + std::min(change, g.difference / 2);
    e.reason += ", the order checked on a third grid (" + number_text(order.value, 2) + " observed)";
  }
}

constexpr double kAgain = 1.5;  // times what was extrapolated, where the coarse grid stands too near

/// Bonds as long as a layer is thick know both its sides and nothing of itself. Differences to a grid whose support
/// radius is that long follow no order: the limit may lie anywhere between the value of the finest grid (a high order)
/// and that of first order. The coarse grid has hardly seen the layer and stands too near: below first order lies half
/// as much again.
bool spans_a_layer(const Grids& g) { return g.section.thinnest.thickness / spacing_of(*g.coarse) < g.section.support; }
void stay_in_the_middle(const Grids& g, Estimate& e) {
  e.value = (g.fine.factor_of_safety + e.value) / 2;
  e.error = (kAgain - 0.5) * g.difference + g.noise;
  e.reason = g.text() + "; bonds of the coarser one reach across the layer of '" + g.section.thinnest.material + "' (" +
             number_text(g.section.thinnest.thickness, 3) +
             " m), so that the order is unknown: the middle between its limits, and the estimate reaches beyond both";
}

/// What speaks against the extrapolation though the factors of safety do not.
void widen_where_in_doubt(const Grids& g, Estimate& e) {
  constexpr double kOff = 0.1, kOther = 0.3;
  const double area = g.fine.sliding_area, coarse_area = g.coarse->sliding_area;
  std::string doubt;
  if (g.fine.misfit > kOff)
    doubt = "key lines lie up to " + number_text(g.fine.misfit, 2) + " of a coarse cell off the cell edges";
  else if (std::fabs(coarse_area / area - 1) > kOther)
    doubt = "the mechanism changes (sliding area " + number_text(coarse_area, 3) + " m2, then " + number_text(area, 3) +
            " m2)";
  else return;
  e.error = std::max(e.error, g.difference + g.noise), e.reason += "; " + doubt + ", so the estimate is widened";
}

/// Soil that bears no tension comes apart column by column, the finer the grid the sooner: finer grids may read lower
/// than first order says.
void widen_where_tension_is_cut_off(const Grids& g, Estimate& e) {
  const double error = kAgain * g.difference + g.noise;
  if (!g.section.cut_off || !(error > e.error)) return;
  e.error = error;
  e.reason += "; soil with a tension cut-off may bear still less on finer grids, so the estimate is widened";
}

/// Half the spacing, and the slope bears a fifth less: what it tends to cannot be told from two such grids.
void refuse_far_apart(const Grids& g, Estimate& e) {
  constexpr double kApart = 0.2;
  if (e.status != "OK" || g.third != nullptr || !(g.difference > kApart * g.fine.factor_of_safety)) return;
  refuse(e, g.fine, "TOO_COARSE", kAgain * g.difference + g.noise,
         "the two grids are " + number_text(std::round(100 * g.difference / g.fine.factor_of_safety)) + " % apart");
}

/// What the factors of safety of the grids say by themselves.
Estimate reading_of(const Grids& g) {
  if (g.coarse == nullptr) return of_one_grid(g);
  if (g.third == nullptr && rises(g)) return of_rising_grids(g);
  Estimate e = of_two_grids(g);
  if (g.third != nullptr) take_third_grid(g, e);
  if (e.status != "OK") return e;
  if (spans_a_layer(g)) {
    stay_in_the_middle(g, e);
    return e;
  }
  widen_where_in_doubt(g, e);
  widen_where_tension_is_cut_off(g, e);
  refuse_far_apart(g, e);
  return e;
}

void refuse_unresolved_layer(const Grids& g, Estimate& e) {
  refuse(e, g.fine, "THIN_LAYER", kNone,
         "the layer of '" + g.section.thinnest.material + "' is " + number_text(g.section.thinnest.thickness, 3) +
             " m thick, only " + number_text(g.cells, 2) + " spacings of the finest grid (" +
             number_text(kResolvedCells) +
             " are needed), which hardly sees it: if it is weak, the factor of safety may be far too high");
  e.discretisation = false;
}

/// The face of soil with next to no cohesion fails as a skin, as thin as the grid allows: half the spacing, half the
/// skin, and nothing that could be extrapolated.
void refuse_skin(const Grids& g, Estimate& e) {
  constexpr double kThinner = 0.9;  // dry faces of sand: 0.51 to 0.86
  if (!(g.fine.sliding_thickness < g.section.support * spacing_of(g.fine))) return;
  const std::string only = number_text(g.fine.sliding_thickness / spacing_of(g.fine), 2) + " spacings";
  if (g.coarse == nullptr) e.reason += "; the sliding mass is only " + only + " thick";
  else if (g.fine.sliding_thickness < kThinner * g.coarse->sliding_thickness)
    refuse(e, g.fine, "THIN_SLIDE", std::max(e.error, kAgain * g.difference + g.noise),
           "the sliding mass is " + number_text(g.coarse->sliding_thickness, 2) + " m thick, then " +
               number_text(g.fine.sliding_thickness, 2) + " m, only " + only + ": a skin as thin as the grid allows");
}

/// F_e is a ratio of powers: what the books of the flow leave out may be missing from it.
void refuse_open_books(const Grids& g, Estimate& e) {
  constexpr double kBooks = 0.01;
  if (!(g.fine.energy_residual > kBooks)) return;
  refuse(e, g.fine, "ENERGY_UNBALANCED", std::max(e.error, g.fine.energy_residual * g.fine.factor_of_safety),
         "the energy books of the flow do not close (residual " + number_text(g.fine.energy_residual, 3) + ")");
}

/// Undrained soil that is sheared slowly hardens without end: how much it bears depends on how far it is let go.
void say_that_it_hardens(const Grids& g, Estimate& e) {
  constexpr double kSlight = 0.005;
  const double share = g.fine.hardening / g.fine.factor_of_safety;
  if (share > kSlight)
    e.reason += "; the failing slope still hardens: let go as far again it would bear some " +
                number_text(100 * share, 2) + " % more";
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

Estimate estimate(std::span<const Level> levels, const SectionFacts& section) {
  const Grids g(levels, section);
  Estimate e = reading_of(g);
  const bool unresolved = g.cells < kResolvedCells;
  if (unresolved) refuse_unresolved_layer(g, e);
  else refuse_skin(g, e);
  refuse_open_books(g, e);
  say_that_it_hardens(g, e);
  e.error = unresolved ? kNone : std::max(e.error, g.half);
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
