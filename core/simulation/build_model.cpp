#include "simulation/build_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "boundary/wall.h"
#include "simulation/cohesion_gradient.h"
#include "simulation/ground_water.h"
#include "simulation/lattice_packs.h"
#include "simulation/surface_load.h"
#include "smoothing/any_kernel.h"

namespace vbgpd {

namespace {

Strength strength_of(const MaterialDef& m, Real spacing) {
  Strength s;
  s.cohesion = std::max(std::isnan(m.cohesion) ? 0 : m.cohesion, least_cohesion(m, spacing));
  s.friction_angle = radians(m.friction_angle);
  s.dilatancy_angle = radians(m.dilatancy_angle);
  if (!std::isnan(m.tension_cutoff)) s.tension_cutoff = m.tension_cutoff;
  return s;
}

Strength joined_strength(const Strength& weaker, const Strength& other) {
  Strength s = weaker;
  s.dilatancy_angle = std::min(s.dilatancy_angle, other.dilatancy_angle);
  s.tension_cutoff = std::min(s.tension_cutoff, other.tension_cutoff);
  return s;
}

/// A bond between two materials is as strong as the weaker of them where they meet, at the stress level of the section;
/// against a rock that never yields the soil's own strength decides (core/bond/README.md).
void build_materials(const SceneDef& scene, const Section& section, Real h, Real stress, Model& m) {
  m.materials = static_cast<int>(scene.materials.size());
  const auto n = scene.materials.size();
  const bool gradient = has_cohesion_gradient(scene);
  const std::vector<Real> heights = gradient ? meeting_heights(scene, section) : std::vector<Real>(n * n, kNone);
  const auto moduli_of = [&](const AnyLaw& law, const MaterialDef& d) {
    const Real ratio = effective_poisson_ratio(law, d.poisson_ratio, strength_of(d, h));
    return derive(Elastic{}, d.young_modulus, ratio, {});
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const MaterialDef &a = scene.materials[i], &b = scene.materials[j];
      const AnyLaw la = *law_by_name(a.law), lb = *law_by_name(b.law);
      const Strength sa = strength_of(a, h), sb = strength_of(b, h);
      const Real y = heights[std::min(i, j) * n + std::max(i, j)];
      const auto strength_there = [&](const MaterialDef& d, const Strength& s) {
        return s.cohesion + (std::isnan(y) ? 0 : extra_cohesion(d, y)) + stress * std::tan(s.friction_angle);
      };
      const bool rock = !yields(la) || !yields(lb);
      const bool first = rock ? !yields(lb) : strength_there(a, sa) <= strength_there(b, sb);
      const Strength &weaker = first ? sa : sb, &other = first ? sb : sa;
      const LawConstants ca = moduli_of(la, a), cb = moduli_of(lb, b);
      LawConstants moduli;
      moduli.shear_modulus = joined(ca.shear_modulus, cb.shear_modulus);
      moduli.bulk_modulus = joined(ca.bulk_modulus, cb.bulk_modulus);
      m.pair_law.push_back(generality(la) >= generality(lb) ? la : lb);
      m.pair_strength.push_back(rock ? weaker : joined_strength(weaker, other));
      m.pair_elastic.push_back(moduli);
      if (gradient) m.pair_grows.push_back((first ? a : b).cohesion_gradient > 0);
    }
}

Real heavier(const MaterialDef& d) { return std::fmax(d.unit_weight, d.saturated_unit_weight); }

/// A vertical stress typical of the section: a third of the heaviest soil's weight over the height, or of the loads.
Real mean_stress(const SceneDef& scene, const Section& section) {
  Real stress = 0;
  for (const MaterialDef& d : scene.materials) stress = std::max(stress, heavier(d) * section.height / 3);
  for (const LoadDef& l : scene.loads) stress = std::max({stress, l.pressure / 3, l.pressure_end / 3});
  return stress;
}

void find_features(const SceneDef& scene, const Section& section, Model& m) {
  std::vector<bool> used(scene.materials.size(), false);
  for (const Seed& s : section.seeds) used[static_cast<std::size_t>(s.material)] = true;
  Features f;
  f.bond = bond_law_by_name(scene.bond)->at_rest;
  f.plastic = f.volumetric_plastic = f.dilatant = f.cohesion_gradient = f.has_algorithm[0] = f.has_algorithm[1] = false;
  Real softest = kInfinity, stiffest = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const MaterialDef& d = scene.materials[i];
    const AnyLaw law = *law_by_name(d.law);
    f.has_algorithm[static_cast<int>(algorithm_of(law))] = true;
    f.plastic |= yields(law);
    f.volumetric_plastic |= yields(law) && (d.friction_angle > 0 || !std::isnan(d.tension_cutoff));
    f.cohesion_gradient |= yields(law) && d.cohesion_gradient > 0;
    f.dilatant |= yields(law) && d.dilatancy_angle > 0;
    const Real bulk = m.pair_elastic[i * (used.size() + 1)].bulk_modulus;
    softest = std::min(softest, bulk), stiffest = std::max(stiffest, bulk);
  }
  f.uneven_dilation = f.dilatant && stiffest > softest && f.bond != BondLaw::kNone;
  m.features = f;
}

void build_masses(const SceneDef& scene, const Section& section, Model& m) {
  const auto n = static_cast<std::size_t>(m.storage);
  for (Array* a : {&m.force_x, &m.force_y, &m.free_x, &m.free_y, &m.mass})
    a->allocate(n, static_cast<int>(a - &m.force_x) + 2, m.heap);
  if (m.features.cohesion_gradient) m.extra_cohesion.allocate(n, 9, m.heap);
  if (m.features.uneven_dilation) m.compressibility.allocate(n, 12, m.heap);
  // Weightless soil still needs inertia for dynamic steps: a weight that the loads would balance over the section's
  // height.
  Real heaviest = 0, load = 0;
  for (const MaterialDef& d : scene.materials) heaviest = std::max(heaviest, heavier(d));
  for (const LoadDef& l : scene.loads) load = std::max({load, std::fabs(l.pressure), std::fabs(l.pressure_end)});
  m.height = section.height;
  m.stress_scale = std::max(heaviest * m.height, load);
  if (!(m.stress_scale > 0)) m.stress_scale = 1;
  const Real least = 1e-6 * m.stress_scale / m.height;
  const std::vector<Real> extra =
      m.features.cohesion_gradient ? extra_cohesion_of_seeds(scene, section) : std::vector<Real>{};
  Real soil = 0, compliance = 0;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (!seed.active) continue;
    const auto i = static_cast<std::size_t>(m.storage_of[k]);
    const MaterialDef& d = scene.materials[static_cast<std::size_t>(seed.material)];
    const Real weight = unit_weight_at(scene, seed.material, section.place(k));
    const Real inertial = weight > least ? weight : m.stress_scale / m.height;
    m.mass[i] = inertial * seed.volume / scene.gravity;
    if (seed.hold == Hold::kFree) soil += seed.volume, compliance += seed.volume / d.young_modulus;
    if (m.features.cohesion_gradient) m.extra_cohesion[i] = extra[k];
    const auto pair = static_cast<std::size_t>(seed.material * (m.materials + 1));
    if (m.features.uneven_dilation) m.compressibility[i] = 1 / m.pair_elastic[pair].bulk_modulus;
    WallMotion wall;
    if (seed.hold == Hold::kFixed) wall = fixed_wall();
    if (seed.hold == Hold::kVelocity) wall = moved_wall();
    if (seed.hold == Hold::kRoller) wall = roller_wall(seed.normal.x(), seed.normal.y());
    m.free_x[i] = wall.free_x;
    m.free_y[i] = wall.free_y;
    if (wall.guided) {
      GuidedParticle g;
      g.particle = m.storage_of[k];
      g.prescribed = seed.hold == Hold::kVelocity ? 1 : 0;
      g.x = seed.normal.x(), g.y = seed.normal.y();  // of the prescribed ones apply_drive says more
      m.guided.push_back(g);
    }
  }
  // rock under a slope must not make its displacements look large, nor a soft lens all of it soft
  m.stiffness = soil / compliance;
}

}  // namespace

