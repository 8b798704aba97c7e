#include "exchange/scene_buffer.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "scene/limits.h"
#include "scene/wording.h"
#include "vbgpd_generated.h"

namespace vbgpd {
namespace {

namespace fb = flatbuffers;
namespace schema = exchange;  // the namespace flatc writes

constexpr std::array<std::string_view, 2> kUnits{"SI", "kPa"};
constexpr const char* kUnitsHelp = "write \"SI\" (m, Pa, N/m3) or \"kPa\" (m, kPa, kN/m3)";

std::string at(const char* list, std::size_t i) { return std::string(list) + "[" + std::to_string(i) + "]"; }

/// Copies a verified buffer into a scene. Format problems are gathered; exceeding a limit throws at once.
class Reader {
 public:
  SceneDef read(const schema::Scene& from) {
    read_units(from.units());
    SceneDef scene;
    scene.units = stress_ == 1 ? Units::kSI : Units::kKilopascal;
    take(from.name(), "name", scene.name);
    take(from.source(), "source", scene.source);
    if (from.profile()) take(from.profile()->exterior(), "profile.exterior", scene.exterior);
    each(from.materials(), "materials", scene.materials);
    each(from.layers(), "layers", scene.layers);
    each(from.boundaries(), "boundaries", scene.boundaries);
    each(from.loads(), "loads", scene.loads);
    each(from.published(), "published", scene.published);
    read_settings(from, scene);
    if (!problems_.empty()) throw Error(Status::kFormat, problems_);
    return scene;
  }

 private:
  void read_units(const fb::String* units) {
    std::string name;
    take(units, "units", name);
    if (name.empty()) problem(std::string("units is required: ") + kUnitsHelp);
    else if (name == "kPa") stress_ = 1000;
    else if (name != "SI")
      problem("units \"" + name.substr(0, 64) + "\" is not known: " + kUnitsHelp + suggestion_text(name, kUnits));
  }

  void read_settings(const schema::Scene& from, SceneDef& scene) {
    take(from.gravity(), scene.gravity);
    take(from.spacing(), scene.spacing);
    if (const auto* seismic = from.seismic()) {
      take(seismic->kh(), scene.kh);
      take(seismic->kv(), scene.kv);
    }
    if (const auto* water = from.water()) {
      take(water->table(), "water.table", scene.water_table);
      take(water->unit_weight(), scene.water_unit_weight, stress_);
    }
    if (const auto* numerics = from.numerics()) {
      take(numerics->bond(), "numerics.bond", scene.bond);
      take(numerics->kernel(), "numerics.kernel", scene.kernel);
      take(numerics->smoothing_ratio(), scene.smoothing_ratio);
      take(numerics->jitter(), scene.jitter);
    }
    if (const auto* search = from.strength_reduction()) {
      take(search->srf_min(), scene.strength_reduction.srf_min);
      take(search->srf_max(), scene.strength_reduction.srf_max);
      take(search->tolerance(), scene.strength_reduction.tolerance);
    }
  }

  void read(const schema::Material& from, const std::string& where, MaterialDef& m) {
    take(from.name(), where + ".name", m.name);
    take(from.law(), where + ".law", m.law);
    take(from.unit_weight(), m.unit_weight, stress_);
    take(from.young_modulus(), m.young_modulus, stress_);
    take(from.poisson_ratio(), m.poisson_ratio);
    take(from.cohesion(), m.cohesion, stress_);
    take(from.friction_angle(), m.friction_angle);
    take(from.dilatancy_angle(), m.dilatancy_angle);
    take(from.tension_cutoff(), m.tension_cutoff, stress_);
    take(from.cohesion_gradient(), m.cohesion_gradient, stress_);
    take(from.cohesion_datum(), m.cohesion_datum);
    take(from.saturated_unit_weight(), m.saturated_unit_weight, stress_);
    take(from.pore_pressure_ratio(), m.pore_pressure_ratio);
  }

  void read(const schema::Layer& from, const std::string& where, LayerDef& layer) {
    take(from.material(), where + ".material", layer.material);
    take(from.polygon(), where + ".polygon", layer.polygon);
  }

