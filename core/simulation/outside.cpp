#include "simulation/outside.h"

#include <cmath>
#include <limits>
#include <string_view>

#include "scene/wording.h"
#include "simulation/simulation.h"

namespace vbgpd {

namespace {

[[noreturn]] void refuse(ObjectKind object, std::size_t id, double value, const std::string& text) {
  Issue issue;
  issue.status = Status::kRange, issue.object = object, issue.object_id = static_cast<std::int64_t>(id);
  issue.value = value, issue.text = text;
  throw Error(issue);
}

}  // namespace

PoreFlux::PoreFlux(const Model& m, const Array& pressure) {
  const auto n = static_cast<std::size_t>(m.storage);
  xx.allocate(n, 4, m.heap), xy.allocate(n, 5, m.heap), yy.allocate(n, 6, m.heap);
  // VB5 for an isotropic stress: V_i S_i = m I sum_j B_ij/2, and no pair force
  const bool bonded = m.features.bond != BondLaw::kNone;
  for (const BondPack& p : m.packs)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(p.i + l), j = static_cast<std::size_t>(p.j + l);
      if (((p.lanes >> l) & 1) == 0 || m.seed_of[i] < 0 || m.seed_of[j] < 0) continue;
      const Real bond_volume =
          bonded ? m.offset(p, l).weight * (m.volume[i] * m.share[j] + m.share[i] * m.volume[j]) : m.volume[i];
      const Real half = -(pressure[i] + pressure[j]) / 2 * bond_volume / 2;
      xx[i] += half, xx[j] += half;  // without bonds i == j: the whole of it
    }
  for (std::size_t i = 0; i < n; ++i) {
    if (m.seed_of[i] < 0) continue;
    const Real flux = xx[i] / m.volume[i];
    xx[i] = flux * m.moment_xx[i], xy[i] = flux * m.moment_xy[i], yy[i] = flux * m.moment_yy[i];
  }
}

void add_pore_force(const Array& pressure, Model& m) {
  const PoreFlux flux(m, pressure);
  for_each_flux_force(m, flux.nodal(), [&](std::size_t i, std::size_t, const Vec2& force) {
    m.force_x[i] += force.x(), m.force_y[i] += force.y();
  });
}

double largest_written(const FieldInfo& info) {
  return std::string_view(info.name) == "velocity" ? kLargestSpeed : std::numeric_limits<double>::max();
}

std::string fault_text(double value, double largest) {
  if (!std::isfinite(value)) return "is not a finite number";
  return "is " + number_text(value) + " m/s; it must be between -" + number_text(largest) + " and " +
         number_text(largest) + " m/s";
}

void require_writable(const FieldInfo& info, const std::vector<double>& rows) {
  const double largest = largest_written(info);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::fabs(rows[k]) <= largest) continue;
    Issue issue;
    issue.status = Status::kRange, issue.object = ObjectKind::kModel, issue.value = rows[k];
    issue.item = static_cast<std::int64_t>(k) / info.components;
    issue.text =
        std::string(info.name) + " of particle " + std::to_string(issue.item) + " " + fault_text(rows[k], largest);
    throw Error(issue);
  }
}

void require_drive(const Drive& wanted, const Drive& present, const Section& section) {
  for (std::size_t n = 0; n < wanted.loads.size(); ++n)
    for (const double p : {wanted.loads[n].pressure, wanted.loads[n].pressure_end})
      if (!std::isfinite(p)) refuse(ObjectKind::kLoad, n, p, "the pressure of a load must be a finite number of Pa");
  for (std::size_t n = 0; n < wanted.velocities.size(); ++n) {
    const Vec2& v = wanted.velocities[n];
    if (!v.allFinite())
      refuse(ObjectKind::kBoundary, n, v.x(), "the velocity of a boundary must be finite numbers of m/s");
    if (v != present.velocities[n] && section.boundaries[n].kind != BoundaryKind::kVelocity)
      throw Error(Status::kState, "boundary " + std::to_string(n) +
                                      " does not move: only boundaries of kind velocity can be given one");
  }
}

}  // namespace vbgpd
