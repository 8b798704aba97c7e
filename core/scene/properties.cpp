// One line per number of a scene; the member pointer beside each serves reading and writing by name.
#include "scene/properties.h"

#include <array>
#include <limits>
#include <utility>
#include <variant>

namespace vbgpd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Member = std::variant<double MaterialDef::*, double LoadDef::*, double BoundaryDef::*, double SceneDef::*,
                            double StrengthReductionDef::*>;

struct Entry {
  Member member;
  Property property;
};

struct Range {
  double min, max;
  bool min_open, max_open;
};
constexpr Range kAny{-kInfinity, kInfinity, true, true};
constexpr Range kPositive{0, kInfinity, true, true};
constexpr Range kNotNegative{0, kInfinity, false, true};
constexpr Range kAngle{0, 90, false, true};
constexpr Range kFactor{1e-3, 1e3, false, false};
constexpr Range kCoefficient{-1, 1, true, true};

template <typename Object>
constexpr Entry entry(double Object::*member, ObjectKind object, const char* name, const char* unit,
                      double default_value, Range range, const char* doc, bool required = false) {
  return {member,
          {object, name, unit, doc, default_value, range.min, range.max, range.min_open, range.max_open, required}};
}

constexpr auto kMaterial = ObjectKind::kMaterial;
constexpr auto kLoad = ObjectKind::kLoad;
constexpr auto kBoundary = ObjectKind::kBoundary;
constexpr auto kScene = ObjectKind::kProfile;
constexpr bool kRequired = true;

constexpr std::array kEntries = {
    entry(&MaterialDef::unit_weight, kMaterial, "unit_weight", "N m-3", kNone, kNotNegative, "Total unit weight.",
          kRequired),
    entry(&MaterialDef::saturated_unit_weight, kMaterial, "saturated_unit_weight", "N m-3", kNone, kNotNegative,
          "Total unit weight below the water table; absent = unit_weight."),
    entry(&MaterialDef::pore_pressure_ratio, kMaterial, "pore_pressure_ratio", "1", 0, Range{0, 1, false, true},
          "r_u: pore pressure over the weight of the soil above; such a soil knows no water table."),
    entry(&MaterialDef::young_modulus, kMaterial, "young_modulus", "Pa", 1e8, kPositive,
          "Young's modulus; the factor of safety does not depend on it."),
    entry(&MaterialDef::poisson_ratio, kMaterial, "poisson_ratio", "1", 0.3, Range{-1, 0.5, true, true},
          "Poisson's ratio."),
    entry(&MaterialDef::cohesion, kMaterial, "cohesion", "Pa", kNone, kNotNegative,
          "Cohesion, or undrained shear strength; needed by every law but elastic."),
    entry(&MaterialDef::friction_angle, kMaterial, "friction_angle", "degree", 0, kAngle,
          "Angle of internal friction."),
    entry(&MaterialDef::dilatancy_angle, kMaterial, "dilatancy_angle", "degree", 0, kAngle,
          "Angle of dilatancy, at most the friction angle."),
    entry(&MaterialDef::tension_cutoff, kMaterial, "tension_cutoff", "Pa", kNone, kNotNegative,
          "Largest tension; absent = the apex of the cone, in a run-out none."),
    entry(&MaterialDef::cohesion_gradient, kMaterial, "cohesion_gradient", "Pa m-1", 0, kNotNegative,
          "Growth of cohesion with depth below cohesion_datum, law undrained."),
    entry(&MaterialDef::cohesion_datum, kMaterial, "cohesion_datum", "m", kNone, kAny,
          "Elevation below which cohesion grows; needed with cohesion_gradient."),

    entry(&LoadDef::x0, kLoad, "x0", "m", kNone, kAny, "Left end of the load.", kRequired),
    entry(&LoadDef::x1, kLoad, "x1", "m", kNone, kAny, "Right end of the load, right of x0.", kRequired),
    entry(&LoadDef::pressure, kLoad, "pressure", "Pa", kNone, kAny, "Pressure at x0, positive downwards.", kRequired),
    entry(&LoadDef::pressure_end, kLoad, "pressure_end", "Pa", kNone, kAny,
          "Pressure at x1, positive downwards; linear in between.", kRequired),

    entry(&BoundaryDef::vx, kBoundary, "vx", "m s-1", 0, kAny, "Velocity to the right, kind velocity."),
    entry(&BoundaryDef::vy, kBoundary, "vy", "m s-1", 0, kAny, "Velocity upwards, kind velocity."),
    entry(&BoundaryDef::friction_angle, kBoundary, "friction_angle", "degree", kNone, kAngle,
          "Coulomb friction of a fixed boundary in a run-out; absent = rough: no slip."),

    entry(&SceneDef::water_unit_weight, kScene, "water_unit_weight", "N m-3", 9810, kPositive,
          "Unit weight of the water below the water table."),
    entry(&SceneDef::kh, kScene, "kh", "1", 0, kCoefficient,
          "Horizontal pseudo-static coefficient: body force kh * unit weight towards +x."),
    entry(&SceneDef::kv, kScene, "kv", "1", 0, kCoefficient,
          "Vertical pseudo-static coefficient: body force kv * unit weight downwards."),
    entry(&SceneDef::gravity, kScene, "gravity", "m s-2", 9.81, kPositive, "Turns unit weight into density."),
    entry(&SceneDef::spacing, kScene, "spacing", "m", kNone, kPositive,
          "Distance between particles; a twentieth of the slope height is a good start.", kRequired),
    entry(&SceneDef::smoothing_ratio, kScene, "smoothing_ratio", "1", 1.3, Range{1.1, 2, false, false},
          "Smoothing length / spacing; the support radius is twice the smoothing length."),
    entry(&SceneDef::jitter, kScene, "jitter", "1", 0, Range{0, 0.5, false, true},
          "Largest random shift of a particle out of the centre of its cell, in spacings; 0 = a lattice."),
    entry(&StrengthReductionDef::srf_min, kScene, "srf_min", "1", 0.1, kFactor,
          "Smallest strength reduction factor tried."),
    entry(&StrengthReductionDef::srf_max, kScene, "srf_max", "1", 20, kFactor,
          "Largest strength reduction factor tried."),
    entry(&StrengthReductionDef::tolerance, kScene, "srf_tolerance", "1", 0.005, Range{1e-4, 0.5, false, false},
          "Width of the bracket of the factor of safety asked for."),
};

