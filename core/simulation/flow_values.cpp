// Named numbers and energies of a run-out.
#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "simulation/flow_simulation.h"

namespace vbgpd {

Real FlowSimulation::kinetic_energy() const {
  Real sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const Real vx = state_.motion[4 * i + 2], vy = state_.motion[4 * i + 3];
    sum += lists_.constants[4 * i + 1] * (vx * vx + vy * vy) / 2;
  }
  return sum;
}

/// Elastic energy of the particles' stress: V (J2 / 2G + m^2 / 2K).
Real FlowSimulation::stored_energy() const {
  Real sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const LawConstants& c = model_.moduli[static_cast<std::size_t>(lists_.soil[i])];
    const double* const s = state_.stress.data() + 4 * i;
    const Real j2 = s[0] * s[0] + s[1] * s[1] + s[0] * s[1] + s[2] * s[2];
    sum += lists_.volume[i] * (j2 / (2 * c.shear_modulus) + s[3] * s[3] / (2 * c.bulk_modulus));
  }
  return sum;
}

Real FlowSimulation::elastic_energy() const { return stored_energy() + last_.guard; }

/// What the books do not explain, relative to the largest entry, or to a millionth of what the stress stores where all
/// entries are smaller.
Real FlowSimulation::energy_residual() const {
  if (!ledger_.open) return 0;
  const Real kinetic = kinetic_energy() - ledger_.kinetic_before, guard = last_.guard - ledger_.guard_before;
  const Real residual = ledger_.external - kinetic - ledger_.internal - ledger_.bond - ledger_.viscous - guard -
                        ledger_.damping - ledger_.contact;
  if (!std::isfinite(residual)) return kNone;
  const Real largest = std::max({std::fabs(ledger_.external), std::fabs(kinetic), std::fabs(ledger_.internal),
                                 std::fabs(ledger_.viscous), std::fabs(ledger_.damping), 1e-6 * ledger_.stored_before});
  return largest > 0 ? std::fabs(residual) / largest : 0;
}

Real FlowSimulation::max_displacement() const {
  Real square = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const auto id = static_cast<std::size_t>(state_.particle[i]);
    const Real ux = state_.motion[4 * i] - model_.reference_x[id],
               uy = state_.motion[4 * i + 1] - model_.reference_y[id];
    square = std::max(square, ux * ux + uy * uy);
  }
  return std::sqrt(square);
}

Monitors FlowSimulation::monitors() const {
  Monitors out;
  out.unbalanced_force_ratio = model_.force_scale > 0 ? last_.unbalanced / model_.force_scale : 0;
  Real velocity2 = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const double* const v = state_.motion.data() + 4 * i + 2;
    velocity2 = std::max(velocity2, v[0] * v[0] + v[1] * v[1]);
  }
  out.max_displacement = max_displacement(), out.max_velocity = std::sqrt(velocity2);
  out.kinetic_energy = kinetic_energy();
  out.plastic_bonds = static_cast<std::int64_t>(plastic_bond_count());
  return out;
}

void FlowSimulation::set(std::string_view name, double value) {
  require_settable(name, value);
  if (name == "damping") damping_ = value;
  else if (name == "strength_reduction_factor") set_factor(value);
  else if (name == "kh" || name == "kv") {
    Drive changed = drive_;
    (name == "kh" ? changed.kh : changed.kv) = value;
    set_drive(changed);
  } else
    throw Error(Status::kUnsupported,
                std::string(name) +
                    " cannot be set on a run-out model, whose time step is spacing / wave speed times " +
                    number_text(model_.options.time_step));
}

double FlowSimulation::get(std::string_view name) const {
  if (name == "damping") return damping_;
  if (name == "strength_reduction_factor") return factor_;
  if (name == "kh") return drive_.kh;
  if (name == "kv") return drive_.kv;
  if (name == "time") return time_;
  if (name == "steps") return static_cast<double>(steps_);
  if (name == "time_step") return model_.time_step;
  if (name == "stable_time_step") return model_.time_step / model_.options.time_step;  // spacing / wave speed
  if (name == "unbalanced_force_ratio") return monitors().unbalanced_force_ratio;
  if (name == "max_displacement") return max_displacement();
  if (name == "max_velocity") return monitors().max_velocity;
  if (name == "displacement_level") return max_displacement() / displacement_scale();
  if (name == "total_mass") {
    Real sum = 0;
    for (std::size_t i = 0; i < model_.mass.size(); ++i) sum += model_.mass[i];
    return sum;
  }
  if (name == "area") return section_.area;
  if (name == "height") return section_.height;
  if (name == "spacing_x") return section_.lattice.spacing.x();
  if (name == "spacing_y") return section_.lattice.spacing.y();
  if (name == "particles") return static_cast<double>(model_.particles);
  if (name == "bonds") return static_cast<double>(bond_count());
  if (name == "plastic_bonds") return plastic_bond_count();
  if (name == "bytes") return static_cast<double>(memory().total());
  if (name == "kinetic_energy") return kinetic_energy();
  if (name == "peak_kinetic_energy") return peak_kinetic_;
  if (name == "standing_time") return time_ - farther_at_;
  if (name == "elastic_energy") return elastic_energy();
  if (name == "plastic_dissipation")
    return ledger_.open ? ledger_.internal + ledger_.bond - (stored_energy() - ledger_.stored_before) : 0;
  if (name == "damping_dissipation") return ledger_.damping;
  if (name == "viscous_dissipation") return ledger_.viscous;
  if (name == "contact_work") return ledger_.contact;
  if (name == "external_work") return ledger_.external;
  if (name == "energy_residual") return energy_residual();
  if (name == "viscosity") return model_.viscosity;
  if (name == "yielding_area") return last_.yielding;
  if (name == "neighbour_searches") return static_cast<double>(searches_);
  for (const NamedValue& v : named_values())
    if (name == v.name) throw Error(Status::kUnsupported, std::string(name) + " has no value on a run-out model");
  no_such_value(name, {"peak_kinetic_energy", "standing_time", "viscous_dissipation", "contact_work", "viscosity",
                       "yielding_area", "neighbour_searches"});
}

}  // namespace vbgpd
