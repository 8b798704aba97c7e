// Closed forms of elasticity: a column under its own weight, at rest and swinging.
#include <cmath>
#include <numbers>
#include <vector>

#include "problem.h"

namespace vbgpd::accuracy {

namespace {

constexpr double kHeight = 10, kUnitWeight = 20e3, kYoung = 1e8, kPoisson = 0.3, kGravity = 9.80665;
constexpr double kModulus = kYoung * (1 - kPoisson) / ((1 + kPoisson) * (1 - 2 * kPoisson));

/// A block with smooth sides on a fixed base: one-dimensional compression.
SceneDef column(const SceneDef& choice) {
  SceneDef s = rectangle(choice, elastic_material(), kHeight / 2, kHeight);
  s.boundaries = {held("base", BoundaryKind::kFixed), held("left", BoundaryKind::kRoller),
                  held("right", BoundaryKind::kRoller)};
  s.gravity = kGravity;
  return s;
}

std::vector<double> heights(const Simulation& simulation) {
  std::vector<double> y;
  const std::vector<double> position = field(simulation, "reference_position");
  for (std::size_t i = 1; i < position.size(); i += 2) y.push_back(position[i]);
  return y;
}

/// Root mean square of sigma_yy - gamma (y - H) over the soil, in units of gamma H.
Outcome column_stress(const SceneDef& choice, const CompileOptions& options) {
  const auto simulation = Simulation::compile(column(choice), options);
  const std::int64_t steps = relax_to_rest(*simulation);
  const std::vector<double> y = heights(*simulation), stress = field(*simulation, "stress");
  double sum = 0;
  std::size_t soil = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(y[i] > 0 && y[i] < kHeight)) continue;
    const double off = stress[4 * i + 1] - kUnitWeight * (y[i] - kHeight);
    sum += off * off, ++soil;
  }
  return outcome(*simulation, std::sqrt(sum / static_cast<double>(soil)) / (kUnitWeight * kHeight), steps);
}

/// Largest error of u_y = gamma (y^2/2 - H y) / M, in units of the settlement of the surface gamma H^2 / 2 M.
Outcome column_settlement(const SceneDef& choice, const CompileOptions& options) {
  const auto simulation = Simulation::compile(column(choice), options);
  const std::int64_t steps = relax_to_rest(*simulation);
  const std::vector<double> y = heights(*simulation), u = field(*simulation, "displacement");
  const double surface = kUnitWeight * kHeight * kHeight / (2 * kModulus);
  double worst = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(y[i] > 0 && y[i] < kHeight)) continue;
    const double exact = kUnitWeight * (y[i] * y[i] / 2 - kHeight * y[i]) / kModulus;
    worst = std::max(worst, std::fabs(u[2 * i + 1] - exact));
  }
  return outcome(*simulation, worst / surface, steps);
}

/// Gravity switched on at once: the column swings with T = 4 H / c_p. First return of the top row to where it began,
/// located by the zero of its velocity, against T (first mode 96 % of the motion, all modes return at T).
Outcome column_period(const SceneDef& choice, const CompileOptions& options) {
  const auto simulation = Simulation::compile(column(choice), options);
  const std::vector<double> y = heights(*simulation);
  std::size_t top = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (y[i] < kHeight && (y[top] > kHeight || y[i] > y[top])) top = i;
  const double period = 4 * kHeight / std::sqrt(kModulus / (kUnitWeight / kGravity));
  const double step = simulation->get("time_step");
  // the middle of the swing: largest displacement at T/2; its time from a parabola through the three largest values
  std::int64_t steps = 0;
  double before = 0, now = 0, time = 0, found = std::nan("");
  while (time < 0.8 * period) {
    simulation->step(1, nullptr);
    ++steps, time += step;
    const double next = -field(*simulation, "displacement")[2 * top + 1];
    if (time > 0.3 * period && now > before && now >= next) {
      const double shift = 0.5 * (before - next) / (before - 2 * now + next);
      found = 2 * (time - step + shift * step);
      break;
    }
    before = now, now = next;
  }
  return outcome(*simulation, std::fabs(found / period - 1), steps);
}

constexpr Problem kProblems[] = {
    {"column_stress", "RMS of sigma_yy / gamma H", "gamma (H - y), closed form", kHeight, 40, column_stress},
    {"column_settlement", "largest displacement error / surface settlement", "gamma H^2 / 2 M, closed form", kHeight,
     40, column_settlement},
    {"column_period", "relative error of the period", "4 H / c_p, closed form", kHeight, 40, column_period},
};

}  // namespace

std::span<const Problem> elastic_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
