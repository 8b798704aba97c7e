// Readings of made-up flows: what is told from rest, creep and hardening.
#include "analysis/flow_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace vbgpd {
namespace {

constexpr std::int64_t kResponse = 200;  // steps: a look of one response time spans twenty windows
constexpr double kElastic = 0.01;
const TrialRules kRules;
const Look kBrief{1, kRules.growth, kRules.catching_up};

/// Steady: R on a plateau, 0.1 of the elastic displacement in a response time and ever so little more, internal power
/// 1 % short.
Window steady(int n) {
  const double times = static_cast<double>(n * kWindow) / kResponse;
  return {1e-3, kElastic * (1 + 0.1 * times + 1e-6 * times * times), 5.0, 0.99};
}

std::vector<Window> flow_of(const std::function<Window(int)>& window, int count = 60) {
  std::vector<Window> out;
  for (int n = 0; n < count; ++n) out.push_back(window(n));
  return out;
}

Flow seen(const std::vector<Window>& history, const Look& look = kBrief) {
  return flow_in(history, look, kRules, kResponse, kElastic).value();
}

TEST(FlowLook, SeesNothingBeforeTheLookIsFull) {
  EXPECT_FALSE(flow_in(flow_of(steady, 20), kBrief, kRules, kResponse, kElastic));
  EXPECT_TRUE(flow_in(flow_of(steady, 21), kBrief, kRules, kResponse, kElastic));
  EXPECT_FALSE(flow_in(flow_of(steady, 60), {3, kRules.growth, kRules.catching_up}, kRules, kResponse, kElastic));
}

TEST(FlowLook, SteadyFlowFails) {
  const Flow flow = seen(flow_of(steady));
  EXPECT_TRUE(flow.fails);
  EXPECT_NEAR(flow.slope, 0, 1e-12);
  EXPECT_NEAR(flow.growth, 0.1, 1e-5);
  EXPECT_NEAR(flow.unsteadiness, 0, 1e-12);
}

TEST(FlowLook, WhatComesToRestDoesNotFail) {
  const auto dying = [](int n) {
    Window w = steady(n);
    w.ratio *= std::exp(-0.2 * n * kWindow / kResponse);  // a fifth of e in a response time
    return w;
  };
  EXPECT_FALSE(seen(flow_of(dying)).fails);
  EXPECT_NEAR(seen(flow_of(dying)).slope, -0.2, 1e-9);
  const auto slowing = [](int n) {
    Window w = steady(n);
    w.displacement = kElastic * (1 + std::sqrt(n));
    return w;
  };
  EXPECT_FALSE(seen(flow_of(slowing)).fails);
  const auto all_but_still = [](int n) {
    Window w = steady(n);
    w.ratio = 2 * kRules.equilibrium;
    return w;
  };
  EXPECT_FALSE(seen(flow_of(all_but_still)).fails);
}

TEST(FlowLook, WhatHardensTowardsTheFactorDoesNotFail) {
  const auto hardening = [](double per_response_time) {
    return [=](int n) {
      Window w = steady(n);
      w.power_ratio =
          0.99 + per_response_time * (n - 54.5) * kWindow / kResponse;  // 0.99 in the middle of the later half
      return w;
    };
  };
  EXPECT_TRUE(seen(flow_of(hardening(0.001))).fails);    // 1 % short, eight response times make up 0.8 %
  EXPECT_FALSE(seen(flow_of(hardening(0.0015))).fails);  // ... and here 1.2 %
  EXPECT_NEAR(seen(flow_of(hardening(0.0015))).unsteadiness, 0, 1e-3);
}

TEST(FlowLook, FarFlowNeedNotLastButMustFlow) {
  const Look far{1, kRules.growth, kRules.catching_up, true};
  const auto fails = [&](void (*change)(int, Window&)) {
    return seen(flow_of([&](int n) {
                  Window w = steady(n);
                  change(n, w);
                  return w;
                }),
                far)
        .fails;
  };
  EXPECT_TRUE(fails([](int n, Window& w) { w.ratio *= std::exp(-0.2 * n * kWindow / kResponse); }));  // dying
  EXPECT_TRUE(fails([](int n, Window& w) { w.displacement = kElastic * (1 + std::sqrt(n)); }));       // slowing down
  EXPECT_TRUE(fails([](int n, Window& w) { w.power_ratio = 0.99 + 0.0015 * (n - 54.5) * kWindow / kResponse; }));
  EXPECT_FALSE(fails([](int, Window& w) { w.ratio = 2 * kRules.equilibrium; }));  // all but at rest
  EXPECT_FALSE(fails([](int, Window& w) { w.displacement = kElastic; }));         // does not move
  EXPECT_FALSE(fails([](int, Window& w) { w.power_ratio = 1.001; }));             // would be held
}

TEST(FlowLook, WhatIsReadAsTheMomentumRestartsCountsForNothing) {
  const auto restarting = [](int n) {
    Window w = steady(n);
    if (n == 50) w.external_power = 1e-4, w.power_ratio = -0.8;
    return w;
  };
  const Flow flow = seen(flow_of(restarting));
  EXPECT_TRUE(flow.fails);
  EXPECT_LT(flow.unsteadiness, 0.003);
}

TEST(FlowLook, JerkyFlowStraysByWhatItsPowerRatioDoes) {
  const auto jerky = [](int n) {
    Window w = steady(n);
    w.power_ratio += n % 2 == 0 ? 0.004 : -0.004;
    return w;
  };
  EXPECT_NEAR(seen(flow_of(jerky)).unsteadiness, 0.004, 2e-4);
}

/// F_e rises with the logarithm of what the slope has moved, `times` its elastic displacement in the end.
std::vector<Window> hardening_flow(double rise, double times, double tremble = 0) {
  return flow_of(
      [=](int n) {
        Window w = steady(n);
        const double moved = times * (n + 1) / 100.0;
        w.displacement = kElastic * (1 + moved);
        w.power_ratio = 0.99 + rise * std::log(moved / times) + (n % 2 == 0 ? tremble : -tremble);
        return w;
      },
      100);
}

TEST(Hardening, ReadsWhatALogarithmOfTheDisplacementWillRiseBy) {
  for (const double times : {0.01, 1.0, 1000.0}) {  // however far that is
    const Hardening seen = hardening_in(hardening_flow(0.004, times)).value();
    EXPECT_NEAR(seen.power_ratio + seen.rise, 0.99 + 0.004 * std::log(2), 1e-4) << times;
  }
}

TEST(Hardening, SeesNoneInASteadyFlowThatTrembles) {
  const Hardening seen = hardening_in(hardening_flow(0, 3, 0.001)).value();
  EXPECT_NEAR(seen.power_ratio, 0.99, 1e-4);
  EXPECT_NEAR(seen.rise, 0, 2e-4);
}

TEST(Hardening, IsReadOfTheFlowNotOfTheHaltsInBetween) {
  std::vector<Window> jerky = hardening_flow(0.004, 1);
  for (std::size_t k = 4; k < jerky.size(); k += 5) jerky[k].external_power = 1e-9, jerky[k].power_ratio = 2;
  const Hardening seen = hardening_in(jerky).value();
  EXPECT_NEAR(seen.power_ratio + seen.rise, 0.99 + 0.004 * std::log(2), 2e-4);
}

TEST(Hardening, IsNegativeInSoilThatSoftens) {
  EXPECT_LT(hardening_in(hardening_flow(-0.004, 1)).value().rise, -0.002);
}

TEST(Hardening, HasNothingToReadWhereNothingMoves) {
  const auto still = [](int n) {
    Window w = steady(n);
    w.displacement = kElastic;
    return w;
  };
  EXPECT_FALSE(hardening_in(flow_of(still)));
  const auto back = [](int n) {
    Window w = steady(n);
    w.displacement = kElastic * (1 - 0.001 * n);
    return w;
  };
  EXPECT_FALSE(hardening_in(flow_of(back)));
  EXPECT_FALSE(hardening_in(flow_of(steady, 1)));
}

}  // namespace
}  // namespace vbgpd
