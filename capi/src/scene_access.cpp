#include "scene_access.h"

#include <algorithm>
#include <array>
#include <vector>

#include "error_record.h"
#include "scene/properties.h"
#include "scene/wording.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {
namespace {

using Names = std::vector<std::string_view>;

[[noreturn]] void unknown_name(ObjectKind kind, const char* what, std::string_view name, int argument,
                               const Names& known) {
  std::string text = std::string("A ") + kind_name(kind) + " has no " + what + " named \"" + std::string(name) + "\"";
  text += known.empty() ? "." : ": it has " + list_text(known) + suggestion_text(name, known);
  throw ArgumentError(argument, Status::kUnknownName, text);
}

Names known_numbers(ObjectKind kind) {
  Names names;
  for (const Property& property : properties()) {
    if (property.object == kind) names.emplace_back(property.name);
  }
  return names;
}

/// The part of a scene that a member belongs to.
template <class T>
SceneDef& part(SceneDef& s, std::size_t, T SceneDef::*) {
  return s;
}
template <class T>
MaterialDef& part(SceneDef& s, std::size_t i, T MaterialDef::*) {
  return s.materials[i];
}
template <class T>
LayerDef& part(SceneDef& s, std::size_t i, T LayerDef::*) {
  return s.layers[i];
}
template <class T>
BoundaryDef& part(SceneDef& s, std::size_t i, T BoundaryDef::*) {
  return s.boundaries[i];
}

struct NamedText {
  ObjectKind kind;
  const char* name;
  std::string (*read)(SceneDef&, std::size_t id);
  void (*write)(SceneDef&, std::size_t id, std::string value, int argument);
};

template <auto Member>
constexpr NamedText text(ObjectKind kind, const char* name) {
  return {kind, name, [](SceneDef& s, std::size_t i) { return part(s, i, Member).*Member; },
          [](SceneDef& s, std::size_t i, std::string value, int) { (part(s, i, Member).*Member).swap(value); }};
}

std::string kind_of_boundary(SceneDef& s, std::size_t i) {
  return std::string(kBoundaryKinds[static_cast<std::size_t>(s.boundaries[i].kind)]);
}

void set_kind_of_boundary(SceneDef& s, std::size_t i, std::string value, int argument) {
  const auto found = std::find(kBoundaryKinds.begin(), kBoundaryKinds.end(), value);
  if (found == kBoundaryKinds.end())
    throw ArgumentError(argument, Status::kUnknownName,
                        "There is no kind \"" + value + "\" of boundary" + suggestion_text(value, kBoundaryKinds) +
                            "; known: " + list_text(kBoundaryKinds) + ".");
  s.boundaries[i].kind = static_cast<BoundaryKind>(found - kBoundaryKinds.begin());
}

/// Also in the layers made of it.
void set_name_of_material(SceneDef& s, std::size_t i, std::string value, int argument) {
  const std::string old_name = s.materials[i].name;
  if (value == old_name) return;
  require_new_material_name(s, value, argument);
  // Layers mean the first material of a name, should a scene file hold two.
  const auto first = std::find_if(s.materials.begin(), s.materials.end(),
                                  [&](const MaterialDef& material) { return material.name == old_name; });
  std::vector<LayerDef> layers = s.layers;
  if (first == s.materials.begin() + static_cast<std::ptrdiff_t>(i)) {
    for (LayerDef& layer : layers) {
      if (layer.material == old_name) layer.material = value;
    }
  }
  s.layers.swap(layers);  // all that may throw is behind us
  s.materials[i].name.swap(value);
}

constexpr std::array<NamedText, 10> kTexts{{
    text<&SceneDef::name>(ObjectKind::kProfile, "name"),
    text<&SceneDef::source>(ObjectKind::kProfile, "source"),
    text<&SceneDef::bond>(ObjectKind::kProfile, "bond"),
    text<&SceneDef::kernel>(ObjectKind::kProfile, "kernel"),
    {ObjectKind::kMaterial, "name", text<&MaterialDef::name>(ObjectKind::kMaterial, "name").read, set_name_of_material},
    text<&MaterialDef::law>(ObjectKind::kMaterial, "law"),
    text<&LayerDef::material>(ObjectKind::kLayer, "material"),
    text<&BoundaryDef::name>(ObjectKind::kBoundary, "name"),
    text<&BoundaryDef::side>(ObjectKind::kBoundary, "side"),
    {ObjectKind::kBoundary, "kind", kind_of_boundary, set_kind_of_boundary},
}};

Names known_texts(ObjectKind kind) {
  Names names;
  for (const NamedText& text : kTexts) {
    if (text.kind == kind) names.emplace_back(text.name);
  }
  return names;
}

const NamedText& find_text(ObjectKind kind, std::string_view name, int argument) {
  const auto found = std::find_if(kTexts.begin(), kTexts.end(),
                                  [&](const NamedText& text) { return text.kind == kind && name == text.name; });
  if (found == kTexts.end()) unknown_name(kind, "text", name, argument, known_texts(kind));
  return *found;
}

std::int64_t size_of(const auto& list) { return static_cast<std::int64_t>(list.size()); }

}  // namespace

