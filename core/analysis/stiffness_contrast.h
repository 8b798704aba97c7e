// How far apart the stiffnesses of soils lie in a search for the factor of safety.
#pragma once

#include "simulation/simulation.h"

namespace vbgpd {

/// Numbers of the soils of the section that may yield.
std::vector<std::size_t> yielding_soils(const Simulation& simulation);
/// Whether one of them is so.
bool any_yielding_soil(const Simulation& simulation, bool (*is_so)(const MaterialDef&));

struct StiffnessContrast {
  double ratio = 1;               ///< of the stiffest soil of the section to the softest, Young's moduli
  std::string stiffest, softest;  ///< their names
};
/// Of the soil that is there and may yield.
StiffnessContrast stiffness_contrast(const Simulation& simulation);

/// The scene with no soil that may yield more than `most` times as stiff as the softest one. A mechanism through a jump
/// of stiffness gathers speed the more slowly the larger the jump is, while the factor of safety does not depend on
/// elastic constants (Griffiths & Lane 1999 give all soils nominal ones; measured: tests/stability).
SceneDef with_contrast(const Simulation& simulation, double most);

}  // namespace vbgpd
