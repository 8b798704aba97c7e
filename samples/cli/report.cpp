// The result as a short report for a person.
#include <algorithm>
#include <cmath>

#include "format.h"
#include "fos_result.h"

namespace cli {

namespace {

std::string place(Point p) {
  // m, to the centimetre at least where coordinates are those of a map
  const auto number = [](double v) {
    const double size = std::fabs(v);
    return size < 1e-6 ? "0" : size < 1000 ? plain_number(v, 5) : format("%.2f", v);
  };
  return format("(%s, %s)", number(p.x).c_str(), number(p.y).c_str());
}

/// How the value came about: by how many grids, with what bracket.
std::string origin_text(const FosResult& r) {
  if (!std::isfinite(r.factor_of_safety)) return "";
  const auto grids = std::count_if(r.levels.begin(), r.levels.end(),
                                   [](const vbgpd_level& level) { return std::isfinite(level.factor_of_safety); });
  if (grids > 1 && (r.status == "OK" || r.status == "TARGET_NOT_MET"))
    return format("   from %d grids", static_cast<int>(grids));
  return grids > 1 ? "   middle of the bracket of the finest grid"
                   : "   middle of the bracket of one grid, whose error is unknown";
}

std::string level_text(std::size_t i, const vbgpd_level& level) {
  std::string bracket = "no bracket";
  if (std::isfinite(level.srf_stable) && std::isfinite(level.srf_unstable))
    bracket = format("bracket [%.4f, %.4f]", level.srf_stable, level.srf_unstable);
  else if (std::isfinite(level.srf_stable)) bracket = format("stands at %.4f, no failure shown", level.srf_stable);
  else if (std::isfinite(level.srf_unstable)) bracket = format("fails at %.4f", level.srf_unstable);
  const std::string middle =
      std::isfinite(level.factor_of_safety) ? format("FS %.4f", level.factor_of_safety) : "FS not found";
  const std::string estimate = i > 0 && std::isfinite(level.error_estimate)
                                   ? format(", so far %.4f ± %.4f", level.estimate, level.error_estimate)
                                   : "";
  return format("  grid %zu         spacing %s m, %s, %s: %s, %s, %s, %s%s\n", i + 1,
                plain_number(level.spacing_x, 4).c_str(), counted(level.particles, "particle").c_str(),
                counted(level.bonds, "bond").c_str(), middle.c_str(), bracket.c_str(),
                counted(level.trials, "trial").c_str(), duration(level.wall_seconds).c_str(), estimate.c_str());
}

/// The mechanism goes down: it enters at the higher end and leaves at the lower one. Ends of one height are both ways
/// out, as below a footing.
std::string slip_text(const FosResult& r) {
  if (r.slip_surface.empty()) return "  slip surface   not found\n";
  Point entry = r.slip_surface.front(), exit = r.slip_surface.back();
  if (entry.y < exit.y) std::swap(entry, exit);
  const Point deepest =
      *std::min_element(r.slip_surface.begin(), r.slip_surface.end(), [](Point a, Point b) { return a.y < b.y; });
  const bool level = entry.y - exit.y < 0.02 * (entry.y - deepest.y);
  std::string text = "  slip surface   " +
                     (level ? "comes out at " + place(entry) + " and " : "enters at " + place(entry) + ", leaves at ") +
                     place(exit) + ", lowest at " + place(deepest);
  if (std::isfinite(r.sliding_area)) text += ", sliding area " + plain_number(r.sliding_area, 4) + " m2";
  return text + "\n";
}

std::string line(const char* name, const std::string& value) {
  return value.empty() ? "" : format("  %-14s %s\n", name, value.c_str());
}

}  // namespace

std::string to_text(const FosResult& r, const std::string& scene_name) {
  std::string text = scene_name.empty() ? "" : scene_name + "\n";
  text += factor_of_safety_label(r) + origin_text(r) + "\n";
  for (std::size_t i = 0; i < r.levels.size(); ++i) text += level_text(i, r.levels[i]);
  text += line("status", r.reason.empty() ? r.status : r.status + ": " + r.reason);
  if (std::isfinite(r.next_level_seconds))
    text += line("one grid more", "spacing " + plain_number(r.next_level_spacing, 3) + " m, about " +
                                      duration(r.next_level_seconds) + " (predicted)");
  text += slip_text(r);
  text += line("scheme", r.scheme);
  text += line("reduced", r.reduced);
  text += line("flow rule", r.flow_rule);
  if (std::isfinite(r.displacement_level))
    text += line("displacement", "E u/(gamma H2) = " + plain_number(r.displacement_level, 3));
  if (std::isfinite(r.wall_seconds))
    text += line("time", duration(r.wall_seconds) + " (processor " + duration(r.cpu_seconds) + ")");
  return text;
}

}  // namespace cli
