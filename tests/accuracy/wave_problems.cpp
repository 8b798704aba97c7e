// Standing waves in a box with smooth walls, whose frequencies are exact, a plate that swings, and the patch test.
#include <algorithm>
#include <cmath>
#include <functional>
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

using Mode = std::function<Vec2(double x, double y)>;
Vec2 compression(double x, double) { return {std::sin(kWaveNumber * x), 0}; }
/// Without change of volume and without shear on the walls.
Vec2 shear(double x, double y) {
  return {std::sin(kWaveNumber * x) * std::cos(kWaveNumber * y),
          -std::cos(kWaveNumber * x) * std::sin(kWaveNumber * y)};
}

/// Period of a mode, from the first two zeros of the velocity in that mode, against the exact one.
Outcome period(const SceneDef& scene, const CompileOptions& options, const Mode& mode, double exact) {
  const auto simulation = Simulation::compile(scene, options);
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
  return period(box(choice), options, compression, 2 * kSide / std::sqrt(modulus / density()));
}

Outcome wave_shear(const SceneDef& choice, const CompileOptions& options) {
  return period(box(choice), options, shear, std::numbers::sqrt2 * kSide / std::sqrt(shear_modulus() / density()));
}

/// b of Timoshenko's cantilever of height / length 1 / 10 in plane strain, its first mode: w = b / L^2 sqrt(E' I / rho
/// A) (Huang 1961, shear factor 5 / 6); 0.8 % below the 3.516 of the thin plate.
double timoshenko_root() {
  const double nu = elastic_material().poisson_ratio, r2 = 0.01 / 12, s2 = r2 * 2 * (1 + nu) / (1 - nu * nu) * 6 / 5;
  const auto equation = [&](double b) {
    const double root = std::sqrt((r2 - s2) * (r2 - s2) + 4 / (b * b));
    const double p = b * std::sqrt((root - r2 - s2) / 2), q = b * std::sqrt((root + r2 + s2) / 2);
    return 2 + (b * b * (r2 - s2) * (r2 - s2) + 2) * std::cosh(p) * std::cos(q) -
           b * (r2 + s2) / std::sqrt(1 - b * b * r2 * s2) * std::sinh(p) * std::sin(q);
  };
  double low = 3, high = 3.6;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (equation(low) * equation(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

/// A plate clamped on the left, set off in its first mode.
Outcome plate(const SceneDef& choice, const CompileOptions& options) {
  constexpr double kLength = 10, kThickness = 1, kRoot = 1.8751;  // of cos kL cosh kL = -1
  SceneDef s = rectangle(choice, elastic_material(), kLength, kThickness);
  s.boundaries = {held("left", BoundaryKind::kFixed)};
  s.kv = kNoWeight;
  const auto mode = [](double x, double) -> Vec2 {
    const double m = std::sin(kRoot) + std::sinh(kRoot), n = std::cos(kRoot) + std::cosh(kRoot);
    const double k = kRoot * x / kLength;
    return {0, x > 0 ? n * (std::sin(k) - std::sinh(k)) - m * (std::cos(k) - std::cosh(k)) : 0};
  };
  const double nu = elastic_material().poisson_ratio;
  const double stiffness = elastic_material().young_modulus / (1 - nu * nu) * kThickness * kThickness / 12;
  const double frequency = timoshenko_root() / (kLength * kLength) * std::sqrt(stiffness / density());
  return period(s, options, mode, 2 * std::numbers::pi / frequency);
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
    {"plate_period", kPeriod, "first mode of Timoshenko's cantilever, L = 10 h, Huang 1961; rungs of h", 1, 20, plate},
};

}  // namespace

std::span<const Problem> wave_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
