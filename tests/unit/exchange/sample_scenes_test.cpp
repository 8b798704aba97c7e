// Every scene file of samples/scenes is read and found good.
#include <gtest/gtest.h>

#include <cmath>

#include "sample_scene.h"
#include "scene/validate.h"
#include "scene_fixture.h"

namespace vbgpd {
namespace {

const std::filesystem::path kFolder = VBGPD_SCENES_DIR;

class SampleScene : public testing::TestWithParam<std::string> {};

TEST_P(SampleScene, HasNoErrorsAndNoWarnings) {
  for (const Issue& issue : validate(sample_scene(GetParam()))) ADD_FAILURE() << issue.text;
}

TEST_P(SampleScene, CarriesTitleSourceAndPublishedValues) {
  const SceneDef scene = sample_scene(GetParam());
  EXPECT_FALSE(scene.name.empty());
  EXPECT_FALSE(scene.source.empty());
  EXPECT_FALSE(scene.published.empty());
  for (const PublishedValue& value : scene.published) {
    EXPECT_FALSE(value.method.empty());
    EXPECT_FALSE(value.source.empty());
    EXPECT_GT(value.factor_of_safety, 0.4);
    EXPECT_LT(value.factor_of_safety, 3);
    if (!std::isnan(value.factor_of_safety_end)) {
      EXPECT_GE(value.factor_of_safety_end, value.factor_of_safety);
    }
  }
}

TEST_P(SampleScene, StandsInTheTableOfTheFolder) {
  EXPECT_NE(file_text(kFolder / "README.md").find("| `" + GetParam() + "` |"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Folder, SampleScene, testing::ValuesIn(scene_names(kFolder)),
                         [](const auto& name) { return name.param; });

TEST(SampleScenes, PushTheSeismicSlopeTowardsItsToe) {
  const SceneDef scene = sample_scene("acads_1d");  // crest on the right
  EXPECT_EQ(scene.kh, -0.15);
}

TEST(SampleScenes, LoadThePrandtlStripWithTheExactBearingCapacity) {
  const SceneDef scene = sample_scene("prandtl_strip");
  EXPECT_NEAR(scene.loads.at(0).pressure / scene.materials.at(0).cohesion, 2 + std::acos(-1), 1e-6);
  EXPECT_NEAR(scene.loads.at(0).x0 + scene.loads.at(0).x1, scene.exterior.at(1).x,
              1e-12);  // in the middle of the block
}

TEST(SampleScenes, GiveTheVerticalCutItsStabilityNumber) {
  const SceneDef scene = sample_scene("vertical_cut");
  const MaterialDef& clay = scene.materials.at(0);
  EXPECT_NEAR(clay.unit_weight * 10 / clay.cohesion, 3.776, 1e-6);
}

}  // namespace
}  // namespace vbgpd
