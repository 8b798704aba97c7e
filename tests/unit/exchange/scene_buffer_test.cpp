#include "exchange/scene_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "scene/properties.h"
#include "scene/validate.h"
#include "scene_fixture.h"

namespace vbgpd {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void expect_same(const Polygon& a, const Polygon& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same(a[i].x, b[i].x) && same(a[i].y, b[i].y)) << "point " << i;
}

void expect_same(const SceneDef& a, const SceneDef& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.bond, b.bond);
  EXPECT_EQ(a.kernel, b.kernel);
  expect_same(a.exterior, b.exterior);
  expect_same(a.water_table, b.water_table);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  ASSERT_EQ(a.layers.size(), b.layers.size());
  ASSERT_EQ(a.boundaries.size(), b.boundaries.size());
  ASSERT_EQ(a.loads.size(), b.loads.size());
  ASSERT_EQ(a.published.size(), b.published.size());
  for (const Property& p : properties())
    for (std::int64_t id = 0;; ++id) {
      const double *left = find_property(a, p.object, id, p.name), *right = find_property(b, p.object, id, p.name);
      if (!left) break;
      EXPECT_TRUE(same(*left, *right)) << p.name << " of " << id << ": " << *left << " and " << *right;
      if (p.object == ObjectKind::kProfile) break;
    }
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    EXPECT_EQ(a.materials[i].name, b.materials[i].name);
    EXPECT_EQ(a.materials[i].law, b.materials[i].law);
  }
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].material, b.layers[i].material);
    expect_same(a.layers[i].polygon, b.layers[i].polygon);
  }
  for (std::size_t i = 0; i < a.boundaries.size(); ++i) {
    EXPECT_EQ(a.boundaries[i].name, b.boundaries[i].name);
    EXPECT_EQ(a.boundaries[i].side, b.boundaries[i].side);
    EXPECT_EQ(a.boundaries[i].kind, b.boundaries[i].kind);
    expect_same(a.boundaries[i].polyline, b.boundaries[i].polyline);
  }
  for (std::size_t i = 0; i < a.published.size(); ++i) {
    EXPECT_EQ(a.published[i].method, b.published[i].method);
    EXPECT_EQ(a.published[i].source, b.published[i].source);
    EXPECT_TRUE(same(a.published[i].factor_of_safety, b.published[i].factor_of_safety));
    EXPECT_TRUE(same(a.published[i].factor_of_safety_end, b.published[i].factor_of_safety_end));
  }
}

/// What reading says, or "" when it returns a scene.
std::string refusal(std::span<const std::uint8_t> bytes) {
  try {
    validate(scene_from_flatbuffer(bytes));
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.issue().status, Status::kFormat);
    return error.what();
  }
}

SceneDef small_scene() {
  SceneDef scene;
  scene.exterior = {{0, 0}, {1, 0}, {0, 1}};
  scene.materials.resize(1);
  scene.materials[0].name = "s";
  scene.layers = {{"s", {}}};
  scene.boundaries.resize(1);
  scene.boundaries[0].side = "base";
  scene.loads = {{0, 1, 2, 3}};
  return scene;
}

TEST(SceneBuffer, ReturnsTheSceneThatWasWritten) {
  expect_same(full_scene(), scene_from_flatbuffer(scene_to_flatbuffer(full_scene())));
}

/// A number that neither the writer nor the reader knows would come back as its default.
TEST(SceneBuffer, KeepsEveryNumberOfAScene) {
  SceneDef scene = full_scene();
  double value = 0.125;
  for (const Property& p : properties()) *find_property(scene, p.object, 0, p.name) = value += 1;
  expect_same(scene, scene_from_flatbuffer(scene_to_flatbuffer(scene)));
}

TEST(SceneBuffer, ReturnsDefaultsAsDefaults) {
  expect_same(SceneDef{}, scene_from_flatbuffer(scene_to_flatbuffer(SceneDef{})));
}

TEST(SceneBuffer, KeepsNumbersThatAreNotFiniteForValidationToRefuse) {
  for (const Property& p : properties()) {
    SceneDef scene = full_scene();
    *find_property(scene, p.object, 0, p.name) = kNone;
    expect_same(scene, scene_from_flatbuffer(scene_to_flatbuffer(scene)));
  }
}

TEST(SceneBuffer, WritesTheSameBytesEachTime) {
  EXPECT_EQ(scene_to_flatbuffer(full_scene()), scene_to_flatbuffer(full_scene()));
}

TEST(SceneBuffer, CarriesItsIdentifier) {
  const auto bytes = scene_to_flatbuffer(full_scene());
  EXPECT_EQ(std::memcmp(bytes.data() + 4, "VBGP", 4), 0);
}

TEST(SceneBuffer, MayLieAtAnyAddress) {
  const auto bytes = scene_to_flatbuffer(full_scene());
  std::vector<std::uint8_t> shifted(bytes.size() + 1);
  std::copy(bytes.begin(), bytes.end(), shifted.begin() + 1);
  expect_same(full_scene(), scene_from_flatbuffer(std::span(shifted).subspan(1)));
}

TEST(SceneBuffer, RefusesWhatIsNoSceneAndSaysSo) {
  EXPECT_EQ(refusal({}), "the scene buffer is empty");
  const std::string json = "{\"units\": \"SI\"}";
  const auto* text = reinterpret_cast<const std::uint8_t*>(json.data());
  EXPECT_NE(refusal({text, json.size()}).find("is not a scene"), std::string::npos);
  EXPECT_NE(refusal(std::vector<std::uint8_t>((64 << 20) + 1)).find("at most 67108864"), std::string::npos);
}

TEST(SceneBuffer, RefusesTooLongNamesAndControlCharacters) {
  SceneDef scene = small_scene();
  scene.materials[0].name = std::string(70000, 'x');
  EXPECT_EQ(refusal(scene_to_flatbuffer(scene)),
            "materials[0].name has 70000 bytes of text: at most 65536 are accepted");
  scene = small_scene();
  scene.boundaries[0].name = "wall\x1B[2J";
  EXPECT_EQ(refusal(scene_to_flatbuffer(scene)), "boundaries[0].name holds control characters: names are plain text");
}

TEST(SceneBuffer, RefusesTooManyObjects) {
  SceneDef scene = small_scene();
  scene.loads.resize(100001);
  EXPECT_EQ(refusal(scene_to_flatbuffer(scene)), "loads has 100001 entries: at most 100000 are accepted");
  scene = small_scene();
  scene.exterior.resize(1000001);
  EXPECT_EQ(refusal(scene_to_flatbuffer(scene)), "profile.exterior has 1000001 points: at most 1000000 are accepted");
}

TEST(SceneBuffer, CutShortAnywhereIsRefusedOrReadNeverMore) {
  const auto bytes = scene_to_flatbuffer(small_scene());
  int refused = 0;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const std::vector<std::uint8_t> cut(
        bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));  // own allocation: ends are guarded
    refused += !refusal(cut).empty();
  }
  EXPECT_GE(refused, static_cast<int>(bytes.size()) - 8);  // padding at the end may go unmissed
}

TEST(SceneBuffer, WithAnyBitFlippedIsRefusedOrReadNeverMore) {
  const auto bytes = scene_to_flatbuffer(small_scene());
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    auto damaged = bytes;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    refused += !refusal(damaged).empty();
  }
  EXPECT_GT(refused,
            static_cast<int>(bytes.size()));  // every offset and table entry has bits that cannot be wrong unnoticed
}

}  // namespace
}  // namespace vbgpd
