#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/format.h"
#include "geometry/jitter.h"
#include "geometry/section.h"
#include "geometry/soil.h"
#include "geometry/stages.h"
#include "geometry/walls.h"

namespace vbgpd {
namespace {

void check_arguments(const Lattice& lattice, int reach, const Polygon& exterior) {
  if (!(lattice.spacing.minCoeff() > 0) || !lattice.spacing.allFinite() || !lattice.origin.allFinite())
    throw Error(Status::kRange, "the lattice needs a finite origin and spacings above 0, not " +
                                    number(lattice.spacing.x()) + " and " + number(lattice.spacing.y()) + " m");
  if (reach < 0) throw Error(Status::kArgument, "the walls cannot be " + std::to_string(reach) + " cells thick");
  if (exterior.size() < 3)
    throw Error(Status::kGeometry, "the exterior of the profile has " + std::to_string(exterior.size()) +
                                       " distinct vertices; it needs at least 3");
}

void require_soil(const Soil& soil) {
  if (!soil.seeds.empty()) return;
  throw Error(Issue{.status = Status::kGeometry,
                    .object = ObjectKind::kProfile,
                    .text = "the exterior of the profile encloses next to no area: no cell of the grid has any soil"});
}

std::vector<Vertices> layer_polygons(const SceneDef& scene, const Vec2& origin) {
  std::vector<Vertices> result;
  for (const LayerDef& layer : scene.layers) result.push_back(local(layer.polygon, origin));
  return result;
}

std::vector<Seed> merged(const std::vector<Seed>& soil, const std::vector<Seed>& walls) {
  std::vector<Seed> all;
  all.reserve(soil.size() + walls.size());
  std::merge(soil.begin(), soil.end(), walls.begin(), walls.end(), std::back_inserter(all),
             [](const Seed& a, const Seed& b) { return a.ix != b.ix ? a.ix < b.ix : a.iy < b.iy; });
  return all;
}

void check_count(std::size_t count, std::int64_t max_particles) {
  const std::int64_t most = max_particles > 0 ? max_particles : std::numeric_limits<Index>::max();
  if (static_cast<std::int64_t>(count) <= most) return;
  throw Error(Issue{.status = Status::kLimit,
                    .object = ObjectKind::kProfile,
                    .value = static_cast<double>(count),
                    .text = "the section needs " + std::to_string(count) +
                            " particles (walls included), more than the " + std::to_string(most) +
                            " allowed: use a larger spacing or allow more particles"});
}

}  // namespace

Section discretise(const SceneDef& scene, const Lattice& lattice, int reach, std::int64_t max_particles) {
  const Polygon outline = counter_clockwise(scene.exterior);
  check_arguments(lattice, reach, outline);
  const Vertices exterior = local(outline, lattice.origin);
  const Box box = box_of(outline);
  const Real noise = coordinate_noise(box);
  const GridLines grid = make_grid(lattice, exterior, layer_polygons(scene, lattice.origin), noise);

  Soil soil = cut_soil(exterior, grid, lattice.spacing, max_particles);
  assign_materials(scene, lattice.origin, grid, lattice.spacing, soil);
  merge_slivers(grid, lattice.spacing, std::max(Real(1e-9), 8 * noise / lattice.spacing.minCoeff()), soil);
  require_soil(soil);

  Section section;
  section.lattice = lattice;
  section.boundaries = boundaries_of(scene);
  const std::vector<HeldEdge> held = held_edges(section.boundaries, exterior, lattice.origin);
  section.seeds = merged(soil.seeds, wall_seeds(held, exterior, soil.seeds, lattice.spacing, reach));
  check_count(section.seeds.size(), max_particles);
  for (Seed& seed : section.seeds) seed.centroid += lattice.origin;
  jitter(scene.jitter, section);
  keep_layers(scene, {}, section);
  return section;
}

}  // namespace vbgpd
