// How thick the soils of a section are: can a grid see them?
#pragma once

#include <vector>

#include "geometry/stages.h"

namespace vbgpd {

/// Spacings that a soil needs across for a grid to see it.
inline constexpr Real kResolvedCells = 2;

/// Thickness of every material in m, as painted: the median length of what vertical lines cut out of it, or horizontal
/// ones where that is less (measured on lines `step` apart; wedges therefore count with their mean thickness, an
/// inclined band with at most 1.4 times its true one). 0 = painted but thinner than any line found; NaN = not painted
/// at all. Layers that are not there count as air.
std::vector<Real> material_thickness(const SceneDef& scene, Real step, const Layers& there = {});

}  // namespace vbgpd
