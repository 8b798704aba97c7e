#include "geometry/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/polygon.h"
#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

bool says(const Issue& issue, const std::string& text) { return issue.text.find(text) != std::string::npos; }

long errors(const std::vector<Issue>& issues) {
  return std::count_if(issues.begin(), issues.end(), [](const Issue& i) { return i.severity == Severity::kError; });
}

std::string all_text(const std::vector<Issue>& issues) {
  std::string text;
  for (const Issue& issue : issues) text += issue.text + "\n";
  return text;
}

TEST(CheckGeometry, SoundSectionsHaveNoIssue) {
  for (const Polygon& polygon : {slope(), slope_on_foundation(), vertical_cut(), overhang(), benches()})
    for (const Polygon& variant : {polygon, reversed(polygon), mirrored(polygon), moved(polygon, 5e5, 4e6)}) {
      const auto issues = check_geometry(scene_of(variant));
      EXPECT_TRUE(issues.empty()) << all_text(issues);
    }
}

TEST(CheckGeometry, ARepeatedLastVertexIsDroppedSilently) {
  Polygon closed = slope();
  closed.push_back(closed.front());
  EXPECT_TRUE(check_geometry(scene_of(closed)).empty());
}

TEST(CheckGeometry, NamesEdgesAndPlaceOfEveryCrossing) {
  SceneDef scene = scene_of({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
  // Edge 1 (10,10)-(30,2) runs through edges 3, 4 and 5.
  add_layer(scene, "weak band", {{2, 2}, {10, 10}, {30, 2}, {30, 12}, {20, 2}, {14, 14}, {14, 2}});
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 3u) << all_text(issues);
  EXPECT_EQ(issues[0].object, ObjectKind::kLayer);
  EXPECT_EQ(issues[0].object_id, 1);
  EXPECT_EQ(issues[0].item, 1);
  EXPECT_EQ(issues[0].status, Status::kGeometry);
  // y = 14 - 0.4 x meets y = x - 18 at x = 32 / 1.4.
  EXPECT_NEAR(issues[0].x, 32 / 1.4, 1e-12);
  EXPECT_NEAR(issues[0].y, 32 / 1.4 - 18, 1e-12);
  EXPECT_TRUE(
      says(issues[0], "layers[1] 'weak band': edges 1 and 3 cross at (22.86, 4.86); a polygon must not cross itself"))
      << issues[0].text;
  EXPECT_TRUE(says(issues[1], "edges 1 and 4 cross at (17.50, 7.00)")) << issues[1].text;
  EXPECT_TRUE(says(issues[2], "edges 1 and 5 cross at (14.00, 8.40)")) << issues[2].text;
}

TEST(CheckGeometry, ReportsTouchingAndOverlappingEdges) {
  const auto touch = check_geometry(scene_of({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}));
  ASSERT_EQ(touch.size(), 1u) << all_text(touch);
  EXPECT_EQ(touch[0].item, 3);
  EXPECT_TRUE(says(touch[0], "vertex 3 lies on edge 0 at (5.00, 0.00); a polygon must not touch itself"))
      << touch[0].text;
  const auto spike = check_geometry(scene_of({{0, 0}, {10, 0}, {10, 5}, {10, 3}, {0, 3}}));
  ASSERT_EQ(spike.size(), 2u) << all_text(spike);
  EXPECT_TRUE(says(spike[0], "edges 1 and 2 run over each other from (10.00, 5.00) to (10.00, 3.00)") ||
              says(spike[0], "edges 1 and 2 run over each other from (10.00, 3.00) to (10.00, 5.00)"))
      << all_text(spike);
}

TEST(CheckGeometry, ReportsRepeatedVertices) {
  const auto issues = check_geometry(scene_of({{0, 0}, {10, 0}, {10, 0}, {10, 10}, {0, 10}}));
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_EQ(issues[0].item, 2);
  EXPECT_TRUE(says(issues[0], "vertices 1 and 2 are the same point (10.00, 0.00)")) << issues[0].text;
  const auto pinched = check_geometry(scene_of({{0, 0}, {5, 5}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}));
  ASSERT_EQ(pinched.size(), 1u) << all_text(pinched);
  EXPECT_EQ(pinched[0].item, 4);
}

TEST(CheckGeometry, ReportsTooFewVerticesAndNoArea) {
  const auto two = check_geometry(scene_of({{1, 2}, {3, 4}, {1, 2}}));
  ASSERT_FALSE(two.empty());
  EXPECT_TRUE(says(two[0], "profile.exterior: has 2 distinct vertices; a polygon needs at least 3")) << two[0].text;
  const auto line = check_geometry(scene_of({{0, 0}, {1, 1}, {3, 3}}));
  ASSERT_FALSE(line.empty());
  EXPECT_TRUE(says(line[0], "encloses no area")) << line[0].text;
  EXPECT_FALSE(check_geometry(scene_of({})).empty());
}

TEST(CheckGeometry, IsExactForAnAlmostFlatPolygon) {
  // The third vertex is off the line by one unit in the last place: an area, if a tiny one.
  const double up = std::nextafter(3.0, 4.0);
  const auto thin = check_geometry(scene_of({{0, 0}, {1, 1}, {3, up}}));
  for (const Issue& issue : thin) EXPECT_FALSE(says(issue, "encloses no area")) << issue.text;
}

TEST(CheckGeometry, ReportsCoordinatesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto issues = check_geometry(scene_of({{0, 0}, {nan, 0}, {10, 10}, {0, inf}}));
  ASSERT_EQ(issues.size(), 2u) << all_text(issues);
  EXPECT_EQ(issues[0].item, 1);
  EXPECT_EQ(issues[1].item, 3);
  EXPECT_TRUE(says(issues[1], "vertex 3 is (0, inf)")) << issues[1].text;
}

TEST(CheckGeometry, LayersMustOverlapTheExterior) {
  SceneDef scene = scene_of(slope());
  add_layer(scene, "gone", {{40, 0}, {50, 0}, {50, 5}});
  add_layer(scene, "beside", {{32, 0}, {50, 0}, {50, -5}, {32, -5}});
  add_layer(scene, "wide", {{-5, 0}, {40, 0}, {40, 3}, {-5, 3}});
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 3u) << all_text(issues);
  EXPECT_EQ(errors(issues), 2);
  EXPECT_TRUE(says(issues[0], "layers[1] 'gone': lies wholly outside the exterior")) << issues[0].text;
  EXPECT_EQ(issues[0].x, 40);
  EXPECT_TRUE(says(issues[1], "layers[2] 'beside': lies wholly outside")) << issues[1].text;
  EXPECT_EQ(issues[2].severity, Severity::kWarning);
  EXPECT_TRUE(
      says(issues[2], "layers[3] 'wide': lies partly outside the exterior, for example at vertex 0 (-5.00, 0.00)"))
      << issues[2].text;
  EXPECT_NEAR(issues[2].value, 5 * 3 + 8 * 3 + 3 * 6 / 2.0, 1e-9);
}

