// Every file of tests/validation/scenes/bad is refused, and the message names the place and what would be right.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"
#include "scene/validate.h"
#include "scene_fixture.h"

namespace vbgpd {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(VBGPD_SCENES_DIR) / "../../tests/validation/scenes/bad";

/// Faults of polygons, which only geometry/check.h finds: text and numbers of these files are in order.
const char* const kGeometry = "";

const std::map<std::string, std::string> kExpected = {
    {"a_list", "a_list.json:1:1: expected {, found ["},
    {"binary", "binary.json: is not text: byte 0 has the value 0"},
    {"blank", "blank.json: the file is empty"},
    {"boundary_nowhere", "boundaries[1] 'edge': where is missing: give side (base, left, right) or a polyline"},
    {"boundary_touches_nothing", kGeometry},
    {"boundary_twice_placed", "boundaries[1] 'left': side and polyline are both given"},
    {"cohesion_missing", "materials[0] 'clay': cohesion is missing: law \"mohr_coulomb\" needs it"},
    {"cut_short", "cut_short.json:8:11: expected :, found end of file"},
    {"decimal_comma",
     "decimal_comma.json:10:16: expected a name in quotes, found 5: decimals are written with a point"},
    {"deep_nesting", "deep_nesting.json:11:3: unknown field \"extra\""},
    {"deep_nesting_in_a_list", "deep_nesting_in_a_list.json:8:14: layers[0]: expected an object { ... }, found a list"},
    {"dilatancy_above_friction", "dilatancy_angle = 25 degrees: must not exceed friction_angle = 20 degrees"},
    {"duplicate_material", "materials[1] 'clay': the name is already that of materials[0]"},
    {"empty", "empty.json: the file is empty"},
    {"faults_of_every_kind", "faults_of_every_kind.json:3:67: materials[0].unit_weight: expected a number"},
    {"field_twice", "field_twice.json:11:3: spacing is written a second time"},
    {"friction_angle_95", "materials[0] 'clay': friction_angle = 95 degrees: must be in [0, 90)"},
    {"gradient_without_datum", "materials[0] 'clay': cohesion_gradient = 2 kPa/m needs cohesion_datum"},
    {"infinity_literal", "infinity_literal.json:10:14: spacing: 1e999 is not a finite number"},
    {"layer_outside", kGeometry},
    {"layer_without_material", "layer_without_material.json:8:14: layers[0].material is required: name of a material"},
    {"load_backwards", "loads[0]: x0 = 8 m: must be left of x1 = 2 m"},
    {"load_off_the_ground", kGeometry},
    {"missing_coordinate", "missing_coordinate.json:4:65: profile.exterior[2].y is required"},
    {"misspelt_field",
     "misspelt_field.json:6:64: materials[0]: unknown field \"cohesoin\"; did you mean \"cohesion\"?"},
    {"nan_literal", "nan_literal.json:6:76: materials[0].cohesion: nan is not a finite number"},
    {"negative_cohesion", "materials[0] 'clay': cohesion = -10 kPa: must be >= 0"},
    {"negative_tension_cutoff", "materials[0] 'clay': tension_cutoff = -1 kPa: must be >= 0"},
    {"negative_young_modulus", "materials[0] 'clay': young_modulus = -100000 kPa: must be > 0"},
    {"no_layers", "layers: the list is empty"},
    {"no_strength", "materials[0] 'clay': cohesion = 0 and friction_angle = 0"},
    {"not_utf8", "not_utf8.json:2:14: illegal UTF-8 sequence"},
    {"number_for_text", "number_for_text.json:6:14: materials[0].name: expected text in quotes, found 7"},
    {"object_for_list", "object_for_list.json:8:13: layers: expected a list [ ... ], found an object"},
    {"poisson_ratio_half", "poisson_ratio = 0.5: must be in (-1, 0.5); use 0.49 for undrained soil"},
    {"polyline_of_one_point", "boundaries[1]: polyline has 1 point: a line needs at least 2"},
    {"seismic_above_one", "scene: kh = 1.5: must be in (-1, 1)"},
    {"self_crossing_exterior", kGeometry},
    {"self_crossing_layer", kGeometry},
    {"several_misspelt_fields", "several_misspelt_fields.json:8:3: unknown field \"layer\"; did you mean \"layers\"?"},
    {"several_problems", "layers[0] 'sand': material \"sand\" is not known: use one of clay"},
    {"spacing_missing", "spacing_missing.json:1:1: spacing is required: distance between particles in m"},
    {"spacing_negative", "scene: spacing = -0.5 m: must be > 0"},
    {"spacing_zero", "scene: spacing = 0 m: must be > 0"},
    {"srf_range_reversed", "scene: srf_max = 1: must be greater than srf_min = 2"},
    {"srf_tolerance_zero", "scene: srf_tolerance = 0: must be in [0.0001, 0.5]"},
    {"text_for_number", "text_for_number.json:10:14: spacing: expected a number, found the text \"0.5\""},
    {"trailing_comma",
     "trailing_comma.json:11:1: expected a name in quotes, found }: the comma before it is one too many"},
    {"trailing_garbage", "trailing_garbage.json:12:1: expected end of file, found {"},
    {"two_point_exterior", "profile: exterior has 2 vertices: an area needs at least 3"},
    {"uncovered_soil", kGeometry},
    {"undrained_with_friction", "law \"undrained\" has cohesion only; use law \"mohr_coulomb\""},
    {"units_missing", "units_missing.json:1:1: units is required: \"SI\" (m, Pa, N/m3) or \"kPa\" (m, kPa, kN/m3)"},
    {"units_unknown", "units \"psf\" is not known: write \"SI\" (m, Pa, N/m3) or \"kPa\" (m, kPa, kN/m3)"},
    {"unknown_kernel", "scene: kernel \"wendland\" is not known: use one of wendland_c2, cubic_spline"},
    {"unknown_kind",
     "unknown_kind.json:9:43: boundaries[0].kind \"fixd\" is not known: write \"free\", \"fixed\", \"roller\" or "
     "\"velocity\"; did you mean \"fixed\"?"},
    {"unknown_law", "materials[0] 'clay': law \"mohr_colomb\" is not known"},
    {"unknown_material", "layers[0] 'clya': material \"clya\" is not known: use one of clay; did you mean \"clay\"?"},
    {"unknown_side", "boundaries[1] 'lefft': side \"lefft\" is not known: use one of base, left, right"},
    {"water_backwards", "water: table[2]: x = 12 m: must be right of x = 20 m of the point before"},
    {"water_of_one_point", "water: the water table has one point: give at least two, from left to right"},
    {"water_too_short",
     "water: the water table begins at x = 3 m: add a point at or left of the left end of the section, x = 0 m"},
    {"zero_area_exterior", kGeometry},
};

/// All errors of a file, one a line; empty when text and numbers are in order.
std::string errors_of(const std::string& name) {
  try {
    const auto bytes = scene_text_to_flatbuffer(file_text(kFolder / (name + ".json")), name + ".json");
    std::string text;
    for (const Issue& issue : validate(scene_from_flatbuffer(bytes)))
      if (issue.severity == Severity::kError) text += issue.text + "\n";
    return text;
  } catch (const Error& error) {
    return error.what();
  }
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, IsRefusedWithAMessageThatNamesThePlace) {
  const auto expected = kExpected.find(GetParam());
  ASSERT_NE(expected, kExpected.end()) << "no expectation for this file";
  const std::string errors = errors_of(GetParam());
  if (expected->second == kGeometry) {
    EXPECT_EQ(errors, "");
  } else {
    EXPECT_NE(errors.find(expected->second), std::string::npos) << errors;
  }
}

INSTANTIATE_TEST_SUITE_P(Folder, BadScene, testing::ValuesIn(scene_names(kFolder)),
                         [](const auto& name) { return name.param; });

TEST(BadScenes, AreAllThere) {
  const auto names = scene_names(kFolder);
  EXPECT_EQ(names.size(), kExpected.size());
}

TEST(BadScenes, HaveAllTheirProblemsReportedAtOnce) {
  const std::string errors = errors_of("several_problems");
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 4) << errors;
}

}  // namespace
}  // namespace vbgpd
