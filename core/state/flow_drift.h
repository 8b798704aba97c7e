// How long neighbour lists of a run-out serve: not until one particle has moved, but until two that are not listed can
// have come within the support.
#pragma once

#include "state/flow_cells.h"
#include "state/flow_model.h"

namespace vbgpd {

/// How far a particle may move, in skins, before the lists are made anew whatever its neighbours do: cells are wider
/// than the support by twice as much, so that particles of cells that do not touch stay out of each other's reach.
inline constexpr Real kFarthest = 1;
inline Real cell_size(const FlowModel& m) { return m.support + 2 * kFarthest * m.options.skin * m.spacing; }

/// Groups what lay in one cell when it was listed, soil and mirror images apart, and notes which groups touch.
void group_by_cell(const FlowModel& m, const FlowState& s, const Cells& cells, const Bins& soil, const Bins& images,
                   FlowLists& lists);

/// How far every particle may still move before the lists serve no longer, m; below 0 they do not. Two that are not
/// listed were farther apart than the support and the skin; the largest difference between the displacements of groups
/// that touch bounds how near they have come.
Real room_left(const FlowModel& m, const FlowState& s, const FlowLists& lists);

}  // namespace vbgpd
