// A column of dry bars collapses, spreads and comes to rest: nothing lost, nothing clumped, the books balanced.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/job.h"
#include "analysis/runout_shape.h"
#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

TEST(RunoutColumn, CollapsesToRestWithoutLossOrClumps) {
  const auto s = runout(bar_column(10));
  const auto job = make_runout_job(*s);
  job->set("end_time", 2);
  ASSERT_EQ(job->run(0, nullptr), Status::kOk);
  EXPECT_EQ(job->result().status, "AT_REST") << job->result().reason;
  EXPECT_LT(s->get("kinetic_energy"), 1e-6 * s->get("peak_kinetic_energy"));
  const double spacing = s->model().spacing;
  EXPECT_GT(smallest_distance(*s), 0.78 * spacing);
  const std::vector<Point> ground = ground_surface(*s);
  EXPECT_NEAR(ground.front().y, 0.1, 0.001);  // the corner at the wall never moved
  double area = 0;
  for (const Point& p : ground) area += p.y * spacing;
  EXPECT_NEAR(area, 0.02, 0.1 * 0.02);
  EXPECT_LT(s->get("energy_residual"), 0.01);
  EXPECT_GT(job->result().runout_distance, 0.1);
}

TEST(RunoutColumn, EnergyResidualFallsWithTheTimeStep) {
  const auto residual = [](double factor) {
    FlowOptions options;
    options.time_step = factor;
    const auto s = runout(bar_column(10), 1, options);
    load_by_gravity(*s);
    s->step(static_cast<std::int64_t>(0.3 / s->get("time_step")), nullptr);
    return s->get("energy_residual");
  };
  EXPECT_LT(residual(0.1), 0.7 * residual(0.3));
}

TEST(RunoutColumn, IsTheSameForAnyNumberOfThreadsAndAfterARestoreInTheMiddleOfTheSlide) {
  StateImage middle;
  std::uint64_t hash = 0;
  for (const int threads : {1, 2, 3}) {
    const auto s = runout(bar_column(20), threads);
    s->step(1200, nullptr);
    EXPECT_GT(s->get("neighbour_searches"), 2);
    if (threads == 1) middle = s->image();
    EXPECT_EQ(s->state_hash(), middle.hash) << threads;
    s->step(1000, nullptr);
    if (threads == 1) hash = s->state_hash();
    EXPECT_EQ(s->state_hash(), hash) << threads;
  }
  for (const int threads : {1, 2, 3}) {
    CompileOptions options;
    options.threads = threads;
    const auto s = Simulation::restored(bar_column(20), options, middle);
    EXPECT_EQ(s->get("steps"), 1200);
    s->step(1000, nullptr);
    EXPECT_EQ(s->state_hash(), hash) << threads;
  }
}

TEST(RunoutColumn, GoesOnTheSameAfterARestoreInTheMiddle) {
  const auto s = runout(bar_column(10));
  s->step(1000, nullptr);
  const auto middle = s->save();
  s->step(1000, nullptr);
  const std::uint64_t hash = s->state_hash();
  const double residual = s->get("energy_residual");
  s->step(500, nullptr);
  s->restore(*middle);
  s->step(1000, nullptr);
  EXPECT_EQ(s->state_hash(), hash);
  EXPECT_EQ(s->get("energy_residual"), residual);
}

TEST(RunoutColumn, IsTheSameOnAMapSizedGrid) {
  SceneDef scene = bar_column(10);
  const auto near = runout(scene);
  for (Point& p : scene.exterior) p.x += 4096, p.y += 512;  // exact in binary
  const auto far = runout(scene);
  near->step(300, nullptr), far->step(300, nullptr);
  const std::vector<double> a = field(*near, "displacement"), b = field(*far, "displacement");
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::fabs(a[i] - b[i]));
  EXPECT_LT(difference, 1e-6 * 0.1);  // round-off of the coordinates grows in a collapse
}

TEST(RunoutColumn, StandsWhenItIsStrongAndFallsWhenReduced) {
  MaterialDef clay = soil("mohr_coulomb", 20e3, 20);
  SceneDef scene = slope(clay, 1);
  CompileOptions options;
  LatticeSimulation lattice(scene, options, best_kernels());
  const auto moved = [&](double factor) {
    lattice.set("strength_reduction_factor", factor);
    const auto s = make_runout(lattice);
    const auto job = make_runout_job(*s);
    job->set("end_time", 4);
    job->run(0, nullptr);
    return job->result().moved_area;
  };
  EXPECT_EQ(moved(1), 0);  // FS about 1.9
  EXPECT_GT(moved(3), 10);
}

TEST(RunoutColumn, RefusesWhatItCannotDo) {
  const auto s = runout(bar_column(10));
  EXPECT_THROW(make_strength_reduction(*s), Error);
  EXPECT_THROW(make_equilibrium(*s), Error);
  EXPECT_THROW(make_runout(*s), Error);
  const LatticeSimulation lattice(bar_column(10), {}, best_kernels());
  EXPECT_THROW(make_runout_job(const_cast<LatticeSimulation&>(lattice)), Error);
  SceneDef moving = bar_column(10);
  moving.boundaries[1].kind = BoundaryKind::kVelocity;
  EXPECT_THROW(runout(moving), Error);
}

}  // namespace
}  // namespace vbgpd::test
