// Images of run-outs that are not what a run-out wrote: refused, and the model is as it was.
#include <gtest/gtest.h>

#include <functional>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

class RunoutImages : public testing::Test {
 protected:
  RunoutImages() {
    simulation_->step(400, nullptr);
    image_ = simulation_->image();
  }
  std::vector<double>& values(std::string_view name) {
    for (StateImage::Rows& r : image_.rows)
      if (r.name == name) return r.values;
    throw std::runtime_error("no such rows");
  }
  double& number(std::string_view name) {
    for (StateImage::Number& n : image_.numbers)
      if (n.name == name) return n.value;
    throw std::runtime_error("no such number");
  }
  void expect_refused(const char* what) {
    const std::uint64_t before = simulation_->state_hash();
    try {
      simulation_->restore_image(image_);
      ADD_FAILURE() << what;
    } catch (const Error& e) {
      EXPECT_EQ(e.issue().status, Status::kFormat) << what;
    }
    EXPECT_EQ(simulation_->state_hash(), before) << what;
    image_ = simulation_->image();
  }

  std::unique_ptr<FlowSimulation> simulation_ = runout(bar_column(5));
  StateImage image_;
};

TEST_F(RunoutImages, AreTakenWhenWhole) {
  simulation_->step(50, nullptr);
  simulation_->restore_image(image_);
  EXPECT_EQ(simulation_->state_hash(), image_.hash);
}

TEST_F(RunoutImages, AreRefusedWithAnythingMissing) {
  const StateImage whole = image_;
  for (std::size_t k = 0; k < whole.rows.size(); ++k) {
    if (whole.rows[k].name == "load_pressure" || whole.rows[k].name == "boundary_velocity") continue;
    image_.rows.erase(image_.rows.begin() + static_cast<std::ptrdiff_t>(k));
    expect_refused(whole.rows[k].name.c_str());
  }
  for (std::size_t k = 0; k < whole.numbers.size(); ++k) {
    image_.numbers.erase(image_.numbers.begin() + static_cast<std::ptrdiff_t>(k));
    expect_refused(whole.numbers[k].name.c_str());
  }
}

TEST_F(RunoutImages, AreRefusedWithImpossibleValues) {
  values("order")[3] = values("order")[4];
  expect_refused("the same particle twice");
  values("order")[3] = 0.5;
  expect_refused("half a particle");
  values("order")[3] = -1;
  expect_refused("a particle before the first");
  values("order")[3] = 1e300;
  expect_refused("a particle beyond the last");
  values("position")[3] = 1e250;
  expect_refused("a particle beyond all places");
  values("velocity")[0] = std::nan("");
  expect_refused("no number");
  values("guard_size")[0] = 1;
  expect_refused("a guard larger than the particle");
  values("traction").resize(values("traction").size() - 8);
  expect_refused("too few tractions");
  values("stress")[0] += 1;
  expect_refused("another state than that of the hash");
  number("strength_reduction_factor") = 0;
  expect_refused("no strength");
  number("kh") = 7;
  expect_refused("kh of 7");
  image_.particles -= 1;
  expect_refused("another number of particles");
  image_.runs_out = false;
  expect_refused("at rest");
}

TEST_F(RunoutImages, AreRefusedWhenAllParticlesLieInOnePlace) {
  // 3200 particles in one place would list ten million neighbours
  const auto large = runout(bar_column(40));
  image_ = large->image();
  for (StateImage::Rows& r : image_.rows)
    if (r.name == "listed") std::fill(r.values.begin(), r.values.end(), 0.05);
  try {
    large->restore_image(image_);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("on top of each other"), std::string::npos) << e.what();
  }
}

TEST_F(RunoutImages, FarAwayParticlesOfABrokenRunHaveNoPlaceInTheCells) {
  FlowState& state = simulation_->state();
  state.motion[0] = 1e200, state.motion[5] = std::nan("");
  simulation_->state_was_changed();
  EXPECT_GT(simulation_->bond_count(), 0);
}

}  // namespace
}  // namespace vbgpd::test
