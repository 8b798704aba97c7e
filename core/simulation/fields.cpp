// The tables of output fields and named numbers. To add a field: a line here and a case in read_fields.cpp.
#include <array>
#include <limits>

#include "scene/wording.h"
#include "simulation/simulation.h"

namespace vbgpd {

namespace {

constexpr auto kParticle = Location::kParticle;
constexpr auto kBond = Location::kBond;
constexpr auto kReal = FieldType::kReal;
constexpr auto kInteger = FieldType::kInteger;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr FieldInfo kFields[] = {
    {"position", "m", "present position x, y", kParticle, kReal, 2},
    {"reference_position", "m",
     "position x, y in the undeformed section: centre of the lattice cell (in a run-out, of its soil) plus the jitter",
     kParticle, kReal, 2},
    {"displacement", "m", "displacement x, y since creation", kParticle, kReal, 2},
    {"velocity", "m s-1", "velocity x, y (per pseudo-time while a quasi-static job is under way)", kParticle, kReal, 2, true},
    {"stress", "Pa", "Cauchy stress xx, yy, zz, xy, tension positive; effective where there is pore pressure",
     kParticle, kReal, 4},
    {"plastic_strain", "1", "engineering plastic shear strain sqrt(2 e:e), average of the bonds", kParticle, kReal, 1},
    {"plastic_bond_fraction", "1", "share of the bonds that have yielded", kParticle, kReal, 1},
    {"volume", "m2", "soil area of the particle, per metre run a volume", kParticle, kReal, 1},
    {"mass", "kg", "mass per metre run", kParticle, kReal, 1},
    {"pore_pressure", "Pa", "of the water, compression positive; total stress = stress - pore_pressure", kParticle,
     kReal, 1, true},
    {"external_force", "N", "force x, y set from outside, per metre run", kParticle, kReal, 2, true},
    {"material", "1", "index of the material", kParticle, kInteger, 1},
    {"boundary", "1", "index of the boundary that holds a wall particle, -1 = soil", kParticle, kInteger, 1},
    {"particle_id", "1", "stable id, soil first", kParticle, kInteger, 1},
    {"bond_particles", "1", "ids of the two particles of a bond", kBond, kInteger, 2},
    {"bond_state", "1", "0 elastic, 1 has yielded (plastic bond)", kBond, kInteger, 1},
    {"bond_stress", "Pa", "longitudinal, tangential and shear stress of the bond in its own frame", kBond, kReal, 3},
    {"bond_plastic_strain", "1", "engineering plastic shear strain of the bond", kBond, kReal, 1},
    {"active", "1", "1, or 0 where the layer is switched off: no volume, mass, stress or displacement", kParticle,
     kInteger, 1},
};

constexpr NamedValue kValues[] = {
    {"damping", "1", "local damping coefficient of dynamic steps: f_d = -alpha |f| sgn v", 0, 0, 1, true, true},
    {"time_step_factor", "1", "dynamic time step over the stable one; above 1 a run diverges, which is noticed",
     kDefaultTimeStepFactor, 1e-6, 4, false, true},
    {"strength_reduction_factor", "1", "F by which c and tan phi are divided", 1, 1e-3, 1e3, false, true},
    {"kh", "1", "pseudo-static coefficient: body force kh * unit weight towards +x; at first that of the profile", 0,
     -1, 1, true, true, true},
    {"kv", "1", "pseudo-static coefficient: body force kv * unit weight downwards; at first that of the profile", 0, -1,
     1, true, true, true},
    {"time", "s", "simulated time", 0, 0, kInf, false, false},
    {"steps", "1", "dynamic steps done", 0, 0, kInf, false, false},
    {"time_step", "s", "time step of dynamic stepping", kNan, 0, kInf, false, false},
    {"stable_time_step", "s", "2 / highest frequency, measured on the bonds", kNan, 0, kInf, false, false},
    {"unbalanced_force_ratio", "1", "sum |f| / sum of weights and loads", kNan, 0, kInf, false, false},
    {"max_displacement", "m", "largest displacement", 0, 0, kInf, false, false},
    {"max_velocity", "m s-1", "largest velocity", 0, 0, kInf, false, false},
    {"displacement_level", "1", "E u_max / (gamma H^2)", 0, 0, kInf, false, false},
    {"total_mass", "kg", "mass of the soil per metre run", kNan, 0, kInf, false, false},
    {"area", "m2", "area of the section", kNan, 0, kInf, false, false},
    {"height", "m", "height of the slope", kNan, 0, kInf, false, false},
    {"spacing_x", "m", "particle spacing in x", kNan, 0, kInf, false, false},
    {"spacing_y", "m", "particle spacing in y", kNan, 0, kInf, false, false},
    {"particles", "1", "soil and wall particles", kNan, 0, kInf, false, false},
    {"bonds", "1", "virtual bonds", kNan, 0, kInf, false, false},
    {"plastic_bonds", "1", "bonds that have yielded", 0, 0, kInf, false, false},
    {"bytes", "1", "memory of model and state", kNan, 0, kInf, false, false},
    {"kinetic_energy", "J", "per metre run", 0, 0, kInf, false, false},
    {"elastic_energy", "J", "per metre run", 0, 0, kInf, false, false},
    {"plastic_dissipation", "J", "by dynamic steps, per metre run", 0, 0, kInf, false, false},
    {"damping_dissipation", "J", "by dynamic steps, per metre run", 0, 0, kInf, false, false},
    {"external_work", "J",
     "of weight, seismic force, loads, pore water and external forces in dynamic steps, per metre run", 0, -kInf, kInf,
     false, false},
    {"energy_residual", "1",
     "external work - kinetic - elastic - dissipated, relative to the largest of them (velocities brought to the time "
     "of the displacements); nan where walls are moved, whose work is not booked",
     0, 0, kInf, false, false},
};

}  // namespace

std::span<const FieldInfo> fields() { return kFields; }

int find_field(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kFields); ++i)
    if (name == kFields[i].name) return static_cast<int>(i);
  return -1;
}

std::span<const NamedValue> named_values() { return kValues; }

void require_settable(std::string_view name, double value) {
  for (const NamedValue& v : kValues) {
    if (name != v.name) continue;
    if (!v.settable) throw Error(Status::kState, std::string(name) + " can be read, not set");
    if ((v.min_open ? value > v.min_value : value >= v.min_value) &&
        (v.max_open ? value < v.max_value : value <= v.max_value))
      return;
    Issue issue;
    issue.status = Status::kRange, issue.object = ObjectKind::kModel, issue.value = value;
    issue.text = std::string(name) + " = " + number_text(value) + ": must be in " + (v.min_open ? "(" : "[") +
                 number_text(v.min_value) + ", " + number_text(v.max_value) + (v.max_open ? ")" : "]");
    throw Error(issue);
  }
  no_such_value(name);
}

void no_such_value(std::string_view name, std::initializer_list<std::string_view> others) {
  std::vector<std::string_view> known;
  for (const NamedValue& v : kValues) known.emplace_back(v.name);
  known.insert(known.end(), others);
  throw Error(Status::kUnknownName, "a model has no number named \"" + std::string(name) + "\": it has " +
                                        list_text(known) + suggestion_text(name, known));
}

}  // namespace vbgpd
