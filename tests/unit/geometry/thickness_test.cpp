#include "geometry/thickness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vbgpd {
namespace {

Polygon rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

SceneDef box_of_sand() {
  SceneDef s;
  s.exterior = rectangle(1000, 2000, 1020, 2010);
  s.materials.resize(3);
  s.materials[0].name = "sand", s.materials[1].name = "clay", s.materials[2].name = "unused";
  s.layers = {{"sand", {}}};
  return s;
}

TEST(Thickness, OfOneSoilIsTheSmallerExtentOfTheSection) {
  const auto t = material_thickness(box_of_sand(), 0.5);
  EXPECT_NEAR(t[0], 10, 1e-9);
  EXPECT_TRUE(std::isnan(t[1]) && std::isnan(t[2]));
}

TEST(Thickness, OfABandIsItsOwnHoweverFarItIsDrawnBeyondTheSection) {
  SceneDef s = box_of_sand();
  s.layers.push_back({"clay", rectangle(900, 2003, 1100, 2003.4)});
  EXPECT_NEAR(material_thickness(s, 1)[1], 0.4, 1e-9);
}

TEST(Thickness, IsThatOfWhatLaterLayersLeave) {
  SceneDef s = box_of_sand();
  s.layers.push_back({"clay", rectangle(1000, 2000, 1020, 2006)});
  s.layers.push_back({"sand", rectangle(1000, 2000, 1020, 2005)});
  EXPECT_NEAR(material_thickness(s, 1)[1], 1, 1e-9);
}

TEST(Thickness, OfABandUprightIsMeasuredAcrossIt) {
  SceneDef s = box_of_sand();
  s.layers.push_back({"clay", rectangle(1005.2, 2000, 1005.5, 2010)});
  EXPECT_NEAR(material_thickness(s, 1)[1], 0.3, 1e-9);
}

TEST(Thickness, OfAWedgeIsThatAtItsMiddle) {
  SceneDef s = box_of_sand();
  s.layers.push_back({"clay", {{1000, 2000}, {1020, 2000}, {1020, 2002}}});
  EXPECT_NEAR(material_thickness(s, 0.1)[1], 1, 0.02);
}

TEST(Thickness, OfALensBetweenAllLinesIsNothing) {
  SceneDef s = box_of_sand();
  s.layers.push_back({"clay", rectangle(1004.1, 2004.1, 1004.3, 2004.3)});
  EXPECT_EQ(material_thickness(s, 1)[1], 0);
}

}  // namespace
}  // namespace vbgpd
