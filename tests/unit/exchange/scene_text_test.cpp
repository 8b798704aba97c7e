#include "exchange/scene_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "exchange/scene_buffer.h"
#include "scene/properties.h"
#include "scene/validate.h"
#include "scene_fixture.h"

namespace vbgpd {
namespace {

/// A scene in kPa with `extra` among its fields.
std::string scene_text(const std::string& extra = "") {
  return R"({
  "name": "embankment", "units": "kPa",
  "profile": {"exterior": [{"x": 0, "y": 0}, {"y": 0, "x": 32}, {"x": 12, "y": 10}, {"x": 0, "y": 10}]},
  "materials": [{"name": "soil", "unit_weight": 20, "cohesion": 10, "friction_angle": 20}],
  "layers": [{"material": "soil"}],
  )" + extra +
         R"("spacing": 0.5
})";
}

void put(std::string& text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, text.npos) << from;
  text.replace(at, from.size(), to);
}

SceneDef read(const std::string& text) { return scene_from_flatbuffer(scene_text_to_flatbuffer(text, "a.json")); }

std::string refusal(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.issue().status, Status::kFormat);
    return error.what();
  }
}

TEST(SceneText, TurnsKilopascalsIntoPascals) {
  std::string text = scene_text(
      R"("loads": [{"x0": 0, "x1": 6, "pressure": 20}, {"x0": 7, "x1": 8, "pressure": 1, "pressure_end": 2}], )");
  const auto at = text.find("\"cohesion\"");
  text.insert(at, R"("young_modulus": 5000, "tension_cutoff": 3, "dilatancy_angle": 5, )");
  text.insert(at, R"("cohesion_gradient": 2, "cohesion_datum": 4, )");
  const SceneDef scene = read(text);
  const MaterialDef& soil = scene.materials.at(0);
  EXPECT_EQ(soil.unit_weight, 20000);
  EXPECT_EQ(soil.young_modulus, 5e6);
  EXPECT_EQ(soil.cohesion, 10000);
  EXPECT_EQ(soil.tension_cutoff, 3000);
  EXPECT_EQ(soil.cohesion_gradient, 2000);
  EXPECT_EQ(soil.cohesion_datum, 4);  // lengths and angles are the same in both systems
  EXPECT_EQ(soil.friction_angle, 20);
  EXPECT_EQ(soil.dilatancy_angle, 5);
  EXPECT_EQ(scene.loads.at(0).pressure, 20000);
  EXPECT_EQ(scene.loads.at(0).pressure_end, 20000);  // absent: uniform
  EXPECT_EQ(scene.loads.at(1).pressure_end, 2000);
  EXPECT_EQ(scene.exterior.at(1).x, 32);
  EXPECT_EQ(scene.spacing, 0.5);
}

TEST(SceneText, TakesSiAsItIs) {
  std::string text = scene_text();
  put(text, "kPa", "SI");
  EXPECT_EQ(read(text).materials.at(0).unit_weight, 20);
}

TEST(SceneText, FillsWhatIsAbsentOrNullWithDefaults) {
  const SceneDef scene = read(scene_text(R"("gravity": null, "numerics": {"smoothing_ratio": null}, )")), usual;
  const MaterialDef soil = scene.materials.at(0), usual_soil;
  EXPECT_EQ(soil.law, usual_soil.law);
  EXPECT_EQ(soil.young_modulus, usual_soil.young_modulus);
  EXPECT_EQ(soil.poisson_ratio, usual_soil.poisson_ratio);
  EXPECT_TRUE(std::isnan(soil.tension_cutoff));
  EXPECT_EQ(scene.gravity, usual.gravity);
  EXPECT_EQ(scene.smoothing_ratio, usual.smoothing_ratio);
  EXPECT_EQ(scene.kernel, usual.kernel);
  EXPECT_EQ(scene.strength_reduction.tolerance, usual.strength_reduction.tolerance);
  EXPECT_TRUE(scene.boundaries.empty());
}

