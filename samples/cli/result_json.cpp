// The result as one JSON object. Every field is always there; what has no value is null (nlohmann writes NaN so).
#include <nlohmann/json.hpp>

#include "fos_result.h"

namespace cli {

namespace {

using Json = nlohmann::ordered_json;

const char* verdict_name(std::int32_t verdict) {
  switch (verdict) {
    case VBGPD_VERDICT_STABLE:
      return "stable";
    case VBGPD_VERDICT_FAILED:
      return "failed";
    default:
      return "undecided";
  }
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json level_json(const vbgpd_level& level) {
  return {{"spacing", level.spacing_x},
          {"spacing_x", level.spacing_x},
          {"spacing_y", level.spacing_y},
          {"particles", level.particles},
          {"bonds", level.bonds},
          {"srf_stable", level.srf_stable},
          {"srf_unstable", level.srf_unstable},
          {"factor_of_safety", level.factor_of_safety},
          {"estimate", level.estimate},
          {"error_estimate", level.error_estimate},
          {"sliding_area", level.sliding_area},
          {"trials", level.trials},
          {"steps", level.steps},
          {"wall_seconds", level.wall_seconds},
          {"cpu_seconds", level.cpu_seconds}};
}

Json trial_json(const vbgpd_trial& trial) {
  return {{"level", trial.level},
          {"strength_reduction_factor", trial.strength_reduction_factor},
          {"verdict", verdict_name(trial.verdict)},
          {"band_connected", trial.band_connected != 0},
          {"unbalanced_force_ratio", trial.unbalanced_force_ratio},
          {"unbalanced_force_slope", trial.unbalanced_force_slope},
          {"displacement_level", trial.displacement_level},
          {"displacement_growth", trial.displacement_growth},
          {"power_ratio", trial.power_ratio},
          {"steps", trial.steps},
          {"wall_seconds", trial.wall_seconds}};
}

template <class Items, class Convert>
Json list(const Items& items, Convert convert) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(convert(item));
  return array;
}

}  // namespace

std::string to_json(const FosResult& r) {
  const Json object = {
      {"factor_of_safety", r.factor_of_safety},
      {"srf_stable", r.srf_stable},
      {"srf_unstable", r.srf_unstable},
      {"status", r.status},
      {"reason", text_or_null(r.reason)},
      {"error_estimate", r.error_estimate},
      {"scheme", text_or_null(r.scheme)},
      {"reduced", text_or_null(r.reduced)},
      {"flow_rule", text_or_null(r.flow_rule)},
      {"displacement_level", r.displacement_level},
      {"observed_order", r.observed_order},
      {"next_level", {{"spacing", r.next_level_spacing}, {"wall_seconds", r.next_level_seconds}}},
      {"levels", list(r.levels, level_json)},
      {"trials", list(r.trials, trial_json)},
      {"slip_surface", list(r.slip_surface,
                            [](Point p) {
                              return Json::array({p.x, p.y});
                            })},
      {"sliding_area", r.sliding_area},
      {"energy_residual", r.energy_residual},
      {"wall_seconds", r.wall_seconds},
      {"cpu_seconds", r.cpu_seconds},
      {"hash", text_or_null(r.hash)},
      {"version", vbgpd_version_string()},
      {"warnings", r.warnings},
      {"errors", r.errors},
  };
  return object.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace cli