TEST(CheckGeometry, ALayerPaintedOverIsAWarning) {
  SceneDef scene = scene_of(slope());
  add_layer(scene, "hidden", {{2, 2}, {4, 2}, {4, 4}, {2, 4}});
  add_layer(scene, "cover", {{1, 1}, {3, 1}, {3, 5}, {1, 5}});
  EXPECT_TRUE(check_geometry(scene).empty());
  add_layer(scene, "cover", {{3, 1}, {5, 1}, {5, 5}, {3, 5}});  // together they hide it
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_EQ(issues[0].severity, Severity::kWarning);
  EXPECT_EQ(issues[0].object_id, 1);
}

TEST(CheckGeometry, SoilWithoutMaterialIsAnErrorWithAPlace) {
  SceneDef scene = scene_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  scene.layers.clear();
  add_layer(scene, "soil", {{0, 0}, {10, 0}, {10, 6}, {0, 6}});
  add_layer(scene, "top", {{0, 6}, {7, 6}, {7, 10}, {0, 10}});
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_EQ(issues[0].object, ObjectKind::kProfile);
  EXPECT_NEAR(issues[0].value, 12, 1e-12);
  EXPECT_TRUE(issues[0].x > 7 && issues[0].x < 10 && issues[0].y > 6 && issues[0].y < 10);
  add_layer(scene, "top", {{7, 6}, {10, 6}, {10, 10}, {7, 10}});
  EXPECT_TRUE(check_geometry(scene).empty());
  scene.layers.clear();  // validate says so
  EXPECT_TRUE(check_geometry(scene).empty());
}

