#include "scene/difference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/properties.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

/// A scene in kPa goes through bytes and comes back with another last digit.
bool alike(double a, double b) {
  constexpr double kRoundOff = 1e-12;
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::fabs(a - b) <= kRoundOff * std::max(std::fabs(a), std::fabs(b));
}

bool alike(const Polygon& a, const Polygon& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Point& p, const Point& q) { return alike(p.x, q.x) && alike(p.y, q.y); });
}

/// Set while a model runs, and carried by its checkpoints; or read by a strength reduction only.
bool of_no_account(std::string_view name) {
  constexpr std::array<std::string_view, 9> kNames{"kh", "kv",      "pressure", "pressure_end", "vx",
                                                   "vy", "srf_min", "srf_max",  "srf_tolerance"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

std::string said(double value) { return std::isnan(value) ? "absent" : number_text(value, 12); }

std::string differing_number(const SceneDef& scene, const SceneDef& other, ObjectKind kind, std::size_t id,
                             const std::string& owner) {
  for (const Property& p : properties()) {
    if (p.object != kind || of_no_account(p.name)) continue;
    const auto index = static_cast<std::int64_t>(id);
    const double here = *find_property(scene, kind, index, p.name), there = *find_property(other, kind, index, p.name);
    if (!alike(here, there)) return owner + " has " + p.name + " " + said(there) + " there, " + said(here) + " here";
  }
  return {};
}

std::string differing_text(const std::string& here, const std::string& there, const std::string& what) {
  return here == there ? std::string() : what + " is \"" + there + "\" there, \"" + here + "\" here";
}

std::string differing_count(std::size_t here, std::size_t there, const char* what) {
  return here == there ? std::string()
                       : "it has " + std::to_string(there) + " " + what + ", this model " + std::to_string(here);
}

/// Names may change, the soil they mean may not.
std::size_t material_of(const SceneDef& scene, const LayerDef& layer) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const MaterialDef& m) { return m.name == layer.material; });
  return static_cast<std::size_t>(found - scene.materials.begin());
}

std::string differing_materials(const SceneDef& scene, const SceneDef& other) {
  if (std::string text = differing_count(scene.materials.size(), other.materials.size(), "materials"); !text.empty())
    return text;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const std::string owner = "material " + std::to_string(i);
    if (std::string text = differing_text(scene.materials[i].law, other.materials[i].law, "the law of " + owner);
        !text.empty())
      return text;
    if (std::string text = differing_number(scene, other, ObjectKind::kMaterial, i, owner); !text.empty()) return text;
  }
  return {};
}

std::string differing_layers(const SceneDef& scene, const SceneDef& other) {
  if (std::string text = differing_count(scene.layers.size(), other.layers.size(), "layers"); !text.empty())
    return text;
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    const std::string layer = "layer " + std::to_string(i);
    if (!alike(scene.layers[i].polygon, other.layers[i].polygon)) return "the polygon of " + layer + " is another one";
    if (material_of(scene, scene.layers[i]) != material_of(other, other.layers[i]))
      return layer + " is of another material";
  }
  return {};
}

std::string differing_boundaries(const SceneDef& scene, const SceneDef& other) {
  if (std::string text = differing_count(scene.boundaries.size(), other.boundaries.size(), "boundaries"); !text.empty())
    return text;
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
    const BoundaryDef &here = scene.boundaries[i], &there = other.boundaries[i];
    const std::string owner = "boundary " + std::to_string(i);
    if (here.side != there.side || !alike(here.polyline, there.polyline)) return owner + " is at another place";
    const auto kind = [](const BoundaryDef& b) {
      return std::string(kBoundaryKinds[static_cast<std::size_t>(b.kind)]);
    };
    if (std::string text = differing_text(kind(here), kind(there), "the kind of " + owner); !text.empty()) return text;
    if (std::string text = differing_number(scene, other, ObjectKind::kBoundary, i, owner); !text.empty()) return text;
  }
  return {};
}

std::string differing_loads(const SceneDef& scene, const SceneDef& other) {
  if (std::string text = differing_count(scene.loads.size(), other.loads.size(), "loads"); !text.empty()) return text;
  for (std::size_t i = 0; i < scene.loads.size(); ++i)
    if (std::string text = differing_number(scene, other, ObjectKind::kLoad, i, "load " + std::to_string(i));
        !text.empty())
      return text;
  return {};
}

std::string differing_whole(const SceneDef& scene, const SceneDef& other) {
  if (!alike(scene.exterior, other.exterior)) return "its exterior is another one";
  if (!alike(scene.water_table, other.water_table)) return "its water table is another one";
  if (std::string text = differing_text(scene.bond, other.bond, "the bond"); !text.empty()) return text;
  if (std::string text = differing_text(scene.kernel, other.kernel, "the kernel"); !text.empty()) return text;
  return differing_number(scene, other, ObjectKind::kProfile, 0, "the profile");
}

}  // namespace

std::string first_difference(const SceneDef& scene, const SceneDef& other) {
  for (const auto differing :
       {differing_whole, differing_materials, differing_layers, differing_boundaries, differing_loads})
    if (std::string text = differing(scene, other); !text.empty()) return text;
  return {};
}

}  // namespace vbgpd