TEST(SceneText, KnowsTheFourKindsOfBoundary) {
  const SceneDef scene = read(scene_text(
      R"("boundaries": [{"side": "left", "kind": "free"}, {"side": "base", "kind": "fixed", "friction_angle": 24},
         {"side": "right", "kind": "roller"},
         {"polyline": [{"x": 0, "y": 0}, {"x": 1, "y": 0}], "kind": "velocity", "vx": 0.1, "vy": -0.2}], )"));
  ASSERT_EQ(scene.boundaries.size(), 4u);
  EXPECT_EQ(scene.boundaries[0].kind, BoundaryKind::kFree);
  EXPECT_EQ(scene.boundaries[1].kind, BoundaryKind::kFixed);
  EXPECT_EQ(scene.boundaries[1].friction_angle, 24);
  EXPECT_TRUE(std::isnan(scene.boundaries[0].friction_angle));
  EXPECT_EQ(scene.boundaries[2].kind, BoundaryKind::kRoller);
  EXPECT_EQ(scene.boundaries[3].kind, BoundaryKind::kVelocity);
  EXPECT_EQ(scene.boundaries[3].vy, -0.2);
}

TEST(SceneText, AcceptsByteOrderMarkCommentsAndWindowsLineEnds) {
  std::string text = "\xEF\xBB\xBF// a slope\n";
  text += scene_text(R"(/* flat "ground" { */ )");
  text += "\n// the end\n";
  EXPECT_EQ(refusal(text), "");
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.insert(at, 1, '\r');
  EXPECT_EQ(refusal(text), "");
}

TEST(SceneText, StartsMessagesWithFileLineAndColumn) {
  const std::string text = scene_text("\"spacng\": 1,\n  ");
  EXPECT_EQ(refusal(text),
            "a.json:6:3: unknown field \"spacng\"; did you mean \"spacing\"? (known here: name, source, units, "
            "profile, materials, "
            "layers, boundaries, loads, seismic, gravity, spacing, numerics, strength_reduction, published, water)");
}

TEST(SceneText, CountsColumnsInCharacters) {
  EXPECT_EQ(refusal(scene_text("\"source\": \"\xC3\xA4\xC3\xB6\xC3\xBC\", \"kh\": 0, ")).substr(0, 12), "a.json:6:20:");
}

TEST(SceneText, ReportsAllMisspeltFieldsAtOnce) {
  std::string text = scene_text("\"gravty\": 1, ");
  put(text, "friction_angle", "phi");
  const std::string said = refusal(text);
  EXPECT_NE(said.find("a.json:4:69: materials[0]: unknown field \"phi\" (known here: name, law,"), std::string::npos)
      << said;
  EXPECT_NE(said.find("\na.json:6:3: unknown field \"gravty\"; did you mean \"gravity\"?"), std::string::npos) << said;
}

TEST(SceneText, NamesAMisspeltFieldOnceAndNotAsMissingToo) {
  std::string text = scene_text();
  put(text, "\"spacing\"", "\"Spacing\"");
  const std::string said = refusal(text);
  EXPECT_NE(said.find("did you mean \"spacing\"?"), std::string::npos);
  EXPECT_EQ(said.find("required"), std::string::npos) << said;
}

TEST(SceneText, RefusesSecondValuesOfAField) {
  EXPECT_EQ(refusal(scene_text("\"gravity\": 9.81, \"gravity\": 1.62, ")),
            "a.json:6:20: gravity is written a second time: keep the value that is meant");
}

TEST(SceneText, RefusesWhatOnlyLooksLikeANumber) {
  for (const char* bad : {"nan",      "NaN",
                          "inf",      "-inf",
                          "Infinity", "-Infinity",
                          "1e999",    "true",
                          "0x10",     "+1",
                          "1.2.3",    "010",
                          ".5",       "10.",
                          "-",        "1e",
                          "1e+",      "rad(180)",
                          "\"9.81\"", "\"nan\"",
                          "[9.81]",   "{\"value\": 9.81}"}) {
    const std::string said = refusal(scene_text(std::string("\"gravity\": ") + bad + ", "));
    EXPECT_EQ(said.find("a.json:6:14: gravity: "), 0u) << bad << ": " << said;
  }
}

TEST(SceneText, AcceptsEveryWayToWriteAFiniteNumber) {
  for (const char* good : {"9.81", "981e-2", "0.981E1", "98.1e-01", "9.8100000000000000000000001"})
    EXPECT_EQ(read(scene_text(std::string("\"gravity\": ") + good + ", ")).gravity, 9.81) << good;
}

