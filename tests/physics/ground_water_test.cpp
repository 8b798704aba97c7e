// Ground water of a scene: what it weighs, where it presses, and slopes under water.
#include "simulation/ground_water.h"

#include <gtest/gtest.h>

#include "analysis/job.h"
#include "physics/runout_scenes.h"
#include "simulation/take_over.h"

namespace vbgpd::test {
namespace {

constexpr double kWater = 9810;

SceneDef wet_slope(double level) {
  SceneDef s = slope(soil("mohr_coulomb", 10e3, 20), 1);
  s.water_table = {{-1, level}, {33, level}};
  return s;
}

/// Forces from outside, weight and water, on the soil.
std::vector<Vec2> forces(const LatticeSimulation& s) {
  std::vector<Vec2> out;
  for (std::size_t k = 0; k < s.section().seeds.size(); ++k) {
    if (s.section().seeds[k].hold != Hold::kFree) continue;
    const auto i = static_cast<std::size_t>(s.model().storage_of[k]);
    out.emplace_back(s.model().force_x[i], s.model().force_y[i]);
  }
  return out;
}

double factor_of_safety(const SceneDef& scene) {
  const auto simulation = Simulation::compile(scene, {});
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", 1);
  job->run(0, {});
  return job->result().factor_of_safety;
}

TEST(GroundWater, LevelIsStraightBetweenItsPointsAndLevelBeyond) {
  SceneDef s = wet_slope(0);
  s.water_table = {{0, 4}, {10, 6}, {32, 6}};
  EXPECT_DOUBLE_EQ(water_level(s, 5), 5);
  EXPECT_DOUBLE_EQ(water_level(s, -3), 4);
  EXPECT_DOUBLE_EQ(water_level(s, 40), 6);
  s.water_table.clear();
  EXPECT_EQ(water_level(s, 5), -kInfinity);
}

TEST(GroundWater, PressureIsHydrostaticBelowTheTableAndNoneAbove) {
  const LatticeSimulation s(wet_slope(4), {}, best_kernels());
  const std::vector<double> place = field(s, "reference_position"), pressure = field(s, "pore_pressure");
  for (std::size_t k = 0; k < pressure.size(); ++k)
    EXPECT_NEAR(pressure[k], kWater * std::max(0.0, 4 - place[2 * k + 1]), 1e-6);
}

TEST(GroundWater, RatioOfPorePressureIsThatOfTheWeightAbove) {
  SceneDef scene = block(soil("mohr_coulomb", 10e3, 20), 10, 10, 0.5);
  scene.materials[0].pore_pressure_ratio = 0.4;
  const LatticeSimulation s(scene, {}, best_kernels());
  const std::vector<double> place = field(s, "reference_position"), pressure = field(s, "pore_pressure");
  for (std::size_t k = 0; k < pressure.size(); ++k)
    if (place[2 * k] > 0 && place[2 * k] < 10) {
      EXPECT_NEAR(pressure[k], 0.4 * 20e3 * (10 - place[2 * k + 1]), 1e-6 * 80e3);
    }
}

TEST(GroundWater, RatioCountsTheLayersThatAreThere) {
  SceneDef scene = block(soil("mohr_coulomb", 10e3, 20), 10, 10, 0.5);
  scene.materials[0].pore_pressure_ratio = 0.4;
  scene.layers.push_back({scene.materials[0].name, {{0, 6}, {10, 6}, {10, 10}, {0, 10}}});
  LatticeSimulation s(scene, {}, best_kernels());
  s.set_layers({true, false});
  CompileOptions coarse;
  coarse.coarsening = 2;
  LatticeSimulation other(scene, coarse, best_kernels());
  take_over(s, other);
  for (const LatticeSimulation* one : {&s, &other}) {
    const std::vector<double> place = field(*one, "reference_position"), pressure = field(*one, "pore_pressure");
    for (std::size_t k = 0; k < pressure.size(); ++k)
      if (place[2 * k] > 0 && place[2 * k] < 10 && place[2 * k + 1] < 6) {
        EXPECT_NEAR(pressure[k], 0.4 * 20e3 * (6 - place[2 * k + 1]), 1e-6 * 80e3);
      }
  }
  s.set_layers({true, true});
  EXPECT_EQ(field(s, "pore_pressure"), field(LatticeSimulation(scene, {}, best_kernels()), "pore_pressure"));
}

TEST(GroundWater, LeavesSoilUnderWaterItsBuoyantWeight) {
  for (const double level : {10.0, 60.0}) {
    SceneDef dry = slope(soil("mohr_coulomb", 10e3, 20), 1);
    dry.materials[0].unit_weight -= kWater;
    const LatticeSimulation under_water(wet_slope(level), {}, best_kernels());
    const std::vector<double> place = field(under_water, "reference_position");
    const std::vector<Vec2> wet = forces(under_water);
    const std::vector<Vec2> buoyant = forces(LatticeSimulation(dry, {}, best_kernels()));
    Vec2 sum = Vec2::Zero(), expected = Vec2::Zero();
    double most = 0;
    for (std::size_t k = 0; k < wet.size(); ++k) {
      sum += wet[k], expected += buoyant[k];
      const bool inside = place[2 * k] < 12 && place[2 * k + 1] < 6.5 && place[2 * k + 1] > 5;  // off every edge
      if (inside) most = std::max(most, (wet[k] - buoyant[k]).norm() / dry.materials[0].unit_weight);
    }
    EXPECT_NEAR(sum.y() / expected.y(), 1, 0.01) << level;
    EXPECT_NEAR(sum.x() / expected.y(), 0, 0.01) << level;
    EXPECT_LT(most, 0.02) << level;
  }
}

TEST(GroundWater, DepthOfStandingWaterDoesNotMatter) {
  const std::vector<Vec2> shallow = forces(LatticeSimulation(wet_slope(10), {}, best_kernels()));
  const std::vector<Vec2> deep = forces(LatticeSimulation(wet_slope(1000), {}, best_kernels()));
  for (std::size_t k = 0; k < shallow.size(); ++k) EXPECT_LT((shallow[k] - deep[k]).norm(), 1e-9 * 1000 * kWater);
}

TEST(GroundWater, SlopeUnderWaterIsAsSafeAsOneOfBuoyantWeight) {
  SceneDef dry = slope(soil("mohr_coulomb", 10e3, 20), 0.5);
  dry.materials[0].unit_weight -= kWater;
  SceneDef wet = wet_slope(25);
  wet.spacing = 0.5;
  EXPECT_NEAR(factor_of_safety(wet), factor_of_safety(dry), 0.0075);
}

TEST(GroundWater, SaturatedSoilWeighsMoreBelowTheTable) {
  SceneDef s = wet_slope(4);
  s.materials[0].saturated_unit_weight = 22e3;
  EXPECT_DOUBLE_EQ(unit_weight_at(s, 0, {5, 3.9}), 22e3);
  EXPECT_DOUBLE_EQ(unit_weight_at(s, 0, {5, 4.1}), 20e3);
}

TEST(GroundWater, OtherGridHasItFromTheSceneUnlessAHostHasChangedIt) {
  LatticeSimulation from(wet_slope(4.3), {}, best_kernels());
  CompileOptions coarse;
  coarse.coarsening = 2;
  LatticeSimulation to(wet_slope(4.3), coarse, best_kernels());
  const std::vector<double> own = field(to, "pore_pressure");
  take_over(from, to);
  EXPECT_EQ(field(to, "pore_pressure"), own);
  from.write(find_field("pore_pressure"), std::vector<double>(field(from, "pore_pressure").size(), 0.0));
  take_over(from, to);
  for (const double p : field(to, "pore_pressure")) EXPECT_EQ(p, 0);
}

TEST(GroundWater, GoesOnIntoARunOut) {
  SceneDef s = wet_slope(0);
  s.water_table = {{0, 6}, {12, 6}, {32, 0}};
  const auto wet = runout(s);
  const std::vector<double> place = field(*wet, "reference_position"), pressure = field(*wet, "pore_pressure");
  for (std::size_t k = 0; k < pressure.size(); ++k)
    EXPECT_NEAR(pressure[k], kWater * std::max(0.0, water_level(s, place[2 * k]) - place[2 * k + 1]),
                0.5 * kWater);  // particles of cut cells sit at the centroid now
}

TEST(GroundWater, ThatStandsOnTheGroundIsRefusedInARunOut) {
  try {
    runout(wet_slope(4));
    ADD_FAILURE() << "was not refused";
  } catch (const Error& e) {
    EXPECT_EQ(e.issue().status, Status::kUnsupported);
    EXPECT_NE(e.issue().text.find("water stands on the ground"), std::string::npos);
  }
}

TEST(GroundWater, DrawnAlongTheGroundDoesNotStandOnIt) {
  SceneDef s = wet_slope(0);
  s.water_table = {{0, 10}, {12, 10}, {19.7, 10 - 7.7 / 2}, {32, 0}};
  const LatticeSimulation model(s, {}, best_kernels());
  EXPECT_FALSE(water_stands(s, model.section()));
  for (Point& p : s.water_table) p.y += 0.01;
  EXPECT_TRUE(water_stands(s, model.section()));
}

TEST(GroundWater, PressesOnTheGroundItStandsOn) {
  const LatticeSimulation s(wet_slope(12), {}, best_kernels());
  const StandingWater water(s.scene(), s.section(), s.model());
  Vec2 thrust = Vec2::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.model().storage); ++i)
    if (s.model().seed_of[i] >= 0 &&
        s.section().seeds[static_cast<std::size_t>(s.model().seed_of[i])].hold == Hold::kFree)
      thrust += Vec2(water.x[i], water.y[i]);
  // 2 m of it on the crest of 12 m, 2 to 12 m on the face of 20 m by 10 m
  EXPECT_NEAR(thrust.y(), -kWater * (12 * 2 + 20 * 7), 0.02 * kWater * 164);
  EXPECT_NEAR(thrust.x(), -kWater * 10 * 7, 0.02 * kWater * 70);
}

}  // namespace
}  // namespace vbgpd::test
