// Surface loads in a run-out.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

TEST(RunoutLoad, PressesNothingUp) {
  SceneDef scene = slope(soil("mohr_coulomb", 10e3, 20), 1);
  LoadDef load;
  load.x0 = 2, load.x1 = 10, load.pressure = load.pressure_end = 50e3;
  scene.loads = {load};
  const auto s = runout(scene);
  double total = 0;
  for (std::size_t id = 0; id < static_cast<std::size_t>(s->particle_count()); ++id) {
    EXPECT_LT(s->model().force_y[id], 0) << id;
    total -= s->model().force_y[id];
  }
  EXPECT_NEAR(total, 220 * 20e3 + 8 * 50e3, 1);
}

}  // namespace
}  // namespace vbgpd::test
