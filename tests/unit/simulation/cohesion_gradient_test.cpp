// Bonds between two soils of which one grows stronger with depth.
#include "simulation/cohesion_gradient.h"

#include <gtest/gtest.h>

#include "physics/scenes.h"
#include "simulation/build_model.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd::test {
namespace {

constexpr double kSurface = 4e3, kGradient = 2e3, kTop = 10, kMeet = 4;  // Pa, Pa/m, m, m

/// Clay that gains 2 kPa a metre from the top at y = 10 m on, and another soil below y = 4 m.
SceneDef two_soils(MaterialDef below) {
  MaterialDef clay = soil("undrained", kSurface, 0);
  clay.name = "clay", clay.cohesion_gradient = kGradient, clay.cohesion_datum = kTop;
  SceneDef s = block(clay, 8, kTop, 0.5);
  below.name = "below";
  s.materials.push_back(below);
  s.layers.push_back({"below", {{0, 0}, {8, 0}, {8, kMeet}, {0, kMeet}}});
  return s;
}

struct Joint {
  double cohesion = 0, depth = 0;  ///< mean over the bonds between the two soils, Pa, m
};

Joint joint_of(const SceneDef& scene) {
  const LatticeSimulation s(scene, {}, best_kernels());
  const Model& m = s.model();
  const auto constants = pair_constants(m, 1, false);
  Joint joint;
  double count = 0;
  for (const BondPack& p : m.packs)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(p.i + l), j = static_cast<std::size_t>(p.j + l);
      if (((p.lanes >> l) & 1) == 0 || m.seed_of[i] < 0 || m.seed_of[j] < 0 || m.material[i] == m.material[j]) continue;
      const LawConstants& c = constants[p.pair];
      joint.cohesion += c.k + (m.extra_cohesion[i] + m.extra_cohesion[j]) / 2 * c.k_per_cohesion;
      const auto y = [&](std::size_t k) { return s.section().place(static_cast<std::size_t>(m.seed_of[k])).y(); };
      joint.depth += kTop - (y(i) + y(j)) / 2;
      ++count;
    }
  joint.cohesion /= count, joint.depth /= count;
  return joint;
}

TEST(CohesionGradient, AgainstRockTheSoilsStrengthWhereTheyMeetDecides) {
  const Joint joint = joint_of(two_soils(soil("elastic", 0, 0)));
  EXPECT_NEAR(joint.depth, kTop - kMeet, 1e-9);
  EXPECT_NEAR(joint.cohesion, kSurface + kGradient * joint.depth, 0.02 * kGradient);
}

TEST(CohesionGradient, AWeakerSoilBelowDecidesWithWhatItHas) {
  const Joint joint = joint_of(two_soils(soil("undrained", 10e3, 0)));  // 16 kPa of clay above it
  EXPECT_NEAR(joint.cohesion, 10e3, 1e-6);
}

TEST(CohesionGradient, AStrongerSoilBelowLeavesItToTheClay) {
  const Joint joint = joint_of(two_soils(soil("undrained", 40e3, 0)));
  EXPECT_NEAR(joint.cohesion, kSurface + kGradient * joint.depth, 0.02 * kGradient);
}

TEST(CohesionGradient, SoilWithoutOneHasItsOwnCohesionWithinItself) {
  const SceneDef scene = two_soils(soil("undrained", 40e3, 0));
  const LatticeSimulation s(scene, {}, best_kernels());
  const LawConstants below = pair_constants(s.model(), 1, false)[3];
  EXPECT_EQ(below.k, 40e3);
  EXPECT_EQ(below.k_per_cohesion, 0);
}

}  // namespace
}  // namespace vbgpd::test
