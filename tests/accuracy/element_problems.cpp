// Compression of a block between smooth plates under the load that its closed-form strength carries: FS = 1.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "problem.h"

namespace vbgpd::accuracy {

namespace {

constexpr double kWidth = 5, kHeight = 10, kCohesion = 1e4, kFriction = 30;
constexpr double kCoulomb = 45 + kFriction / 2, kRoscoe = 45;  // degrees, dilatancy 0

/// `cell_pressure` acts all round by suction of the pore water, as in a sample under vacuum; the rest comes from above.
std::unique_ptr<Simulation> sample(const SceneDef& choice, const CompileOptions& options, const char* law,
                                   double cell_pressure) {
  MaterialDef soil = elastic_material();
  soil.law = law, soil.unit_weight = 0, soil.cohesion = kCohesion, soil.friction_angle = kFriction;
  SceneDef s = rectangle(choice, soil, kWidth, kHeight);
  s.boundaries = {held("base", BoundaryKind::kRoller), held("left", BoundaryKind::kRoller)};
  const double angle = kFriction * std::numbers::pi / 180, n = (1 + std::sin(angle)) / (1 - std::sin(angle));
  const double from_above = cell_pressure * (n - 1) + 2 * kCohesion * std::sqrt(n);
  s.loads = {{0, kWidth, from_above, from_above}};
  auto simulation = Simulation::compile(s, options);
  if (cell_pressure > 0)
    simulation->write(find_field("pore_pressure"),
                      std::vector<double>(static_cast<std::size_t>(simulation->particle_count()), -cell_pressure));
  return simulation;
}

Outcome compression(const SceneDef& choice, const CompileOptions& options, const char* law, double cell_pressure) {
  return factor_of_safety_error(*sample(choice, options, law, cell_pressure), 1);
}

Outcome uniaxial(const SceneDef& choice, const CompileOptions& options) {
  return compression(choice, options, "mohr_coulomb", 0);
}
Outcome biaxial_mohr_coulomb(const SceneDef& choice, const CompileOptions& options) {
  return compression(choice, options, "mohr_coulomb", 1e5);
}
Outcome biaxial_drucker_prager(const SceneDef& choice, const CompileOptions& options) {
  return compression(choice, options, "drucker_prager", 1e5);
}

/// Inclination of the band in the failed sample: a straight line through the place of the largest plastic strain of
/// every row that has a third of the largest of all. 1 = as steep as Coulomb's band or as flat as Roscoe's.
Outcome shear_band(const SceneDef& choice, const CompileOptions& options) {
  const auto simulation = sample(choice, options, "mohr_coulomb", 1e5);
  Outcome out = factor_of_safety_error(*simulation, 1);
  const std::vector<double> x = field(*simulation, "reference_position"), boundary = field(*simulation, "boundary"),
                            strain = field(*simulation, "plastic_strain");
  struct Place {
    double x, strain;
  };
  std::map<double, Place> rows;
  double largest = 0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (boundary[i] >= 0) continue;
    Place& most = rows.try_emplace(x[2 * i + 1], Place{x[2 * i], strain[i]}).first->second;
    if (strain[i] > most.strain) most = {x[2 * i], strain[i]};
    largest = std::max(largest, strain[i]);
  }
  std::erase_if(rows, [&](const auto& row) { return row.second.strain < largest / 3; });
  double mean_x = 0, mean_y = 0, yy = 0, xy = 0;
  for (const auto& [y, most] : rows) mean_x += most.x / rows.size(), mean_y += y / rows.size();
  for (const auto& [y, most] : rows) yy += std::pow(y - mean_y, 2), xy += (y - mean_y) * (most.x - mean_x);
  const double angle = std::atan(std::fabs(yy / xy)) * 180 / std::numbers::pi;
  out.error = std::fabs(angle - (kCoulomb + kRoscoe) / 2) / ((kCoulomb - kRoscoe) / 2);
  return out;
}

constexpr const char* kKind = "|FS / exact - 1|";
constexpr Problem kProblems[] = {
    {"uniaxial", kKind, "2 c cos phi / (1 - sin phi), closed form; rungs of the width", kWidth, 20, uniaxial},
    {"biaxial_mohr_coulomb", kKind, "s3 N + 2 c sqrt(N), closed form", kWidth, 20, biaxial_mohr_coulomb},
    {"biaxial_drucker_prager", kKind, "as before, cone matched for psi = 0", kWidth, 20, biaxial_drucker_prager},
    {"shear_band", "|angle - 52.5| / 7.5 degrees", "between Roscoe's 45 and Coulomb's 60 degrees", kWidth, 40,
     shear_band},
};

}  // namespace

std::span<const Problem> element_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
