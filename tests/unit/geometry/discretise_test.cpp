#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

std::vector<Polygon> shapes() {
  std::vector<Polygon> all;
  for (const Polygon& p : {slope(), slope_on_foundation(), vertical_cut(), overhang(), benches()}) {
    all.push_back(p);
    all.push_back(reversed(p));
    all.push_back(mirrored(p));
  }
  return all;
}

// Shoelace formula, independent of the code under test.
double area_of(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += (a.x - polygon[0].x) * (b.y - polygon[0].y) - (b.x - polygon[0].x) * (a.y - polygon[0].y);
  }
  return std::abs(sum) / 2;
}

TEST(Discretise, VolumesSumToTheExteriorArea) {
  for (const Polygon& polygon : shapes())
    for (const double spacing : {0.31, 0.5, 1.0, 1.7}) {
      const Section section = cut(scene_of(polygon), spacing);
      EXPECT_NEAR(section.area, area_of(polygon), 1e-12 * section.area);
      EXPECT_NEAR(soil_volume(section), section.area, 1e-12 * section.area) << "spacing " << spacing;
    }
}

TEST(Discretise, RefusesAnExteriorWithNextToNoArea) {
  const SceneDef scene = scene_of({{0, 0}, {1e-311, 1e-318}, {4, 4}});
  EXPECT_THROW(cut(scene, 1), Error);
}

TEST(Discretise, FirstMomentsSumToThoseOfTheExterior) {
  // Benches, integrated by hand-free triangulation about the origin.
  const Polygon polygon = benches();
  double mx = 0, my = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double twice = a.x * b.y - b.x * a.y;
    mx += twice * (a.x + b.x) / 6;
    my += twice * (a.y + b.y) / 6;
  }
  Vec2 sum = Vec2::Zero();
  for (const Seed& seed : cut(scene_of(polygon), 0.7).seeds)
    if (seed.hold == Hold::kFree) sum += seed.volume * seed.centroid;
  EXPECT_NEAR(sum.x(), mx, 1e-11 * mx);
  EXPECT_NEAR(sum.y(), my, 1e-11 * my);
}

TEST(Discretise, MapCoordinatesChangeNoVolume) {
  for (const Polygon& polygon : {slope(), benches(), overhang()}) {
    const Section near = cut(scene_of(polygon), 0.5), far = cut(scene_of(moved(polygon, 5e5, 4e6)), 0.5);
    EXPECT_NEAR(soil_volume(far), far.area, 1e-9 * far.area);
    ASSERT_EQ(far.seeds.size(), near.seeds.size());
    ASSERT_EQ(far.cut_pairs.size(), near.cut_pairs.size());
    for (std::size_t i = 0; i < near.seeds.size(); ++i) {
      EXPECT_EQ(far.seeds[i].ix, near.seeds[i].ix);
      EXPECT_EQ(far.seeds[i].iy, near.seeds[i].iy);
      EXPECT_NEAR(far.seeds[i].volume, near.seeds[i].volume, 1e-8);
      EXPECT_NEAR(far.seeds[i].centroid.x(), near.seeds[i].centroid.x() + 5e5, 1e-8);
      EXPECT_NEAR(far.seeds[i].centroid.y(), near.seeds[i].centroid.y() + 4e6, 1e-8);
    }
  }
}

TEST(Discretise, SlopeInSmallNumbersIsCutAsByHand) {
  // 2:1 face, cells 1 x 1: row iy holds cells up to x = 32 - 2 (iy + 1), then one of 3/4 and a sliver of 1/4.
  const Section section = cut(scene_of(slope()), 1.0);
  EXPECT_EQ(section.lattice.spacing, Vec2(1, 1));
  EXPECT_EQ(count(section, Hold::kFree), 12 * 10 + 10 * 10);  // sum over rows of 31 - 2 iy
  EXPECT_DOUBLE_EQ(section.area, 220);
  EXPECT_DOUBLE_EQ(section.height, 10);
  ASSERT_NE(seed_at(section, 30, 0), nullptr);
  for (Index iy = 0; iy < 10; ++iy) {
    const Index ix = 30 - 2 * iy;
    const Seed* face = seed_at(section, ix, iy);  // with the sliver to its right a triangle 2 m wide and 1 m high
    ASSERT_NE(face, nullptr);
    EXPECT_DOUBLE_EQ(face->volume, 1);
    EXPECT_NEAR((face->centroid - Vec2(ix + 2.0 / 3, iy + 1.0 / 3)).norm(), 0, 1e-12);
    EXPECT_DOUBLE_EQ(seed_at(section, ix - 1, iy)->volume, 1);
    EXPECT_EQ(seed_at(section, ix + 1, iy), nullptr);
  }
  EXPECT_EQ(seed_at(section, 31, 0), nullptr);
}

