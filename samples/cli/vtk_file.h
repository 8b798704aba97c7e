// Particles as VTK files for ParaView: one .vtu a frame and a .pvd that lists them with their times.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine.h"

namespace cli {

/// Every real field of the particles as an unstructured grid of points.
std::string particles_vtu(const vbgpd_model* model);

/// file name and time of each frame
std::string collection_pvd(const std::vector<std::pair<std::string, double>>& frames);

}  // namespace cli
