// A problem with a known answer: what is asked of the engine, and how far it is off.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "simulation/simulation.h"

namespace vbgpd::accuracy {

/// What one run gave.
struct Outcome {
  double error = 0;  ///< as the problem defines it; NaN = no answer
  std::int64_t particles = 0, steps = 0;
  double bytes = 0;
  std::uint64_t hash = 0;  ///< of the state it ended in
};

/// Which schemes a problem is run with.
enum class Schemes {
  kLattice,   ///< virtual bonds and none, either kernel
  kRunout,    ///< virtual bonds and none; run-outs refuse the cubic spline
  kPairLaws,  ///< all pair laws of the run-out
};

struct Problem {
  const char* name;
  const char* error_kind;  ///< what `error` measures
  const char* reference;   ///< the known answer and where it comes from
  double height;           ///< m: the ladder is height / 5, / 10 ...
  int finest;              ///< last rung: height / finest
  /// `choice` carries bond law, kernel and spacing, `options` the threads.
  Outcome (*run)(const SceneDef& choice, const CompileOptions& options);
  Schemes schemes = Schemes::kLattice;
};

std::span<const Problem> elastic_problems();
std::span<const Problem> wave_problems();
std::span<const Problem> cavity_problems();
std::span<const Problem> element_problems();
std::span<const Problem> limit_problems();
std::span<const Problem> motion_problems();
std::span<const Problem> column_problems();

// What problems have in common.

std::vector<double> field(const Simulation& simulation, const char* name);
/// As kv: a scene must have some weight left.
inline constexpr double kNoWeight = -1 + 1e-12;
/// A material without strength, 20 kN/m3, E = 1e8 Pa, nu = 0.3.
MaterialDef elastic_material();
/// `choice` with one soil in a rectangle at the origin and nothing that holds it.
SceneDef rectangle(const SceneDef& choice, const MaterialDef& material, double width, double height);
BoundaryDef held(const char* side, BoundaryKind kind);
/// Without strengths to an unbalanced force ratio of `rest`; the steps it took.
std::int64_t relax_to_rest(Simulation& simulation, double rest = 1e-8);
Outcome outcome(const Simulation& simulation, double error, std::int64_t steps);
/// Root mean square error of the radial and the hoop stress of the soil about a centre, in units of `scale`.
double polar_stress_error(const Simulation& simulation, const Point& centre, double scale,
                          const std::function<double(double)>& radial, const std::function<double(double)>& hoop);
/// |FS / exact - 1|, with so many grids.
Outcome factor_of_safety_error(Simulation& simulation, int levels, double exact = 1);

}  // namespace vbgpd::accuracy
