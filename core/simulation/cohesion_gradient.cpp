#include "simulation/cohesion_gradient.h"

#include <algorithm>
#include <utility>

#include "simulation/build_model.h"

namespace vbgpd {

namespace {

/// The seeds within the support of another one, by lattice cell.
class Surroundings {
 public:
  Surroundings(const SceneDef& scene, const Section& section) : section_(section), reach_(support_reach(scene)) {}

  template <class Visit>
  void around(const Seed& seed, const Visit& visit) const {
    for (Index dx = -reach_; dx <= reach_; ++dx)
      for (Index dy = -reach_; dy <= reach_; ++dy)
        if (const Seed* other = at(seed.ix + dx, seed.iy + dy); other != nullptr && other != &seed) visit(*other);
  }

 private:
  const Seed* at(Index ix, Index iy) const {
    const auto before = [](const Seed& s, const std::pair<Index, Index>& cell) { return std::pair(s.ix, s.iy) < cell; };
    const auto found = std::lower_bound(section_.seeds.begin(), section_.seeds.end(), std::pair(ix, iy), before);
    const bool here = found != section_.seeds.end() && found->ix == ix && found->iy == iy && found->active;
    return here ? &*found : nullptr;
  }

  const Section& section_;
  Index reach_;
};

const MaterialDef& material_of(const SceneDef& scene, const Seed& seed) {
  return scene.materials[static_cast<std::size_t>(seed.material)];
}

Real height_of(const Section& section, const Seed& seed) {
  return section.place(static_cast<std::size_t>(&seed - section.seeds.data())).y();
}

}  // namespace

Real extra_cohesion(const MaterialDef& material, Real y) {
  return material.cohesion_gradient > 0 ? material.cohesion_gradient * std::max<Real>(0, material.cohesion_datum - y)
                                        : 0;
}

bool has_cohesion_gradient(const SceneDef& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const MaterialDef& d) { return d.cohesion_gradient > 0; });
}

std::vector<Real> meeting_heights(const SceneDef& scene, const Section& section) {
  const std::size_t n = scene.materials.size();
  std::vector<Real> sum(n * n, 0), count(n * n, 0);
  const Surroundings surroundings(scene, section);
  for (const Seed& seed : section.seeds) {
    if (!seed.active) continue;
    surroundings.around(seed, [&](const Seed& other) {
      if (other.material <= seed.material) return;  // each pair once
      const std::size_t pair = static_cast<std::size_t>(seed.material) * n + static_cast<std::size_t>(other.material);
      sum[pair] += (height_of(section, seed) + height_of(section, other)) / 2, ++count[pair];
    });
  }
  for (std::size_t pair = 0; pair < sum.size(); ++pair) sum[pair] /= count[pair];  // 0 / 0 = they do not meet
  return sum;
}

std::vector<Real> extra_cohesion_of_seeds(const SceneDef& scene, const Section& section) {
  std::vector<Real> extra(section.seeds.size(), 0);
  const Surroundings surroundings(scene, section);
  for (std::size_t k = 0; k < extra.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (!seed.active) continue;
    if (material_of(scene, seed).cohesion_gradient > 0) {
      extra[k] = extra_cohesion(material_of(scene, seed), height_of(section, seed));
      continue;
    }
    Real sum = 0, count = 0;
    surroundings.around(seed, [&](const Seed& other) {
      if (material_of(scene, other).cohesion_gradient > 0)
        sum += extra_cohesion(material_of(scene, other), height_of(section, seed)), ++count;
    });
    if (count > 0) extra[k] = sum / count;
  }
  return extra;
}

}  // namespace vbgpd
