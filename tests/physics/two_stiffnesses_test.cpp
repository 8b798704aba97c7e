// Two soils of very different stiffness, one on the other: stress is continuous across the joint, so bonds that cross
// it are springs in series.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/forecast.h"
#include "analysis/job.h"
#include "analysis/stiffness_contrast.h"
#include "physics/scenes.h"
#include "simulation/flow_simulation.h"
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

constexpr double kAsTheyAre = 1e12;

std::unique_ptr<Job> search(Simulation& simulation, double contrast) {
  auto job = make_strength_reduction(simulation);
  job->set("levels", 1), job->set("stiffness_contrast", contrast);
  EXPECT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  EXPECT_LT(job->result().energy_residual, 3e-3);
  return job;
}

double factor_of_safety(const SceneDef& s, double contrast) {
  const auto simulation = Simulation::compile(s, {});
  return search(*simulation, contrast)->result().factor_of_safety;
}

TEST(TwoStiffnesses, FactorOfSafetyHardlyKnowsThem) {
  for (const double dilatancy : {0.0, 20.0}) {
    SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, dilatancy), 1);
    const double alike = factor_of_safety(s, kAsTheyAre);
    put_on_rock(s, 30, 32, 2);
    EXPECT_NEAR(factor_of_safety(s, kAsTheyAre) / alike, 1, 0.02) << dilatancy;
  }
}

TEST(TwoStiffnesses, FarApartNeedTheMemoryThatIsForecast) {
  SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20), 0.5);
  const double plain = forecast_strength_reduction(*Simulation::compile(s, {})).bytes;
  put_on_rock(s, 100, 32, 2);
  const auto simulation = Simulation::compile(s, {});
  const double twin = simulation->get("bytes"), forecast = forecast_strength_reduction(*simulation).bytes;
  EXPECT_GT(forecast, plain + twin);
  search(*simulation, kStiffnessContrast);
  simulation->monitors(), simulation->step(1, nullptr);  // all copies of the state are there now
  EXPECT_GT(simulation->get("bytes"), 1.5 * twin);
  EXPECT_GT(forecast, simulation->get("bytes") + twin);
}

TEST(TwoStiffnesses, FarApartAreSearchedAsIfTheyLayCloseTogether) {
  for (const double dilatancy : {0.0, 20.0}) {
    SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, dilatancy), 1);
    const double alike = factor_of_safety(s, kAsTheyAre);
    for (const double stiffer : {1e-3, 1e3, 1e6}) {
      SceneDef joined = s;
      put_on_rock(joined, stiffer, 32, 2);
      EXPECT_NEAR(factor_of_safety(joined, 3) / alike, 1, 0.01) << stiffer << ", " << dilatancy;
    }
  }
}

std::vector<double> values(const Simulation& s, const char* field) {
  std::vector<double> out;
  s.read(find_field(field), out);
  return out;
}

TEST(TwoStiffnesses, TheModelTakesOverTheFailureThatWasFoundWithThemCloseTogether) {
  SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, 0), 1);
  put_on_rock(s, 1e3, 32, 2);
  const auto simulation = Simulation::compile(s, {});
  const auto job = search(*simulation, 3);
  EXPECT_NE(job->result().reason.find("'rock' counted as 3 times as stiff as 'soil', not 1000"), std::string::npos);
  EXPECT_EQ(simulation->get("strength_reduction_factor"), job->result().srf_unstable);
  EXPECT_FALSE(job->result().slip_surface.empty());
  EXPECT_EQ(simulation->get("max_displacement"), job->result().max_displacement);
  // going on with the true stiffness it is a failing slope, too: where it would balance has not changed
  const RelaxReport flow = simulation->relax(400, {});
  EXPECT_FALSE(flow.diverged);
  EXPECT_NEAR(flow.power_ratio * job->result().srf_unstable / job->result().factor_of_safety, 1, 0.01);
}

TEST(TwoStiffnesses, FailureTakenOverGoesOnToRunOut) {
  SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, 0), 1);
  put_on_rock(s, 1e3, 32, 2);
  const auto simulation = Simulation::compile(s, {});
  search(*simulation, 3);
  const auto flow = make_runout(*simulation);
  const std::vector<double> there = values(*simulation, "stress"), here = values(*flow, "stress"),
                            x = values(*simulation, "reference_position");
  for (std::size_t i = 0; i < here.size() / 4; ++i) {
    if (std::fabs(x[2 * i + 1] - 2) < 3) continue;  // beside the joint
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(here[4 * i + c], there[4 * i + c], 0.05 * 20e3 * 10) << i;
  }
  EXPECT_EQ(flow->step(20, nullptr).status, Status::kOk);
  // rock a thousand times as stiff would burst at once if its strain were taken for stress
  EXPECT_LT(flow->get("max_velocity"), std::sqrt(9.81 * 10));
}

TEST(TwoStiffnesses, StressesTakenOverFromSofterSoilAreTheSame) {
  for (const char* bond : {"virtual_bond", "none"}) {
    SceneDef soft = test::slope(test::soil("mohr_coulomb", 10e3, 20, 10), 1);
    soft.bond = bond;
    SceneDef stiff = soft;
    put_on_rock(soft, 2, 32, 4), put_on_rock(stiff, 500, 32, 4);
    const auto from = Simulation::compile(soft, {}), to = Simulation::compile(stiff, {});
    from->set("strength_reduction_factor", 1.4);
    from->relax(300, {});
    to->relax(100, {});  // whatever it did before does not count
    to->take_stresses(*from);
    EXPECT_EQ(values(*to, "displacement"), values(*from, "displacement"));
    EXPECT_EQ(to->get("strength_reduction_factor"), 1.4);
    EXPECT_EQ(to->get("plastic_bonds"), from->get("plastic_bonds"));
    const std::vector<double> x = values(*from, "reference_position"), there = values(*from, "stress"),
                              here = values(*to, "stress");
    for (std::size_t i = 0; i < here.size() / 4; ++i) {
      const bool beside_the_joint = std::fabs(x[2 * i + 1] - 4) < 3;
      for (std::size_t c = 0; c < 4; ++c) {
        const double at = here[4 * i + c], scale = 20e3 * 10;
        EXPECT_NEAR(at, there[4 * i + c], (beside_the_joint ? 0.03 : 1e-9) * scale) << bond << ", particle " << i;
      }
    }
  }
}

TEST(TwoStiffnesses, StressesOfAnotherSectionAreRefused) {
  SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20, 0), 1);
  const auto one = Simulation::compile(s, {});
  s.spacing = 2;
  const auto other = Simulation::compile(s, {});
  const std::uint64_t before = one->state_hash();
  try {
    one->take_stresses(*other);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.issue().status, Status::kArgument);
  }
  EXPECT_EQ(one->state_hash(), before);
}

}  // namespace
}  // namespace vbgpd
