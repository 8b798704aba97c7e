// Exact collapse loads, as factors of safety whose true value is 1: each on one grid and extrapolated over two.
#include <cmath>
#include <numbers>

#include "../sample_scene.h"
#include "problem.h"

namespace vbgpd::accuracy {

namespace {

Outcome factor_of_safety(const char* name, int levels, const SceneDef& choice, const CompileOptions& options) {
  SceneDef s = sample_scene(name);
  s.bond = choice.bond, s.kernel = choice.kernel, s.spacing = choice.spacing;
  return factor_of_safety_error(*Simulation::compile(s, options), levels);
}

using Options = CompileOptions;
Outcome vertical_cut_1(const SceneDef& c, const Options& o) { return factor_of_safety("vertical_cut", 1, c, o); }
Outcome vertical_cut_2(const SceneDef& c, const Options& o) { return factor_of_safety("vertical_cut", 2, c, o); }
Outcome prandtl_1(const SceneDef& c, const Options& o) { return factor_of_safety("prandtl_strip", 1, c, o); }
Outcome prandtl_2(const SceneDef& c, const Options& o) { return factor_of_safety("prandtl_strip", 2, c, o); }
Outcome strip_on_slope_1(const SceneDef& c, const Options& o) { return factor_of_safety("prandtl_60", 1, c, o); }
Outcome strip_on_slope_2(const SceneDef& c, const Options& o) { return factor_of_safety("prandtl_60", 2, c, o); }
Outcome slope_45_1(const SceneDef& c, const Options& o) { return factor_of_safety("slope_45", 1, c, o); }
Outcome slope_45_2(const SceneDef& c, const Options& o) { return factor_of_safety("slope_45", 2, c, o); }

/// A face of 1.5 : 1 without cohesion: the skin slides, whatever its thickness.
Outcome infinite_slope(const SceneDef& choice, const Options& options) {
  constexpr double kFriction = 35, kRun = 1.5;
  MaterialDef sand = elastic_material();
  sand.law = "mohr_coulomb", sand.cohesion = 0, sand.friction_angle = kFriction;
  SceneDef s = rectangle(choice, sand, 1, 1);
  s.exterior = {{0, 0}, {12 + 10 * kRun, 0}, {12, 10}, {0, 10}};
  s.boundaries = {held("base", BoundaryKind::kFixed), held("left", BoundaryKind::kRoller)};
  const double exact = std::tan(kFriction * std::numbers::pi / 180) * kRun;
  return factor_of_safety_error(*Simulation::compile(s, options), 1, exact);
}

/// A wall of height H before clay on a rough base, with the pressure gamma z -+ 2 c on it that just holds the clay, or
/// just pushes it. The pressure acts on the first column of particles, half a spacing inside.
Outcome rankine(const SceneDef& choice, const Options& options, double sign) {
  constexpr double kHeight = 10;
  MaterialDef clay = elastic_material();
  clay.law = "undrained", clay.cohesion = clay.unit_weight * kHeight / 8;
  SceneDef s = rectangle(choice, clay, 2.5 * kHeight, kHeight);
  s.boundaries = {held("base", BoundaryKind::kFixed), held("right", BoundaryKind::kRoller)};
  const auto simulation = Simulation::compile(s, options);
  const std::vector<double> boundary = field(*simulation, "boundary");
  std::vector<double> force = field(*simulation, "reference_position");
  const double dx = simulation->get("spacing_x"), dy = simulation->get("spacing_y");
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const bool first = boundary[i] < 0 && force[2 * i] < dx;
    const double pressure = clay.unit_weight * (kHeight - force[2 * i + 1]) + sign * 2 * clay.cohesion;
    force[2 * i] = first ? pressure * dy : 0, force[2 * i + 1] = 0;
  }
  simulation->write(find_field("external_force"), force);
  return factor_of_safety_error(*simulation, 1);
}
Outcome rankine_active(const SceneDef& c, const Options& o) { return rankine(c, o, -1); }
Outcome rankine_passive(const SceneDef& c, const Options& o) { return rankine(c, o, 1); }

constexpr const char* kKind = "|FS / exact - 1|";
constexpr Problem kProblems[] = {
    {"vertical_cut", kKind, "gamma H / c = 3.776, Pastor et al. 2000 bounds", 10, 40, vertical_cut_1},
    {"vertical_cut_two_grids", kKind, "as before, extrapolated", 10, 40, vertical_cut_2},
    {"prandtl", kKind, "q = (2 + pi) c, Prandtl 1921; rungs of the strip's width", 4, 20, prandtl_1},
    {"prandtl_two_grids", kKind, "as before, extrapolated", 4, 20, prandtl_2},
    {"strip_on_slope", kKind, "q = c (2 + pi - 2 b) at the edge of a slope of b = 60 degrees; rungs of the strip", 10,
     40, strip_on_slope_1},
    {"strip_on_slope_two_grids", kKind, "as before, extrapolated", 10, 40, strip_on_slope_2},
    {"slope_45", kKind, "gamma H / c = 6.012, this project's extrapolated number", 10, 40, slope_45_1},
    {"slope_45_two_grids", kKind, "as before, extrapolated", 10, 40, slope_45_2},
    {"rankine_active", kKind, "gamma z - 2 c, closed form", 10, 40, rankine_active},
    {"rankine_passive", kKind, "gamma z + 2 c, closed form", 10, 40, rankine_passive},
    {"infinite_slope", kKind, "tan phi / tan beta = 1.0503, closed form", 10, 40, infinite_slope},
};

}  // namespace

std::span<const Problem> limit_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
