#include "analysis/forecast.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/stiffness_contrast.h"
#include "analysis/trial.h"

namespace vbgpd {

namespace {

/// Steps grow with the number of particles across the section. Over the published scenes of samples/scenes at their own
/// spacing they are 41 to 432 times sqrt(particles), half of them between 57 and 81; soil that dilates, over six slopes
/// with psi = phi, takes 159 to 440 times.
constexpr double kStepsPerRoot = 70, kDilatant = 280;

double steps_per_root(const Simulation& simulation) {
  const auto dilates = [](const MaterialDef& m) { return m.dilatancy_angle > 0; };
  return any_yielding_soil(simulation, dilates) ? kDilatant : kStepsPerRoot;
}

double measured_step(Simulation& simulation) {
  struct PutBack {
    Simulation& simulation;
    std::shared_ptr<SavedState> before = simulation.save();
    ~PutBack() { simulation.restore(*before); }  // only the state differs: takes nothing from the heap
  } const put_back{simulation};
  simulation.halt();
  simulation.relax(1, {});  // finds its time step first
  constexpr double kLongEnough = 0.02;
  constexpr std::int64_t kWindow = 4;
  double best = INFINITY, all = 0;
  while (all < kLongEnough) {
    const Stopwatch watch;
    simulation.relax(kWindow, {});
    const double seconds = watch.wall();
    best = std::min(best, seconds / kWindow), all += seconds;
  }
  return best;
}

double feature_bytes(const Simulation& simulation, std::string_view name) {
  for (const Feature& f : simulation.plan())
    if (f.name == name) return static_cast<double>(f.particle_bytes + f.bond_bytes);
  return 0;
}

double state_bytes(const Simulation& simulation) {
  const double n = static_cast<double>(simulation.particle_count());
  return 4 * sizeof(double) * n +  // displacement and velocity
         feature_bytes(simulation, "plasticity") + feature_bytes(simulation, "volumetric plasticity");
}

/// Soils too far apart in stiffness are searched in a second simulation, what failed there is then taken over.
double twin_bytes(const Simulation& simulation) {
  if (stiffness_contrast(simulation).ratio <= kStiffnessContrast) return 0;
  constexpr double kCopies =
      3;  // of the strain taken over: the state, that of the monitors and that of the energy audit
  return simulation.get("bytes") + kCopies * feature_bytes(simulation, "plasticity");
}

}  // namespace

Forecast forecast_strength_reduction(Simulation& simulation) {
  if (simulation.runs_out()) throw Error(Status::kUnsupported, "a run-out has no factor of safety to forecast");
  Forecast f;
  f.step_seconds = measured_step(simulation);
  f.steps = steps_per_root(simulation) * std::sqrt(static_cast<double>(simulation.particle_count()));
  f.seconds = f.steps * f.step_seconds;
  constexpr double kSaved = 4, kCoarse = 0.25;
  f.bytes = simulation.get("bytes") * (1 + kCoarse) + kSaved * state_bytes(simulation) + twin_bytes(simulation);
  return f;
}

}  // namespace vbgpd