constexpr auto kProperties = [] {
  std::array<Property, kEntries.size()> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = kEntries[i].property;
  return table;
}();

template <typename Objects>
auto* nth(Objects& objects, std::int64_t id) {
  return id >= 0 && id < static_cast<std::int64_t>(objects.size()) ? &objects[static_cast<std::size_t>(id)] : nullptr;
}

/// The object a member pointer belongs to, or nullptr when the scene has no such object.
struct Owner {
  const SceneDef& scene;
  std::int64_t id;
  const MaterialDef* of(double MaterialDef::*) const { return nth(scene.materials, id); }
  const LoadDef* of(double LoadDef::*) const { return nth(scene.loads, id); }
  const BoundaryDef* of(double BoundaryDef::*) const { return nth(scene.boundaries, id); }
  const SceneDef* of(double SceneDef::*) const { return &scene; }
  const StrengthReductionDef* of(double StrengthReductionDef::*) const { return &scene.strength_reduction; }
};

}  // namespace

std::span<const Property> properties() { return kProperties; }

const double* find_property(const SceneDef& scene, ObjectKind object, std::int64_t id, std::string_view name) {
  for (const Entry& entry : kEntries) {
    if (entry.property.object != object || name != entry.property.name) continue;
    return std::visit(
        [&](auto member) -> const double* {
          const auto* owner = Owner{scene, id}.of(member);
          return owner ? &(owner->*member) : nullptr;
        },
        entry.member);
  }
  return nullptr;
}

double* find_property(SceneDef& scene, ObjectKind object, std::int64_t id, std::string_view name) {
  return const_cast<double*>(find_property(std::as_const(scene), object, id, name));
}

}  // namespace vbgpd
