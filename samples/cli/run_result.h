// Everything the engine says about one run-out, as plain data.
#pragma once

#include <string>
#include <vector>

#include "engine.h"

namespace cli {

/// One line of the time series.
struct Sample {
  double time = 0, kinetic_energy = 0, plastic_fraction = 0, crest_settlement = 0, toe_displacement = 0,
         runout_distance = 0, moved_area = 0, energy_residual = 0;
};

struct RunResult {
  std::string status, reason, scheme, flow_rule, hash;
  double factor = 1, viscosity = 0, kh = 0, kv = 0, peak_kinetic_energy = 0, max_displacement = 0, wall_seconds = 0;
  double spacing = 0;
  std::int64_t particles = 0, steps = 0;
  std::vector<Sample> series;  ///< the last one is the end
  std::vector<Point> ground;   ///< final ground surface, left to right
  std::vector<std::string> warnings, errors;
};

/// The object of `vbgpd run --json`.
std::string to_json(const RunResult& result);
/// A short report for a person.
std::string to_text(const RunResult& result, const std::string& scene_name);
/// The time series and the ground surface as comma-separated values with a heading.
std::string series_csv(const std::vector<Sample>& series);
std::string ground_csv(const std::vector<Point>& ground);

}  // namespace cli