TEST(Discretise, LeavesNoSliver) {
  for (const Polygon& polygon : shapes()) {
    const Section section = cut(scene_of(polygon), 0.83);
    const double half = 0.5 * section.lattice.spacing.prod();
    for (const Seed& seed : section.seeds)
      EXPECT_TRUE(seed.hold != Hold::kFree || seed.volume >= half * (1 - 1e-8)) << seed.ix << ", " << seed.iy;
  }
}

TEST(Discretise, LongThinToeBecomesCellsOfAtLeastHalf) {
  const Section section = cut(scene_of({{0, 0}, {40, 0}, {20, 2}, {0, 2}}), 0.9);  // 10:1
  const double half = 0.5 * section.lattice.spacing.prod();
  for (const Seed& seed : section.seeds)
    EXPECT_TRUE(seed.hold != Hold::kFree || seed.volume >= half * (1 - 1e-8)) << seed.ix;
  EXPECT_NEAR(soil_volume(section), 60, 1e-11);
}

TEST(Discretise, KeepsASliverThatHasNoNeighbour) {
  // Lattice far coarser than the section: one cell, less than half full.
  Lattice lattice;
  lattice.spacing = Vec2(10, 10);
  const Section section = discretise(scene_of({{0, 0}, {2, 0}, {2, 1}}), lattice, 0, 0);
  ASSERT_EQ(section.seeds.size(), 1u);
  EXPECT_DOUBLE_EQ(section.seeds[0].volume, 1);
}

TEST(Discretise, HalfCellsOnAFortyFiveDegreeFaceAreKept) {
  for (const double offset : {0.0, 4e6}) {
    const Section section = cut(scene_of(moved({{0, 0}, {20, 0}, {10, 10}, {0, 10}}, offset, offset)), 0.5);
    for (Index k = 0; k < 20; ++k) {
      const Seed* face = seed_at(section, 39 - k, k);
      ASSERT_NE(face, nullptr);
      EXPECT_NEAR(face->volume, 0.125, 1e-8);
    }
  }
}

TEST(Discretise, SeedsAreSortedAndEachCellComesOnce) {
  for (const Polygon& polygon : shapes()) {
    const Section section = cut(scene_of(polygon), 0.9);
    for (std::size_t i = 0; i + 1 < section.seeds.size(); ++i) {
      const Seed &a = section.seeds[i], &b = section.seeds[i + 1];
      EXPECT_TRUE(a.ix < b.ix || (a.ix == b.ix && a.iy < b.iy));
    }
  }
}

TEST(Discretise, MirroredSceneGivesMirroredSeeds) {
  for (const Polygon& polygon : {slope(), slope_on_foundation(), vertical_cut(), overhang(), benches()}) {
    const Section a = cut(scene_of(polygon), 0.77, 2), b = cut(scene_of(mirrored(polygon)), 0.77, 2);
    EXPECT_NEAR(a.lattice.spacing.x(), b.lattice.spacing.x(), 1e-12);
    EXPECT_NEAR(a.lattice.spacing.y(), b.lattice.spacing.y(), 1e-12);
    ASSERT_EQ(a.seeds.size(), b.seeds.size());
    EXPECT_EQ(a.cut_pairs.size(), b.cut_pairs.size());
    const double width = -(a.lattice.origin.x() + b.lattice.origin.x());
    const Index last = static_cast<Index>(std::lround(width / a.lattice.spacing.x())) - 1;
    for (const Seed& seed : a.seeds) {
      const Seed* twin = seed_at(b, last - seed.ix, seed.iy);
      ASSERT_NE(twin, nullptr) << seed.ix << ", " << seed.iy;
      EXPECT_EQ(twin->hold, seed.hold);
      EXPECT_NEAR(twin->volume, seed.volume, 1e-11);
      EXPECT_NEAR(twin->centroid.x(), -seed.centroid.x(), 1e-10);
      EXPECT_NEAR(twin->centroid.y(), seed.centroid.y(), 1e-10);
      EXPECT_NEAR(twin->normal.x(), -seed.normal.x(), 1e-12);
    }
  }
}