TEST(SceneText, ReadsNumbersTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"})
    if (std::setlocale(LC_ALL, name)) {
      EXPECT_EQ(read(scene_text()).spacing, 0.5) << name;
    }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(SceneText, HasNoWayToReadOtherFilesOrChangeTheSchema) {
  EXPECT_NE(refusal("include \"vbgpd.fbs\";\n" + scene_text()), "");
  EXPECT_NE(refusal("table Extra { x:int; }\n" + scene_text()), "");
  EXPECT_NE(refusal(scene_text() + "root_type Point;"), "");
}

std::string read_without_faults(const std::string& text, SceneDef& scene) {
  const SceneText read = read_scene_text(text, "a.json");
  std::string paths;
  for (const SceneFault& fault : read.faults) paths += fault.path + " ";
  if (read.bytes.empty()) return paths + "nothing";
  scene = scene_from_flatbuffer(read.bytes);
  return paths;
}

TEST(SceneText, KeepsWhatIsNotAtFault) {
  SceneDef scene;
  const std::string text =
      scene_text(R"("gravty": [{"x": 1}, "}"], "gravity": "much", "seismic": {"kh": NaN, "kv": 0.1},
    "boundaries": [{"side": "left", "kind": "fxed"}, {"side": "base"}, {}, 7, {"sde": "right", "kind": "roller"}],
    "loads": [{"x0": 1, "x1": 2, "pressure": 3, "x1": 4}], "water": [], )");
  EXPECT_EQ(read_without_faults(text, scene),
            "gravity gravity seismic.kh boundaries[0].kind boundaries[1].kind boundaries[2].kind boundaries[3] "
            "boundaries[4].side loads[0].x1 water ");
  EXPECT_EQ(scene.kv, 0.1);
  EXPECT_EQ(scene.gravity, SceneDef().gravity);
  ASSERT_EQ(scene.boundaries.size(), 5u);
  EXPECT_EQ(scene.boundaries[0].side, "left");
  EXPECT_EQ(scene.boundaries[1].side, "base");
  EXPECT_EQ(scene.boundaries[4].kind, BoundaryKind::kRoller);
  EXPECT_EQ(scene.loads.at(0).x1, 2);
  EXPECT_EQ(scene.materials.at(0).cohesion, 10000);
  EXPECT_EQ(scene.spacing, 0.5);
}

TEST(SceneText, KeepsNothingWhereTheUnitsAreInDoubt) {
  SceneDef scene;
  std::string text = scene_text();
  put(text, "kPa", "kpa");
  EXPECT_EQ(read_without_faults(text, scene), "units nothing");
}

TEST(SceneText, KnowsWhereAnIssueIs) {
  const std::string text = scene_text(R"("seismic": {"kv": 0, "kh": 7}, "numerics": {"jitter": 8},
    "strength_reduction": {"tolerance": 9},
    "water": {"table": [{"x": 0, "y": 0}, {"y": 0, "x": 99}], "unit_weight": 3}, )");
  const auto there = [&](const char* issue) {
    const TextPosition at = issue_positions(std::vector<std::string>{issue}, text).at(0);
    if (at.line == 0) return std::string("nowhere");
    std::size_t line = 0;
    for (std::size_t n = 1; n < at.line; ++n) line = text.find('\n', line) + 1;
    return text.substr(line + at.column - 1, 7);
  };
  EXPECT_EQ(there("materials[0] 'soil': cohesion = 10 Pa: must be"), "10, \"fr");
  EXPECT_EQ(there("materials[0] 'a: b': friction_angle = 20 degrees"), "20}],\n ");
  EXPECT_EQ(there("materials[0] 'soil': cohesion_gradient = 2"), "{\"name\"");  // not written: the soil
  EXPECT_EQ(there("layers[0] 'soil': material \"soil\" is"), "\"soil\"}");
  EXPECT_EQ(there("profile.exterior: edges 1 and 2 cross"), "{\"y\": 0");
  EXPECT_EQ(there("profile: exterior[2].y = inf"), "10}, {\"");
  EXPECT_EQ(there("scene: spacing = 0.5 m"), "0.5\n}");
  EXPECT_EQ(there("scene: kh = 7: must"), "7}, \"nu");
  EXPECT_EQ(there("scene: jitter = 8: must"), "8},\n   ");
  EXPECT_EQ(there("scene: srf_tolerance = 9: must"), "9},\n   ");
  EXPECT_EQ(there("scene: water_unit_weight = 3 kN/m3: must"), "3}, \"sp");
  EXPECT_EQ(there("water: table[1]: x = 99 m: must"), "{\"y\": 0");
  EXPECT_EQ(there("loads[0]: x0 = 8 m"), "nowhere");  // there is no such load
  EXPECT_EQ(there("scene: gravity = 0 m/s2"), "nowhere");
}

