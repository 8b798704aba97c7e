// What a model uses of the engine, what was left out, and what a factor of safety is going to cost.
#include "plan.h"

#include "analysis/forecast.h"
#include "convert.h"
#include "exchange/scene_buffer.h"
#include "geometry/predicates.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

std::vector<Feature> whole_plan(const Simulation& simulation) {
  std::vector<Feature> plan = simulation.plan();
  plan.push_back({"CGAL", "exact checks of polygons by CGAL; without it by the engine's own exact predicates",
                  checks_with_cgal()});
  plan.push_back({"flatbuffers", "scenes from flatbuffers and from scene files", reads_flatbuffers()});
  return plan;
}

vbgpd_feature feature_of(const Feature& from, const Simulation& simulation) {
  vbgpd_feature to{};
  to.struct_size = sizeof to;
  to.used = from.used ? 1 : 0;
  to.name = from.name;
  to.doc = from.doc;
  to.bytes = static_cast<std::int64_t>(from.particle_bytes + from.bond_bytes);
  to.bytes_per_particle = static_cast<double>(from.particle_bytes) /
                          static_cast<double>(std::max<std::int64_t>(simulation.particle_count(), 1));
  if (simulation.bond_count() > 0)
    to.bytes_per_bond = static_cast<double>(from.bond_bytes) / static_cast<double>(simulation.bond_count());
  return to;
}

}  // namespace

std::optional<double> forecast_of(const Engine& engine, std::string_view name) {
  constexpr std::string_view kPrefix = "forecast_";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  double Forecast::*number = nullptr;
  if (name == "step_seconds") number = &Forecast::step_seconds;
  if (name == "steps") number = &Forecast::steps;
  if (name == "seconds") number = &Forecast::seconds;
  if (name == "bytes") number = &Forecast::bytes;
  if (number == nullptr)
    throw ArgumentError(2, Status::kUnknownName,
                        "A model has no forecast named \"forecast_" + std::string(name) +
                            "\": it has forecast_step_seconds, forecast_steps, forecast_seconds, forecast_bytes.");
  return forecast_strength_reduction(engine.to_change()).*number;
}

}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_plan(const vbgpd_model* model, int64_t i, vbgpd_feature* f) {
  return with(model, [&](ModelObject& object) {
    require_struct(f, 3);
    const Simulation& simulation = *object.engine->simulation;
    const std::vector<Feature> plan = whole_plan(simulation);
    const Feature* const feature = item_at(plan, i, 2);
    if (feature == nullptr) return Status::kEndOfData;
    fill(f, feature_of(*feature, simulation));
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_memory(const vbgpd_model* model, vbgpd_memory* m) {
  return with(model, [&](ModelObject& object) {
    require_struct(m, 2);
    const Memory from = object.engine->simulation->memory();
    const auto bytes = [](std::size_t n) { return static_cast<std::int64_t>(n); };
    vbgpd_memory told{};
    told.struct_size = sizeof told;
    told.bytes = bytes(from.total());
    told.model = bytes(from.model), told.state = bytes(from.state), told.scratch = bytes(from.scratch);
    told.copies = bytes(from.copies), told.outside = bytes(from.outside), told.saved = bytes(from.saved);
    fill(m, told);
    return Status::kOk;
  });
}
