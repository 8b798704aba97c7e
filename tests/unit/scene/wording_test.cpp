#include "scene/wording.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vbgpd {
namespace {

constexpr std::array<std::string_view, 4> kNames{"cohesion", "cohesion_gradient", "friction_angle", "law"};

TEST(NumberText, HasSixSignificantDigitsAndNoLocale) {
  EXPECT_EQ(number_text(0.5), "0.5");
  EXPECT_EQ(number_text(20000), "20000");
  EXPECT_EQ(number_text(1.0 / 3), "0.333333");
  EXPECT_EQ(number_text(-1e8), "-1e+08");
  EXPECT_EQ(number_text(std::nan("")), "nan");
}

TEST(EditDistance, CountsInsertedDeletedReplacedAndSwappedCharacters) {
  EXPECT_EQ(edit_distance("law", "law"), 0u);
  EXPECT_EQ(edit_distance("lw", "law"), 1u);
  EXPECT_EQ(edit_distance("lawn", "law"), 1u);
  EXPECT_EQ(edit_distance("lew", "law"), 1u);
  EXPECT_EQ(edit_distance("cohesoin", "cohesion"), 1u);
  EXPECT_EQ(edit_distance("", "law"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestName, FindsMisspeltAndShortenedNames) {
  EXPECT_EQ(nearest_name("cohesoin", kNames), "cohesion");
  EXPECT_EQ(nearest_name("friction", kNames), "friction_angle");
  EXPECT_EQ(nearest_name("lwa", kNames), "law");
}

TEST(NearestName, FindsNothingForAnotherWord) {
  EXPECT_EQ(nearest_name("porosity", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'c'), kNames), "");
}

}  // namespace
}  // namespace vbgpd