TEST(SceneText, HasAPlaceForEveryNumberOfAScene) {
  const std::string text = R"({"gravity": 1, "spacing": 2, "seismic": {"kh": 3, "kv": 4}, "water": {"unit_weight": 5},
    "numerics": {"smoothing_ratio": 6, "jitter": 7}, "strength_reduction": {"srf_min": 8, "srf_max": 9, "tolerance": 0}})";
  std::set<TextPosition> places;
  std::size_t numbers = 0;
  for (const Property& p : properties()) {
    if (p.object != ObjectKind::kProfile) continue;
    ++numbers;
    const TextPosition at = issue_positions(std::vector{"scene: " + std::string(p.name) + " = 1"}, text).at(0);
    EXPECT_GT(at.line, 0u) << p.name;
    places.insert(at);
  }
  EXPECT_EQ(places.size(), numbers);
}

std::vector<std::string> told(const std::string& text) {
  std::vector<std::string> lines;
  const SceneText read = read_scene_text(text, "a.json");
  for (const SceneFault& fault : read.faults) lines.push_back(fault.text);
  if (read.bytes.empty()) return lines;
  for (const Issue& issue : validate(scene_from_flatbuffer(read.bytes)))
    if (issue.severity == Severity::kError &&
        std::none_of(read.faults.begin(), read.faults.end(),
                     [&](const SceneFault& fault) { return may_follow_from(issue.text, fault); }))
      lines.push_back(issue.text);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(SceneText, TellsFaultsThatHaveNothingToDoWithEachOther) {
  std::string text = scene_text(R"("gravity": -1, "strength_reduction": {"srf_min": "0.01", "srf_max": 0.05}, )");
  put(text, "\"cohesion\": 10", "\"cohesion\": -1, \"cohesive\": 2, \"poisson_ratio\": 2");
  text.replace(text.find("{\"x\": 0"), 1, "{\"z\": 3, ");
  put(text, "\"friction_angle\": 20", "\"friction_angle\": \"20\", \"dilatancy_angle\": 5");
  Lines lines = told(text);
  for (std::string& line : lines) line.resize(std::min(line.find_first_of(";:"), line.size()));
  EXPECT_EQ(lines, (Lines{"profile.exterior[0]", "materials[0]", "materials[0].friction_angle",
                          "strength_reduction.srf_min", "materials[0] 'soil'", "materials[0] 'soil'", "scene"}));
}

TEST(SceneText, ReadsAMisspeltFieldAsTheOneItIsMeantToBe) {
  std::string text = scene_text("\"seismc\": {\"kh\": \"a tenth\"}, ");
  put(text, "\"cohesion\": 10", "\"cohesoin\": -10");
  put(text, "\"units\"", "\"unit\"");
  const Lines lines = told(text);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0].substr(0, 20), "unknown field \"unit\"");
  EXPECT_EQ(lines[3].substr(0, 33), "seismic.kh: expected a number, fo");
  EXPECT_EQ(lines[4].substr(0, 39), "materials[0] 'soil': cohesion = -10 kPa");
}

TEST(SceneText, TellsWhereItStopsBeingJsonBesideWhatIsWrongBefore) {
  EXPECT_EQ(told("{\"units\": 7,\n \"profile\" 3}"),
            (Lines{"units: expected text in quotes, found 7", "expected :, found 3"}));
  const Lines lines = told(scene_text("\"gravity\": \"9.81\", ") + " {");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1], "expected end of file, found {");
  EXPECT_EQ(told("{\"name\": \"a\"").back(), "expected , or }, found end of file");
}

TEST(SceneText, JudgesTheRestByAllFaultsHoweverMany) {
  std::string soils = "\"cohesion\": 10", text = scene_text();
  for (int i = 0; i < 50; ++i) soils += ", \"cohesion\": 10";
  put(text, "\"cohesion\": 10", soils);
  EXPECT_EQ(told(text).size(), 50u);
  const std::string said = refusal(text);
  EXPECT_TRUE(said.ends_with("a.json: and 30 more")) << said;
  put(text, "0.5", "-1");
  put(text, "\"units\": \"kPa\",", "");
  EXPECT_EQ(told(text).size(), 51u);  // no word about the spacing, whose unit is in doubt
}

