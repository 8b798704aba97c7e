// What a partner program sets while a simulation runs: forces on particles and the pressure of the water in the pores.
#pragma once

#include <string>
#include <vector>

#include "state/model.h"

namespace vbgpd {

struct FieldInfo;
struct Drive;
struct Section;

/// By storage index; absent arrays have no bytes.
struct Outside {
  Array external_x, external_y;  ///< N per metre run
  Array pore_pressure;           ///< Pa, compression positive
};

/// Z_i = V_i S_i M_i^-1 / V_i of VB5: two particles push each other with omega_ij V_i V_j (Z_i + Z_j) xi_ij.
struct NodalFlux {
  const Array &xx, &xy, &yx, &yy;
};

/// The nodal flux of the stress -p I, every bond with the mean pressure of its ends.
struct PoreFlux {
  Array xx, xy, yy;
  PoreFlux(const Model& m, const Array& pore_pressure);
  NodalFlux nodal() const { return {xx, xy, xy, yy}; }
};

/// Adds the force of the pore water to m.force_x, m.force_y: the internal force (VB5) of the stress -p I. The bonds are
/// fixed, so this sum is made once per pressure field; the bonds go on to carry effective stress.
void add_pore_force(const Array& pore_pressure, Model& m);

/// m/s, of what may be written: beyond it kinetic energy and the works booked with it would soon be no numbers that a
/// checkpoint holds, and no wave in soil is as fast.
inline constexpr double kLargestSpeed = 1e9;
/// The largest magnitude that may be written to a field; NaN and infinity are beyond it.
double largest_written(const FieldInfo& info);
/// What is wrong with a number beyond that, as "is not a finite number".
std::string fault_text(double value, double largest);
/// Throws Error(kRange) that names the first particle with such a number; rows by particle id.
void require_writable(const FieldInfo& info, const std::vector<double>& rows);

/// Throws Error(kRange) for loads and velocities that are not finite, Error(kState) for a velocity of a boundary that
/// does not move.
void require_drive(const Drive& wanted, const Drive& present, const Section& section);

/// Calls f(i, j, force of j on i) for every particle i and each of its neighbours j.
template <class F>
void for_each_flux_force(const Model& m, const NodalFlux& z, F&& f) {
  for (const Block& block : m.blocks)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(block.first + l);
      if (m.seed_of[i] < 0) continue;
      for (std::int32_t k = block.neighbours_begin; k < block.neighbours_end; ++k) {
        const NeighbourPack& p = m.neighbours[static_cast<std::size_t>(k)];
        const auto j = static_cast<std::size_t>(p.j + l);
        if (((p.lanes >> l) & 1) == 0 || m.seed_of[j] < 0) continue;
        const Offset o = m.offset(k, block, l);
        const Real weight = o.weight * m.volume[i] * m.volume[j];
        f(i, j,
          Vec2(weight * ((z.xx[i] + z.xx[j]) * o.xi_x + (z.xy[i] + z.xy[j]) * o.xi_y),
               weight * ((z.yx[i] + z.yx[j]) * o.xi_x + (z.yy[i] + z.yy[j]) * o.xi_y)));
      }
    }
}

}  // namespace vbgpd