Real least_cohesion(const MaterialDef& m, Real spacing) {
  constexpr Real kShare = 0.03;  // of the weight of one layer of particles
  return m.friction_angle > 0 ? kShare * m.unit_weight * spacing : 0;
}

int support_reach(const SceneDef& scene) { return static_cast<int>(std::ceil(2 * scene.smoothing_ratio - 1e-9)); }

std::vector<LawConstants> pair_constants(const Model& m, Real factor, bool elastic) {
  std::vector<LawConstants> constants(m.pair_law.size());
  for (std::size_t p = 0; p < constants.size(); ++p) {
    LawConstants& c = constants[p];
    if (!elastic)
      std::visit([&](auto law) { decltype(law)::derive(reduced(m.pair_strength[p], factor), c); }, m.pair_law[p]);
    if (!m.pair_grows.empty() && !m.pair_grows[p]) c.k_per_cohesion = 0;
    c.shear_modulus = m.pair_elastic[p].shear_modulus;
    c.bulk_modulus = m.pair_elastic[p].bulk_modulus;
  }
  return constants;
}

Drive scene_drive(const SceneDef& scene, const Section& section) {
  Drive drive{scene.kh, scene.kv, scene.loads, {}};
  for (LoadDef& load : drive.loads)
    if (std::isnan(load.pressure_end)) load.pressure_end = load.pressure;
  for (const BoundaryDef& b : section.boundaries) drive.velocities.emplace_back(b.vx, b.vy);
  return drive;
}

