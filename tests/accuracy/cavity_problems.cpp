// Round sections, a quarter of each between rollers: a cavity under pressure, elastic and at its limit, and a disk that
// turns.
#include <cmath>
#include <numbers>

#include "problem.h"

namespace vbgpd::accuracy {

namespace {

constexpr double kInner = 1, kOuter = 2;
constexpr int kChords = 64;  // of a quarter circle

void add_arc(Polygon& polygon, double radius, bool upwards) {
  for (int k = 0; k <= kChords; ++k) {
    const double angle = std::numbers::pi / 2 * (upwards ? k : kChords - k) / kChords;
    // the ends exactly on the axes, where the rollers are
    polygon.push_back({k == (upwards ? kChords : 0) ? 0 : radius * std::cos(angle),
                       k == (upwards ? 0 : kChords) ? 0 : radius * std::sin(angle)});
  }
}

/// A quarter of a ring, of a disk when `inner` is 0; weightless.
SceneDef quarter(const SceneDef& choice, MaterialDef material, double inner) {
  material.unit_weight = 0;
  SceneDef s = rectangle(choice, material, 1, 1);
  s.exterior.clear();
  add_arc(s.exterior, kOuter, true);
  if (inner > 0) add_arc(s.exterior, inner, false);
  else s.exterior.push_back({0, 0});
  BoundaryDef below, left;
  below.kind = left.kind = BoundaryKind::kRoller;
  below.polyline = {{inner, 0}, {kOuter, 0}}, left.polyline = {{0, kOuter}, {0, inner}};
  s.boundaries = {below, left};
  return s;
}

/// Body force of `density` (N/m4) times the distance from the centre, on the soil alone: rollers let walls slide along.
void pull_outwards(Simulation& simulation, double density) {
  std::vector<double> force = field(simulation, "reference_position");
  const std::vector<double> volume = field(simulation, "volume"), boundary = field(simulation, "boundary");
  for (std::size_t k = 0; k < force.size(); ++k) force[k] *= boundary[k / 2] < 0 ? density * volume[k / 2] : 0;
  simulation.write(find_field("external_force"), force);
}

/// Pressure on the wall of the cavity. A pore pressure of -pressure there that fades to nothing at the outer circle
/// loads both free surfaces as it should, by the normals of the discretisation itself; a body force cancels its
/// gradient, and what is left for the soil is the pressure on the wall.
void press_cavity(Simulation& simulation, double pressure) {
  const std::vector<double> x = field(simulation, "reference_position");
  const double area = kOuter * kOuter - kInner * kInner;
  std::vector<double> water(x.size() / 2);
  for (std::size_t i = 0; i < water.size(); ++i)
    water[i] = -pressure * (kOuter * kOuter - x[2 * i] * x[2 * i] - x[2 * i + 1] * x[2 * i + 1]) / area;
  simulation.write(find_field("pore_pressure"), water);
  pull_outwards(simulation, 2 * pressure / area);
}

Outcome cavity_stress(const SceneDef& choice, const CompileOptions& options) {
  constexpr double kPressure = 1e5, kShare = kPressure * kInner * kInner / (kOuter * kOuter - kInner * kInner);
  const auto simulation = Simulation::compile(quarter(choice, elastic_material(), kInner), options);
  press_cavity(*simulation, kPressure);
  const std::int64_t steps = relax_to_rest(*simulation);
  const double error = polar_stress_error(
      *simulation, {0, 0}, kPressure, [](double r) { return kShare * (1 - kOuter * kOuter / (r * r)); },
      [](double r) { return kShare * (1 + kOuter * kOuter / (r * r)); });
  return outcome(*simulation, error, steps);
}

Outcome cavity_limit(const SceneDef& choice, const CompileOptions& options, int levels) {
  MaterialDef clay = elastic_material();
  clay.law = "undrained", clay.cohesion = 1e4;
  const auto simulation = Simulation::compile(quarter(choice, clay, kInner), options);
  press_cavity(*simulation, 2 * clay.cohesion * std::log(kOuter / kInner));
  return factor_of_safety_error(*simulation, levels);
}
Outcome cavity_limit_1(const SceneDef& choice, const CompileOptions& options) {
  return cavity_limit(choice, options, 1);
}
Outcome cavity_limit_2(const SceneDef& choice, const CompileOptions& options) {
  return cavity_limit(choice, options, 2);
}

/// As it is seen from the disk itself: the centrifugal force is a body force.
Outcome disk_stress(const SceneDef& choice, const CompileOptions& options) {
  constexpr double kForce = 1e5;  // density times the square of the angular velocity, N/m4
  const MaterialDef rock = elastic_material();
  const double nu = rock.poisson_ratio, unit = kForce / (8 * (1 - nu));
  const auto simulation = Simulation::compile(quarter(choice, rock, 0), options);
  pull_outwards(*simulation, kForce);
  const std::int64_t steps = relax_to_rest(*simulation);
  const double error = polar_stress_error(
      *simulation, {0, 0}, unit * (3 - 2 * nu) * kOuter * kOuter,
      [=](double r) { return unit * (3 - 2 * nu) * (kOuter * kOuter - r * r); },
      [=](double r) { return unit * ((3 - 2 * nu) * kOuter * kOuter - (1 + 2 * nu) * r * r); });
  return outcome(*simulation, error, steps);
}

constexpr double kWall = kOuter - kInner;
constexpr Problem kProblems[] = {
    {"cavity_stress", "RMS of the stress / pressure", "Lame's thick cylinder, b = 2 a, closed form", kWall, 40,
     cavity_stress},
    {"cavity_limit", "|FS / exact - 1|", "p = 2 c ln(b / a), Tresca, closed form; rungs of b - a", kWall, 20,
     cavity_limit_1},
    {"cavity_limit_two_grids", "|FS / exact - 1|", "as before, extrapolated", kWall, 20, cavity_limit_2},
    {"disk_stress", "RMS of the stress / stress at the centre", "turning disk in plane strain, closed form", kOuter, 40,
     disk_stress},
};

}  // namespace

std::span<const Problem> cavity_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
