// Staged construction: layers taken away or placed between two steps.
#include <algorithm>

#include "simulation/build_model.h"
#include "simulation/ground_water.h"
#include "simulation/lattice_simulation.h"
#include "simulation/placement.h"

namespace vbgpd {

LatticeSimulation::Stage LatticeSimulation::stage(const Layers& layers, bool placed, const Drive& drive,
                                                  const Outside& outside, Real factor) const {
  Stage s;
  s.layers = layers;
  s.section = section_;
  keep_layers(scene_, layers, s.section);
  s.model = build_model(scene_, s.section, kernels_.width, options_.heap);
  if (placed) {
    Features& f = s.model.features;
    f.placed = f.plastic = f.volumetric_plastic = true;
  }
  load(drive, outside, s.section, s.model);
  measure_forces(s.model);
  s.scratch.allocate(s.model);
  s.partial.resize(s.model.chunks.size());
  s.constants = pair_constants(s.model, factor, false);
  s.elastic_constants = pair_constants(s.model, 1, true);
  fit_dilation_cap(s.model, s.constants, s.dilation_cap);
  return s;
}

/// Frequencies of the other stage are found again when they are asked for.
void LatticeSimulation::exchange(Stage& s) noexcept {
  std::swap(layers_, s.layers), std::swap(section_, s.section), std::swap(model_, s.model);
  std::swap(state_, s.state), std::swap(scratch_, s.scratch), std::swap(partial_, s.partial);
  std::swap(dilation_cap_, s.dilation_cap);
  std::swap(constants_, s.constants), std::swap(elastic_constants_, s.elastic_constants);
  dynamic_frequency_ = relaxing_frequency_ = 0;
  audit_ = Audit();
}

void LatticeSimulation::set_layers(const Layers& wanted) {
  const bool all = std::find(wanted.begin(), wanted.end(), false) == wanted.end();
  const Layers layers = all ? Layers() : wanted;
  if (layers == layers_) return;
  bool adds = false;
  for (const Seed& seed : section_.seeds) adds |= !seed.active && has_layer(layers, seed.layer);
  const bool places = adds && has_moved(state_);
  Outside outside = outside_;
  if (has_ground_water(scene_)) {  // r_u counts the soil that is there; what a host has written stays
    Section section = section_;
    keep_layers(scene_, layers, section);
    std::vector<double> present;
    read(find_field("pore_pressure"), present);
    if (present == scene_pore_pressure(scene_, section_))
      outside.pore_pressure = stored_pressure(scene_pore_pressure(scene_, section));
  }
  Stage next = stage(layers, places || model_.features.placed, drive_, outside, factor_);
  if (places) evaluate();  // gradients of the state as it is
  next.state = carried_over(section_, model_, state_, scratch_, next.model, places, next.scratch);
  // whoever digs or fills does the work that the books would lack
  const Real before = steps_ > 0 ? stored_energy() : 0;
  exchange(next);
  try {
    if (steps_ > 0) ledger_.external += stored_energy() - before;
  } catch (...) {
    exchange(next);
    throw;
  }
  outside_ = std::move(outside);
  since_restart_ = 0;
  force_version_ = ++newest_force_version_;
}

std::uint64_t LatticeSimulation::hash_of(const State& state, const Layers& layers) {
  std::uint64_t h = state.hash();
  for (std::size_t k = 0; k < layers.size(); ++k)
    if (!layers[k]) h = (h ^ (k + 1)) * 1099511628211ull;
  return h;
}

}  // namespace vbgpd
