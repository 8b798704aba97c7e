// Which particles a caller means, and the fields that are meant.
#pragma once

#include <vector>

#include "simulation/simulation.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {

/// The field of that number; throws ArgumentError when there is none.
const FieldInfo& field_in(std::int32_t field, int argument);
/// Ids of the selected particles; NULL selects all.
std::vector<std::int64_t> selected(const Simulation& simulation, const vbgpd_selection* selection, int argument);
std::vector<double> field_rows(const Simulation& simulation, const char* field);

}  // namespace vbgpd::capi
