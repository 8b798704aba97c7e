// From factors of safety on several grids to one value with an error estimate: which grids, in which order, how far the
// differences between them can be trusted, and what one more grid would cost.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/job.h"

namespace vbgpd {

/// One grid of a ladder, as the spacing options of a compilation.
struct Grid {
  Real spacing_factor;
  int multiple, coarsening;
};

/// Coarse to fine, the last with the spacing of the scene: 1 its own grid, 2 also twice the spacing on the same key
/// lines, 3 to 5 half octaves of spacing between and beyond.
std::vector<Grid> closed_ladder(int levels);

/// Grid n of a ladder without end: cells of 1, 1/2, 1/3, 1/4, 1/6, 1/8 ... of twice the scene's spacing, so that every
/// one has its edges on the same key lines. Grid 1 is that of the scene itself.
Grid open_ladder(int n);
/// A ladder has no end in theory only: its last grid has 1/32 of the scene's spacing and a thousand times its
/// particles.
constexpr int kOpenLadder = 12;

/// The thinnest soil of the section, for a warning where the grid cannot see it.
struct ThinLayer {
  std::string material;
  Real thickness = kNone;  ///< m; NaN = a single soil, nothing to resolve
};

/// What an estimate has to know of the section.
struct SectionFacts {
  ThinLayer thinnest;
  Real support = 2.6;    ///< radius of the smoothing kernel, spacings
  Real height = kNone;   ///< of the slope, m; NaN = unknown
  bool cut_off = false;  ///< there is soil with a tension cut-off
};

struct Estimate {
  std::string status, reason;  ///< OK, NOT_FIRST_ORDER, NOT_MONOTONIC, THIN_LAYER, THIN_SLIDE, TOO_COARSE,
                               ///< ENERGY_UNBALANCED
  double value = kNone;  ///< extrapolated where that can be trusted, half way where the order is unknown, else that of
                         ///< the finest grid
  double error = kNone;  ///< never less than half the bracket of the finest grid
  double observed_order = kNone;  ///< of three grids; NaN where the differences give none
  bool discretisation = false;    ///< the error of the grid is in `error`: there were two grids to compare
};

/// Extrapolates over the finest grid and the finest one at least twice as coarse, at first order,
///   FS* = FS(h) - (FS(r h) - FS(h)) / (r - 1).
/// Two grids of which the finer reads higher are not extrapolated: its value, and an error that reaches back to the
/// other. Brackets enter with their full width. Half of what was extrapolated stays in doubt; a third grid replaces
/// that half by what the observed order changes. Where the sliding mass differs from grid to grid all of it stays in
/// doubt. Needs at least one level; every level has a factor of safety.
Estimate estimate(std::span<const Level> levels, const SectionFacts& section);

/// Wall seconds of a grid with that spacing: particles times steps grow like spacing^-3, or as the last two grids did
/// when that is faster.
double predicted_seconds(std::span<const Level> levels, double spacing);

/// Spacing of a level as one length, sqrt(dx dy), m.
double spacing_of(const Level& level);

}  // namespace vbgpd