TEST(Discretise, AMillimetreModelIsCutLikeAMetreModel) {
  const Section metre = cut(scene_of(benches()), 0.8), milli = cut(scene_of(scaled(benches(), 1e-3)), 0.8e-3);
  ASSERT_EQ(metre.seeds.size(), milli.seeds.size());
  for (std::size_t i = 0; i < metre.seeds.size(); ++i) {
    EXPECT_EQ(metre.seeds[i].iy, milli.seeds[i].iy);
    EXPECT_NEAR(metre.seeds[i].volume, milli.seeds[i].volume * 1e6, 1e-10);
  }
}

TEST(Discretise, GroundRunsFromLeftToRightAlongTheTop) {
  const Section section = cut(scene_of(reversed(slope_on_foundation())), 1.0);
  const Polygon expected = {{0, 10}, {12, 10}, {32, 0}, {52, 0}};
  ASSERT_EQ(section.ground.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(section.ground[i].x, expected[i].x);
    EXPECT_EQ(section.ground[i].y, expected[i].y);
  }
  EXPECT_DOUBLE_EQ(section.height, 10);
  EXPECT_DOUBLE_EQ(cut(scene_of({{0, 0}, {8, 0}, {8, 3}, {0, 3}}), 0.5).height,
                   3);  // flat ground: the section's height
}

TEST(Discretise, PaintsLayersInOrder) {
  SceneDef scene = scene_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add_layer(scene, "clay", {{0, 0}, {10, 0}, {10, 5}, {0, 5}});
  add_layer(scene, "sand", {{4, 2}, {8, 2}, {8, 8}, {4, 8}});
  const auto material = [&](Index ix, Index iy) { return seed_at(cut(scene, 1.0), ix, iy)->material; };
  EXPECT_EQ(material(1, 8), 0);
  EXPECT_EQ(material(1, 1), 1);
  EXPECT_EQ(material(5, 3), 2);
  EXPECT_EQ(material(5, 6), 2);
  std::swap(scene.layers[1], scene.layers[2]);
  EXPECT_EQ(material(5, 3), 1);
  EXPECT_EQ(material(5, 6), 2);
  std::rotate(scene.layers.begin(), scene.layers.begin() + 1, scene.layers.end());  // the background last hides all
  EXPECT_EQ(material(5, 3), 0);
}

TEST(Discretise, ACellTakesTheMaterialOfItsLargestVisibleShare) {
  // Cell (3, 3): "clay" covers 60 %, but "sand" hides most of that; 45 % stays soil, 35 % sand, 20 % clay.
  SceneDef scene = scene_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add_layer(scene, "clay", {{3, 0}, {3.55, 0}, {3.55, 10}, {3, 10}});
  add_layer(scene, "sand", {{3, 0}, {3.35, 0}, {3.35, 10}, {3, 10}});
  EXPECT_EQ(seed_at(cut(scene, 1.0), 3, 3)->material, 0);
  scene.layers[2].polygon = {{3, 0}, {3.5, 0}, {3.5, 10}, {3, 10}};
  EXPECT_EQ(seed_at(cut(scene, 1.0), 3, 3)->material, 2);
  scene.layers[2].material = "clay";  // both count for clay now
  scene.layers[1].polygon = {{3, 0}, {3.2, 0}, {3.2, 10}, {3, 10}};
  EXPECT_EQ(seed_at(cut(scene, 1.0), 3, 3)->material, 1);
}

TEST(Discretise, InclinedLayersKeepTheirAreaOnAverage) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "band", {{0, 2.013}, {20, 6.013}, {20, 8.006}, {0, 4.006}});
  double band = 0;
  for (const Seed& seed : cut(scene, 0.1, 1, 0).seeds)
    if (seed.material == 1) band += seed.volume;
  EXPECT_NEAR(band, 39.86, 0.2);
}

TEST(Discretise, RefusesMoreParticlesThanAllowed) {
  const SceneDef scene = scene_of(slope());
  const Lattice lattice = fit_lattice(scene, 0.1, 1);
  for (const std::int64_t most : {1000, 22500}) {  // more soil than that; and soil fits but walls do not
    try {
      discretise(scene, lattice, 3, most);
      FAIL() << "accepted " << most;
    } catch (const Error& error) {
      EXPECT_EQ(error.issue().status, Status::kLimit);
      EXPECT_NE(std::string(error.what()).find(std::to_string(most)), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace vbgpd::geometry_test
