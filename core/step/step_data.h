// The arrays of one step as plain pointers: what the instruction-set specific files see (they include no container).
#pragma once

#include <cstdint>

#include "material/constants.h"
#include "state/records.h"

namespace vbgpd {

/// What drives a step: it changes between steps, never inside one.
struct Controls {
  double time_step = 0;
  double momentum = 1;           ///< b: velocity kept from the last step (1 = true dynamics, < 1 = relaxation)
  double local_damping = 0;      ///< alpha of f_d = -alpha |f| sgn v
  double kick = 0;               ///< time step of the velocities: time_step, or 0 in an evaluation
  const double* mass = nullptr;  ///< 0 in padding
  const LawConstants* constants = nullptr;  ///< per material pair, at the present strength reduction factor
  const double* dilation_cap = nullptr;     ///< largest elastic volumetric strain of a particle; null = none
  bool keeps_gaps = false;                  ///< what exceeds it turns plastic, else it closes again
  double cohesion_scale = 1;                ///< 1/F, for cohesion that grows with depth
  bool ledger = false;                      ///< book works and dissipation
};

/// Sums of one step, combined in chunk order.
struct Sums {
  double unbalanced = 0;      ///< sum |f_x| + |f_y| over what may move, N
  double power = 0;           ///< sum f . v
  double external_power = 0;  ///< sum f_ext . v
  double displacement2 = 0;   ///< max |u|^2
  double velocity2 = 0;       ///< max |v|^2
  double external_work = 0, internal_work = 0, damping_work = 0, plastic_work = 0;  ///< this step, J; only with ledger
};

struct StepData {
  // model
  const Offset* offsets;
  const BondPack* packs;
  const NeighbourPack* neighbours;
  const Block* blocks;
  const Chunk* chunks;
  int chunk_count;
  const GuidedParticle* guided;
  int guided_count;
  const double *volume, *share, *moment_xx, *moment_xy, *moment_yy, *force_x, *force_y, *free_x, *free_y, *sum_x,
      *sum_y, *extra_cohesion, *compressibility;
  const double *place_x, *place_y;  ///< off the lattice only
  const float* pair_weight;         ///< likewise, by weight_record
  std::int32_t forward_packs;
  double least_r2;  ///< m2, nearer pairs are no bonds but padding
  bool uses_algorithm[kReturnAlgorithms];
  // state
  double *ux, *uy, *vx, *vy, *plastic_volume, *gap;
  const double* plastic_strain;  ///< at the start of the step
  double* plastic_strain_to;     ///< at its end, in place; null in an evaluation, which keeps none
  // scratch
  double *weighted_x, *weighted_y, *lxx, *lxy, *lyx, *lyy, *dilation, *zxx, *zxy, *zyx, *zyy, *px, *py;
  double* volume_source;        ///< null where no flow is dilatant
  double *opening, *mean_load;  ///< of the ledger; mean_load null where volume_source is
};

}  // namespace vbgpd
