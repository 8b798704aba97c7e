// Stresses taken over from softer soil: a factor of safety is looked for where stiffnesses lie close together, what
// failed there goes on with the true ones.
#include "simulation/bond_records.h"
#include "simulation/lattice_simulation.h"
#include "simulation/observe.h"

namespace vbgpd {

void LatticeSimulation::take_stresses(const Simulation& softer) {
  const auto* const from = dynamic_cast<const LatticeSimulation*>(&softer);
  const bool alike = from != nullptr && from->layers_ == layers_ && from->model_.storage == model_.storage &&
                     from->model_.seed_of == model_.seed_of && from->model_.material == model_.material &&
                     from->model_.slots == model_.slots && from->model_.bonds == model_.bonds;
  if (!alike) throw Error(Status::kArgument, "stresses can be taken over from the same section only");
  Stage next = stage(layers_, true, drive_, outside_, from->factor_);
  from->evaluate();
  const State& old = from->state_;
  State& s = next.state;
  s.allocate(next.model);
  s.displacement_x = old.displacement_x, s.displacement_y = old.displacement_y;
  s.velocity_x = old.velocity_x, s.velocity_y = old.velocity_y;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.storage); ++i) {
    if (model_.seed_of[i] < 0) continue;
    const auto pair = static_cast<std::size_t>(model_.material[i] * (model_.materials + 1));
    const Real kept = from->model_.pair_elastic[pair].bulk_modulus / model_.pair_elastic[pair].bulk_modulus;
    const Real dilated = old.plastic_volume.present() ? old.plastic_volume[i] : 0;
    const Real gap = old.gap.present() ? old.gap[i] : 0;
    s.gap[i] = gap;
    s.plastic_volume[i] =
        dilated + (1 - kept) * (from->scratch_.gradient_xx[i] + from->scratch_.gradient_yy[i] - dilated - gap);
  }
  const auto width = static_cast<std::size_t>(model_.width);
  for_each_record(model_, [&](const BondPack& p, int l, std::size_t i, std::size_t j, std::size_t r) {
    const Real kept = from->model_.pair_elastic[p.pair].shear_modulus / model_.pair_elastic[p.pair].shear_modulus;
    const auto strain =
        observe_detail::deviator(observe_detail::strain(old, from->scratch_, from->model_.offset(p, l), i, j));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = r + c * width;
      const Real plastic = old.plastic_strain.present() ? old.plastic_strain[at] : 0;
      const Real shape = (1 - kept) * (strain[c] - plastic);
      s.placed_strain[at] = (old.placed_strain.present() ? old.placed_strain[at] : 0) + shape;
      s.plastic_strain[at] = plastic + shape;
    }
  });
  exchange(next);
  unbook();
  factor_ = from->factor_;
  since_restart_ = 0;
  force_version_ = ++newest_force_version_;
}

}  // namespace vbgpd
