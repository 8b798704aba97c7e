#include <gtest/gtest.h>

#include <cmath>

#include "physics/scenes.h"
#include "simulation/build_model.h"

namespace vbgpd {
namespace {

Model two_layers(const MaterialDef& upper, const MaterialDef& lower) {
  SceneDef scene = test::block(upper, 10, 10, 1);
  scene.materials[0].name = "upper";
  scene.materials.push_back(lower);
  scene.materials[1].name = "lower";
  scene.layers = {{"upper", {}}, {"lower", {{0, 0}, {10, 0}, {10, 5}, {0, 5}}}};
  const Section section = discretise(scene, fit_lattice(scene, 1, 1), 3, 0);
  return build_model(scene, section, 4);
}

TEST(MixedBond, IsAsStrongAsTheWeakerMaterial) {
  const Model m = two_layers(test::soil("undrained", 50e3, 0), test::soil("undrained", 20e3, 0));
  const auto c = pair_constants(m, 1, false);
  EXPECT_EQ(c[0 * 2 + 1].k, 20e3);
  EXPECT_EQ(c[1 * 2 + 0].k, 20e3);
  EXPECT_EQ(c[0].k, 50e3);
  EXPECT_EQ(pair_constants(m, 2, false)[1].k, 10e3);  // reduced like the materials themselves
}

TEST(MixedBond, JoinsTheModuliLikeSpringsInSeries) {
  MaterialDef stiff = test::soil("undrained", 50e3, 0);
  stiff.young_modulus = 3e8;
  const Model m = two_layers(stiff, test::soil("undrained", 20e3, 0));
  const auto c = pair_constants(m, 1, false);
  EXPECT_NEAR(1 / c[1].shear_modulus, (1 / c[0].shear_modulus + 1 / c[3].shear_modulus) / 2, 1e-9 / c[0].shear_modulus);
}

TEST(MixedBond, UsesTheLawThatRepresentsBoth) {
  const Model m = two_layers(test::soil("mohr_coulomb", 5e3, 30), test::soil("undrained", 20e3, 0));
  EXPECT_TRUE(std::holds_alternative<MohrCoulomb>(m.pair_law[1]));
}

TEST(MixedBond, AgainstRockHasTheStrengthOfTheSoil) {
  const Model m = two_layers(test::soil("undrained", 50e3, 0), test::soil("elastic", 0, 0));
  const auto c = pair_constants(m, 1, false);
  EXPECT_EQ(c[1].k, 50e3);
  EXPECT_TRUE(std::isinf(c[3].k));
}

TEST(LeastCohesion, IsAShareOfOneLayersWeightAndOnlyForFrictionalSoil) {
  EXPECT_NEAR(least_cohesion(test::soil("mohr_coulomb", 0, 35), 0.5), 0.03 * 20e3 * 0.5, 1e-9);
  EXPECT_EQ(least_cohesion(test::soil("undrained", 1e3, 0), 0.5), 0);
}

}  // namespace
}  // namespace vbgpd
