// Standing waves in a box with smooth walls, whose frequencies are exact, and the patch test.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem.h"

namespace vbgpd::accuracy {

namespace {

constexpr double kSide = 10, kWaveNumber = std::numbers::pi / kSide;

/// Smooth walls all round, no weight.
SceneDef box(const SceneDef& choice) {
  SceneDef s = rectangle(choice, elastic_material(), kSide, kSide);
  BoundaryDef top;
  top.polyline = {{0, kSide}, {kSide, kSide}}, top.kind = BoundaryKind::kRoller;
  s.boundaries = {held("base", BoundaryKind::kRoller), held("left", BoundaryKind::kRoller),
                  held("right", BoundaryKind::kRoller), top};
  s.kv = kNoWeight;
  return s;
}

using Mode = Vec2 (*)(double x, double y);
Vec2 compression(double x, double) { return {std::sin(kWaveNumber * x), 0}; }
/// Without change of volume and without shear on the walls.
Vec2 shear(double x, double y) {
  return {std::sin(kWaveNumber * x) * std::cos(kWaveNumber * y),
          -std::cos(kWaveNumber * x) * std::sin(kWaveNumber * y)};
}

/// Period of a mode, from the first two zeros of the velocity in that mode, against the exact one.
Outcome period(const SceneDef& choice, const CompileOptions& options, Mode mode, double exact) {
  const auto simulation = Simulation::compile(box(choice), options);
  const std::vector<double> x = field(*simulation, "reference_position"), mass = field(*simulation, "mass");
  std::vector<double> shape(x.size());
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const Vec2 v = mode(x[2 * i], x[2 * i + 1]);
    shape[2 * i] = v.x(), shape[2 * i + 1] = v.y();
  }
  std::vector<double> start = shape;
  for (double& v : start) v *= 1e-3;
  simulation->write(find_field("velocity"), start);
  const auto amplitude = [&] {
    const std::vector<double> v = field(*simulation, "velocity");
    double sum = 0;
    for (std::size_t k = 0; k < v.size(); ++k) sum += mass[k / 2] * v[k] * shape[k];
    return sum;
  };
  const double step = simulation->get("time_step");
  std::vector<double> zeros;
  std::int64_t steps = 0;
  for (double before = amplitude(); zeros.size() < 2 && static_cast<double>(steps) * step < 3 * exact; ++steps) {
    simulation->step(1, nullptr);
    const double now = amplitude();
    if ((before > 0) != (now > 0)) zeros.push_back(step * (static_cast<double>(steps) + before / (before - now)));
    before = now;
  }
  const double found = zeros.size() < 2 ? std::nan("") : 2 * (zeros[1] - zeros[0]);
  return outcome(*simulation, std::fabs(found / exact - 1), steps);
}

double density() { return elastic_material().unit_weight / SceneDef().gravity; }
double shear_modulus() {
  const MaterialDef m = elastic_material();
  return m.young_modulus / (2 * (1 + m.poisson_ratio));
}

Outcome wave_compression(const SceneDef& choice, const CompileOptions& options) {
  const double nu = elastic_material().poisson_ratio, modulus = shear_modulus() * 2 * (1 - nu) / (1 - 2 * nu);
  return period(choice, options, compression, 2 * kSide / std::sqrt(modulus / density()));
}

Outcome wave_shear(const SceneDef& choice, const CompileOptions& options) {
  return period(choice, options, shear, std::numbers::sqrt2 * kSide / std::sqrt(shear_modulus() / density()));
}

/// One step of a free body with a linear velocity field: displacements are linear, stress must be uniform.
Outcome patch(const SceneDef& choice, const CompileOptions& options) {
  SceneDef s = rectangle(choice, elastic_material(), kSide, kSide);
  s.exterior = {{0, 0}, {kSide, 0}, {0.7 * kSide, 0.8 * kSide}, {0, kSide}};  // with an inclined free surface
  s.kv = kNoWeight;
  const auto simulation = Simulation::compile(s, options);
  const double xx = 3e-3, xy = 5e-3, yx = -2e-3, yy = -7e-3;  // 1/s
  std::vector<double> velocity = field(*simulation, "reference_position");
  for (std::size_t k = 0; k < velocity.size(); k += 2) {
    const double x = velocity[k], y = velocity[k + 1];
    velocity[k] = xx * x + xy * y, velocity[k + 1] = yx * x + yy * y;
  }
  simulation->write(find_field("velocity"), velocity);
  simulation->step(1, nullptr);
  const double nu = s.materials[0].poisson_ratio, g = shear_modulus() * simulation->get("time_step");
  const double lame = 2 * nu / (1 - 2 * nu) * g * (xx + yy);
  const double exact[4] = {2 * g * xx + lame, 2 * g * yy + lame, lame, g * (xy + yx)};
  const std::vector<double> stress = field(*simulation, "stress");
  double worst = 0;
  for (std::size_t k = 0; k < stress.size(); ++k) worst = std::max(worst, std::fabs(stress[k] - exact[k % 4]));
  return outcome(*simulation, worst / std::fabs(exact[1]), 1);
}

constexpr const char* kPeriod = "relative error of the period";
constexpr Problem kProblems[] = {
    {"patch", "largest stress error / stress", "uniform stress of a linear field, closed form", kSide, 20, patch},
    {"wave_compression", kPeriod, "2 L / c_p, closed form", kSide, 40, wave_compression},
    {"wave_shear", kPeriod, "sqrt(2) L / c_s, closed form", kSide, 40, wave_shear},
};

}  // namespace

std::span<const Problem> wave_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
