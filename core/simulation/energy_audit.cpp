// Plastic soil hides a step that is too long: yielding bonds cap the forces, so nothing becomes infinite, but the
// motion feeds on energy that nobody put in. So the books are looked at now and then.
#include <algorithm>
#include <cmath>

#include "simulation/lattice_simulation.h"

namespace vbgpd {

Real LatticeSimulation::kinetic_energy() const {
  Real sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.storage); ++i) {
    if (!(model_.free_x[i] + model_.free_y[i] > 0)) continue;
    const Real v2 = state_.velocity_x[i] * state_.velocity_x[i] + state_.velocity_y[i] * state_.velocity_y[i];
    sum += model_.mass[i] * v2 / 2;
  }
  return sum;
}

Real LatticeSimulation::stored_energy() const { return kinetic_energy() + elastic_energy() + half_step_work(); }

bool LatticeSimulation::walls_move() const {
  return std::any_of(model_.guided.begin(), model_.guided.end(), [](const auto& g) { return g.prescribed != 0; });
}

Real LatticeSimulation::energy_residual() const {
  if (!ledger_.open) return 0;
  if (walls_move()) return kNone;  // they do work that the ledger does not book
  const Real kinetic = kinetic_energy(), elastic = elastic_energy() - ledger_.before;
  const Real residual = ledger_.booked() - kinetic - elastic - half_step_work();
  if (!std::isfinite(residual)) return kNone;  // max and > would let it pass for nothing missing
  const Real largest =
      std::max({std::fabs(ledger_.external), kinetic, std::fabs(elastic), ledger_.plastic, ledger_.damping});
  return largest > 0 ? std::fabs(residual) / largest : 0;
}

void LatticeSimulation::begin_audit(Real share) {
  if (walls_move()) return;  // by energy_residual there is nothing to audit
  audit_.state = state_, audit_.ledger = ledger_, audit_.time = time_, audit_.steps = steps_;
  audit_.stored = stored_energy();
  audit_.share = share, audit_.valid = true;
}

Real LatticeSimulation::audit() {
  constexpr std::int64_t kEvery = 512;
  constexpr Real kTolerated = 0.05, kNoise = 1e-3;
  if (!audit_.valid) return 0;
  if (steps_ - audit_.steps < kEvery) return audit_.share;
  const Real gained = stored_energy() - audit_.stored, booked = ledger_.booked() - audit_.ledger.booked();
  // energies this small against the elastic energy of the section's own weight are noise
  const Real least = kNoise * model_.stress_scale * model_.stress_scale / model_.stiffness * section_.area;
  const Real scale =
      std::max({least, kinetic_energy(), std::fabs(gained), std::fabs(ledger_.external - audit_.ledger.external),
                ledger_.plastic - audit_.ledger.plastic, ledger_.damping - audit_.ledger.damping});
  const Real share = std::fabs(gained - booked) / (kTolerated * scale);
  if (share <= 1) {
    begin_audit(share);
    return share;
  }
  state_ = audit_.state, ledger_ = audit_.ledger, time_ = audit_.time, steps_ = audit_.steps;
  return std::isfinite(share) ? share : kInfinity;
}

}  // namespace vbgpd
