// Everything the engine says about one search for the factor of safety, as plain data.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "engine.h"

namespace cli {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct FosResult {
  double factor_of_safety = kNone, srf_stable = kNone, srf_unstable = kNone, error_estimate = kNone;
  std::string status, reason, scheme, reduced, flow_rule;
  double displacement_level = kNone, sliding_area = kNone, energy_residual = kNone;
  double observed_order = kNone, next_level_spacing = kNone, next_level_seconds = kNone;
  double wall_seconds = kNone, cpu_seconds = kNone;
  std::vector<vbgpd_level> levels;
  std::vector<vbgpd_trial> trials;
  std::vector<Point> slip_surface;  ///< left to right
  std::string hash;                 ///< of the final state, 16 hexadecimal digits
  std::vector<std::string> warnings, errors;
};

/// `outcome` is what the last vbgpd_job_run gave back. Works on unfinished jobs too: what has no value yet is NaN or
/// empty.
FosResult read_result(const vbgpd_job* job, const vbgpd_model* model, vbgpd_status outcome);

/// The object of `vbgpd fos --json`.
std::string to_json(const FosResult& result);

/// A short report for a person.
std::string to_text(const FosResult& result, const std::string& scene_name);

/// "FS = 1.342 ± 0.006", or as much as is known: "FS > 4.000".
std::string factor_of_safety_label(const FosResult& result);

}  // namespace cli
