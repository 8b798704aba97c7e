// What a call that moves the model says afterwards, against what is worked out anew.
#include <gtest/gtest.h>

#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {
namespace {

class MonitorsAfterSteps : public testing::Test {
 protected:
  LatticeSimulation simulation{test::slope(test::soil("drucker_prager", 10e3, 20), 1), {}, best_kernels()};
};

TEST_F(MonitorsAfterSteps, CarryTheForcesTheLastStepMovedWith) {
  simulation.step(40, nullptr);
  const Real before = simulation.monitors().unbalanced_force_ratio;
  const StepReport report = simulation.step(1, nullptr);
  EXPECT_NEAR(simulation.monitors_after(report).unbalanced_force_ratio, before, 1e-12 * before);
  EXPECT_NE(simulation.monitors().unbalanced_force_ratio, before);
}

TEST_F(MonitorsAfterSteps, AreThoseOfThePresentStateInAllElse) {
  simulation.set("strength_reduction_factor", 3);
  const Monitors quick = simulation.monitors_after(simulation.step(200, nullptr)), anew = simulation.monitors();
  EXPECT_GT(quick.plastic_bonds, 0);
  EXPECT_EQ(quick.plastic_bonds, anew.plastic_bonds);
  EXPECT_EQ(quick.max_displacement, anew.max_displacement);
  EXPECT_EQ(quick.max_velocity, anew.max_velocity);
  EXPECT_EQ(quick.kinetic_energy, anew.kinetic_energy);
}

TEST_F(MonitorsAfterSteps, OfNoStepAreThoseOfThePresentState) {
  simulation.step(40, nullptr);
  const StepReport report = simulation.step(0, nullptr);
  EXPECT_FALSE(report.unbalanced_force_ratio.has_value());
  EXPECT_EQ(simulation.monitors_after(report).unbalanced_force_ratio, simulation.monitors().unbalanced_force_ratio);
}

}  // namespace
}  // namespace vbgpd
