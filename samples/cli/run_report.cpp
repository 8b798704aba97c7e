// A run-out as text, JSON and comma-separated values.
#include <nlohmann/json.hpp>

#include "format.h"
#include "run_result.h"

namespace cli {

namespace {

using Json = nlohmann::ordered_json;

Json sample_json(const Sample& s) {
  return {{"time", s.time},
          {"kinetic_energy", s.kinetic_energy},
          {"plastic_fraction", s.plastic_fraction},
          {"crest_settlement", s.crest_settlement},
          {"toe_displacement", s.toe_displacement},
          {"runout_distance", s.runout_distance},
          {"moved_area", s.moved_area},
          {"energy_residual", s.energy_residual}};
}

}  // namespace

std::string to_json(const RunResult& r) {
  const Sample last = r.series.empty() ? Sample{} : r.series.back();
  Json series = Json::array(), ground = Json::array();
  for (const Sample& s : r.series) series.push_back(sample_json(s));
  for (const Point& p : r.ground) ground.push_back(Json::array({p.x, p.y}));
  Json object = {{"status", r.status}, {"reason", r.reason}};
  object.update(sample_json(last));
  object.update(Json{{"strength_reduction_factor", r.factor},
                     {"peak_kinetic_energy", r.peak_kinetic_energy},
                     {"max_displacement", r.max_displacement},
                     {"viscosity", r.viscosity},
                     {"kh", r.kh},
                     {"kv", r.kv},
                     {"scheme", r.scheme},
                     {"flow_rule", r.flow_rule},
                     {"spacing", r.spacing},
                     {"particles", r.particles},
                     {"steps", r.steps},
                     {"wall_seconds", r.wall_seconds},
                     {"series", series},
                     {"ground_surface", ground},
                     {"hash", r.hash},
                     {"version", vbgpd_version_string()},
                     {"warnings", r.warnings},
                     {"errors", r.errors}});
  return object.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const RunResult& r, const std::string& scene_name) {
  const Sample last = r.series.empty() ? Sample{} : r.series.back();
  std::string text = scene_name.empty() ? "" : scene_name + "\n";
  text += format("run-out %s m, moved area %s m2, largest displacement %s m, after %s s\n",
                 plain_number(last.runout_distance, 4).c_str(), plain_number(last.moved_area, 4).c_str(),
                 plain_number(r.max_displacement, 4).c_str(), plain_number(last.time, 4).c_str());
  text += "  status         " + r.status + ": " + r.reason + "\n";
  text += format("  displacement   crest settled %s m, toe moved %s m\n",
                 plain_number(last.crest_settlement, 4).c_str(), plain_number(last.toe_displacement, 4).c_str());
  if (r.kh != 0 || r.kv != 0)
    text += format("  seismic        kh %s, kv %s act for as long as the soil moves, as no earthquake does\n",
                   plain_number(r.kh, 4).c_str(), plain_number(r.kv, 4).c_str());
  text += format("  energy         peak kinetic %s J/m, books closed to %.2g of their largest entry\n",
                 plain_number(r.peak_kinetic_energy, 4).c_str(), last.energy_residual);
  text += format("  scheme         %s; viscosity alpha c h = %s m2/s, F = %s\n", r.scheme.c_str(),
                 plain_number(r.viscosity, 4).c_str(), plain_number(r.factor, 4).c_str());
  text += format("  grid           spacing %s m, %s, %s steps, %s\n", plain_number(r.spacing, 4).c_str(),
                 counted(r.particles, "particle").c_str(), with_thousands(r.steps).c_str(),
                 duration(r.wall_seconds).c_str());
  return text;
}

std::string series_csv(const std::vector<Sample>& series) {
  std::string text =
      "time_s,kinetic_energy_J_per_m,plastic_fraction,crest_settlement_m,toe_displacement_m,runout_distance_m,"
      "moved_area_m2,energy_residual\n";
  for (const Sample& s : series)
    text += format("%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", s.time, s.kinetic_energy, s.plastic_fraction,
                   s.crest_settlement, s.toe_displacement, s.runout_distance, s.moved_area, s.energy_residual);
  return text;
}

std::string ground_csv(const std::vector<Point>& ground) {
  std::string text = "x_m,y_m\n";
  for (const Point& p : ground) text += format("%.9g,%.9g\n", p.x, p.y);
  return text;
}

}  // namespace cli
