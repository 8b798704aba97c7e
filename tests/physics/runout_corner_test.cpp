// Corners of walls that the soil lies in.
#include <gtest/gtest.h>

#include "analysis/job.h"
#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// A slope whose smooth base has a step, down whose foot it falls: soil is squeezed through where two walls meet.
TEST(RunoutWalls, HoldSoilThatFallsIntoAHollowCorner) {
  SceneDef scene = slope(soil("mohr_coulomb", 2e3, 20), 0.5);
  scene.materials[0].young_modulus = 2e7;
  const std::vector<Point> rock = {{0, 5}, {15, 5}, {16.5, 0}, {40, 0}};
  scene.exterior = {{0, 5}, {15, 5}, {16.5, 0}, {40, 0}, {40, 3}, {22, 3}, {12, 13}, {0, 13}};
  scene.boundaries.clear();
  for (const auto& line : {rock, std::vector<Point>{{0, 13}, {0, 5}}, std::vector<Point>{{40, 0}, {40, 3}}}) {
    BoundaryDef wall;
    wall.kind = BoundaryKind::kRoller, wall.polyline = line;
    scene.boundaries.push_back(wall);
  }
  const auto s = runout(scene);
  const auto job = make_runout_job(*s);
  job->set("end_time", 4);
  ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  const std::vector<double> x = field(*s, "position");
  for (std::size_t i = 0; i < x.size() / 2; ++i) EXPECT_GT(x[2 * i + 1], -0.5) << x[2 * i];
}

}  // namespace
}  // namespace vbgpd::test
