#include "fos_result.h"

#include <cmath>

#include "format.h"

namespace cli {

namespace {

template <class Item>
std::vector<Item> read_items(const vbgpd_job* job, vbgpd_status (*read)(const vbgpd_job*, std::int64_t, Item*)) {
  std::vector<Item> items;
  for (std::int64_t i = 0;; ++i) {
    Item item{};
    item.struct_size = sizeof item;
    const vbgpd_status status = read(job, i, &item);
    if (status == VBGPD_END_OF_DATA || status == VBGPD_E_STATE) return items;
    require(status, job);
    items.push_back(item);
  }
}

}  // namespace

FosResult read_result(const vbgpd_job* job, const vbgpd_model* model, vbgpd_status outcome) {
  FosResult r;
  r.factor_of_safety = number(job, "factor_of_safety");
  r.srf_stable = number(job, "srf_stable");
  r.srf_unstable = number(job, "srf_unstable");
  r.error_estimate = number(job, "error_estimate");
  r.displacement_level = number(job, "displacement_level");
  r.sliding_area = number(job, "sliding_area");
  r.energy_residual = number(job, "energy_residual");
  r.observed_order = number(job, "observed_order");
  r.next_level_spacing = number(job, "next_level_spacing");
  r.next_level_seconds = number(job, "next_level_seconds");
  r.wall_seconds = number(job, "wall_seconds");
  r.cpu_seconds = number(job, "cpu_seconds");
  r.status = text(job, "status");
  r.reason = text(job, "reason");
  r.scheme = text(job, "scheme");
  r.reduced = text(job, "reduced");
  r.flow_rule = text(job, "flow_rule");
  r.levels = read_items<vbgpd_level>(job, vbgpd_job_level);
  r.trials = read_items<vbgpd_trial>(job, vbgpd_job_trial);
  r.slip_surface = slip_surface(job);
  r.hash = state_hash(model);
  if (outcome == VBGPD_CANCELLED) r.status = "CANCELLED", r.reason = "stopped on request before the search had ended";
  if (outcome == VBGPD_E_DIVERGED) r.status = "DIVERGED", r.reason = error_text(job);
  return r;
}

std::string factor_of_safety_label(const FosResult& r) {
  if (std::isfinite(r.factor_of_safety)) {
    const std::string value = format("FS = %.3f", r.factor_of_safety);
    // one grid says nothing about its own error: half its bracket is no error bar
    return std::isfinite(r.error_estimate) && r.levels.size() > 1 ? value + format(" ± %.3f", r.error_estimate) : value;
  }
  // half a bracket is that of a coarse grid, whose error nobody knows
  if (r.status == "CANCELLED" || r.status == "NOT_CONVERGED" || r.status == "DIVERGED") return "FS not found";
  const bool above = std::isfinite(r.srf_stable), below = std::isfinite(r.srf_unstable);
  if (above && below) return format("FS between %.3f and %.3f", r.srf_stable, r.srf_unstable);
  if (above) return format("FS > %.3f", r.srf_stable);
  if (below) return format("FS < %.3f", r.srf_unstable);
  return "FS not found";
}

}  // namespace cli
