#include "scene/properties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace vbgpd {
namespace {

/// One default-constructed object of every kind.
SceneDef scene_of_defaults() {
  SceneDef scene;
  scene.materials.resize(1);
  scene.loads.resize(1);
  scene.boundaries.resize(1);
  return scene;
}

TEST(Properties, DefaultsAreThoseOfTheSceneDefinition) {
  const SceneDef scene = scene_of_defaults();
  for (const Property& p : properties()) {
    const double* value = find_property(scene, p.object, 0, p.name);
    ASSERT_NE(value, nullptr) << p.name;
    if (std::isnan(p.default_value)) EXPECT_TRUE(std::isnan(*value)) << p.name;
    else EXPECT_EQ(*value, p.default_value) << p.name;
  }
}

TEST(Properties, DefaultsLieInTheirRanges) {
  for (const Property& p : properties()) {
    EXPECT_LT(p.min_value, p.max_value) << p.name;
    if (std::isnan(p.default_value)) continue;
    EXPECT_TRUE(p.min_open ? p.default_value > p.min_value : p.default_value >= p.min_value) << p.name;
    EXPECT_TRUE(p.max_open ? p.default_value < p.max_value : p.default_value <= p.max_value) << p.name;
    EXPECT_FALSE(p.required) << p.name << " has a default, so it cannot be required";
  }
}

TEST(Properties, OfOneKindStandTogetherUnderDifferentNames) {
  std::set<ObjectKind> finished;
  std::set<std::pair<ObjectKind, std::string>> names;
  ObjectKind current = ObjectKind::kNone;
  for (const Property& p : properties()) {
    if (p.object != current) {
      EXPECT_TRUE(finished.insert(p.object).second) << p.name;
      current = p.object;
    }
    EXPECT_TRUE(names.emplace(p.object, p.name).second) << p.name;
    EXPECT_GT(std::string(p.unit).size(), 0u) << p.name;
    EXPECT_EQ(std::string(p.doc).back(), '.') << p.name;
  }
}

TEST(Properties, NameEveryNumberOfAScene) {
  // Every double of MaterialDef, LoadDef, BoundaryDef, SceneDef and StrengthReductionDef is a property.
  const auto count = [](ObjectKind kind) {
    std::size_t n = 0;
    for (const Property& p : properties()) n += p.object == kind;
    return n;
  };
  EXPECT_EQ(count(ObjectKind::kMaterial), 11u);
  EXPECT_EQ(count(ObjectKind::kLoad), sizeof(LoadDef) / sizeof(double));
  EXPECT_EQ(count(ObjectKind::kBoundary), 3u);
  EXPECT_EQ(count(ObjectKind::kProfile), 7 + sizeof(StrengthReductionDef) / sizeof(double));
}

TEST(FindProperty, PointsAtTheMemberOfThatName) {
  SceneDef scene = scene_of_defaults();
  scene.materials.resize(2);
  EXPECT_EQ(find_property(scene, ObjectKind::kMaterial, 1, "cohesion"), &scene.materials[1].cohesion);
  EXPECT_EQ(find_property(scene, ObjectKind::kLoad, 0, "pressure_end"), &scene.loads[0].pressure_end);
  EXPECT_EQ(find_property(scene, ObjectKind::kBoundary, 0, "vy"), &scene.boundaries[0].vy);
  EXPECT_EQ(find_property(scene, ObjectKind::kProfile, -1, "kh"), &scene.kh);
  EXPECT_EQ(find_property(scene, ObjectKind::kProfile, 77, "srf_tolerance"), &scene.strength_reduction.tolerance);
}

TEST(FindProperty, LeadsEachNameToANumberOfItsOwn) {
  SceneDef scene = scene_of_defaults();
  std::set<const double*> places;
  for (const Property& p : properties()) EXPECT_TRUE(places.insert(find_property(scene, p.object, 0, p.name)).second);
}

TEST(FindProperty, IsNullForUnknownNamesAndObjects) {
  const SceneDef scene = scene_of_defaults();
  EXPECT_EQ(find_property(scene, ObjectKind::kMaterial, 0, "spacing"), nullptr);
  EXPECT_EQ(find_property(scene, ObjectKind::kMaterial, 0, ""), nullptr);
  EXPECT_EQ(find_property(scene, ObjectKind::kMaterial, 1, "cohesion"), nullptr);
  EXPECT_EQ(find_property(scene, ObjectKind::kMaterial, -1, "cohesion"), nullptr);
  EXPECT_EQ(find_property(scene, ObjectKind::kLayer, 0, "cohesion"), nullptr);
}

}  // namespace
}  // namespace vbgpd
