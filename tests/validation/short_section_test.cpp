// A section that ends too near cuts the mechanism off: the factor of safety is too high, and the result says so.
#include <gtest/gtest.h>

#include "validation/solve.h"

namespace vbgpd {
namespace {

/// Soft clay, 5 m high at 2:1 on 8 m of the same, with so much level ground on either side.
SceneDef soft_clay(double level_ground) {
  SceneDef s;
  MaterialDef clay;
  clay.name = "clay", clay.law = "undrained", clay.unit_weight = 17.5e3, clay.cohesion = 20e3;
  s.materials = {clay};
  const double crest = level_ground, toe = crest + 10, end = toe + level_ground;
  s.exterior = {{0, 0}, {end, 0}, {end, 8}, {toe, 8}, {crest, 13}, {0, 13}};
  s.layers = {{"clay", {}}};
  s.spacing = 0.5;
  return s;
}

TEST(ShortSection, IsNamedWhereItCutsTheSlipSurfaceOff) {
  const JobResult wide = solved(soft_clay(20)), cut_short = solved(soft_clay(3));
  EXPECT_GT(cut_short.factor_of_safety, 1.1 * wide.factor_of_safety);
  EXPECT_NE(cut_short.reason.find("end of the section"), std::string::npos) << cut_short.reason;
  EXPECT_EQ(wide.reason.find("end of the section"), std::string::npos) << wide.reason;
}

TEST(ShortSection, IsNoneWhereTheToeIsItsCorner) {
  SceneDef s = soft_clay(20);
  s.exterior = {{0, 8}, {30, 8}, {20, 13}, {0, 13}};
  const JobResult result = solved(s);
  EXPECT_EQ(result.reason.find("end of the section"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace vbgpd
