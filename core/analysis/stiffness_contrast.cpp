#include "analysis/stiffness_contrast.h"

#include <algorithm>
#include <cmath>

#include "scene/names.h"

namespace vbgpd {

std::vector<std::size_t> yielding_soils(const Simulation& simulation) {
  const std::vector<MaterialDef>& materials = simulation.scene().materials;
  std::vector<bool> there(materials.size(), false);
  for (const Seed& s : simulation.section().seeds) {
    const auto m = static_cast<std::size_t>(s.material);
    there[m] = there[m] || (s.active && yields(materials[m]));
  }
  std::vector<std::size_t> out;
  for (std::size_t m = 0; m < there.size(); ++m)
    if (there[m]) out.push_back(m);
  return out;
}

bool any_yielding_soil(const Simulation& simulation, bool (*is_so)(const MaterialDef&)) {
  const std::vector<std::size_t> soils = yielding_soils(simulation);
  return std::any_of(soils.begin(), soils.end(), [&](std::size_t m) { return is_so(simulation.scene().materials[m]); });
}

StiffnessContrast stiffness_contrast(const Simulation& simulation) {
  const std::vector<MaterialDef>& materials = simulation.scene().materials;
  const std::vector<std::size_t> there = yielding_soils(simulation);
  if (there.empty()) return {};
  const auto softer = [&](std::size_t a, std::size_t b) {
    return materials[a].young_modulus < materials[b].young_modulus;
  };
  const auto [softest, stiffest] = std::minmax_element(there.begin(), there.end(), softer);
  const MaterialDef &soft = materials[*softest], &stiff = materials[*stiffest];
  return {stiff.young_modulus / soft.young_modulus, stiff.name, soft.name};
}

SceneDef with_contrast(const Simulation& simulation, double most) {
  SceneDef scene = simulation.scene();
  const std::vector<std::size_t> soils = yielding_soils(simulation);
  double softest = INFINITY;
  for (std::size_t m : soils) softest = std::min(softest, scene.materials[m].young_modulus);
  for (std::size_t m : soils)
    scene.materials[m].young_modulus = std::min(scene.materials[m].young_modulus, most * softest);
  return scene;
}

}  // namespace vbgpd