TEST(CheckGeometry, BoundariesMustRunAlongTheExterior) {
  SceneDef scene = scene_of(slope());
  BoundaryDef good, bad;
  good.polyline = {{0, 5}, {0, 0}, {22, 5}};
  bad.name = "rock";
  bad.polyline = {{0, 0}, {10, -0.5}, {40, 0}};
  scene.boundaries = {good, bad};
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 2u) << all_text(issues);
  EXPECT_EQ(issues[0].object, ObjectKind::kBoundary);
  EXPECT_EQ(issues[0].object_id, 1);
  EXPECT_EQ(issues[0].item, 1);
  EXPECT_NEAR(issues[0].value, 0.5, 1e-12);
  EXPECT_TRUE(says(issues[0], "boundaries[1] 'rock': point 1 at (10.00, -0.50) touches nothing")) << issues[0].text;
  EXPECT_NEAR(issues[1].value, 8, 1e-12);
}

TEST(CheckGeometry, LoadsMustLieOnTheGroundSurface) {
  SceneDef scene = scene_of(slope());
  scene.loads = {{0, 12, 1e4, 1e4}, {30, 35, 1e4, 1e4}, {6, 3, 1e4, 1e4}};
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 2u) << all_text(issues);
  EXPECT_EQ(issues[0].object, ObjectKind::kLoad);
  EXPECT_EQ(issues[0].object_id, 1);
  EXPECT_EQ(issues[0].value, 35);
  EXPECT_TRUE(
      says(issues[0], "loads[1]: from x = 30.00 to 35.00 is off the ground surface, which spans x = 0.00 to 32.00"))
      << issues[0].text;
  EXPECT_TRUE(says(issues[1], "x0 must be less than x1")) << issues[1].text;
}

TEST(CheckGeometry, LoadsThatStandOnEachOtherAreNamed) {
  SceneDef scene = scene_of(slope());
  scene.loads = {{2, 4, 10e3, 10e3}, {3, 5, 10e3, 10e3}};
  auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_EQ(issues[0].severity, Severity::kWarning);
  EXPECT_EQ(issues[0].object_id, 1);
  EXPECT_EQ(issues[0].text, "loads[1]: stands on loads[0] from x = 3 to 4 m: their pressures add");
  scene.loads = {{2, 4, 10e3, 10e3}, {4, 5, 10e3, 10e3}};
  EXPECT_TRUE(check_geometry(scene).empty());
  // of many, each with the one before it that reaches farthest
  scene.loads = {{8, 9, 10e3, 10e3}, {1, 10, 10e3, 10e3}, {2, 3, 10e3, 10e3}};
  issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 2u) << all_text(issues);
  EXPECT_TRUE(says(issues[0], "loads[2]: stands on loads[1] from x = 2 to 3 m")) << issues[0].text;
  EXPECT_TRUE(says(issues[1], "loads[1]: stands on loads[0] from x = 8 to 9 m")) << issues[1].text;
}

TEST(CheckGeometry, WaterThatStandsIsLevel) {
  SceneDef scene = scene_of(slope());
  const Box box = box_of(scene.exterior);
  const double left = box.low.x(), right = box.high.x(), top = box.high.y(), bottom = box.low.y();
  for (const double level : {top + 1, (top + bottom) / 2, bottom}) {  // over everything, at the foot, none
    scene.water_table = {{left, level}, {right, level}};
    EXPECT_TRUE(check_geometry(scene).empty()) << level;
  }
  scene.water_table = {{left, top - 1}, {right, bottom}};  // falls within the soil
  EXPECT_TRUE(check_geometry(scene).empty());
  scene.water_table = {{left, top + 1}, {right, top + 4}};
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_EQ(issues[0].severity, Severity::kWarning);
  EXPECT_NEAR(issues[0].value, 3, 1e-12);
  EXPECT_TRUE(says(issues[0], "water that stands is level")) << issues[0].text;
  // out of the slope and into it again: it stands between two places where it meets the ground
  scene.water_table = {{left, top - 2}, {12, top - 2}, {22, top - 2}, {right, bottom}};
  ASSERT_EQ(check_geometry(scene).size(), 1u);
  EXPECT_NEAR(check_geometry(scene)[0].value, top - 2 - bottom, 1e-9);
  EXPECT_NEAR(check_geometry(scene)[0].x, 16, 1e-9);
}

