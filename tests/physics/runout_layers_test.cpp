// Run-out from a stage of construction: soil dug away is as if it had never been drawn.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// A slope that fails, with or without a berm, layer 1, on its toe. Both profiles have the same lattice.
SceneDef slope(bool berm) {
  SceneDef s = block(soil("mohr_coulomb", 2e3, 15), 1, 1, 1);
  s.exterior = {{0, 0}, {40, 0}, {40, 6}, {20, 6}, {10, 16}, {0, 16}};
  if (!berm) return s;
  s.exterior = {{0, 0}, {40, 0}, {40, 10}, {30, 10}, {30, 6}, {20, 6}, {10, 16}, {0, 16}};
  s.layers.push_back({s.materials[0].name, {{30, 6}, {40, 6}, {40, 10}, {30, 10}}});
  return s;
}
const Layers kDug = {true, false};
Status never() { return Status::kOk; }

TEST(RunoutLayers, DugSlopeRunsOutLikeTheOneDrawnWithout) {
  LatticeSimulation stage(slope(true), {}, best_kernels());
  const FlowSimulation whole(stage);
  stage.set_layers(kDug);
  FlowSimulation dug(stage);
  const auto drawn = runout(slope(false));
  ASSERT_EQ(dug.particle_count(), drawn->particle_count());
  EXPECT_LT(dug.particle_count(), whole.particle_count());
  EXPECT_EQ(field(dug, "reference_position"), field(*drawn, "reference_position"));
  EXPECT_NEAR(dug.get("height"), drawn->get("height"), 1e-12);
  for (FlowSimulation* s : {&dug, drawn.get()}) {
    load_by_gravity(*s, 1e-4);
    ASSERT_EQ(s->advance_to(1, never).status, Status::kOk);
  }
  EXPECT_GT(drawn->get("max_displacement"), 0.5);
  const std::vector<double> a = field(dug, "displacement"), b = field(*drawn, "displacement");
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-6 * drawn->get("max_displacement"));
}

TEST(RunoutLayers, ImageBringsItsLayersAlong) {
  LatticeSimulation stage(slope(true), {}, best_kernels());
  FlowSimulation whole(stage);
  stage.set_layers(kDug);
  FlowSimulation dug(stage);
  dug.advance_to(0.2, never);
  const StateImage image = dug.image();
  EXPECT_THROW(whole.restore_image(image), Error);
  const auto again = Simulation::restored(dug.scene(), {}, image);
  EXPECT_EQ(again->layers(), kDug);
  dug.advance_to(0.4, never), again->advance_to(0.4, never);
  EXPECT_EQ(again->state_hash(), dug.state_hash());
}

}  // namespace
}  // namespace vbgpd::test
