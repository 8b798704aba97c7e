// What a compiled scene uses and what was left out of it, with the memory each thing takes.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

/// One thing the engine can do. What is left out has no bytes and costs no time.
struct Feature {
  const char* name;
  const char* doc;
  bool used = false;
  std::size_t particle_bytes = 0;  ///< allocated, all particles together
  std::size_t bond_bytes = 0;      ///< allocated, all bonds together
};

/// What a scene asks for that takes no memory of its own: it only changes numbers that are there anyway.
std::vector<Feature> scene_features(const SceneDef& scene);

}  // namespace vbgpd
