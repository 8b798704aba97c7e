#include <cmath>

#include "geometry/format.h"
#include "geometry/paint.h"
#include "geometry/soil.h"

namespace vbgpd {
namespace {

struct Patch {
  Index layer;
  Vertices outline;
};

// What the layers leave in each cell: one layer that fills it, with later ones that cover part of it.
struct Coats {
  std::vector<Index> ground;   // per seed: last layer that fills the cell, -1 = none
  std::vector<Index> patched;  // per seed: index into patches, -1 = none
  std::vector<std::vector<Patch>> patches;

  explicit Coats(std::size_t seeds) : ground(seeds, -1), patched(seeds, -1) {}

  void fill(Index seed, Index layer) {
    ground[seed] = layer;
    if (patched[seed] >= 0) patches[patched[seed]].clear();
  }

  void patch(Index seed, Index layer, const Vertices& outline) {
    if (patched[seed] < 0) {
      patched[seed] = static_cast<Index>(patches.size());
      patches.emplace_back();
    }
    patches[patched[seed]].push_back({layer, outline});
  }
};

std::vector<Index> layer_materials(const SceneDef& scene) {
  std::vector<Index> result;
  for (std::size_t k = 0; k < scene.layers.size(); ++k) {
    Index found = -1;
    for (std::size_t m = 0; m < scene.materials.size() && found < 0; ++m)
      if (scene.materials[m].name == scene.layers[k].material) found = static_cast<Index>(m);
    if (found < 0) {
      throw Error(Issue{.status = Status::kUnknownName,
                        .object = ObjectKind::kLayer,
                        .object_id = static_cast<std::int64_t>(k),
                        .text = "layers[" + std::to_string(k) + "].material = '" + scene.layers[k].material +
                                "': there is no material of this name"});
    }
    result.push_back(found);
  }
  return result;
}

Coats paint_cells(const SceneDef& scene, const Vec2& origin, const GridLines& grid, const Soil& soil) {
  Coats coats(soil.seeds.size());
  const CellIndex index(soil.seeds);
  for (std::size_t k = 0; k < scene.layers.size(); ++k) {
    const Index layer = static_cast<Index>(k);
    const Polygon polygon = counter_clockwise(scene.layers[k].polygon);
    if (polygon.empty()) {
      for (std::size_t i = 0; i < soil.seeds.size(); ++i) coats.fill(static_cast<Index>(i), layer);
      continue;
    }
    CellVisitor visit;
    visit.full = [&](Index column, Index begin, Index end) {
      for (Index row = begin; row < end; ++row) {
        const Index seed = index.find(grid.ix0 + column, grid.iy0 + row);
        if (seed >= 0) coats.fill(seed, layer);
      }
    };
    visit.partly = [&](Index column, Index row, const Vertices& outline) {
      const Index seed = index.find(grid.ix0 + column, grid.iy0 + row);
      if (seed >= 0) coats.patch(seed, layer, outline);
    };
    cut_by_grid(local(polygon, origin), grid, visit);
  }
  return coats;
}

// The material of a cell and the layer that brings most of it; -1 when no layer is seen in it.
struct Holder {
  Index material = -1, layer = -1;
};

// Shares of one cell, summed over layers of the same material.
Holder largest_share(const Vertices& soil, Index ground, const std::vector<Patch>& patches,
                     const std::vector<Index>& material_of) {
  std::vector<const Vertices*> layers;
  std::vector<Index> materials, numbers;
  if (ground >= 0) {
    layers.push_back(nullptr);
    numbers.push_back(ground);
  }
  for (const Patch& patch : patches) {
    layers.push_back(&patch.outline);
    numbers.push_back(patch.layer);
  }
  for (Index layer : numbers) materials.push_back(material_of[layer]);
  const std::vector<Real> visible = paint(soil, layers).visible;
  std::vector<Real> share = visible;
  Holder best;
  Real most = 0;
  for (std::size_t k = 0; k < share.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j)
      if (materials[j] == materials[k]) {
        share[k] += share[j];
        share[j] = 0;
      }
  }
  for (std::size_t k = 0; k < share.size(); ++k)
    if (share[k] > 0 && share[k] >= most * (1 - 1e-9)) {
      most = share[k];
      best.material = materials[k];
    }
  most = 0;
  for (std::size_t k = 0; k < visible.size(); ++k)
    if (materials[k] == best.material && visible[k] > 0 && visible[k] >= most * (1 - 1e-9)) {
      most = visible[k];
      best.layer = numbers[k];
    }
  return best;
}

// Cells in a gap between layers, narrower than the checks report, take the material of the nearest soil that has one.
void fill_gaps(const Vec2& spacing, Soil& soil) {
  const CellIndex index(soil.seeds);
  std::vector<Index> gaps;
  for (std::size_t i = 0; i < soil.seeds.size(); ++i)
    if (soil.seeds[i].material < 0) gaps.push_back(static_cast<Index>(i));
  std::vector<Index> found;
  for (Index i : gaps) {
    const Seed& seed = soil.seeds[i];
    const Index near =
        nearest_seed(index, seed.ix, seed.iy, 64, spacing, [&](Index j) { return soil.seeds[j].material >= 0; });
    if (near < 0) {
      throw Error(Issue{.status = Status::kGeometry,
                        .object = ObjectKind::kProfile,
                        .text = "no layer covers the soil about cell (" + std::to_string(seed.ix) + ", " +
                                std::to_string(seed.iy) +
                                ") of the lattice; add a layer without polygon to fill the exterior"});
    }
    found.push_back(near);
  }
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    soil.seeds[gaps[k]].material = soil.seeds[found[k]].material;
    soil.seeds[gaps[k]].layer = soil.seeds[found[k]].layer;
  }
}

}  // namespace

void assign_materials(const SceneDef& scene, const Vec2& origin, const GridLines& grid, const Vec2& spacing,
                      Soil& soil) {
  const std::vector<Index> material_of = layer_materials(scene);
  const Coats coats = paint_cells(scene, origin, grid, soil);
  for (std::size_t i = 0; i < soil.seeds.size(); ++i) {
    Seed& seed = soil.seeds[i];
    seed.layer = coats.ground[i];
    if (seed.layer >= 0) seed.material = material_of[seed.layer];
    if (coats.patched[i] < 0 || coats.patches[coats.patched[i]].empty()) continue;
    Vertices cell;
    if (soil.cut_of[i] < 0) {
      const Index column = seed.ix - grid.ix0, row = seed.iy - grid.iy0;
      const Real x0 = grid.x[column], x1 = grid.x[column + 1], y0 = grid.y[row], y1 = grid.y[row + 1];
      cell = {Vec2(x0, y0), Vec2(x1, y0), Vec2(x1, y1), Vec2(x0, y1)};
    }
    const Vertices& outline = soil.cut_of[i] < 0 ? cell : soil.cut[soil.cut_of[i]].outline;
    const Holder holder = largest_share(outline, coats.ground[i], coats.patches[coats.patched[i]], material_of);
    seed.material = holder.material, seed.layer = holder.layer;
  }
  fill_gaps(spacing, soil);
}

}  // namespace vbgpd
