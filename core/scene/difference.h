// Whether two scenes make the same model: what a checkpoint is asked before a model takes it.
#pragma once

#include <string>

#include "scene/scene_def.h"

namespace vbgpd {

/// The first thing in which `other` makes another model than `scene`, e.g. "material 0 has young_modulus 4e+07 there,
/// 2e+07 here"; empty where there is none. Names do not count, nor what may be set while a model runs (kh, kv,
/// pressures of loads, velocities of boundaries), nor what only a strength reduction reads. Numbers may differ by the
/// round-off of their units.
std::string first_difference(const SceneDef& scene, const SceneDef& other);

}  // namespace vbgpd
