// Staged construction: soil dug away is as if it had never been drawn, soil placed is stress-free and then weighs.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string_view>

#include "analysis/job.h"
#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"
#include "simulation/sampler.h"

namespace vbgpd {
namespace {

constexpr double kWeight = 20e3;

/// A slope with a berm on its toe, layer 1, of the same soil.
SceneDef with_berm(const MaterialDef& soil) {
  SceneDef s = test::block(soil, 1, 1, 1);
  s.exterior = {{0, 0}, {40, 0}, {40, 10}, {30, 10}, {30, 6}, {20, 6}, {10, 16}, {0, 16}};
  s.layers.push_back({soil.name, {{30, 6}, {40, 6}, {40, 10}, {30, 10}}});
  return s;
}
SceneDef without_berm(const MaterialDef& soil) {
  SceneDef s = with_berm(soil);
  s.exterior = {{0, 0}, {40, 0}, {40, 6}, {20, 6}, {10, 16}, {0, 16}};
  s.layers.resize(1);
  return s;
}
/// A vertical cut with a berm, layer 1, that holds its foot.
SceneDef cut_with_berm(const MaterialDef& soil) {
  SceneDef s = with_berm(soil);
  s.exterior = {{0, 0}, {40, 0}, {40, 6}, {20, 6}, {20, 10}, {10, 10}, {10, 16}, {0, 16}};
  s.layers[1].polygon = {{10, 6}, {20, 6}, {20, 10}, {10, 10}};
  return s;
}
SceneDef cut_without_berm(const MaterialDef& soil) {
  SceneDef s = without_berm(soil);
  s.exterior = {{0, 0}, {40, 0}, {40, 6}, {10, 6}, {10, 16}, {0, 16}};
  return s;
}
/// Two layers on a rigid floor between smooth walls, the upper one from y = 6 to 10.
SceneDef two_layers(const MaterialDef& soil) {
  SceneDef s = test::block(soil, 10, 10, 1);
  s.layers.push_back({soil.name, {{0, 6}, {10, 6}, {10, 10}, {0, 10}}});
  return s;
}

const MaterialDef kSoil = test::soil("mohr_coulomb", 12e3, 20);
const MaterialDef kRock = test::soil("elastic", 10e3, 0);
const Layers kOff = {true, false}, kOn = {true, true};

std::unique_ptr<LatticeSimulation> compiled(const SceneDef& scene, int threads = 1) {
  CompileOptions options;
  options.threads = threads;
  return std::make_unique<LatticeSimulation>(scene, options, best_kernels());
}

std::vector<double> read(const Simulation& s, const char* field) {
  std::vector<double> rows;
  s.read(find_field(field), rows);
  return rows;
}

void settle(Simulation& s) {
  s.halt();
  while (s.relax(20, {}).unbalanced_force_ratio > 1e-8) {
  }
  s.halt();
}

/// By the cell of the undeformed section, of what is there.
std::map<std::pair<long, long>, std::size_t> by_place(const Simulation& s) {
  std::map<std::pair<long, long>, std::size_t> ids;
  const auto at = read(s, "reference_position"), active = read(s, "active");
  for (std::size_t k = 0; k < active.size(); ++k)
    if (active[k] != 0) ids[{std::lround(4 * at[2 * k]), std::lround(4 * at[2 * k + 1])}] = k;
  return ids;
}

void expect_same_motion(const Simulation& a, const Simulation& b, double tolerance) {
  const auto here = by_place(a), there = by_place(b);
  ASSERT_EQ(here.size(), there.size());
  const auto ua = read(a, "displacement"), ub = read(b, "displacement");
  const double scale = a.get("max_displacement");
  ASSERT_GT(scale, 0);
  for (const auto& [place, id] : here) {
    ASSERT_TRUE(there.count(place));
    const std::size_t other = there.at(place);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(ua[2 * id + c], ub[2 * other + c], tolerance * scale);
  }
}

class Bonds : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Laws, Bonds, testing::Values("virtual_bond", "none"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(Bonds, DugSlopeMovesLikeTheOneDrawnWithout) {
  SceneDef a = with_berm(kSoil), b = without_berm(kSoil);
  a.bond = b.bond = GetParam();
  const auto dug = compiled(a), drawn = compiled(b);
  ASSERT_EQ(dug->section().lattice.spacing, drawn->section().lattice.spacing);
  dug->set_layers(kOff);
  EXPECT_EQ(dug->bond_count(), drawn->bond_count());
  EXPECT_NEAR(dug->get("total_mass"), drawn->get("total_mass"), 1e-6);
  EXPECT_NEAR(dug->get("time_step"), drawn->get("time_step"), 1e-3 * drawn->get("time_step"));
  dug->set("strength_reduction_factor", 1.2), drawn->set("strength_reduction_factor", 1.2);
  dug->relax(300, {}), drawn->relax(300, {});
  EXPECT_GT(drawn->get("plastic_bonds"), 0);
  EXPECT_EQ(dug->get("plastic_bonds"), drawn->get("plastic_bonds"));
  expect_same_motion(*dug, *drawn, 1e-9);
}

TEST(Layers, DugCutHasTheFactorOfSafetyOfTheOneDrawnWithout) {
  const MaterialDef soil = test::soil("mohr_coulomb", 50e3, 20);
  const auto dug = compiled(cut_with_berm(soil)), drawn = compiled(cut_without_berm(soil)),
             whole = compiled(cut_with_berm(soil));
  ASSERT_EQ(dug->section().lattice.spacing, drawn->section().lattice.spacing);
  dug->set_layers(kOff);
  std::vector<double> factor;
  std::vector<std::vector<Point>> line;
  for (LatticeSimulation* s : {dug.get(), drawn.get(), whole.get()}) {
    const auto job = make_strength_reduction(*s);
    ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
    EXPECT_EQ(job->result().levels.size(), 2u);
    factor.push_back(job->result().factor_of_safety);
    line.push_back(job->result().slip_surface);
  }
  EXPECT_NEAR(factor[0], factor[1], 1e-12);
  EXPECT_GT(factor[2], 1.1 * factor[1]);  // the berm had held it
  ASSERT_FALSE(line[1].empty());
  EXPECT_NEAR(line[0].front().x, line[1].front().x, 1e-3);
  EXPECT_NEAR(line[0].back().x, line[1].back().x, 1e-3);
}

TEST(Layers, TakeTheirMassWithThem) {
  const auto s = compiled(with_berm(kSoil));
  const double before = s->get("total_mass");
  s->set_layers(kOff);
  EXPECT_NEAR(before - s->get("total_mass"), 10 * 4 * kWeight / 9.81, 1e-9 * before);
  EXPECT_NEAR(s->get("area"), 40 * 6 + 10 * 10 + 50, 1e-9);
  EXPECT_NEAR(s->get("height"), 10, 1e-9);
}

TEST(Layers, OffAndOnAgainBeforeAnythingMovedChangesNothing) {
  const auto s = compiled(with_berm(kSoil)), untouched = compiled(with_berm(kSoil));
  const auto hash = s->state_hash();
  s->set_layers(kOff);
  EXPECT_NE(s->state_hash(), hash);
  s->set_layers(kOn);
  EXPECT_TRUE(s->layers().empty());
  EXPECT_EQ(s->state_hash(), hash);
  EXPECT_EQ(s->get("bytes"), untouched->get("bytes"));
  s->step(40, nullptr), untouched->step(40, nullptr);
  EXPECT_EQ(s->state_hash(), untouched->state_hash());
}

TEST(Layers, WhatIsOffReadsAsNothing) {
  const auto s = compiled(with_berm(kSoil));
  settle(*s);
  s->set_layers(kOff);
  const auto active = read(*s, "active"), at = read(*s, "reference_position"), boundary = read(*s, "boundary");
  std::map<std::string, std::vector<double>> rows;
  for (const char* name : {"volume", "mass", "stress", "displacement", "velocity"}) rows[name] = read(*s, name);
  int off = 0;
  for (std::size_t k = 0; k < active.size(); ++k) {
    if (boundary[k] < 0) {
      EXPECT_EQ(active[k] == 0, at[2 * k] > 30 && at[2 * k + 1] > 6);
    }
    if (active[k] != 0) continue;
    ++off;
    for (const auto& [name, values] : rows) {
      const std::size_t components = values.size() / active.size();
      for (std::size_t c = 0; c < components; ++c) EXPECT_EQ(values[k * components + c], 0) << name;
    }
  }
  EXPECT_EQ(off, 40 + 4 * 3);  // and three columns of the wall beside it
  Sampler sampler(*s, find_field("stress"), true);
  double stress[4];
  EXPECT_FALSE(sampler.at(35, 7, stress));
  EXPECT_TRUE(sampler.at(35, 5, stress));
  for (const Point& p : deformed_ground(*s))
    if (p.x > 22) {
      EXPECT_NEAR(p.y, 6, 0.1);
    }
}

TEST(Layers, ElasticSoilForgetsWhatWasDugAway) {
  const auto dug = compiled(two_layers(kRock)), never = compiled(two_layers(kRock));
  settle(*dug);
  dug->set_layers(kOff), never->set_layers(kOff);
  settle(*dug), settle(*never);
  expect_same_motion(*dug, *never, 1e-5);
}

TEST(Layers, ElasticSoilIsPressedByAFillAsIfAllHadBeenPlacedAtOnce) {
  const auto staged = compiled(two_layers(kRock)), at_once = compiled(two_layers(kRock));
  staged->set_layers(kOff);
  settle(*staged);
  const auto before = read(*staged, "displacement");
  staged->set_layers(kOn);
  settle(*staged), settle(*at_once);
  const auto u = read(*staged, "displacement"), whole = read(*at_once, "displacement"),
             stress = read(*staged, "stress"), expected = read(*at_once, "stress"),
             at = read(*staged, "reference_position"), boundary = read(*staged, "boundary");
  const double largest = at_once->get("max_displacement");
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const double y = at[2 * k + 1];
    if (boundary[k] >= 0) continue;
    EXPECT_NEAR(stress[4 * k + 1], expected[4 * k + 1], 0.01 * kWeight * 10) << y;
    if (y < 6) {
      EXPECT_NEAR(u[2 * k + 1], whole[2 * k + 1], 0.01 * largest) << y;
      EXPECT_LT(u[2 * k + 1], before[2 * k + 1]);
    } else {
      EXPECT_GT(u[2 * k + 1], whole[2 * k + 1]);  // nobody waited for it while the soil below settled under itself
    }
  }
}

using Ends = std::pair<std::int64_t, std::int64_t>;
std::map<Ends, std::array<double, 3>> bond_stress(const Simulation& s) {
  std::vector<std::int64_t> ends;
  s.read(find_field("bond_particles"), ends);
  const auto stress = read(s, "bond_stress");
  std::map<Ends, std::array<double, 3>> out;
  for (std::size_t b = 0; b < ends.size() / 2; ++b)
    out[{ends[2 * b], ends[2 * b + 1]}] = {stress[3 * b], stress[3 * b + 1], stress[3 * b + 2]};
  return out;
}

TEST(Layers, PlacingSoilChangesNoStress) {
  for (const MaterialDef& soil : {kSoil, kRock, test::soil("undrained", 30e3, 0)}) {
    const auto s = compiled(with_berm(soil));
    s->set_layers(kOff);
    s->relax(150, {});
    const auto before = bond_stress(*s);
    const auto there = read(*s, "active");
    const double plastic = s->get("plastic_bonds");
    s->set_layers(kOn);
    EXPECT_EQ(s->get("plastic_bonds"), plastic) << soil.law;
    const auto after = bond_stress(*s);
    EXPECT_GT(after.size(), before.size());
    const double nothing = 1e-9 * 16 * kWeight;
    for (const auto& [ends, stress] : after) {
      const int old =
          static_cast<int>(there[static_cast<std::size_t>(ends.first)] + there[static_cast<std::size_t>(ends.second)]);
      // the mean stress belongs to the particles, a bond has the mean of its ends; the rest is its own
      ASSERT_EQ(before.count(ends), old == 2 ? 1u : 0u);
      const auto was = old == 2 ? before.at(ends) : std::array<double, 3>{};
      ASSERT_NEAR(stress[2], was[2], nothing) << soil.law;
      ASSERT_NEAR(stress[0] - stress[1], was[0] - was[1], nothing) << soil.law;
      if (old != 1) {
        ASSERT_NEAR(stress[0], was[0], nothing) << soil.law;
      }
    }
  }
}

TEST(Layers, SoilDugAndPlacedAgainComesBackWithoutStress) {
  const auto s = compiled(two_layers(kRock));
  settle(*s);
  s->set_layers(kOff);
  s->set_layers(kOn);
  const auto stress = read(*s, "stress"), at = read(*s, "reference_position"), boundary = read(*s, "boundary");
  for (std::size_t k = 0; k < boundary.size(); ++k)
    if (boundary[k] < 0 && at[2 * k + 1] > 9) {
      EXPECT_NEAR(stress[4 * k + 1], 0, 1e-6 * kWeight);
    }
}

TEST(Layers, ShapeOfPlacedSoilHasANameAndNoBytesWhereNothingWasPlaced) {
  const auto s = compiled(with_berm(kSoil));
  const auto placed = [&] {
    double sum = 0;
    std::size_t bytes = 0;
    bool used = false;
    for (const Feature& f : s->plan()) {
      sum += static_cast<double>(f.particle_bytes + f.bond_bytes);
      if (std::string_view(f.name) == "placed soil") used = f.used, bytes = f.bond_bytes;
    }
    EXPECT_EQ(sum, s->get("bytes"));
    EXPECT_EQ(used, bytes > 0);
    return used;
  };
  EXPECT_FALSE(placed());
  s->set_layers(kOff);
  s->step(10, nullptr);
  EXPECT_FALSE(placed());
  s->set_layers(kOn);
  EXPECT_TRUE(placed());
}

TEST(Layers, LoadsGoDownToTheNewGround) {
  SceneDef scene = with_berm(kRock), without = without_berm(kRock);
  scene.loads = without.loads = {{31, 37, 50e3, 30e3}};
  const auto dug = compiled(scene), drawn = compiled(without);
  dug->set_layers(kOff);
  dug->relax(200, {}), drawn->relax(200, {});
  expect_same_motion(*dug, *drawn, 1e-9);
  settle(*dug);
  double borne = 0;
  for (std::size_t side = 0; side < 3; ++side) borne += dug->boundary_reaction(side).y();
  EXPECT_NEAR(borne, dug->get("total_mass") * 9.81 + 6 * 40e3, 1e-5 * borne);
}

TEST(Layers, SavedStatesAndImagesBringTheirLayersBack) {
  const auto s = compiled(with_berm(kSoil)), other = compiled(with_berm(kSoil));
  s->step(200, nullptr);
  const auto whole = s->save();
  const auto hash_whole = s->state_hash();
  s->set_layers(kOff);
  s->step(50, nullptr);
  const auto dug = s->save();
  const auto image_dug = s->image();
  const auto hash_dug = s->state_hash();
  s->set_layers(kOn);
  s->step(50, nullptr);
  const auto placed = s->save();
  const auto image_placed = s->image();
  const auto hash_placed = s->state_hash();
  s->step(20, nullptr);
  const auto later = s->state_hash();
  s->restore(*whole);
  EXPECT_EQ(s->state_hash(), hash_whole);
  EXPECT_TRUE(s->layers().empty());
  s->restore(*dug);
  EXPECT_EQ(s->state_hash(), hash_dug);
  EXPECT_EQ(s->layers(), kOff);
  s->restore(*placed);
  EXPECT_EQ(s->state_hash(), hash_placed);
  s->step(20, nullptr);
  EXPECT_EQ(s->state_hash(), later);
  other->restore_image(image_dug);
  EXPECT_EQ(other->state_hash(), hash_dug);
  other->restore_image(image_placed);
  EXPECT_EQ(other->state_hash(), hash_placed);
  other->step(20, nullptr);
  EXPECT_EQ(other->state_hash(), later);
  StateImage wrong = image_dug;
  for (auto& r : wrong.rows)
    if (r.name == "active_layer") r.values = {0, 0};
  EXPECT_THROW(other->restore_image(wrong), Error);
  EXPECT_EQ(other->state_hash(), later);
}

TEST(Layers, BooksBalanceAcrossDiggingAndFilling) {
  const auto s = compiled(with_berm(kSoil));
  s->set("damping", 0.3);
  for (const Layers& layers : {kOff, kOn, kOff}) {
    s->step(300, nullptr);
    s->set_layers(layers);
    EXPECT_LT(s->get("energy_residual"), 0.01);
  }
  EXPECT_EQ(s->step(600, nullptr).status, Status::kOk);
  EXPECT_LT(s->get("energy_residual"), 0.01);
}

TEST(Layers, AnyNumberOfThreadsGivesTheSameBits) {
  std::uint64_t hash[2];
  for (int threads : {1, 2}) {
    const auto s = compiled(with_berm(kSoil), threads);
    s->step(60, nullptr);
    s->set_layers(kOff);
    s->step(60, nullptr);
    s->set_layers(kOn);
    s->step(60, nullptr);
    hash[threads - 1] = s->state_hash();
  }
  EXPECT_EQ(hash[0], hash[1]);
}

TEST(Layers, AllOffIsRefusedAndLosesNothing) {
  const auto s = compiled(with_berm(kSoil));
  s->step(20, nullptr);
  const auto hash = s->state_hash();
  EXPECT_THROW(s->set_layers({false, false}), Error);
  EXPECT_EQ(s->state_hash(), hash);
  EXPECT_TRUE(s->layers().empty());
}

}  // namespace
}  // namespace vbgpd
