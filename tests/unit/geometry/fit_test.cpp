#include <gtest/gtest.h>

#include <cmath>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

double off_edge(double length, double spacing) {
  const double cells = length / spacing;
  return std::abs(cells - std::round(cells));
}

TEST(FitLattice, KeepsTheAskedSpacingWhenItMeetsEveryKeyLine) {
  const Lattice lattice = fit_lattice(scene_of(slope()), 0.5, 2);
  EXPECT_DOUBLE_EQ(lattice.spacing.x(), 0.5);
  EXPECT_DOUBLE_EQ(lattice.spacing.y(), 0.5);
  EXPECT_EQ(lattice.origin, Vec2(0, 0));
  EXPECT_NEAR(lattice.misfit.maxCoeff(), 0, 1e-12);
}

TEST(FitLattice, MeetsWidthToeAndCrestOnEveryMultipleOfTheCoarsestCells) {
  const SceneDef scene = scene_of(slope_on_foundation());
  for (const double asked : {0.21, 0.3, 0.47, 0.77, 1.1})
    for (const int multiple : {1, 2, 4}) {
      if (asked * multiple > 1.6) continue;  // toe 5 m and crest 15 m above the base: 3 or more cells
      const Lattice lattice = fit_lattice(scene, asked, multiple);
      const Lattice coarse = coarsened(lattice, multiple);
      EXPECT_NEAR(off_edge(52, coarse.spacing.x()), 0, 1e-9);
      EXPECT_NEAR(off_edge(5, coarse.spacing.y()), 0, 1e-9) << asked << " x " << multiple;
      EXPECT_NEAR(off_edge(15, coarse.spacing.y()), 0, 1e-9);
      EXPECT_NEAR(lattice.misfit.y(), 0, 1e-9);
      EXPECT_NEAR(lattice.spacing.x() / asked, 1, 0.1 + 1e-9);
      EXPECT_NEAR(lattice.spacing.y() / asked, 1, 0.1 + 1e-9);
    }
}

TEST(FitLattice, KeepsCellsNearlySquare) {
  for (double asked = 0.2; asked < 1.2; asked += 0.0371) {
    const Lattice lattice = fit_lattice(scene_of(slope()), asked, 2);
    EXPECT_NEAR(lattice.spacing.x() / lattice.spacing.y(), 1, 0.07) << asked;
  }
}

TEST(FitLattice, MeetsAnInteriorVerticalFaceAndLoadEnds) {
  SceneDef scene = scene_of({{0, 0}, {21, 0}, {21, 10}, {9, 10}, {9, 5}, {0, 5}});
  const Lattice lattice = fit_lattice(scene, 0.52, 2);
  EXPECT_NEAR(off_edge(9, 2 * lattice.spacing.x()), 0, 1e-9);
  EXPECT_NEAR(lattice.misfit.x(), 0, 1e-9);
  scene.loads = {{12, 18, 1e4, 1e4}};
  const Lattice loaded = fit_lattice(scene, 0.52, 2);
  EXPECT_NEAR(off_edge(12, 2 * loaded.spacing.x()), 0, 1e-9);
  EXPECT_NEAR(loaded.misfit.x(), 0, 1e-9);
}

TEST(FitLattice, PrefersTheExteriorToALayerBoundary) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "clay", {{0, 0}, {20, 0}, {20, 3.7}, {0, 3.7}});
  const Lattice lattice = fit_lattice(scene, 1.0, 1);
  EXPECT_LT(lattice.misfit.y(), 0.1);
  EXPECT_LT(off_edge(10, lattice.spacing.y()), off_edge(3.7, lattice.spacing.y()) + 1e-12);
}

TEST(FitLattice, MeetsALayerBoundaryWhenItCan) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "clay", {{0, 0}, {20, 0}, {20, 3.75}, {0, 3.75}});
  const Lattice lattice = fit_lattice(scene, 0.6, 1);  // 0.625 = 10 / 16 = 3.75 / 6
  EXPECT_NEAR(lattice.spacing.y(), 0.625, 1e-9);
}

TEST(FitLattice, ReportsTheMisfitOfLevelsThatCannotAllBeMet) {
  const Lattice lattice = fit_lattice(scene_of({{0, 0}, {40, 0}, {40, 7.3}, {25, 7.3}, {20, 5}, {0, 5}}), 2.4, 1);
  EXPECT_GT(lattice.misfit.y(), 1e-3);
  EXPECT_NEAR(lattice.misfit.y(), std::max(off_edge(7.3, lattice.spacing.y()), off_edge(5, lattice.spacing.y())), 1e-9);
}

TEST(FitLattice, DoesNotChangeWhenTheSectionIsMovedMirroredOrScaled) {
  for (const Polygon& polygon : {slope_on_foundation(), benches(), overhang()})
    for (const double asked : {0.37, 0.61, 1.0}) {
      const Lattice here = fit_lattice(scene_of(polygon), asked, 2);
      const Lattice there = fit_lattice(scene_of(moved(polygon, 5e5, 4e6)), asked, 2);
      const Lattice mirror = fit_lattice(scene_of(mirrored(polygon)), asked, 2);
      const Lattice large = fit_lattice(scene_of(scaled(polygon, 1000)), asked * 1000, 2);
      EXPECT_NEAR((there.spacing - here.spacing).norm(), 0, 1e-8);
      EXPECT_NEAR((mirror.spacing - here.spacing).norm(), 0, 1e-12);
      EXPECT_NEAR((large.spacing / 1000 - here.spacing).norm(), 0, 1e-12);
      EXPECT_NEAR((mirror.misfit - here.misfit).norm(), 0, 1e-10);
    }
}

TEST(FitLattice, RefusesSpacingsThatCannotWork) {
  const SceneDef scene = scene_of(slope());
  for (const double spacing : {0.0, -1.0, std::nan(""), static_cast<double>(INFINITY), 5.1}) {
    try {
      fit_lattice(scene, spacing, 1);
      FAIL() << "accepted " << spacing;
    } catch (const Error& error) {
      EXPECT_EQ(error.issue().status, Status::kRange) << error.what();
    }
  }
  EXPECT_NO_THROW(fit_lattice(scene, 5.0, 2));
  try {
    fit_lattice(scene, 1e-4, 1);
    FAIL() << "accepted 3.2e10 cells";
  } catch (const Error& error) {
    EXPECT_EQ(error.issue().status, Status::kLimit);
    EXPECT_NE(std::string(error.what()).find("3.2e+10"), std::string::npos) << error.what();
  }
}

TEST(CoarsenedLattice, MeetsTheSameKeyLinesWithTheSameVolume) {
  const SceneDef scene = scene_of(slope_on_foundation());
  const Lattice fine = fit_lattice(scene, 0.4, 2), coarse = coarsened(fine, 2);
  EXPECT_EQ(coarse.origin, fine.origin);
  EXPECT_NEAR(off_edge(5, coarse.spacing.y()), 0, 1e-9);
  EXPECT_NEAR(off_edge(15, coarse.spacing.y()), 0, 1e-9);
  const Section a = discretise(scene, fine, 3, 0), b = discretise(scene, coarse, 3, 0);
  EXPECT_NEAR(soil_volume(a), soil_volume(b), 1e-10);
  EXPECT_NEAR(static_cast<double>(count(a, Hold::kFree)) / count(b, Hold::kFree), 4, 0.2);
}

}  // namespace
}  // namespace vbgpd::geometry_test