TEST(SceneText, MendsObjectsWithoutAnythingButNulls) {
  std::string text = scene_text("\"boundaries\": [{\"kind\": null}], ");
  put(text, "0.5", "-1 ");
  const Lines lines = told(text);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2].substr(0, 18), "scene: spacing = -");
}

TEST(SceneText, ReadsEscapesLikeWhatTheyStandFor) {
  EXPECT_EQ(refusal(scene_text(R"("boundaries": [{"side": "base", "kind": "\u0066ixed"}], "\u0067ravity": 1, )")), "");
  EXPECT_NE(refusal(scene_text(R"("source": "\x41", )")).find("a.json:6:14: JSON has no \\x"), std::string::npos);
}

TEST(SceneText, TakesNumbersTooSmallToStoreForNothing) {
  EXPECT_EQ(read(scene_text("\"seismic\": {\"kh\": 1e-400}, ")).kh, 0);
}

TEST(SceneText, EveryNumberAtFaultExplainsWhatIsThenWrongWithTheScene) {
  const std::string text = scene_text(
      R"("loads": [{"x0": 0, "x1": 6, "pressure": 20}], "water": {"table": [{"x": -1, "y": 2}, {"x": 40, "y": 2}]}, )");
  for (std::size_t at = 0; (at = text.find(": ", at)) != text.npos; ++at) {
    const std::size_t begin = at + 2, end = text.find_first_of(",}\n", begin);
    if (std::string("-0123456789").find(text[begin]) == std::string::npos) continue;
    std::string bad = text;
    bad.replace(begin, end - begin, "\"?\"");
    const SceneText read = read_scene_text(bad, "a.json");
    ASSERT_EQ(read.faults.size(), 1u) << bad;
    for (const Issue& issue : validate(scene_from_flatbuffer(read.bytes)))
      EXPECT_TRUE(may_follow_from(issue.text, read.faults[0])) << issue.text << ", " << read.faults[0].text;
  }
}

TEST(SceneText, AFaultExplainsNothingElsewhere) {
  const SceneFault weight{{}, "materials[0].unit_weight", ""}, name{{}, "materials[0].name", ""},
      kv{{}, "seismic.kv", ""}, profile{{}, "profile.exterior[1].x", ""}, layers{{}, "layers", ""};
  EXPECT_FALSE(may_follow_from("materials[0] 'clay': cohesion is missing", weight));
  EXPECT_TRUE(may_follow_from("materials[0] 'clay': unit_weight is missing", weight));
  EXPECT_FALSE(may_follow_from("materials[1] 'sand': cohesion is missing", weight));
  EXPECT_FALSE(may_follow_from("layers[0] 'sand': material \"sand\" is not known", weight));
  EXPECT_TRUE(may_follow_from("layers[0] 'sand': material \"sand\" is not known", name));
  EXPECT_FALSE(may_follow_from("layers[0] 'sand': polygon has 2 vertices", name));
  EXPECT_TRUE(may_follow_from("layers[0] 'sand': lies wholly outside the exterior", profile));
  EXPECT_FALSE(may_follow_from("scene: spacing = 0 m: must be > 0", profile));
  EXPECT_FALSE(may_follow_from("materials[0] 'clay': poisson_ratio = 2: must", weight));
  EXPECT_FALSE(may_follow_from("materials[0] 'clay': cohesion is missing", profile));
  EXPECT_TRUE(may_follow_from("layers: the list is empty", layers));
  EXPECT_FALSE(may_follow_from("scene: kh = 2: must be in (-1, 1)", kv));
  EXPECT_FALSE(may_follow_from("scene: spacing = 0 m: must be > 0", weight));
}

TEST(SceneText, SurvivesEveryCutAndEveryChangedByte) {
  const std::string text = scene_text("\"boundaries\": [{\"side\": \"base\", \"kind\": \"fixed\"}], ");
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_NE(refusal(text.substr(0, n)), "") << "first " << n << " bytes";
  int refused = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char c : {'"', '}', '\\', 'z', '\0'}) {
      std::string changed = text;
      changed[at] = c;
      refused += !refusal(changed).empty();
    }
  EXPECT_GT(refused, static_cast<int>(3 * text.size()));
}

}  // namespace
}  // namespace vbgpd