void apply_drive(const SceneDef& scene, const Section& section, const Drive& drive, Model& m) {
  m.force_x.fill_zero(), m.force_y.fill_zero();
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (!seed.active) continue;
    const auto i = static_cast<std::size_t>(m.storage_of[k]);
    const Real weight = unit_weight_at(scene, seed.material, section.place(k)) * seed.volume;
    m.force_x[i] = drive.kh * weight;
    m.force_y[i] = -(1 + drive.kv) * weight;
  }
  add_surface_loads(drive.loads, section, scene.smoothing_ratio, m);
  for (GuidedParticle& g : m.guided) {
    if (g.prescribed == 0) continue;
    const Seed& seed = section.seeds[static_cast<std::size_t>(m.seed_of[static_cast<std::size_t>(g.particle)])];
    const Vec2& velocity = drive.velocities[static_cast<std::size_t>(seed.boundary)];
    g.x = velocity.x(), g.y = velocity.y();
  }
}

void measure_forces(Model& m) {
  m.force_scale = 0;
  for (std::int64_t i = 0; i < m.storage; ++i) {
    const auto n = static_cast<std::size_t>(i);
    m.force_scale += std::fabs(m.force_x[n]) * m.free_x[n] + std::fabs(m.force_y[n]) * m.free_y[n];
  }
}

Model build_model(const SceneDef& scene, const Section& section, int width, const Heap& heap) {
  Model m;
  m.take_from(heap);
  m.width = width;
  const Real spacing = std::sqrt(section.lattice.spacing.prod());
  build_materials(scene, section, spacing, mean_stress(scene, section), m);
  find_features(scene, section, m);
  const Real h = scene.smoothing_ratio * std::sqrt(section.lattice.spacing.x() * section.lattice.spacing.y());
  build_packs(section, scene.jitter, *kernel_by_name(scene.kernel), h, m);
  build_masses(scene, section, m);
  apply_drive(scene, section, scene_drive(scene, section), m);
  measure_forces(m);
  m.neighbours.shrink_to_fit(), m.packs.shrink_to_fit(), m.blocks.shrink_to_fit(), m.guided.shrink_to_fit();
  return m;
}

}  // namespace vbgpd