  void read(const schema::Boundary& from, const std::string& where, BoundaryDef& b) {
    take(from.name(), where + ".name", b.name);
    take(from.side(), where + ".side", b.side);
    take(from.polyline(), where + ".polyline", b.polyline);
    take(from.vx(), b.vx);
    take(from.vy(), b.vy);
    take(from.friction_angle(), b.friction_angle);
    std::string kind;
    take(from.kind(), where + ".kind", kind);
    for (std::size_t i = 0; i < kBoundaryKinds.size(); ++i)
      if (kind == kBoundaryKinds[i]) return void(b.kind = static_cast<BoundaryKind>(i));
    const std::string fault = kind.empty() ? " is missing" : " \"" + kind.substr(0, 64) + "\" is not known";
    problem(where + ".kind" + fault + ": use one of " + list_text(kBoundaryKinds) +
            suggestion_text(kind, kBoundaryKinds));
  }

  void read(const schema::Load& from, const std::string&, LoadDef& load) {
    take(from.x0(), load.x0);
    take(from.x1(), load.x1);
    take(from.pressure(), load.pressure, stress_);
    load.pressure_end = load.pressure;
    take(from.pressure_end(), load.pressure_end, stress_);
  }

  void read(const schema::PublishedValue& from, const std::string& where, PublishedValue& value) {
    take(from.method(), where + ".method", value.method);
    take(from.source(), where + ".source", value.source);
    take(from.factor_of_safety(), value.factor_of_safety);
    take(from.factor_of_safety_end(), value.factor_of_safety_end);
  }

  template <typename Table, typename Def>
  void each(const fb::Vector<fb::Offset<Table>>* from, const char* list, std::vector<Def>& to) {
    if (!from) return;
    within(from->size(), kMaxObjects, list, "entries");
    to.resize(from->size());
    for (fb::uoffset_t i = 0; i < from->size(); ++i) read(*from->Get(i), at(list, i), to[i]);
  }

  void take(const fb::Vector<fb::Offset<schema::Point>>* from, const std::string& where, Polygon& to) {
    if (!from) return;
    within(from->size(), kMaxPoints, where, "points");
    to.reserve(from->size());
    for (const schema::Point* p : *from) to.push_back({p->x().value_or(kNone), p->y().value_or(kNone)});
  }

  void take(const fb::String* from, const std::string& where, std::string& to) {
    if (!from) return;
    within(from->size(), kMaxTextBytes, where, "bytes of text");
    text_bytes_ += from->size();
    within(text_bytes_, kMaxAllTextBytes, "the scene", "bytes of text");
    to = from->str();
    if (control_in(to) != to.npos) problem(where + " holds control characters: names are plain text");
  }

  static void take(fb::Optional<double> from, double& to, double factor = 1) {
    if (from) to = *from * factor;
  }

  static void within(std::size_t count, std::size_t limit, const std::string& where, const char* what) {
    if (count > limit)
      throw Error(Status::kFormat, where + " has " + std::to_string(count) + " " + what + ": at most " +
                                       std::to_string(limit) + " are accepted");
  }

  void problem(const std::string& text) { problems_ += (problems_.empty() ? "" : "\n") + text; }

  double stress_ = 1;  ///< Pa per unit of stress of the buffer
  std::size_t text_bytes_ = 0;
  std::string problems_;
};

const schema::Scene& verified(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) throw Error(Status::kFormat, "the scene buffer is empty");
  if (bytes.size() < 8 || !schema::SceneBufferHasIdentifier(bytes.data()))
    throw Error(Status::kFormat, "the buffer is not a scene: bytes 4 to 7 must be \"" +
                                     std::string(schema::SceneIdentifier()) + "\"; scene text is read by another call");
  fb::Verifier::Options options;
  options.max_depth = 8;
  options.max_tables = kMaxTables;
  fb::Verifier verifier(bytes.data(), bytes.size(), options);
  if (!schema::VerifySceneBuffer(verifier))
    throw Error(Status::kFormat, "the scene buffer is damaged or cut short (" + std::to_string(bytes.size()) +
                                     " bytes): some part of it points outside it");
  return *schema::GetScene(bytes.data());
}

/// Writes a scene in SI units. Numbers are always written, NaN included, unless NaN means "left out".
class Writer {
 public:
  std::vector<std::uint8_t> write(const SceneDef& scene) {
    const auto name = text(scene.name), source = text(scene.source), units = text("SI");
    const auto profile = schema::CreateProfile(out_, points(scene.exterior));
    const auto materials = each<schema::Material>(scene.materials);
    const auto layers = each<schema::Layer>(scene.layers);
    const auto boundaries = each<schema::Boundary>(scene.boundaries);
    const auto loads = each<schema::Load>(scene.loads);
    const auto published = each<schema::PublishedValue>(scene.published);
    const auto seismic = schema::CreateSeismic(out_, scene.kh, scene.kv);
    const auto bond = text(scene.bond), kernel = text(scene.kernel);
    const auto numerics = schema::CreateNumerics(out_, bond, kernel, scene.smoothing_ratio, scene.jitter);
    const auto& search = scene.strength_reduction;
    const auto reduction = schema::CreateStrengthReduction(out_, search.srf_min, search.srf_max, search.tolerance);
    const auto water = schema::CreateWater(out_, points(scene.water_table), scene.water_unit_weight);
    const auto root =
        schema::CreateScene(out_, name, source, units, profile, materials, layers, boundaries, loads, seismic,
                            scene.gravity, present(scene.spacing), numerics, reduction, published, water);
    schema::FinishSceneBuffer(out_, root);
    return {out_.GetBufferPointer(), out_.GetBufferPointer() + out_.GetSize()};
  }