const char* kind_name(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kContext:
      return "context";
    case ObjectKind::kProfile:
      return "profile";
    case ObjectKind::kMaterial:
      return "material";
    case ObjectKind::kLayer:
      return "layer";
    case ObjectKind::kLoad:
      return "load";
    case ObjectKind::kBoundary:
      return "boundary";
    case ObjectKind::kModel:
      return "model";
    case ObjectKind::kJob:
      return "job";
    default:
      return "object";
  }
}

ObjectKind part_kind(std::int32_t object_kind, int argument) {
  if (object_kind >= VBGPD_OBJECT_PROFILE && object_kind <= VBGPD_OBJECT_BOUNDARY) {
    return static_cast<ObjectKind>(object_kind);
  }
  throw ArgumentError(argument, Status::kArgument,
                      "object_kind is " + std::to_string(object_kind) +
                          "; a profile has VBGPD_OBJECT_PROFILE, MATERIAL, LAYER, LOAD and BOUNDARY (2 to 6).");
}

std::int64_t part_count(const SceneDef& scene, ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kMaterial:
      return size_of(scene.materials);
    case ObjectKind::kLayer:
      return size_of(scene.layers);
    case ObjectKind::kLoad:
      return size_of(scene.loads);
    case ObjectKind::kBoundary:
      return size_of(scene.boundaries);
    default:
      return 1;
  }
}

void require_part(const SceneDef& scene, ObjectKind kind, std::int64_t id, int argument) {
  const std::int64_t count = part_count(scene, kind);
  if (kind == ObjectKind::kProfile || (id >= 0 && id < count)) return;
  Issue issue;
  issue.object = kind;
  issue.object_id = id;
  issue.text = std::string("There is no ") + kind_name(kind) + " " + std::to_string(id) + ": this profile has " +
               std::to_string(count) + ", with ids from 0.";
  throw ArgumentError(argument, issue);
}

double& named_number(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument) {
  double* const value = find_property(scene, kind, id, name);
  if (value == nullptr) unknown_name(kind, "number", name, argument, known_numbers(kind));
  return *value;
}

std::string named_text(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument) {
  return find_text(kind, name, argument).read(scene, static_cast<std::size_t>(id));
}

void set_named_text(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument,
                    std::string_view value, int value_argument) {
  find_text(kind, name, argument).write(scene, static_cast<std::size_t>(id), std::string(value), value_argument);
}

double default_number(ObjectKind kind, std::string_view name) {
  for (const Property& property : properties()) {
    if (property.object == kind && name == property.name) return property.default_value;
  }
  return kNone;
}

const Polygon& polygon_of(const SceneDef& scene, ObjectKind kind, std::int64_t id, int id_argument) {
  require_part(scene, kind, id, id_argument);
  switch (kind) {
    case ObjectKind::kProfile:
      return scene.exterior;
    case ObjectKind::kLayer:
      return scene.layers[static_cast<std::size_t>(id)].polygon;
    case ObjectKind::kBoundary:
      return scene.boundaries[static_cast<std::size_t>(id)].polyline;
    default:
      throw ArgumentError(
          id_argument - 1, Status::kArgument,
          std::string("A ") + kind_name(kind) + " has no vertices; the profile, layers and boundaries have.");
  }
}

void require_new_material_name(const SceneDef& scene, std::string_view name, int argument) {
  if (name.empty()) throw ArgumentError(argument, Status::kArgument, "A material needs a name.");
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name != name) continue;
    Issue issue;
    issue.object = ObjectKind::kMaterial;
    issue.object_id = static_cast<std::int64_t>(i);
    issue.text = "Material " + std::to_string(i) + " is already named \"" + std::string(name) +
                 "\"; layers find their material by name, so each needs its own.";
    throw ArgumentError(argument, issue);
  }
}

}  // namespace vbgpd::capi
