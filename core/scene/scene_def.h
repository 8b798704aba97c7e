// What the user says: plain data, SI units, angles in degrees. Nothing here computes anything.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace vbgpd {

struct Point {
  double x = 0, y = 0;  ///< m; x to the right, y up; map-sized coordinates are welcome
};
using Polygon = std::vector<Point>;  ///< any winding, first vertex not repeated (a repeated last vertex is dropped)

/// The units a scene was written in, for messages; every number here is in SI.
enum class Units { kSI, kKilopascal };

/// A soil. `law` names an entry of AnyLaw (material/any_law.h). kNone (NaN) marks a value the user left out.
struct MaterialDef {
  std::string name;
  std::string law = "mohr_coulomb";      ///< elastic, drucker_prager, mohr_coulomb, undrained
  double unit_weight = kNone;            ///< N/m3, total, required
  double saturated_unit_weight = kNone;  ///< N/m3, total, below the water table; absent = unit_weight
  /// r_u: pore pressure over the weight of the soil above, [0, 1); a soil that has one knows no water table.
  double pore_pressure_ratio = 0;
  double young_modulus = 1e8;     ///< Pa; the factor of safety does not depend on it
  double poisson_ratio = 0.3;     ///< in (-1, 0.5)
  double cohesion = kNone;        ///< Pa; required by every law but elastic
  double friction_angle = 0;      ///< degrees, [0, 90)
  double dilatancy_angle = 0;     ///< degrees, [0, friction_angle]
  double tension_cutoff = kNone;  ///< Pa, >= 0; absent = the apex of the cone
  double cohesion_gradient = 0;   ///< Pa per metre of depth below cohesion_datum (undrained), >= 0
  double cohesion_datum = kNone;  ///< elevation y, m; required with cohesion_gradient
};

/// A region of one material. Layers are painted in order: a later one overwrites.
struct LayerDef {
  std::string material;  ///< name of a material
  Polygon polygon;       ///< empty = fills the exterior; parts outside the exterior are ignored
};

enum class BoundaryKind { kFree, kFixed, kRoller, kVelocity };
inline constexpr std::array<std::string_view, 4> kBoundaryKinds{"free", "fixed", "roller", "velocity"};

/// How a piece of the outline is held. Either `side` or `polyline` is given.
struct BoundaryDef {
  std::string name;  ///< optional
  std::string side;  ///< "base", "left", "right", or empty when a polyline is given
  Polygon polyline;  ///< points along the exterior, >= 2
  BoundaryKind kind = BoundaryKind::kFixed;
  double vx = 0, vy = 0;  ///< m/s, kVelocity only
  /// Degrees, kFixed only: in a run-out the soil slides on it by Coulomb friction; absent = rough: no slip.
  double friction_angle = kNone;
};

/// Vertical pressure on the ground surface between x0 and x1, linear from pressure to pressure_end (Pa, down positive).
struct LoadDef {
  double x0 = kNone, x1 = kNone, pressure = kNone, pressure_end = kNone;
};

/// A value printed in the literature for this scene, carried along for reports.
struct PublishedValue {
  std::string method, source;
  double factor_of_safety = kNone, factor_of_safety_end = kNone;  ///< the end of a band, or NaN
};

/// Largest ratio of the stiffnesses of yielding soils that a strength reduction leaves as it is, unless told otherwise.
inline constexpr double kStiffnessContrast = 3;

struct StrengthReductionDef {
  double srf_min = 0.1;  ///< search range of the strength reduction factor
  double srf_max = 20;
  double tolerance = 0.005;  ///< width of the bracket asked for
};

struct SceneDef {
  std::string name, source;
  Units units = Units::kSI;  ///< that messages are to use
  Polygon exterior;
  std::vector<MaterialDef> materials;
  std::vector<LayerDef> layers;
  std::vector<BoundaryDef> boundaries;  ///< empty = base fixed, left and right rollers
  std::vector<LoadDef> loads;
  /// Ground water, hydrostatic below this line; points from left to right, empty = dry. Above the ground it stands.
  Polygon water_table;
  double water_unit_weight = 9810;  ///< N/m3
  double kh = 0, kv = 0;   ///< pseudo-static coefficients: extra body force kh*unit_weight in +x, kv*unit_weight in -y
  double gravity = 9.81;   ///< m/s2, turns unit weight into density
  double spacing = kNone;  ///< m between particles, required
  /// virtual_bond (VB-S; VB-H in a run-out), none (corrected nodal SPH), or a rival to compare with in a run-out (sph,
  /// sph_artificial_stress, pseudo_spring, gpd), which acts as none before it.
  std::string bond = "virtual_bond";
  std::string kernel = "wendland_c2";  ///< wendland_c2 or cubic_spline
  double smoothing_ratio = 1.3;        ///< smoothing length / spacing; the support radius is twice the smoothing length
  double jitter = 0;  ///< largest random shift of a particle out of the centre of its cell, in spacings; 0 = a lattice
  StrengthReductionDef strength_reduction;
  std::vector<PublishedValue> published;
};

}  // namespace vbgpd