 private:
  static fb::Optional<double> present(double v) { return std::isnan(v) ? fb::nullopt : fb::Optional<double>(v); }

  fb::Offset<fb::String> text(const std::string& s) { return out_.CreateString(s); }

  fb::Offset<fb::Vector<fb::Offset<schema::Point>>> points(const Polygon& polygon) {
    std::vector<fb::Offset<schema::Point>> offsets;
    offsets.reserve(polygon.size());
    for (const Point& p : polygon) offsets.push_back(schema::CreatePoint(out_, p.x, p.y));
    return out_.CreateVector(offsets);
  }

  fb::Offset<schema::Material> write_one(const MaterialDef& m) {
    const auto name = text(m.name), law = text(m.law);
    return schema::CreateMaterial(out_, name, law, present(m.unit_weight), m.young_modulus, m.poisson_ratio,
                                  present(m.cohesion), m.friction_angle, m.dilatancy_angle, present(m.tension_cutoff),
                                  m.cohesion_gradient, present(m.cohesion_datum), present(m.saturated_unit_weight),
                                  m.pore_pressure_ratio);
  }
  fb::Offset<schema::Layer> write_one(const LayerDef& layer) {
    const auto material = text(layer.material);
    return schema::CreateLayer(out_, material, points(layer.polygon));
  }
  fb::Offset<schema::Boundary> write_one(const BoundaryDef& b) {
    const auto name = text(b.name), side = text(b.side),
               kind = text(std::string(kBoundaryKinds[static_cast<std::size_t>(b.kind)]));
    return schema::CreateBoundary(out_, name, side, points(b.polyline), kind, b.vx, b.vy, present(b.friction_angle));
  }
  fb::Offset<schema::Load> write_one(const LoadDef& load) {
    return schema::CreateLoad(out_, present(load.x0), present(load.x1), present(load.pressure), load.pressure_end);
  }
  fb::Offset<schema::PublishedValue> write_one(const PublishedValue& value) {
    const auto method = text(value.method), source = text(value.source);
    return schema::CreatePublishedValue(out_, method, present(value.factor_of_safety),
                                        present(value.factor_of_safety_end), source);
  }

  template <typename Table, typename Def>
  fb::Offset<fb::Vector<fb::Offset<Table>>> each(const std::vector<Def>& list) {
    std::vector<fb::Offset<Table>> offsets;
    offsets.reserve(list.size());
    for (const Def& def : list) offsets.push_back(write_one(def));
    return out_.CreateVector(offsets);
  }

  fb::FlatBufferBuilder out_{4096};
};

}  // namespace

SceneDef scene_from_flatbuffer(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > kMaxSceneBytes)
    throw Error(Status::kFormat, "the scene buffer has " + std::to_string(bytes.size()) + " bytes: at most " +
                                     std::to_string(kMaxSceneBytes) + " are accepted");
  // A copy: aligned as flatbuffers expects, and nobody can change it between the check and the reading.
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  return Reader().read(verified(copy));
}

std::vector<std::uint8_t> scene_to_flatbuffer(const SceneDef& scene) { return Writer().write(scene); }

bool reads_flatbuffers() noexcept { return true; }

}  // namespace vbgpd
