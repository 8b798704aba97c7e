#include "analysis/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vbgpd {
namespace {

Level level(double spacing, double factor, double tolerance = 0.002) {
  Level l;
  l.spacing_x = l.spacing_y = spacing;
  l.factor_of_safety = factor;
  l.srf_stable = factor - tolerance / 2, l.srf_unstable = factor + tolerance / 2;
  l.sliding_area = 50;
  return l;
}

/// FS = 1.3 + 0.2 h^p on the given spacings.
std::vector<Level> exact(double order, std::initializer_list<double> spacings) {
  std::vector<Level> levels;
  for (double h : spacings) levels.push_back(level(h, 1.3 + 0.2 * std::pow(h, order)));
  return levels;
}

TEST(Ladder, OpenOneKeepsItsKeyLinesAndStartsAtTwiceTheSpacing) {
  double before = INFINITY;
  for (int n = 0; n < kOpenLadder; ++n) {
    const Grid g = open_ladder(n);
    const double spacing = g.spacing_factor * g.coarsening;
    EXPECT_LT(spacing, before);
    // the coarse cell that all of them divide is twice the scene's spacing
    EXPECT_NEAR(g.spacing_factor * g.multiple, 2, 1e-12) << n;
    before = spacing;
  }
  EXPECT_EQ(open_ladder(0).spacing_factor * open_ladder(0).coarsening, 2);
  EXPECT_EQ(open_ladder(1).spacing_factor, 1);
  EXPECT_NEAR(open_ladder(2).spacing_factor, 2. / 3, 1e-15);
  EXPECT_NEAR(open_ladder(3).spacing_factor, 1. / 2, 1e-15);
  EXPECT_NEAR(before, 1. / 32, 1e-15);
}

TEST(Ladder, ClosedOneEndsAtTheScenesSpacing) {
  for (int levels = 1; levels <= 5; ++levels) {
    const std::vector<Grid> grids = closed_ladder(levels);
    ASSERT_EQ(grids.size(), static_cast<std::size_t>(levels));
    EXPECT_EQ(grids.back().spacing_factor * grids.back().coarsening, 1);
    for (std::size_t k = 1; k < grids.size(); ++k)
      EXPECT_LT(grids[k].spacing_factor * grids[k].coarsening, grids[k - 1].spacing_factor * grids[k - 1].coarsening);
  }
}

TEST(Estimate, OfOneGridIsItsBracketAndKnowsNothingOfTheGrid) {
  const Estimate e = estimate(exact(1, {1}), {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_EQ(e.value, 1.5);
  EXPECT_NEAR(e.error, 0.001, 1e-12);
  EXPECT_FALSE(e.discretisation);
}

TEST(Estimate, OfTwoGridsRemovesAFirstOrderErrorAndDoubtsHalfOfIt) {
  const Estimate e = estimate(exact(1, {1, 0.5}), {});
  EXPECT_NEAR(e.value, 1.3, 1e-12);
  EXPECT_NEAR(e.error, 0.05 + 3 * 0.001, 1e-12);  // half of the 0.1 extrapolated, three half brackets
  EXPECT_TRUE(e.discretisation);
}

TEST(Estimate, OfTwoGridsThatRiseIsTheFinerAndReachesBack) {
  const std::vector<Level> rising{level(1, 1.15), level(0.5, 1.17)};
  const Estimate e = estimate(rising, {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_EQ(e.value, 1.17);
  EXPECT_NEAR(e.error, 0.02 + 3 * 0.001, 1e-12);
  EXPECT_NE(e.reason.find("reads higher"), std::string::npos) << e.reason;
  const std::vector<Level> within_brackets{level(1, 1.15), level(0.5, 1.1515)};
  EXPECT_NEAR(estimate(within_brackets, {}).value, 1.153, 1e-12);
  const std::vector<Level> checked{level(1, 1.11), level(0.5, 1.15), level(0.25, 1.17)};  // at first order indeed
  EXPECT_NEAR(estimate(checked, {}).value, 1.19, 1e-12);
}

TEST(Estimate, OfGridsThatAgreeIsNoBetterThanTheirSpacing) {
  SectionFacts section;
  section.height = 10;
  const std::vector<Level> agreeing{level(1, 1.5), level(0.5, 1.5)};
  EXPECT_NEAR(estimate(agreeing, section).error, 0.015 + 3 * 0.001, 1e-12);  // 1 % at H/20
  const std::vector<Level> finer{level(0.5, 1.5), level(0.25, 1.5)};
  EXPECT_NEAR(estimate(finer, section).error, 0.0075 + 3 * 0.001, 1e-12);
  EXPECT_EQ(estimate(exact(1, {1, 0.5}), section).error, estimate(exact(1, {1, 0.5}), {}).error);
  section.height = 0;  // level ground
  EXPECT_NEAR(estimate(agreeing, section).error, 3 * 0.001, 1e-12);
}

TEST(Estimate, OfTwoGridsAFifthApartIsRefused) {
  const std::vector<Level> apart{level(1, 1.3), level(0.5, 0.96)};
  const Estimate e = estimate(apart, {});
  EXPECT_EQ(e.status, "TOO_COARSE") << e.reason;
  EXPECT_EQ(e.value, 0.96);
  EXPECT_GE(e.error, 1.3 - 0.96);
  const std::vector<Level> near{level(1, 1.15), level(0.5, 0.97)};
  EXPECT_EQ(estimate(near, {}).status, "OK");
}

TEST(Estimate, WhereTensionIsCutOffReachesBeyondTheCoarseGrid) {
  SectionFacts section;
  section.cut_off = true;
  const Estimate e = estimate(exact(1, {1, 0.5}), section);
  EXPECT_NEAR(e.value, 1.3, 1e-12);
  EXPECT_NEAR(e.error, 1.5 * 0.1 + 3 * 0.001, 1e-12);
  EXPECT_NE(e.reason.find("tension cut-off"), std::string::npos) << e.reason;
}

TEST(Estimate, OfThreeGridsFindsTheOrderAndIsTheTighter) {
  const auto levels = exact(1, {1, 0.5, 0.25});
  const Estimate e = estimate(levels, {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_NEAR(e.value, 1.3, 1e-12);
  EXPECT_NEAR(e.observed_order, 1, 1e-9);
  EXPECT_NEAR(e.error, 3 * 0.001, 1e-9);
}

TEST(Estimate, OfThreeGridsCoversAnOrderThatIsNotOne) {
  for (double order : {0.8, 1.2}) {
    const Estimate e = estimate(exact(order, {1, 0.5, 0.25}), {});
    EXPECT_EQ(e.status, "OK") << order;
    EXPECT_NEAR(e.observed_order, order, 1e-6);
    EXPECT_LE(std::fabs(e.value - 1.3), e.error) << order;
  }
}

TEST(Estimate, FindsTheOrderOnTheGridBetweenToo) {
  const Estimate e = estimate(exact(1, {1, std::sqrt(0.5), 0.5}), {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_NEAR(e.observed_order, 1, 1e-9);
  EXPECT_NEAR(e.value, 1.3, 1e-12);
}

TEST(Estimate, ExtrapolatesOverAThirdOfTheSpacingToo) {
  const Estimate e = estimate(exact(1, {2, 1, 2. / 3}), {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_NEAR(e.value, 1.3, 1e-12);
}

TEST(Estimate, OfTwoGridsNotTwiceApartIsExtrapolatedAsWell) {
  const Estimate e = estimate(exact(1, {1, 2. / 3}), {});
  EXPECT_NEAR(e.value, 1.3, 1e-12);
  EXPECT_TRUE(e.discretisation);
  // half of the 0.2 * 2 / 3 extrapolated; the brackets enter magnified by 1 / (1.5 - 1)
  EXPECT_NEAR(e.error, 0.2 / 3 + (3 + 2) * 0.001, 1e-12);
}

TEST(Estimate, IsNotExtrapolatedWhereTheOrderIsNotOne) {
  const Estimate e = estimate(exact(3, {1, 0.5, 0.25}), {});
  EXPECT_EQ(e.status, "NOT_FIRST_ORDER");
  EXPECT_EQ(e.value, exact(3, {0.25})[0].factor_of_safety);
  EXPECT_LE(std::fabs(e.value - 1.3), e.error);
}

TEST(Estimate, SaysWhenTheGridsGoUpAndDown) {
  const std::vector<Level> levels = {level(1, 1.40), level(0.5, 1.45), level(0.25, 1.42)};
  const Estimate e = estimate(levels, {});
  EXPECT_EQ(e.status, "NOT_MONOTONIC");
  EXPECT_EQ(e.value, 1.42);
  EXPECT_GE(e.error, 0.05);
}

TEST(Estimate, DoesNotJudgeDifferencesSmallerThanTheBrackets) {
  const std::vector<Level> levels = {level(1, 1.400), level(0.5, 1.4015), level(0.25, 1.400)};
  const Estimate e = estimate(levels, {});
  EXPECT_EQ(e.status, "OK");
  EXPECT_TRUE(std::isnan(e.observed_order));
  EXPECT_GE(e.error, 0.001);
}

TEST(Estimate, IsNeverLessThanHalfTheBracket) {
  const std::vector<Level> levels = {level(1, 1.3, 0.01), level(0.5, 1.3, 0.01), level(0.25, 1.3, 0.01)};
  EXPECT_GE(estimate(levels, {}).error, 0.005);
}

TEST(Estimate, SaysWhichLayerIsThinnerThanTwoSpacings) {
  const auto levels = exact(1, {1, 0.5});
  const Estimate thin = estimate(levels, {"weak band", 0.9});
  EXPECT_EQ(thin.status, "THIN_LAYER");
  EXPECT_EQ(thin.value, levels.back().factor_of_safety);
  EXPECT_NE(thin.reason.find("'weak band' is 0.9 m thick, only 1.8 spacings"), std::string::npos) << thin.reason;
  EXPECT_TRUE(std::isnan(thin.error)) << "grids that do not see a layer say nothing of what it does";
  EXPECT_EQ(estimate(levels, {"weak band", 1.0}).status, "OK");
}

TEST(Estimate, ExtrapolatesNoSkinThatIsAsThinAsTheGridAllows) {
  auto levels = exact(1, {1, 0.5});
  const Estimate thick = estimate(levels, {});
  levels[0].sliding_thickness = 1.3, levels[1].sliding_thickness = 1.2;  // thin, but of the same thickness
  EXPECT_EQ(estimate(levels, {}).status, "OK");
  EXPECT_EQ(estimate(levels, {}).value, thick.value);
  levels[0].sliding_thickness = 2.4, levels[1].sliding_thickness = 1.31;  // 2.6 spacings are seen
  EXPECT_EQ(estimate(levels, {}).status, "OK");
  levels[0].sliding_thickness = 1.6, levels[1].sliding_thickness = 0.8;
  const Estimate thin = estimate(levels, {});
  EXPECT_EQ(thin.status, "THIN_SLIDE");
  EXPECT_EQ(thin.value, levels.back().factor_of_safety);
  EXPECT_GE(thin.error, 1.5 * (levels.back().factor_of_safety - thick.value));
  EXPECT_NE(thin.reason.find("the sliding mass is 1.6 m thick, then 0.8 m, only 1.6 spacings"), std::string::npos)
      << thin.reason;
  const Estimate one = estimate({&levels[1], 1}, {});  // one grid cannot tell whether it gets thinner
  EXPECT_EQ(one.status, "OK");
  EXPECT_NE(one.reason.find("the sliding mass is only 1.6 spacings thick"), std::string::npos) << one.reason;
}

TEST(Estimate, OfASkinIsThatOfASkinHoweverManyGrids) {
  std::vector<Level> levels = {level(1, 1.4), level(0.5, 1.5), level(0.25, 1.4)};
  EXPECT_EQ(estimate(levels, {}).status, "NOT_MONOTONIC");
  for (Level& l : levels) l.sliding_thickness = 1.6 * l.spacing_x;
  const Estimate thin = estimate(levels, {});
  EXPECT_EQ(thin.status, "THIN_SLIDE") << thin.reason;
  EXPECT_EQ(thin.value, levels.back().factor_of_safety);
}

TEST(Estimate, IsTheMiddleOfAllOrdersWhereTheCoarserGridMissesALayer) {
  const auto levels = exact(1, {1, 0.5});
  const Estimate first = estimate(levels, {}), open = estimate(levels, {"weak band", 1.2});
  const double fine = levels.back().factor_of_safety;
  EXPECT_EQ(open.status, "OK");
  EXPECT_NEAR(open.value, (fine + first.value) / 2, 1e-12);
  const double difference = fine - first.value;  // the estimate reaches half as far beyond either limit
  EXPECT_LT(open.value - open.error, first.value - difference / 2);
  EXPECT_GT(open.value + open.error, fine + difference / 2);
  EXPECT_NEAR(open.error, difference + (first.error - difference / 2), 1e-12);
  EXPECT_NE(open.reason.find("'weak band'"), std::string::npos) << open.reason;
  EXPECT_EQ(estimate(levels, {"weak band", 2.6}).value, first.value);  // the support radius of the coarser grid
}

TEST(Estimate, OfTwoGridsThatRiseIsTheFinerWhateverLayersTheyMiss) {
  const std::vector<Level> rising{level(1, 1.15), level(0.5, 1.17)};
  const Estimate plain = estimate(rising, {}), layered = estimate(rising, {"weak band", 1.2});
  EXPECT_EQ(layered.value, 1.17);
  EXPECT_EQ(layered.error, plain.error);
  EXPECT_EQ(layered.reason, plain.reason);
}

TEST(Estimate, DoesNotTrustAFlowWhoseBooksDoNotClose) {
  auto levels = exact(1, {1, 0.5});
  levels.back().energy_residual = 0.009;
  EXPECT_EQ(estimate(levels, {}).status, "OK");
  levels.back().energy_residual = 0.19;
  const Estimate e = estimate(levels, {});
  EXPECT_EQ(e.status, "ENERGY_UNBALANCED");
  EXPECT_EQ(e.value, levels.back().factor_of_safety);
  EXPECT_NEAR(e.error, 0.19 * e.value, 1e-12);
  EXPECT_NE(e.reason.find("residual 0.19"), std::string::npos) << e.reason;
}

TEST(Estimate, IsWidenedByWhatAJerkyFlowStrays) {
  auto levels = exact(1, {1, 0.5});
  const Estimate steady = estimate(levels, {}), one = estimate({&levels[1], 1}, {});
  levels[1].unsteadiness = 0.02;
  EXPECT_NEAR(estimate(levels, {}).error, steady.error + 0.02, 1e-12);
  EXPECT_NEAR(estimate({&levels[1], 1}, {}).error, one.error + 0.02, 1e-12);
  EXPECT_EQ(estimate(levels, {}).value, steady.value);
}

TEST(Estimate, IsWidenedWhereTheMechanismChanges) {
  auto levels = exact(1, {1, 0.5});
  const double error = estimate(levels, {}).error;
  levels[0].sliding_area = 80;
  const Estimate e = estimate(levels, {});
  EXPECT_NEAR(e.error, error + 0.05, 1e-12);
  EXPECT_NE(e.reason.find("mechanism changes"), std::string::npos);
}

TEST(Prediction, GrowsWithTheCubeOfTheRefinementOrAsSeen) {
  std::vector<Level> levels = exact(1, {1});
  levels[0].wall_seconds = 2;
  EXPECT_NEAR(predicted_seconds(levels, 0.5), 16, 1e-12);
  levels.push_back(level(0.5, 1.4));
  levels[1].wall_seconds = 2 * std::pow(2, 3.5);
  EXPECT_NEAR(predicted_seconds(levels, 0.25), levels[1].wall_seconds * std::pow(2, 3.5), 1e-9);
  levels[1].wall_seconds = 3;  // cheaper than the cube: not believed
  EXPECT_NEAR(predicted_seconds(levels, 0.25), 24, 1e-12);
}

}  // namespace
}  // namespace vbgpd
