// Pore pressure on a run-out: soil carries effective stress, water pushes it by its gradient and moves with it.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

constexpr double kWater = 9.81e3, kWeight = 20e3;

/// pressure(x, y) at every particle.
template <class F>
void set_pressure(Simulation& s, F&& pressure) {
  std::vector<double> x, p;
  s.read(find_field("position"), x);
  for (std::size_t i = 0; i < x.size(); i += 2) p.push_back(pressure(x[i], x[i + 1]));
  s.write(find_field("pore_pressure"), p);
}

/// 10 m of sand at 2:1 on 5 m of it, stable while dry (the infinite slope has 1.2).
SceneDef sand_slope() {
  SceneDef s = block(soil("drucker_prager", 2e3, 32), 50, 15, 1);
  s.exterior = {{0, 0}, {50, 0}, {50, 5}, {35, 5}, {15, 15}, {0, 15}};
  return s;
}
double depth(double x, double y) { return std::max(0.0, std::clamp(15 - (x - 15) / 2, 5.0, 15.0) - y); }
void saturate(Simulation& s) {
  set_pressure(s, [](double x, double y) { return 0.7 * kWeight * depth(x, y); });
}

TEST(RunoutWater, LevelGroundUnderWaterCarriesItsBuoyantWeight) {
  MaterialDef sand = soil("drucker_prager", 0, 30);
  const double height = 1, rows = 20;
  sand.young_modulus = 1000 * kWeight * height;
  const auto s = runout(block(sand, height, height, height / rows));
  set_pressure(*s, [&](double, double y) { return kWater * (height - y); });
  load_by_gravity(*s, 1e-6);
  ASSERT_EQ(s->step(static_cast<std::int64_t>(10 * std::sqrt(height / 9.81) / s->get("time_step")), nullptr).status,
            Status::kOk);
  const std::vector<double> x = field(*s, "position"), stress = field(*s, "stress");
  double interior = 0, first_row = 0;
  for (std::size_t i = 0; i < x.size() / 2; ++i) {
    const double y = x[2 * i + 1], expected = -(kWeight - kWater) * (height - y);
    const double error = std::fabs(stress[4 * i + 1] - expected) / (kWeight * height);
    if (y < height / rows) first_row = std::max(first_row, error);
    else if (y < height - height / rows) interior = std::max(interior, error);
  }
  EXPECT_LT(interior, 0.015);
  EXPECT_LT(first_row, 0.03);
  EXPECT_LT(s->get("max_velocity"), 1e-3 * std::sqrt(9.81 * height));
  EXPECT_NEAR(s->boundary_reaction(0).y(), kWeight * height * height, 0.005 * kWeight);  // walls bear soil and water
}

TEST(RunoutWater, RisingPressureMakesAStableSlopeSlide) {
  const auto s = runout(sand_slope());
  load_by_gravity(*s);
  s->advance_to(1, [] { return Status::kOk; });
  const double dry = s->get("max_displacement");
  saturate(*s);
  const auto before = s->save();
  ASSERT_EQ(s->advance_to(3, [] { return Status::kOk; }).status, Status::kOk);
  EXPECT_GT(s->get("max_displacement"), dry + 0.5);
  EXPECT_LT(s->get("energy_residual"), 0.01);

  s->restore(*before);
  set_pressure(*s, [](double, double) { return 0; });  // without it, nothing happens in the same time
  s->advance_to(3, [] { return Status::kOk; });
  EXPECT_LT(s->get("max_displacement"), dry + 0.05);

  s->restore(*before);
  s->advance_to(2, [] { return Status::kOk; });
  const StateImage image = s->image();
  const auto other = runout(sand_slope(), 2);
  other->restore_image(image);
  s->advance_to(3, [] { return Status::kOk; }), other->advance_to(3, [] { return Status::kOk; });
  EXPECT_EQ(other->state_hash(), s->state_hash());
}

/// Water that pushed as hard however far the soil came apart would lift the mass: it did more work than the weight.
TEST(RunoutWater, SoilThatFloatsIsNotLifted) {
  const auto s = runout(sand_slope());
  load_by_gravity(*s);
  set_pressure(*s, [](double x, double y) { return 0.9 * kWeight * depth(x, y); });
  const std::vector<double> start = field(*s, "position"), mass = field(*s, "mass");
  double top = 0;
  for (int second = 1; second <= 12; ++second) {
    ASSERT_EQ(s->advance_to(second, [] { return Status::kOk; }).status, Status::kOk);
    const std::vector<double> x = field(*s, "position");
    for (std::size_t i = 1; i < x.size(); i += 2) top = std::max(top, x[i]);
  }
  EXPECT_LT(top, 15.5);
  const std::vector<double> end = field(*s, "position");
  double weight = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) weight += mass[i] * 9.81 * (start[2 * i + 1] - end[2 * i + 1]);
  EXPECT_GT(s->get("max_displacement"), 5);
  EXPECT_LT(s->get("external_work") - weight, 0.5 * weight);
  EXPECT_LT(s->get("energy_residual"), 0.01);
  EXPECT_LT(s->get("kinetic_energy"), 1e-2 * s->get("peak_kinetic_energy"));
}

TEST(RunoutWater, UpliftTakesItsShareOfTheFrictionOfACoulombBase) {
  MaterialDef rock = soil("elastic", 0, 0);
  rock.young_modulus = 1e7;
  SceneDef scene = block(rock, 1, 0.5, 0.05);
  scene.boundaries.resize(1);
  scene.boundaries[0].friction_angle = 30;
  scene.kh = 0.4;
  const auto s = runout(scene);
  set_pressure(*s, [](double, double y) { return 0.6 * kWeight * (0.5 - y); });
  load_by_gravity(*s, 1e-7);
  s->advance_to(0.5, [] { return Status::kOk; });
  const std::vector<double> v = field(*s, "velocity"), m = field(*s, "mass");
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < m.size(); ++i) momentum += m[i] * v[2 * i], mass += m[i];
  // tan 30 bears 0.58 W dry, 0.23 W with 0.6 W of uplift
  EXPECT_NEAR(momentum / mass, 9.81 * (0.4 - 0.4 * std::tan(kPi / 6)) * 0.5, 0.05);
}

TEST(RunoutWater, ComesAlongFromTheModelAtRestAndCostsNothingWhereThereIsNone) {
  LatticeSimulation lattice(sand_slope(), {}, best_kernels());
  const FlowSimulation dry(lattice);
  saturate(lattice);
  FlowSimulation wet(lattice);
  std::vector<double> was, is = field(wet, "pore_pressure");
  lattice.read(find_field("pore_pressure"), was);
  was.resize(is.size());
  EXPECT_EQ(is, was);
  const double more = wet.get("bytes") - dry.get("bytes"), two = 2 * 8 * static_cast<double>(is.size());
  EXPECT_GE(more, two);
  EXPECT_LT(more, two + 8192);  // arrays begin on lines of their own
  wet.write(find_field("pore_pressure"), std::vector<double>(is.size(), 0));
  EXPECT_EQ(wet.get("bytes"), dry.get("bytes"));
}

}  // namespace
}  // namespace vbgpd::test