TEST(AllIssues, NameAGridOfAFewParticlesOverTheHeight) {
  SceneDef scene = scene_of(slope_on_foundation());
  scene.materials[0].law = "undrained", scene.materials[0].unit_weight = 20e3, scene.materials[0].cohesion = 1e4;
  scene.spacing = 2.5;
  const auto issues = all_issues(scene);
  ASSERT_EQ(issues.size(), 1u) << all_text(issues);
  EXPECT_TRUE(says(issues[0], "the ground rises by 4 spacings only")) << issues[0].text;
  EXPECT_TRUE(says(issues[0], "a spacing of 0.5 m")) << issues[0].text;
  scene.spacing = 2;
  EXPECT_TRUE(all_issues(scene).empty());
}

TEST(AllIssues, NameSoilsTooThinForOneGridOrForTwo) {
  SceneDef scene = scene_of(slope_on_foundation());
  add_layer(scene, "seam", {{0, -1}, {52, -1}, {52, -2}, {0, -2}});
  for (MaterialDef& m : scene.materials) m.law = "undrained", m.unit_weight = 20e3, m.cohesion = 1e4;
  const auto warning_at = [&](double spacing) {
    scene.spacing = spacing;
    const auto issues = all_issues(scene);
    EXPECT_EQ(errors(issues), 0) << all_text(issues);
    return all_text(issues);
  };
  EXPECT_NE(warning_at(0.8).find("the grid sees soil from 2 spacings on"), std::string::npos) << warning_at(0.8);
  EXPECT_NE(warning_at(0.8).find("a spacing of at most 0.5 m"), std::string::npos) << warning_at(0.8);
  EXPECT_NE(warning_at(0.5).find("the coarser one hardly sees it"), std::string::npos) << warning_at(0.5);
  EXPECT_NE(warning_at(0.5).find("a spacing of at most 0.25 m"), std::string::npos) << warning_at(0.5);
  EXPECT_EQ(warning_at(0.25), "");
}

TEST(AllIssues, NameASpacingTooLargeForTheSection) {
  SceneDef scene = scene_of(slope());
  scene.materials[0].unit_weight = 20e3, scene.materials[0].cohesion = 1e4;
  scene.layers.resize(1);
  scene.spacing = 100;
  const auto issues = all_issues(scene);
  ASSERT_FALSE(issues.empty());
  EXPECT_TRUE(says(issues.back(), "larger than half the section's smaller extent")) << all_text(issues);
}

TEST(CheckGeometry, ReportsAllFaultsOfASceneAtOnce) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {0, 10}, {20, 10}});  // a bow tie
  add_layer(scene, "thin", {{1, 1}, {2, 2}});
  add_layer(scene, "bow", {{1, 1}, {3, 3}, {3, 1}, {1, 3}});
  BoundaryDef lost;
  lost.polyline = {{0, 0}, {5, -3}};
  scene.boundaries = {lost};
  scene.loads = {{-4, 2, 1e4, 1e4}};
  const auto issues = check_geometry(scene);
  ASSERT_EQ(issues.size(), 5u) << all_text(issues);
  EXPECT_EQ(issues[0].object, ObjectKind::kProfile);
  EXPECT_NEAR(issues[0].x, 10, 1e-12);
  EXPECT_NEAR(issues[0].y, 5, 1e-12);
  EXPECT_EQ(issues[1].object_id, 1);
  EXPECT_EQ(issues[2].object_id, 2);
  EXPECT_EQ(issues[3].object, ObjectKind::kBoundary);
  EXPECT_EQ(issues[4].object, ObjectKind::kLoad);
}

}  // namespace
}  // namespace vbgpd::geometry_test
