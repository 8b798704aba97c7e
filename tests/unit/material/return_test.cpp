// Every law of AnyLaw is held to the same sentences; a new law joins by being listed.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "material/any_law.h"
#include "material/cone.h"
#include "material/hexagon.h"

namespace vbgpd {
namespace {

Stress<Real> returned(const AnyLaw& law, const LawConstants& c, const Stress<Real>& s) {
  return algorithm_of(law) == ReturnAlgorithm::kCone ? return_to(Cone<Real>(c), s).stress
                                                     : return_to(Hexagon<Real>(c), s).stress;
}

struct PrincipalStress {
  Real major, middle, minor;
};
PrincipalStress principal(const Stress<Real>& s) {
  const Real half = (s.xx + s.yy) / 2, radius = std::hypot((s.xx - s.yy) / 2, s.xy);
  Real p[3] = {s.m + half + radius, s.m + half - radius, s.m + s.zz()};
  std::sort(std::begin(p), std::end(p));
  return {p[2], p[1], p[0]};
}

/// f / k of the law's own yield function; <= 0 inside.
Real yield(const AnyLaw& law, const LawConstants& c, const Stress<Real>& s) {
  if (!yields(law)) return -1;
  if (algorithm_of(law) == ReturnAlgorithm::kCone)
    return std::max((std::sqrt(s.j2()) + c.a * s.m - c.k), s.m - c.t) / c.shear_modulus;
  const PrincipalStress p = principal(s);
  return std::max(p.major - p.minor + (p.major + p.minor) * c.a - c.k, p.major - c.t) / c.shear_modulus;
}

template <class Law>
class EveryLaw : public testing::Test {
 public:
  /// Soils with and without dilatancy and cut-off, in a law's own terms.
  static std::vector<LawConstants> soils() {
    std::vector<LawConstants> out;
    for (Real phi : {0.0, 20.0, 45.0})
      for (Real psi : {0.0, phi / 2, phi})
        for (Real cutoff : {kInfinity, 2e3, 0.0}) {
          Strength s;
          s.cohesion = 1e4, s.friction_angle = radians(phi), s.dilatancy_angle = radians(psi),
          s.tension_cutoff = cutoff;
          if (std::is_same_v<Law, Undrained> && phi > 0) continue;
          out.push_back(derive(Law{}, 1e8, 0.3, s));
        }
    return out;
  }
  static std::vector<Stress<Real>> trials() {
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> u(-1, 1);
    std::vector<Stress<Real>> out;
    for (int n = 0; n < 400; ++n) {
      const Real size = std::pow(10.0, 3 + 2 * (u(random) + 1));
      out.push_back({size * u(random), size * u(random), size * u(random), size * u(random)});
    }
    out.push_back({0, 0, 0, 1e5}), out.push_back({0, 0, 0, -1e5}), out.push_back({0, 0, 0, 0}),
        out.push_back({0, 0, 5e4, 0});
    return out;
  }
};

template <class V>
struct Types;
template <class... L>
struct Types<std::variant<L...>> {
  using Listed = testing::Types<L...>;
};
TYPED_TEST_SUITE(EveryLaw, Types<AnyLaw>::Listed);

TYPED_TEST(EveryLaw, ReturnsToTheYieldSurface) {
  for (const LawConstants& c : this->soils())
    for (const auto& s : this->trials())
      EXPECT_LE(yield(TypeParam{}, c, returned(TypeParam{}, c, s)), 1e-12 + 1e-12 * 1e5 / c.shear_modulus);
}

TYPED_TEST(EveryLaw, LeavesAdmissibleStressUnchanged) {
  for (const LawConstants& c : this->soils())
    for (const auto& s : this->trials()) {
      if (yield(TypeParam{}, c, s) > 0) continue;
      const Stress<Real> r = returned(TypeParam{}, c, s);
      EXPECT_EQ(r.xx, s.xx);
      EXPECT_EQ(r.yy, s.yy);
      EXPECT_EQ(r.xy, s.xy);
      EXPECT_EQ(r.m, s.m);
    }
}

TYPED_TEST(EveryLaw, SecondReturnChangesNothing) {
  for (const LawConstants& c : this->soils())
    for (const auto& s : this->trials()) {
      const Stress<Real> once = returned(TypeParam{}, c, s), twice = returned(TypeParam{}, c, once);
      const Real scale = std::fabs(s.xx) + std::fabs(s.yy) + std::fabs(s.xy) + std::fabs(s.m) + 1;
      EXPECT_NEAR(twice.xx, once.xx, 1e-11 * scale);
      EXPECT_NEAR(twice.yy, once.yy, 1e-11 * scale);
      EXPECT_NEAR(twice.xy, once.xy, 1e-11 * scale);
      EXPECT_NEAR(twice.m, once.m, 1e-11 * scale);
    }
}

TYPED_TEST(EveryLaw, KeepsThePrincipalDirections) {
  for (const LawConstants& c : this->soils())
    for (const auto& s : this->trials()) {
      const Stress<Real> r = returned(TypeParam{}, c, s);
      // the deviator stays parallel to the in-plane axes: (rxx - ryy) sxy = rxy (sxx - syy)
      const Real scale = (s.xx - s.yy) * (s.xx - s.yy) + s.xy * s.xy + 1;
      EXPECT_NEAR(((r.xx - r.yy) * s.xy - r.xy * (s.xx - s.yy)) / scale, 0, 1e-10);
    }
}

TYPED_TEST(EveryLaw, NeverGainsEnergyByYielding) {
  // plastic work sigma : (sigma_trial - sigma) in the elastic norm is not negative for non-dilatant flow
  for (LawConstants c : this->soils()) {
    if (c.b > 0 || c.a > 0)
      continue;  // friction without dilatancy works against pressure, which the mean part below leaves out
    for (const auto& s : this->trials()) {
      const Stress<Real> r = returned(TypeParam{}, c, s);
      const Real dxx = s.xx - r.xx, dyy = s.yy - r.yy, dxy = s.xy - r.xy;
      const Real work = (r.xx * (2 * dxx + dyy) + r.yy * (2 * dyy + dxx) + 2 * r.xy * dxy) / (2 * c.shear_modulus) +
                        r.m * (s.m - r.m) / c.bulk_modulus;
      EXPECT_GE(work, -1e-9 * (s.j2() + s.m * s.m) / c.shear_modulus);
    }
  }
}

TYPED_TEST(EveryLaw, PacksReturnWhatScalarsReturn) {
  for (const LawConstants& c : this->soils()) {
    const auto trials = this->trials();
    for (std::size_t n = 0; n + kWidth <= trials.size(); n += kWidth) {
      Stress<Pack> s{};
      for (int l = 0; l < kWidth; ++l) {
        const auto& t = trials[n + static_cast<std::size_t>(l)];
        s.xx[l] = t.xx, s.yy[l] = t.yy, s.xy[l] = t.xy, s.m[l] = t.m;
      }
      const Stress<Pack> r = algorithm_of(AnyLaw(TypeParam{})) == ReturnAlgorithm::kCone
                                 ? return_to(Cone<Pack>(c), s).stress
                                 : return_to(Hexagon<Pack>(c), s).stress;
      for (int l = 0; l < kWidth; ++l) {
        const auto& t = trials[n + static_cast<std::size_t>(l)];
        const Stress<Real> one = returned(TypeParam{}, c, t);
        const Real scale = 1e-13 * (std::fabs(t.xx) + std::fabs(t.yy) + std::fabs(t.xy) + std::fabs(t.m) + 1);
        EXPECT_NEAR(r.xx[l], one.xx, scale);
        EXPECT_NEAR(r.yy[l], one.yy, scale);
        EXPECT_NEAR(r.xy[l], one.xy, scale);
        EXPECT_NEAR(r.m[l], one.m, scale);
      }
    }
  }
}

Strength soil(Real cohesion, Real phi, Real psi) {
  Strength s;
  s.cohesion = cohesion, s.friction_angle = radians(phi), s.dilatancy_angle = radians(psi);
  return s;
}

/// Strength of a law in plane-strain shear flow with dilatancy angle psi: radius of Mohr's circle at in-plane mean
/// stress `mean`, after so much straining with de_yy = -de_xx + volume that the stress no longer changes.
Real flowing_radius(const AnyLaw& law, const Strength& strength, Real confining) {
  const LawConstants c = derive(law, 1e8, 0.3, strength);
  Stress<Real> s{0, 0, 0, -confining};
  const Real sin_psi = std::sin(strength.dilatancy_angle);
  for (int n = 0; n < 20000;
       ++n) {  // e_xx - e_yy grows; volume follows the dilatancy angle; confinement is restored each step
    const Real shear = 1e-6, volume = sin_psi * 2 * shear;
    Stress<Real> t = s;
    t.xx += 2 * c.shear_modulus * (shear + volume / 2 - volume / 3),
        t.yy += 2 * c.shear_modulus * (-shear + volume / 2 - volume / 3);
    t.m += c.bulk_modulus * volume;
    s = returned(law, c, t);
    s.m -= s.m + (s.xx + s.yy) / 2 + confining;  // keep (sigma_xx + sigma_yy)/2 = -confining
  }
  return std::hypot((s.xx - s.yy) / 2, s.xy);
}

TEST(DruckerPrager, MatchesMohrCoulombInPlaneStrainFlowForAnyDilatancy) {
  for (Real phi : {10.0, 20.0, 35.0})
    for (Real psi : {0.0, phi / 2, phi}) {
      const Real confining = 1e5;
      const Real exact =
          1e4 * std::cos(radians(phi)) + confining * std::sin(radians(phi));  // Mohr-Coulomb in plane strain
      EXPECT_NEAR(flowing_radius(DruckerPrager{}, soil(1e4, phi, psi), confining), exact, 2e-3 * exact)
          << phi << " " << psi;
      EXPECT_NEAR(flowing_radius(MohrCoulomb{}, soil(1e4, phi, psi), confining), exact, 2e-3 * exact)
          << phi << " " << psi;
    }
}

TEST(DruckerPrager, ConstantsReproduceTheFourRowTable) {
  const Real phi = radians(20), c = 1e4, t = std::tan(phi), root = std::sqrt(9 + 12 * t * t);
  const LawConstants associated = derive(DruckerPrager{}, 1e8, 0.3, soil(c, 20, 20));
  EXPECT_NEAR(associated.a, 3 * t / root, 1e-14);      // row 1: alpha = tan phi / sqrt(9 + 12 tan^2 phi)
  EXPECT_NEAR(associated.k, 3 * c / root, 1e-10 * c);  // row 1: k = 3c / sqrt(9 + 12 tan^2 phi)
  EXPECT_NEAR(associated.b, 3 * t / root, 1e-14);      // alpha_psi, same form
  const LawConstants isochoric = derive(DruckerPrager{}, 1e8, 0.3, soil(c, 20, 0));
  EXPECT_NEAR(isochoric.a, std::sin(phi), 1e-14);  // row 3
  EXPECT_NEAR(isochoric.k, c * std::cos(phi), 1e-10 * c);
  EXPECT_EQ(isochoric.b, 0);
}

TEST(MohrCoulomb, UniaxialCompressionFailsAtTheClosedForm) {
  // 2 c cos(phi) / (1 - sin(phi)): c = 10, phi = 30 gives 34.641016
  const LawConstants c = derive(MohrCoulomb{}, 1e8, 0.3, soil(10, 30, 0));
  Stress<Real> s{0, 0, 0, 0};
  for (int n = 0; n < 4000; ++n) {  // shorten y, keep sigma_xx = 0 by letting x out
    Stress<Real> t = s;
    t.yy -= 2 * c.shear_modulus * 1e-9 * 2 / 3, t.xx += 2 * c.shear_modulus * 1e-9 / 3, t.m -= c.bulk_modulus * 1e-9;
    const Real over = t.xx + t.m, stiffness = c.bulk_modulus + 4 * c.shear_modulus / 3, out = -over / stiffness;
    t.xx += 2 * c.shear_modulus * out * 2 / 3, t.yy -= 2 * c.shear_modulus * out / 3, t.m += c.bulk_modulus * out;
    s = returned(MohrCoulomb{}, c, t);
  }
  EXPECT_NEAR(-(s.yy + s.m) + (s.xx + s.m) * 3.0, 34.641016,
              34.641016 * 1e-3);  // sigma_1 = N sigma_3 + UCS, N = tan^2(60) = 3
}

TEST(Undrained, CohesionIsTheRadiusOfMohrsCircle) {
  EXPECT_NEAR(flowing_radius(Undrained{}, soil(5e3, 0, 0), 1e5), 5e3, 1e-6 * 5e3);
}

TEST(StrengthReduction, DividesCohesionAndTangentOfFriction) {
  Strength s = soil(1e4, 30, 25);
  s.tension_cutoff = 3e3;
  const Strength r = reduced(s, 1.5);
  EXPECT_NEAR(r.cohesion, 1e4 / 1.5, 1e-9);
  EXPECT_NEAR(std::tan(r.friction_angle), std::tan(radians(30)) / 1.5, 1e-15);
  EXPECT_NEAR(r.tension_cutoff, 2e3, 1e-9);
  EXPECT_EQ(r.dilatancy_angle, r.friction_angle);  // 25 degrees would be above the reduced friction angle of 21
}

}  // namespace
}  // namespace vbgpd
