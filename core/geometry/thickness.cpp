#include "geometry/thickness.h"

#include <algorithm>
#include <cmath>

#include "geometry/paint.h"
#include "geometry/polygon.h"

namespace vbgpd {

namespace {

/// A polygon along a line: the sorted places where the line enters and leaves it.
std::vector<Real> crossings(const Vertices& polygon, int axis, Real at) {
  std::vector<Real> places;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[j], &b = polygon[i];
    if ((a[axis] > at) == (b[axis] > at)) continue;
    const Real t = (at - a[axis]) / (b[axis] - a[axis]);
    places.push_back(a[1 - axis] + t * (b[1 - axis] - a[1 - axis]));
  }
  std::sort(places.begin(), places.end());
  return places;
}

bool within(const std::vector<Real>& places, Real at) {
  return (std::lower_bound(places.begin(), places.end(), at) - places.begin()) % 2 == 1;
}

struct Region {
  int material;
  Vertices polygon;  // empty = everywhere
};

/// Lengths of every material along one line, runs of one material joined.
void cut(const Vertices& exterior, const std::vector<Region>& regions, int axis, Real at,
         std::vector<std::vector<Real>>& lengths) {
  const std::vector<Real> outline = crossings(exterior, axis, at);
  std::vector<Real> ends = outline;
  std::vector<std::vector<Real>> inside;
  for (const Region& r : regions) {
    inside.push_back(crossings(r.polygon, axis, at));
    ends.insert(ends.end(), inside.back().begin(), inside.back().end());
  }
  std::sort(ends.begin(), ends.end());
  int run = -1;
  Real begin = 0;
  const auto close = [&](Real end) {
    if (run >= 0 && end > begin) lengths[static_cast<std::size_t>(run)].push_back(end - begin);
  };
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(ends[i + 1] > ends[i])) continue;
    const Real middle = (ends[i] + ends[i + 1]) / 2;
    int top = -1;
    if (within(outline, middle))
      for (std::size_t k = 0; k < regions.size(); ++k)
        if (regions[k].polygon.empty() || within(inside[k], middle)) top = regions[k].material;
    if (top == run) continue;
    close(ends[i]);
    run = top, begin = ends[i];
  }
  if (!ends.empty()) close(ends.back());
}

Real median(std::vector<Real> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int index_of(const SceneDef& scene, const std::string& name) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    if (scene.materials[m].name == name) return static_cast<int>(m);
  return -1;
}

}  // namespace

std::vector<Real> material_thickness(const SceneDef& scene, Real step, const Layers& there) {
  const Polygon outline = counter_clockwise(scene.exterior);
  const Vec2 origin = box_of(outline).low;
  const Vertices exterior = local(outline, origin);
  std::vector<Region> regions;
  std::vector<const Vertices*> layers;
  for (const LayerDef& layer : scene.layers) {
    const int material = has_layer(there, static_cast<Index>(regions.size())) ? index_of(scene, layer.material) : -1;
    regions.push_back({material, local(open_polygon(layer.polygon), origin)});
  }
  for (const Region& r : regions) layers.push_back(r.polygon.empty() ? nullptr : &r.polygon);
  const Painted painted = paint(exterior, layers);

  std::vector<Real> result(scene.materials.size(), kNone);
  for (std::size_t k = 0; k < regions.size(); ++k)
    if (regions[k].material >= 0 && painted.visible[k] > 1e-9 * signed_area(exterior))
      result[static_cast<std::size_t>(regions[k].material)] = 0;
  const Vec2 size = box_of(exterior).size();
  std::vector<std::vector<Real>> lengths[2];
  for (int axis = 0; axis < 2; ++axis) {
    lengths[axis].resize(scene.materials.size());
    const auto lines = static_cast<int>(std::clamp(std::round(size[axis] / step), Real(1), Real(1000)));
    for (int n = 0; n < lines; ++n) cut(exterior, regions, axis, size[axis] * (n + Real(0.5)) / lines, lengths[axis]);
  }
  for (std::size_t m = 0; m < result.size(); ++m) {
    if (std::isnan(result[m])) continue;
    const Real up = median(lengths[0][m]), along = median(lengths[1][m]);  // 0 = between the lines of that direction
    result[m] = up > 0 && along > 0 ? std::min(up, along) : std::max(up, along);
  }
  return result;
}

}  // namespace vbgpd
