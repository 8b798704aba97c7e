// Axial compression of a soil sample between a fixed base and a platen moved from outside: peak strength, shear bands,
// and what they are without bonds. Small sister of tests/validation/rivals.
#include <gtest/gtest.h>

#include <algorithm>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

constexpr double kSpeed = 0.02, kShortening = 0.08;  // m/s, m

SceneDef sample(const std::string& bond) {
  SceneDef s = block(soil("mohr_coulomb", 10e3, 20), 1, 2.25, 1.0 / 12);
  MaterialDef& soil = s.materials[0];
  soil.unit_weight = 2000 * 9.81, soil.young_modulus = 1e7, soil.tension_cutoff = 20e3;
  MaterialDef platen = soil;  // heavy, so that what pushes it back in one step is small against its speed
  platen.name = "platen", platen.law = "elastic", platen.unit_weight *= 20;
  s.materials.push_back(platen);
  s.layers.push_back({platen.name, {{0, 2}, {1, 2}, {1, 2.25}, {0, 2.25}}});
  s.boundaries.resize(1);  // the base
  s.kv = -1 + 1e-12;
  s.bond = bond;
  return s;
}

struct Curve {
  double peak, end;  ///< mean axial stress at mid-height over the uniaxial strength
  double band;       ///< degrees from the horizontal
  double plastic;    ///< largest plastic strain
};

/// Direction from the middle of the sample in which most plastic strain lies.
double band_of(const std::vector<double>& x, const std::vector<double>& strain, double spacing) {
  double most = 0, angle = 0;
  for (double degrees = 30; degrees <= 75; degrees += 1)
    for (const double lean : {1.0, -1.0})
      for (double height = 0.5; height <= 1.5; height += spacing / 2) {
        const Vec2 normal(-lean * std::sin(radians(degrees)), std::cos(radians(degrees)));
        double sum = 0;
        for (std::size_t i = 0; i < strain.size(); ++i)
          if (std::fabs((Vec2(x[2 * i], x[2 * i + 1]) - Vec2(0.5, height)).dot(normal)) < spacing) sum += strain[i];
        if (sum > most) most = sum, angle = degrees;
      }
  return angle;
}

Curve compress(const std::string& bond) {
  const auto simulation = runout(sample(bond));
  FlowSimulation& s = *simulation;
  s.set("damping", 0.5);
  const std::vector<double> at = field(s, "reference_position");
  const auto particles = static_cast<std::size_t>(s.particle_count());
  std::vector<double> velocity(2 * particles, 0.0);
  for (std::size_t i = 0; i < particles; ++i) velocity[2 * i + 1] = -kSpeed * std::min(at[2 * i + 1], 2.0) / 2;
  const int write = find_field("velocity");
  s.write(write, velocity);
  const double strength = 2 * 10e3 * std::cos(radians(20)) / (1 - std::sin(radians(20)));
  Curve curve{};
  while (s.get("time") < kShortening / kSpeed) {
    s.step(1, nullptr);
    s.read(write, velocity);
    for (std::size_t i = 0; i < particles; ++i)
      if (at[2 * i + 1] > 2) velocity[2 * i] = 0, velocity[2 * i + 1] = -kSpeed;
    s.write(write, velocity);
    const std::vector<double> stress = field(s, "stress");
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < particles; ++i)
      if (std::fabs(at[2 * i + 1] - 1) < 0.25) sum -= stress[4 * i + 1], ++count;
    curve.end = sum / count / strength;
    curve.peak = std::max(curve.peak, curve.end);
  }
  std::vector<double> strain = field(s, "plastic_strain");
  curve.plastic = *std::max_element(strain.begin(), strain.end());
  curve.band = band_of(field(s, "position"), strain, 1.0 / 12);
  return curve;
}

TEST(RunoutCompression, PeaksAtTheUniaxialStrengthAndShearsInBandsThatHold) {
  const Curve curve = compress("virtual_bond");
  EXPECT_NEAR(curve.peak, 1, 0.02);
  EXPECT_GT(curve.end, 0.9);
  EXPECT_GT(curve.plastic, 0.1);
  EXPECT_GE(curve.band, 40);  // between Roscoe's 45 and Coulomb's 55 degrees, to a spacing over the width
  EXPECT_LE(curve.band, 60);
}

TEST(RunoutCompression, BreaksAlongItsBandsWithoutBonds) {
  const Curve curve = compress("none");
  EXPECT_NEAR(curve.peak, 1, 0.02);
  EXPECT_LT(curve.end, 0.8);
}

}  // namespace
}  // namespace vbgpd::test
