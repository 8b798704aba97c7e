#include "simulation/plan.h"

#include <algorithm>
#include <cmath>

#include "scene/names.h"
#include "simulation/ground_water.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {

namespace {

template <class T, class A>
std::size_t bytes_of(const std::vector<T, A>& v) {
  return v.capacity() * sizeof(T);
}

template <class... Arrays>
std::size_t sum_of(const Arrays&... arrays) {
  return (arrays.bytes() + ...);
}

bool any(const std::vector<MaterialDef>& materials, bool (*has)(const MaterialDef&)) {
  return std::any_of(materials.begin(), materials.end(), has);
}

bool uneven_stiffness(const std::vector<MaterialDef>& materials) {
  const MaterialDef* first = nullptr;
  for (const MaterialDef& m : materials) {
    if (!yields(m)) continue;
    if (first == nullptr) first = &m;
    else if (m.young_modulus != first->young_modulus) return true;
  }
  return false;
}

}  // namespace

std::vector<Feature> scene_features(const SceneDef& s) {
  const auto held = [&](BoundaryKind kind) {
    return std::any_of(s.boundaries.begin(), s.boundaries.end(), [&](const BoundaryDef& b) { return b.kind == kind; });
  };
  const auto has_law = [&](const char* law) {
    return std::any_of(s.materials.begin(), s.materials.end(), [&](const MaterialDef& m) { return m.law == law; });
  };
  return {
      {"elastic law", "soil that never yields", has_law("elastic")},
      {"drucker_prager law", "cone in plane strain, closed-form return", has_law("drucker_prager")},
      {"mohr_coulomb law", "hexagon, closed-form return with edges and apex", has_law("mohr_coulomb")},
      {"undrained law", "cohesion only", has_law("undrained")},
      {"several materials", "bonds between two materials take the weaker strength", s.materials.size() > 1},
      {"uneven stiffness", "soils of different stiffness; strength reduction evens them out beyond stiffness_contrast",
       uneven_stiffness(s.materials)},
      {"dilatancy", "a dilatancy angle above 0",
       any(s.materials, [](const MaterialDef& m) { return yields(m) && m.dilatancy_angle > 0; })},
      {"tension cut-off", "a tension cut-off below the apex of the cone",
       any(s.materials, [](const MaterialDef& m) { return yields(m) && !std::isnan(m.tension_cutoff); })},
      {"seismic coefficients", "kh, kv: part of the external forces", s.kh != 0 || s.kv != 0},
      {"surface loads", "pressures on the ground: part of the external forces", !s.loads.empty()},
      {"ground water", "a water table or a pore pressure ratio: pore pressure from the scene, thrust of standing water",
       has_ground_water(s)},
      {"moving boundaries", "walls with a prescribed velocity", held(BoundaryKind::kVelocity)},
  };
}

std::vector<Feature> Simulation::plan() const {
  std::vector<Feature> plan = scene_features(scene());
  plan.insert(plan.begin(),
              {"particles", "everything this simulation stores", true, static_cast<std::size_t>(get("bytes")), 0});
  return plan;
}

/// Every array and every list of the simulation belongs to exactly one of these.
std::vector<Feature> LatticeSimulation::plan() const {
  const Model& m = model_;
  const State& s = state_;
  const Scratch& t = scratch_;
  const bool bonded = m.features.bond != BondLaw::kNone;
  const std::size_t packs = bytes_of(m.packs), plastic = s.plastic_strain.bytes();
  const std::size_t particles =
      sum_of(m.volume, m.share, m.moment_xx, m.moment_xy, m.moment_yy, m.sum_x, m.sum_y, m.force_x, m.force_y, m.free_x,
             m.free_y, m.mass, m.scaled_mass, s.displacement_x, s.displacement_y, s.velocity_x, s.velocity_y,
             t.weighted_x, t.weighted_y, t.gradient_xx, t.gradient_xy, t.gradient_yx, t.gradient_yy, t.dilation,
             t.flux_xx, t.flux_xy, t.flux_yx, t.flux_yy) +
      bytes_of(m.blocks) + bytes_of(m.chunks) + bytes_of(m.material) + bytes_of(m.seed_of) + bytes_of(m.storage_of) +
      bytes_of(m.id_of) + bytes_of(section_.seeds) + bytes_of(partial_) + (bonded ? 0 : packs);
  std::vector<Feature> plan = {
      {"particles", "position, motion, volume, mass, forces, operators", true, particles, 0},
      {"neighbour lists", "who lies within the support of whom", true, bytes_of(m.neighbours) + bytes_of(m.offsets), 0},
      {"jitter", "particles off the lattice, every pair with a weight of its own", m.off_lattice(),
       sum_of(m.place_x, m.place_y) + bytes_of(m.pair_weight) + bytes_of(section_.shifts), 0},
      {"virtual bonds", "a stress of its own in every bond", bonded,
       bonded ? sum_of(t.pair_force_x, t.pair_force_y) : 0, bonded ? packs : 0},
      {"plasticity", "plastic strain of every bond, without bonds of every particle", m.features.plastic,
       bonded ? 0 : plastic, bonded ? plastic : 0},
      {"volumetric plasticity", "volume that dilates or opens in tension, at the particles",
       m.features.volumetric_plastic, sum_of(s.plastic_volume, s.gap, dilation_cap_), 0},
      {"dilatant volume", "what shearing gives to the particles in a step", m.features.dilatant,
       t.volume_source.bytes(), 0},
      {"dilatancy across stiffness", "how bonds that dilate between soils of different stiffness share the volume",
       m.features.uneven_dilation, m.compressibility.bytes(), 0},
      {"layers switched off", "soil taken away or not placed yet; its places in the arrays stay", !layers_.empty()},
      {"placed soil", "the shape soil was placed in, where the section had moved already", s.placed_strain.present(),
       bonded ? 0 : s.placed_strain.bytes(), bonded ? s.placed_strain.bytes() : 0},
      {"cohesion gradient", "cohesion that grows with depth", m.features.cohesion_gradient, m.extra_cohesion.bytes(),
       0},
      {"guided walls", "wall particles that slide or are moved", !m.guided.empty(), bytes_of(m.guided), 0},
      {"no bonds through air", "pairs whose joining line leaves the soil", !section_.cut_pairs.empty(),
       bytes_of(section_.cut_pairs), 0},
      {"energy ledger", "works and dissipations of dynamic steps, and the state of the last audit",
       audit_.state.displacement_x.present() || t.opening.present(),
       audit_.state.bytes() + sum_of(t.opening, t.mean_load), 0},
      {"forces from outside", "written by a host, per particle",
       outside_.external_x.present() || outside_.external_y.present(), sum_of(outside_.external_x, outside_.external_y),
       0},
      {"pore pressure", "of the scene or written by a host, per particle", outside_.pore_pressure.present(),
       outside_.pore_pressure.bytes(), 0},
      {"views", "which particle an item in storage order is", !storage_ids_.empty(), bytes_of(storage_ids_), 0},
      {"damping", "local damping of dynamic steps", damping_ > 0},
      {"fields and monitors", "computed when read, on a copy of the motion: present from the first reading on",
       probe_.displacement_x.present(), probe_.bytes(), 0},
      {"workers", "threads beside the caller's", options_.threads != 1},
  };
  const std::vector<Feature> of_scene = scene_features(scene_);
  plan.insert(plan.end(), of_scene.begin(), of_scene.end());
  return plan;
}

}  // namespace vbgpd
