// Two soils of very different stiffness, one on the other: stress is continuous across the joint, so bonds that cross
// it are springs in series.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/job.h"
#include "physics/scenes.h"
#include "simulation/simulation.h"

namespace vbgpd {
namespace {

/// Rock under the soil, as strong as that, its top at `height`.
void put_on_rock(SceneDef& s, double times_as_stiff, double width, double height) {
  MaterialDef rock = s.materials[0];
  rock.name = "rock", rock.young_modulus *= times_as_stiff;
  s.materials.push_back(rock);
  s.layers.push_back({"rock", {{-1, -1}, {width + 1, -1}, {width + 1, height}, {-1, height}}});
}

TEST(TwoStiffnesses, ColumnSettlesLikeSpringsInSeries) {
  constexpr double kHeight = 10, kJoint = 5, kSpacing = 0.5, kWeight = 20e3;
  for (const double stiffer : {1.0, 30.0, 1000.0}) {
    SceneDef s = test::block(test::soil("elastic", 0, 0), 5, kHeight, kSpacing);
    put_on_rock(s, stiffer, 5, kJoint);
    const auto simulation = Simulation::compile(s, {});
    for (int n = 0; n < 3000 && simulation->relax(10, {}).unbalanced_force_ratio > 1e-9; ++n) {
    }
    std::vector<double> x, u;
    simulation->read(find_field("reference_position"), x);
    simulation->read(find_field("displacement"), u);
    const double top = kHeight - kSpacing / 2;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; 2 * i < x.size(); ++i)
      if (std::fabs(x[2 * i + 1] - top) < 1e-6 && x[2 * i] > 0 && x[2 * i] < 5) sum -= u[2 * i + 1], ++count;
    ASSERT_EQ(count, 10);
    // of the top row: integral of gamma (H - y) over the oedometric modulus E (1 - nu) / ((1 + nu) (1 - 2 nu))
    const auto below = [&](double y) { return kHeight * y - y * y / 2; };
    const double soil = 1e8 * 0.7 / (1.3 * 0.4);
    const double exact = kWeight / soil * (below(kJoint) / stiffer + below(top) - below(kJoint));
    // at ten spacings a layer; with the mean of the moduli at the joint 0.88 and 0.71 for the two stiff ones
    EXPECT_NEAR(sum / count / exact, 1, 0.1) << stiffer;
  }
}

double factor_of_safety(const SceneDef& s) {
  const auto simulation = Simulation::compile(s, {});
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", 1);
  EXPECT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  EXPECT_LT(job->result().energy_residual, 3e-3);
  return job->result().factor_of_safety;
}

TEST(TwoStiffnesses, FactorOfSafetyHardlyKnowsThem) {
  for (const double dilatancy : {0.0, 20.0}) {
    SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, dilatancy), 1);
    const double alike = factor_of_safety(s);
    put_on_rock(s, 30, 32, 2);
    EXPECT_NEAR(factor_of_safety(s) / alike, 1, 0.02) << dilatancy;
  }
}

}  // namespace
}  // namespace vbgpd
