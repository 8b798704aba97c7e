// The lists of a model: particles sit on a lattice, numbered line by line (along x or y, whichever leaves fewer lanes
// of packs empty), so that `width` consecutive particles and one lattice offset make one pack of bonds. Plain data, no
// containers.
#pragma once

#include <cstdint>

#include "material/constants.h"

namespace vbgpd {

/// Geometry of one lattice offset: the same for every bond along it, unless particles are off the lattice.
struct Offset {
  double xi_x = 0, xi_y = 0;  ///< X_j - X_i, m
  double weight = 0;          ///< omega_ij = W(r), 1/m2
  double inverse_r2 = 0;      ///< 1/m2
  double g_x = 0, g_y = 0;    ///< omega_ij xi, 1/m
  // as bonds take them, with the factors that the mean of two ends brings
  double half_x = 0, half_y = 0;        ///< xi / 2, m
  double twice_n_x = 0, twice_n_y = 0;  ///< 2 xi / r^2, 1/m
  double half_weight = 0;               ///< omega_ij / 2
  double pull = 0;                      ///< 4 / r^2, 1/m2
};

/// Of the pair a vector xi apart; a particle is at no offset from itself.
inline Offset offset_of(double xi_x, double xi_y, double weight) {
  const double r2 = xi_x * xi_x + xi_y * xi_y, inverse_r2 = r2 > 0 ? 1 / r2 : 0;
  const double twice = 2 * inverse_r2;
  return {xi_x,     xi_y,     weight,       inverse_r2,   weight * xi_x, weight * xi_y,
          xi_x / 2, xi_y / 2, xi_x * twice, xi_y * twice, weight / 2,    2 * twice};
}

/// `width` bonds between particles i.. and j.., all of one pair of materials. Sorted by return algorithm, then block.
struct BondPack {
  std::int32_t i = 0, j = 0;  ///< first particle of each end
  std::int32_t slot = 0;      ///< record of the bonds' plastic strain
  std::uint16_t pair = 0;     ///< material pair, index into the table of law constants
  std::uint8_t offset = 0;    ///< index into the forward offsets
  std::uint8_t lanes =
      0xff;  ///< bit l: lane l is a bond of this pack; 0xff: nothing to hide (absent ones have no volume)
};

/// A neighbour pack seen from one side: for the sums over all neighbours of a particle.
struct NeighbourPack {
  std::int32_t j = 0;
  std::uint8_t offset = 0;  ///< index into all offsets: forward ones, then their opposites in the same order
  std::uint8_t lanes = 0xff;
};

/// A run of `width` particles.
struct Block {
  std::int32_t first = 0;                                 ///< first particle
  std::int32_t neighbours_begin = 0, neighbours_end = 0;  ///< range of neighbour packs, forward ones first
  std::int32_t backward_begin = 0;                        ///< where those at opposite offsets begin
  std::int32_t forward_before = 0;                        ///< forward packs of all blocks before
};

/// Where off the lattice the weights of a neighbour pack stand: those of forward packs first, in the order of their
/// bonds' records; then those of the opposites.
inline std::int32_t weight_record(const Block& block, std::int32_t pack, std::int32_t forward_packs) {
  if (pack < block.backward_begin) return pack - block.neighbours_begin + block.forward_before;
  const std::int32_t forward_until = block.forward_before + block.backward_begin - block.neighbours_begin;
  return forward_packs + pack - forward_until;
}

/// A piece of work that one thread does at a time; packs of chunk c only reach particles of chunks c and c + 1.
struct Chunk {
  std::int32_t blocks_begin = 0, blocks_end = 0;
  std::int32_t packs_begin[kReturnAlgorithms] = {}, packs_end[kReturnAlgorithms] = {};  ///< bonds to return by each
};

/// A wall particle that slides along a wall (roller) or is moved (prescribed velocity).
struct GuidedParticle {
  std::int32_t particle = 0;
  std::int32_t prescribed = 0;  ///< 1: moves with (x, y) m/s; 0: may not move along the normal (x, y)
  double x = 0, y = 0;
};

}  // namespace vbgpd
