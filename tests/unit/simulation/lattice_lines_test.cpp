// Along which lines particles are numbered: as few lanes of the packs empty or of other materials as can be.
#include <gtest/gtest.h>

#include "geometry/stages.h"
#include "physics/scenes.h"
#include "simulation/build_model.h"

namespace vbgpd {
namespace {

/// A block of two soils that meet at x = `where` or at y = `where`.
SceneDef halves(double width, double height, bool beside_each_other, double where) {
  SceneDef scene = test::block(test::soil("undrained", 50e3, 0), width, height, 1);
  scene.materials[0].name = "first";
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "second";
  const double x = beside_each_other ? where : width, y = beside_each_other ? height : where;
  scene.layers = {{"first", {}}, {"second", {{0, 0}, {x, 0}, {x, y}, {0, y}}}};
  return scene;
}

Section section_of(const SceneDef& scene) { return discretise(scene, fit_lattice(scene, 1, 1), 3, 0); }

/// Whether the next particle in storage is the neighbour in x.
bool along_x(const SceneDef& scene, int width = 8) {
  const Section section = section_of(scene);
  const Model m = build_model(scene, section, width);
  std::size_t first = 0, next = 0;  // soil in the middle of the block
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    if (section.seeds[k].ix == 4 && section.seeds[k].iy == 4) first = k;
    if (section.seeds[k].ix == 5 && section.seeds[k].iy == 4) next = k;
  }
  return m.storage_of[next] == m.storage_of[first] + 1;
}

TEST(LatticeLines, RunAlongLayers) {
  EXPECT_TRUE(along_x(halves(32, 32, false, 10)));
  EXPECT_FALSE(along_x(halves(32, 32, true, 10)));
}

TEST(LatticeLines, RunAlongTheLongSideOfOneSoil) {
  EXPECT_TRUE(along_x(halves(60, 9, false, 9)));
  EXPECT_FALSE(along_x(halves(9, 60, false, 60)));
}

TEST(LatticeLines, RunAlongTheShortSideWhereTheLongOneLeavesTheCache) {
  const SceneDef scene = halves(2600, 12, false, 12);
  EXPECT_FALSE(along_x(scene, 2));  // packs of two hardly waste a lane either way
  EXPECT_TRUE(along_x(halves(590, 12, false, 12), 2));
}

TEST(LatticeLines, AreThoseOfTheWholeSectionWhicheverLayersAreThere) {
  for (const bool beside_each_other : {false, true}) {
    const SceneDef scene = halves(40, 20, beside_each_other, 7);
    const Section whole = section_of(scene);
    const Model all = build_model(scene, whole, 8);
    for (const Layers& layers : {Layers{true, false}, Layers{false, true}}) {
      Section some = whole;
      keep_layers(scene, layers, some);
      EXPECT_EQ(build_model(scene, some, 8).storage_of, all.storage_of);
    }
  }
}

TEST(LatticeLines, HoldTheSameBondsInPacksOfAnyWidthAndDirection) {
  const SceneDef lying = halves(37, 11, false, 4), standing = halves(11, 37, true, 4);
  for (const SceneDef& scene : {lying, standing}) {
    const Section section = section_of(scene);
    const Model one = build_model(scene, section, 1);
    for (const int width : {2, 4, 8}) {
      const Model m = build_model(scene, section, width);
      EXPECT_EQ(m.bonds, one.bonds) << width;
      for (std::size_t k = 0; k < section.seeds.size(); ++k) {
        const auto i = static_cast<std::size_t>(m.storage_of[k]), j = static_cast<std::size_t>(one.storage_of[k]);
        EXPECT_NEAR(m.scaled_mass[i], one.scaled_mass[j], 1e-12 * one.scaled_mass[j]) << width << ", " << k;
      }
    }
  }
}

}  // namespace
}  // namespace vbgpd
