// Columns of dry soil that collapse: how far they run.
#include <algorithm>
#include <cmath>

#include "analysis/job.h"
#include "problem.h"
#include "simulation/flow_simulation.h"

namespace vbgpd::accuracy {

namespace {

/// 99.5 % quantile of x, linear between particles.
double front(const Simulation& simulation) {
  std::vector<double> x;
  const std::vector<double> position = field(simulation, "position");
  for (std::size_t k = 0; k < position.size(); k += 2) x.push_back(position[k]);
  std::sort(x.begin(), x.end());
  const double at = 0.995 * static_cast<double>(x.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  return below + 1 < x.size() ? x[below] + (at - static_cast<double>(below)) * (x[below + 1] - x[below]) : x[below];
}

/// Rough base, smooth wall on the left, released on the right. To rest or 8 sqrt(H / g), whichever is first; the front
/// is compared with `expected`.
Outcome collapse(const SceneDef& choice, const CompileOptions& options, double width, double height,
                 double friction_angle, double young_modulus, double expected) {
  MaterialDef sand = elastic_material();
  sand.law = "drucker_prager", sand.unit_weight = 2650 * choice.gravity, sand.young_modulus = young_modulus;
  sand.cohesion = 0, sand.friction_angle = friction_angle;
  SceneDef s = rectangle(choice, sand, width, height);
  s.boundaries = {held("base", BoundaryKind::kFixed), held("left", BoundaryKind::kRoller)};
  const auto column = make_runout(*Simulation::compile(s, options));
  const auto job = make_runout_job(*column);
  job->set("end_time", 8 * std::sqrt(height / s.gravity));
  job->run(0, {});
  const double run = front(*column) - width;
  const bool ended = job->result().status == "AT_REST" || job->result().status == "TIME_REACHED";
  return outcome(*column, ended ? std::fabs(run / (expected - width) - 1) : std::nan(""), job->result().steps);
}

/// 0.1 m wide; (L - L0) / L0 = 1.2 a, above a = 1.8 1.9 a^(2/3).
Outcome column(const SceneDef& choice, const CompileOptions& options, double aspect) {
  constexpr double kWidth = 0.1, kDensity = 2650;
  const double height = kWidth * aspect, stiffness = 330 * kDensity * choice.gravity * height;
  const double spread = aspect < 1.8 ? 1.2 * aspect : 1.9 * std::pow(aspect, 2.0 / 3);
  return collapse(choice, options, kWidth, height, 30, stiffness, kWidth * (1 + spread));
}
Outcome column_half(const SceneDef& choice, const CompileOptions& options) { return column(choice, options, 0.5); }
Outcome column_1(const SceneDef& choice, const CompileOptions& options) { return column(choice, options, 1); }
Outcome column_2(const SceneDef& choice, const CompileOptions& options) { return column(choice, options, 2); }
Outcome column_4(const SceneDef& choice, const CompileOptions& options) { return column(choice, options, 4); }

/// Aluminium bars (Bui et al. 2008), against the front of this engine at H / 40.
Outcome bars(const SceneDef& choice, const CompileOptions& options) {
  return collapse(choice, options, 0.2, 0.1, 19.8, 0.84e6, 0.3898);
}

constexpr const char* kKind = "relative error of the run-out (q995)";
constexpr const char* kLube = "(L - L0) / L0, experiments of Lube et al. 2005; 50, 200, 800 particles";
constexpr auto kBoth = Schemes::kRunout;
constexpr Problem kProblems[] = {
    {"column_half", kKind, kLube, 0.05, 20, column_half, kBoth},
    {"column_1", kKind, kLube, 0.0707106781, 20, column_1, Schemes::kPairLaws},
    {"column_2", kKind, kLube, 0.1, 20, column_2, kBoth},
    {"column_4", kKind, kLube, 0.141421356, 20, column_4, kBoth},
    {"bars", kKind, "q995 at H / 40 with virtual bonds, tests/validation/runout", 0.1, 20, bars, kBoth},
};

}  // namespace

std::span<const Problem> column_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
