// vbgpd check: every problem of a scene, or what the scene holds and what the engine leaves out for it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bad_input.h"
#include "commands.h"
#include "exit_code.h"
#include "format.h"
#include "material_text.h"
#include "scene_file.h"

namespace cli {

namespace {

std::vector<vbgpd_feature> plan(const vbgpd_model* model) {
  std::vector<vbgpd_feature> features;
  for (std::int64_t i = 0;; ++i) {
    vbgpd_feature f{};
    f.struct_size = sizeof f;
    if (require(vbgpd_model_plan(model, i, &f), model) == VBGPD_END_OF_DATA) return features;
    features.push_back(f);
  }
}

std::vector<std::string> names(const std::vector<vbgpd_feature>& features, bool used) {
  std::vector<std::string> found;
  for (const vbgpd_feature& f : features)
    if ((f.used != 0) == used) found.push_back(f.name);
  return found;
}

/// "402 bytes per particle + 24 per bond"
std::string bytes_text(double per_particle, double per_bond) {
  std::string text = per_particle > 0 ? format("%.0f bytes per particle", per_particle) : "";
  if (per_bond > 0) text += (text.empty() ? format("%.1f bytes", per_bond) : format(" + %.1f", per_bond)) + " per bond";
  return text;
}

void print_memory(const std::vector<vbgpd_feature>& features) {
  double bytes = 0, per_particle = 0, per_bond = 0;
  for (const vbgpd_feature& f : features)
    bytes += static_cast<double>(f.bytes), per_particle += f.bytes_per_particle, per_bond += f.bytes_per_bond;
  std::printf("  %-10s %.1f MB: %s\n", "memory", bytes / 1e6, bytes_text(per_particle, per_bond).c_str());
  for (const vbgpd_feature& f : features)
    if (f.bytes > 0)
      std::printf("  %-10s   %-24s %s\n", "", f.name, bytes_text(f.bytes_per_particle, f.bytes_per_bond).c_str());
}

void print_forecast(const vbgpd_model* model) {
  std::printf(
      "  %-10s factor of safety on this grid about %s and %.1f MB (an estimate, mostly within a factor of four, "
      "less than a tenth of what soil without tension can take: %.2g s per step measured here, %s steps)\n",
      "expected", duration(number(model, "forecast_seconds")).c_str(), number(model, "forecast_bytes") / 1e6,
      number(model, "forecast_step_seconds"),
      with_thousands(static_cast<std::int64_t>(number(model, "forecast_steps"))).c_str());
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all.empty() ? "nothing" : all;
}

/// "20 to 30 kPa from x = 2 to 8 m"
std::string load_text(const vbgpd_profile* profile, std::int64_t load) {
  const auto value = [&](const char* name) { return number(profile, VBGPD_OBJECT_LOAD, load, name); };
  const double begin = value("pressure") / 1000, end = value("pressure_end") / 1000;
  return plain_number(begin, 4) + (begin == end ? "" : " to " + plain_number(end, 4)) +
         " kPa from x = " + plain_number(value("x0"), 5) + " to " + plain_number(value("x1"), 5) + " m";
}

/// "base fixed, friction 24 degrees in a run-out"
std::string boundary_text(const Scene& scene, std::int64_t boundary) {
  const vbgpd_profile* profile = scene.profile.get();
  const auto value = [&](const char* name) { return number(profile, VBGPD_OBJECT_BOUNDARY, boundary, name); };
  const auto word = [&](const char* name) { return text(profile, VBGPD_OBJECT_BOUNDARY, boundary, name); };
  const std::string side = word("side"), name = word("name");
  const std::string kind = word("kind");
  std::string line = (side.empty() ? "line" + (name.empty() ? "" : " '" + name + "'") : side) + " " + kind;
  if (kind == "velocity") line += " (" + plain_number(value("vx"), 4) + ", " + plain_number(value("vy"), 4) + ") m/s";
  const double friction = value("friction_angle");
  if (std::isfinite(friction)) line += ", friction " + plain_number(friction, 4) + " degrees in a run-out";
  return line;
}

/// What drives and what holds the soil.
template <class Say>
void print_actions(const Scene& scene, const Say& say) {
  const vbgpd_profile* profile = scene.profile.get();
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_LOAD); ++i) say("load", load_text(profile, i));
  const double kh = number(profile, VBGPD_OBJECT_PROFILE, 0, "kh"), kv = number(profile, VBGPD_OBJECT_PROFILE, 0, "kv");
  if (kh != 0 || kv != 0) say("seismic", "kh " + plain_number(kh, 4) + ", kv " + plain_number(kv, 4));
  const std::int64_t boundaries = count(profile, VBGPD_OBJECT_BOUNDARY);
  if (boundaries == 0) say("boundary", "base fixed, left and right roller (the scene gives none)");
  for (std::int64_t i = 0; i < boundaries; ++i) say("boundary", boundary_text(scene, i));
}

void print_summary(const Scene& scene, const vbgpd_model* model) {
  const vbgpd_profile* profile = scene.profile.get();
  const auto say = [](const char* name, const std::string& what) { std::printf("  %-10s %s\n", name, what.c_str()); };
  if (const std::string name = text(profile, VBGPD_OBJECT_PROFILE, 0, "name"); !name.empty()) say("name", name);
  say("section", "area " + plain_number(number(model, "area")) + " m2, slope height " +
                     plain_number(number(model, "height")) + " m");
  const auto particles = static_cast<std::int64_t>(number(model, "particles"));
  const auto bonds = static_cast<std::int64_t>(number(model, "bonds"));
  say("particles", with_thousands(particles));
  say("bonds", with_thousands(bonds));
  say("spacing",
      plain_number(number(model, "spacing_x"), 4) + " x " + plain_number(number(model, "spacing_y"), 4) + " m");
  say("kernel", text(profile, VBGPD_OBJECT_PROFILE, 0, "kernel"));
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_MATERIAL); ++i)
    say("material", text(profile, VBGPD_OBJECT_MATERIAL, i, "name") + ": " + material_text(profile, i));
  if (const std::vector<Point> table = water_table(profile); !table.empty()) {
    const auto [low, high] =
        std::minmax_element(table.begin(), table.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    say("water", "table of " + counted(static_cast<std::int64_t>(table.size()), "point") + ", elevation " +
                     plain_number(low->y, 5) + " to " + plain_number(high->y, 5) + " m");
  }
  print_actions(scene, say);
  const std::vector<vbgpd_feature> features = plan(model);
  say("uses", joined(names(features, true)));
  say("left out", joined(names(features, false)));
  print_memory(features);
  print_forecast(model);
}

}  // namespace

int run_check(const CheckOptions& options) {
  const Context context = create_context(1);
  const Scene scene = read_scene(context.get(), options.scene);
  const std::vector<Issue> issues = validate(scene);
  if (has_error(issues)) throw BadInput(options.scene, issues);
  print_issues(issues, options.scene);
  const Model model = create_model(context.get(), scene.profile.get(), options.scene);
  const std::string warnings =
      issues.empty() ? "" : ", " + counted(static_cast<std::int64_t>(issues.size()), "warning");
  std::printf("%s: the scene is sound%s\n", options.scene.c_str(), warnings.c_str());
  print_summary(scene, model.get());
  return kDone;
}

}  // namespace cli
