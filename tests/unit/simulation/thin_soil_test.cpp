// Soil much thinner than a cell over a held base, and loads whose pressure changes its sign.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {
namespace {

class ThinWedge : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Thickness, ThinWedge, testing::Values(0.3, 0.1, 0.04, 0.02));

/// The cells under the wedge are merged into a few that stand far apart; the base below still knows its soil.
TEST_P(ThinWedge, WallsBelowHaveAMaterial) {
  SceneDef scene = test::slope(test::soil("mohr_coulomb", 10e3, 20), 0.5);
  scene.exterior = {{0, 0}, {60, 0}, {60, 10}, {50, 10}, {40, GetParam()}};
  scene.boundaries.resize(1);
  LatticeSimulation simulation(scene, {}, best_kernels());
  int walls = 0;
  for (const Seed& seed : simulation.section().seeds) {
    EXPECT_EQ(seed.material, 0);
    walls += seed.hold == Hold::kFree ? 0 : 1;
  }
  EXPECT_GT(walls, 100);
  EXPECT_EQ(simulation.step(5, nullptr).status, Status::kOk);
}

/// A load that turns from pulling to pressing turns the soil below: no force, but the moment q b^2 / 6.
TEST(SurfaceLoad, OfBothSignsKeepsItsMoment) {
  SceneDef scene = test::block(test::soil("elastic", 0, 0), 20, 10, 0.5);
  LatticeSimulation bare(scene, {}, best_kernels());
  LoadDef load;
  load.x0 = 6, load.x1 = 14, load.pressure = -10e3, load.pressure_end = 10e3;
  scene.loads = {load};
  LatticeSimulation loaded(scene, {}, best_kernels());
  Real force = 0, moment = 0;
  for (std::size_t k = 0; k < loaded.section().seeds.size(); ++k) {
    const auto i = static_cast<std::size_t>(loaded.model().storage_of[k]);
    const Real f = loaded.model().force_y[i] - bare.model().force_y[i];
    force += f, moment += f * (loaded.section().place(k).x() - 10);
  }
  const Real expected = -10e3 * 8 * 8 / 6;
  EXPECT_NEAR(force, 0, 1e-6 * 10e3 * 8);
  EXPECT_NEAR(moment, expected, 0.01 * std::abs(expected));
}

}  // namespace
}  // namespace vbgpd
