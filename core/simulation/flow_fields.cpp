// Reading fields of a run-out by particle id or bond by bond.
#include <cmath>

#include "simulation/flow_simulation.h"

namespace vbgpd {

/// Calls f(i, j, slot of the traction) for every bond once; i and j are places in the present order.
template <class F>
void FlowSimulation::for_each_bond(F&& f) const {
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i)
    for (auto k = 4 * static_cast<std::size_t>(lists_.rows[i].begin);
         k < 4 * static_cast<std::size_t>(lists_.rows[i].ghosts); ++k) {
      const auto j = static_cast<std::size_t>(lists_.neighbours[k]);
      if (j <= i || j >= static_cast<std::size_t>(model_.particles)) continue;
      const double* const a = state_.motion.data() + 4 * i;
      const double* const b = state_.motion.data() + 4 * j;
      const Real x = b[0] - a[0], y = b[1] - a[1];
      if (x * x + y * y < model_.support * model_.support) f(i, j, 8 * (k / 4) + k % 4);
    }
}

std::int64_t FlowSimulation::bond_count() const {
  std::int64_t count = 0;
  for_each_bond([&](std::size_t, std::size_t, std::size_t) { ++count; });
  return count;
}

/// A bond is plastic when one of its ends has yielded, and a pseudo-spring when it is broken.
bool FlowSimulation::plastic(std::size_t i, std::size_t j, std::size_t slot) const {
  if (model_.bond == FlowBondLaw::kPseudoSpring) return state_.traction[slot] > 0 && !(state_.traction[slot + 4] > 0);
  return state_.plastic_strain[i] > 0 || state_.plastic_strain[j] > 0;
}

Real FlowSimulation::plastic_bond_count() const {
  Real count = 0;
  for_each_bond([&](std::size_t i, std::size_t j, std::size_t slot) { count += plastic(i, j, slot) ? 1 : 0; });
  return count;
}

namespace {

void require_known(std::string_view name) {
  for (const std::string_view known :
       {"position", "reference_position", "displacement", "velocity", "stress", "plastic_strain",
        "plastic_bond_fraction", "volume", "mass", "material", "boundary", "particle_id", "external_force",
        "pore_pressure", "bond_particles", "bond_state", "bond_stress", "bond_plastic_strain", "active"})
    if (name == known) return;
  throw Error(Status::kUnsupported, "a run-out has no field '" + std::string(name) + "'");
}

}  // namespace

void FlowSimulation::read(int field, std::vector<double>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  require_known(info.name);
  if (info.type == FieldType::kInteger) {
    std::vector<std::int64_t> integers;
    read(field, integers);
    out.assign(integers.begin(), integers.end());
    return;
  }
  if (info.location == Location::kParticle) read_particles(field, out);
  else read_bonds(field, out);
}

void FlowSimulation::read_particles(int field, std::vector<double>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  const auto components = static_cast<std::size_t>(info.components), n = static_cast<std::size_t>(model_.particles);
  out.assign(n * components, 0);
  std::vector<Real> bonds, yielded;
  if (name == "plastic_bond_fraction") {
    bonds.assign(n, 0), yielded.assign(n, 0);
    for_each_bond([&](std::size_t i, std::size_t j, std::size_t slot) {
      const Real one = plastic(i, j, slot) ? 1 : 0;
      ++bonds[i], ++bonds[j], yielded[i] += one, yielded[j] += one;
    });
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto id = static_cast<std::size_t>(state_.particle[i]);
    double* const row = out.data() + id * components;
    const double* const m = state_.motion.data() + 4 * i;
    const double* const s = state_.stress.data() + 4 * i;
    if (name == "position") row[0] = m[0] + model_.origin.x(), row[1] = m[1] + model_.origin.y();
    if (name == "reference_position")
      row[0] = model_.reference_x[id] + model_.origin.x(), row[1] = model_.reference_y[id] + model_.origin.y();
    if (name == "displacement") row[0] = m[0] - model_.reference_x[id], row[1] = m[1] - model_.reference_y[id];
    if (name == "velocity") row[0] = m[2], row[1] = m[3];
    if (name == "stress") row[0] = s[0] + s[3], row[1] = s[1] + s[3], row[2] = s[3] - s[0] - s[1], row[3] = s[2];
    if (name == "plastic_strain") row[0] = state_.plastic_strain[i];
    if (name == "plastic_bond_fraction") row[0] = bonds[i] > 0 ? yielded[i] / bonds[i] : 0;
    if (name == "volume") row[0] = model_.volume[id];
    if (name == "mass") row[0] = model_.mass[id];
    if (name == "pore_pressure" && model_.pore_pressure.present()) row[0] = model_.pore_pressure[id];
    if (name == "external_force" && outside_.external_x.present())
      row[0] = outside_.external_x[id], row[1] = outside_.external_y[id];
  }
}

void FlowSimulation::read_bonds(int field, std::vector<double>& out) const {
  const std::string_view name = fields()[static_cast<std::size_t>(field)].name;
  out.clear();
  for_each_bond([&](std::size_t i, std::size_t j, std::size_t slot) {
    if (name == "bond_plastic_strain") {
      out.push_back((state_.plastic_strain[i] + state_.plastic_strain[j]) / 2);
      return;
    }
    const double *const a = state_.motion.data() + 4 * i, *const b = state_.motion.data() + 4 * j;
    const double *const s = state_.stress.data() + 4 * i, *const t = state_.stress.data() + 4 * j;
    const Vec2 n = Vec2(b[0] - a[0], b[1] - a[1]).normalized();
    const Real c = n.x(), d = n.y();
    const Real xx = (s[0] + s[3] + t[0] + t[3]) / 2, yy = (s[1] + s[3] + t[1] + t[3]) / 2, xy = (s[2] + t[2]) / 2;
    const bool pulls = model_.bond == FlowBondLaw::kVirtual;
    const Real tx = pulls ? state_.traction[slot] : 0, ty = pulls ? state_.traction[slot + 4] : 0;
    out.push_back(xx * c * c + yy * d * d + 2 * xy * c * d + tx * c + ty * d);
    out.push_back(xx * d * d + yy * c * c - 2 * xy * c * d);
    out.push_back((yy - xx) * c * d + xy * (c * c - d * d) - tx * d + ty * c);
  });
}

void FlowSimulation::read(int field, std::vector<std::int64_t>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  require_known(info.name);
  if (info.type != FieldType::kInteger)
    throw Error(Status::kArgument, std::string("field '") + info.name + "' holds real numbers; read it as such");
  const std::string_view name = info.name;
  out.clear();
  if (info.location == Location::kParticle) {
    out.assign(static_cast<std::size_t>(model_.particles), 0);
    for (std::size_t id = 0; id < out.size(); ++id) {
      if (name == "material") out[id] = model_.material[id];
      if (name == "boundary") out[id] = -1;
      if (name == "particle_id") out[id] = static_cast<std::int64_t>(id);
      if (name == "active") out[id] = 1;
    }
    return;
  }
  const auto id = [&](std::size_t i) { return static_cast<std::int64_t>(state_.particle[i]); };
  for_each_bond([&](std::size_t i, std::size_t j, std::size_t slot) {
    if (name == "bond_particles") out.push_back(id(i)), out.push_back(id(j));
    if (name == "bond_state") out.push_back(plastic(i, j, slot) ? 1 : 0);
  });
}

}  // namespace vbgpd
