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

struct Features {
  std::vector<std::string> used, left_out;
  void add(const std::string& name, bool is_used) { (is_used ? used : left_out).push_back(name); }
};

bool any_material(const vbgpd_profile* profile, bool (*has)(double), const char* property) {
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_MATERIAL); ++i)
    if (has(number(profile, VBGPD_OBJECT_MATERIAL, i, property))) return true;
  return false;
}

std::vector<std::string> laws(const vbgpd_profile* profile) {
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_MATERIAL); ++i) {
    std::string law = text(profile, VBGPD_OBJECT_MATERIAL, i, "law");
    if (std::find(names.begin(), names.end(), law) == names.end()) names.push_back(std::move(law));
  }
  return names;
}

Features features(const vbgpd_profile* profile) {
  const auto is_nonzero = [](double value) { return std::isfinite(value) && value != 0; };
  const auto is_given = [](double value) { return std::isfinite(value); };
  const auto scene_number = [&](const char* name) { return number(profile, VBGPD_OBJECT_PROFILE, 0, name); };
  Features f;
  for (const std::string& law : laws(profile)) f.add("law " + law, true);
  const std::string bond = text(profile, VBGPD_OBJECT_PROFILE, 0, "bond");
  f.add(bond == "none" ? "virtual bonds (nodal scheme instead)" : "virtual bonds", bond != "none");
  f.add("kernel " + text(profile, VBGPD_OBJECT_PROFILE, 0, "kernel"), true);
  f.add("dilatancy", any_material(profile, is_nonzero, "dilatancy_angle"));
  f.add("tension cut-off", any_material(profile, is_given, "tension_cutoff"));
  f.add("cohesion growing with depth", any_material(profile, is_nonzero, "cohesion_gradient"));
  f.add("surface loads", count(profile, VBGPD_OBJECT_LOAD) > 0);
  f.add("seismic coefficients", is_nonzero(scene_number("kh")) || is_nonzero(scene_number("kv")));
  f.add("own boundaries", count(profile, VBGPD_OBJECT_BOUNDARY) > 0);
  return f;
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all.empty() ? "nothing" : all;
}

void print_summary(const vbgpd_profile* profile, const vbgpd_model* model) {
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
  say("memory", format("%.1f MB", number(model, "bytes") / 1e6));
  for (std::int64_t i = 0; i < count(profile, VBGPD_OBJECT_MATERIAL); ++i)
    say("material", text(profile, VBGPD_OBJECT_MATERIAL, i, "name") + ": " + material_text(profile, i));
  const Features f = features(profile);
  say("uses", joined(f.used));
  say("left out", joined(f.left_out));
}

}  // namespace

int run_check(const CheckOptions& options) {
  const Context context = create_context(1);
  const Profile profile = read_scene(context.get(), options.scene).profile;
  const std::vector<Issue> issues = validate(profile.get());
  if (has_error(issues)) throw BadInput(options.scene, issues);
  print_issues(issues, options.scene);
  const Model model = create_model(context.get(), profile.get(), options.scene);
  const std::string warnings =
      issues.empty() ? "" : ", " + counted(static_cast<std::int64_t>(issues.size()), "warning");
  std::printf("%s: the scene is sound%s\n", options.scene.c_str(), warnings.c_str());
  print_summary(profile.get(), model.get());
  return kDone;
}

}  // namespace cli
