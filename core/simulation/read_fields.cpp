// Reading fields of a lattice simulation by particle id or bond by bond.
#include <cmath>

#include "simulation/lattice_simulation.h"

namespace vbgpd {

void LatticeSimulation::read(int field, std::vector<double>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  if (info.type == FieldType::kInteger) {
    std::vector<std::int64_t> integers;
    read(field, integers);
    out.assign(integers.begin(), integers.end());
    return;
  }
  if (info.location == Location::kParticle) read_particles(field, out);
  else read_bonds(field, out);
}

void LatticeSimulation::read_particles(int field, std::vector<double>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  const auto components = static_cast<std::size_t>(info.components);
  ParticleFields averages;
  if (name == "stress" || name == "plastic_strain" || name == "plastic_bond_fraction") {
    evaluate();
    averages = particle_fields(model_, state_, scratch_, constants_, 1 / factor_);
  }
  out.assign(section_.seeds.size() * components, 0);
  for (std::size_t k = 0; k < section_.seeds.size(); ++k) {
    const auto i = static_cast<std::size_t>(model_.storage_of[k]);
    double* row = out.data() + static_cast<std::size_t>(model_.id_of[k]) * components;
    const Vec2 reference = section_.place(k);
    if (name == "position")
      row[0] = reference.x() + state_.displacement_x[i], row[1] = reference.y() + state_.displacement_y[i];
    if (name == "reference_position") row[0] = reference.x(), row[1] = reference.y();
    if (name == "displacement") row[0] = state_.displacement_x[i], row[1] = state_.displacement_y[i];
    if (name == "velocity") row[0] = state_.velocity_x[i], row[1] = state_.velocity_y[i];
    if (name == "stress")
      row[0] = averages.xx[i], row[1] = averages.yy[i], row[2] = averages.zz[i], row[3] = averages.xy[i];
    if (name == "plastic_strain") row[0] = averages.plastic_strain[i];
    if (name == "plastic_bond_fraction") row[0] = averages.plastic_fraction[i];
    if (name == "volume") row[0] = model_.volume[i];
    if (name == "mass") row[0] = model_.mass[i];
    if (name == "pore_pressure" && outside_.pore_pressure.present()) row[0] = outside_.pore_pressure[i];
    if (name == "external_force") {
      if (outside_.external_x.present()) row[0] = outside_.external_x[i];
      if (outside_.external_y.present()) row[1] = outside_.external_y[i];
    }
  }
}

void LatticeSimulation::read_bonds(int field, std::vector<double>& out) const {
  const std::string_view name = fields()[static_cast<std::size_t>(field)].name;
  out.clear();
  if (model_.features.bond == BondLaw::kNone) return;
  evaluate();
  for_each_bond(model_, state_, scratch_, constants_, 1 / factor_, [&](const ObservedBond& b) {
    if (name == "bond_plastic_strain") {
      out.push_back(b.plastic_shear);
      return;
    }
    const auto place = [&](std::int32_t i) {
      return section_.local_place(static_cast<std::size_t>(model_.seed_of[static_cast<std::size_t>(i)]));
    };
    const Vec2 n = (place(b.j) - place(b.i)).normalized();
    const Real xx = b.sxx + b.mean, yy = b.syy + b.mean, c = n.x(), s = n.y();
    out.push_back(xx * c * c + yy * s * s + 2 * b.sxy * c * s);
    out.push_back(xx * s * s + yy * c * c - 2 * b.sxy * c * s);
    out.push_back((yy - xx) * c * s + b.sxy * (c * c - s * s));
  });
}

void LatticeSimulation::read(int field, std::vector<std::int64_t>& out) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  if (info.type != FieldType::kInteger)
    throw Error(Status::kArgument, std::string("field '") + info.name + "' holds real numbers; read it as such");
  const std::string_view name = info.name;
  out.clear();
  if (info.location == Location::kParticle) {
    out.assign(section_.seeds.size(), 0);
    for (std::size_t k = 0; k < section_.seeds.size(); ++k) {
      const Seed& seed = section_.seeds[k];
      std::int64_t& value = out[static_cast<std::size_t>(model_.id_of[k])];
      if (name == "material") value = seed.material;
      if (name == "boundary") value = seed.hold == Hold::kFree ? -1 : seed.boundary;
      if (name == "particle_id") value = model_.id_of[k];
      if (name == "active") value = seed.active ? 1 : 0;
    }
    return;
  }
  if (model_.features.bond == BondLaw::kNone) return;
  const auto id = [&](std::int32_t i) {
    return model_.id_of[static_cast<std::size_t>(model_.seed_of[static_cast<std::size_t>(i)])];
  };
  for_each_bond(model_, state_, scratch_, constants_, 1 / factor_, [&](const ObservedBond& b) {
    if (name == "bond_particles") out.push_back(id(b.i)), out.push_back(id(b.j));
    if (name == "bond_state") out.push_back(b.plastic ? 1 : 0);
  });
}

}  // namespace vbgpd
