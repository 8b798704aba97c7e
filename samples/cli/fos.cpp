// vbgpd fos: factor of safety and critical slip surface of a scene.
#include <cstdio>
#include <optional>

#include "bad_input.h"
#include "commands.h"
#include "exit_code.h"
#include "fos_result.h"
#include "interrupt.h"
#include "picture/sheet.h"
#include "picture_file.h"
#include "progress.h"
#include "scene_file.h"

namespace cli {

namespace {

/// How many grids there will be; 0 = as many as it takes.
int grid_count(const FosOptions& options) {
  constexpr int kDefault = 2;
  return options.levels.value_or(options.target_error || options.budget ? 0 : kDefault);
}

void apply(const FosOptions& options, Scene& scene) {
  if (options.spacing) set_number(scene, "--spacing", "spacing", *options.spacing);
  if (options.tolerance) set_number(scene, "--tolerance", "srf_tolerance", *options.tolerance);
  if (options.scheme) set_text(scene, "--scheme", "bond", *options.scheme);
}

/// The scene with the options applied and no error left in it; its warnings are said at once.
Scene load(vbgpd_context* context, const FosOptions& options, std::vector<std::string>& warnings) {
  Scene scene = read_scene(context, options.scene);
  apply(options, scene);
  const std::vector<Issue> issues = validate(scene);
  if (has_error(issues)) throw BadInput(options.scene, issues);
  print_issues(issues, options.scene);
  for (const Issue& issue : issues) warnings.push_back(issue.text);
  return scene;
}

Job create_job(const FosOptions& options, vbgpd_model* model) {
  vbgpd_job* handle = nullptr;
  require(vbgpd_job_create_strength_reduction(model, &handle), model);
  Job job(handle);
  const auto set = [&](const char* name, double value) {
    require(vbgpd_job_set_f64(handle, name, VBGPD_STRLEN, value), handle);
  };
  if (options.levels) set("levels", *options.levels);
  if (options.target_error) set("target_error", *options.target_error);
  if (options.budget) set("budget", *options.budget);
  if (options.stiffness_contrast) set("stiffness_contrast", *options.stiffness_contrast);
  if (options.careful) set("careful", 1);
  return job;
}

/// Runs to the end, or until an interrupt.
vbgpd_status run(vbgpd_job* job, ProgressLine& line) {
  InterruptGuard interrupt;
  interrupt.watch(job);
  const auto on_progress = [](void* user, const vbgpd_progress* progress) -> std::int32_t {
    static_cast<ProgressLine*>(user)->show(*progress);
    return InterruptGuard::requested();
  };
  const vbgpd_status status = vbgpd_job_run(job, 0, on_progress, &line, nullptr);
  line.clear();
  return status == VBGPD_E_DIVERGED ? status : require(status, job);
}

int exit_code(vbgpd_status outcome) {
  switch (outcome) {
    case VBGPD_OK:
      return kDone;
    case VBGPD_CANCELLED:
      return kCancelled;
    case VBGPD_E_DIVERGED:
      return kDiverged;
    default:
      return kNotConverged;
  }
}

struct Analysis {
  FosResult result;
  std::string scene_name;
  int code = kFailure;
  std::optional<picture::Sheet> sheet;
};

Analysis analyse(const FosOptions& options) {
  for (const std::string& file : options.pictures) require_writable_picture(file);
  const Context context = create_context(options.threads);
  std::vector<std::string> warnings;
  const Scene scene = load(context.get(), options, warnings);
  const Model model = create_model(context.get(), scene.profile.get(), options.scene);
  const Job job = create_job(options, model.get());
  ProgressLine line(!options.quiet, grid_count(options));
  const vbgpd_status outcome = run(job.get(), line);
  Analysis a;
  a.result = read_result(job.get(), model.get(), outcome);
  a.result.warnings = std::move(warnings);
  a.scene_name = text(scene.profile.get(), VBGPD_OBJECT_PROFILE, 0, "name");
  a.code = exit_code(outcome);
  if (outcome != VBGPD_CANCELLED && !options.pictures.empty()) a.sheet = picture_sheet(scene, model.get(), a.result);
  return a;
}

/// The JSON object of a search that did not take place.
void print_failure(const char* status, const std::vector<Issue>& issues) {
  FosResult result;
  result.status = status;
  for (const Issue& issue : issues) (issue.error ? result.errors : result.warnings).push_back(issue.text);
  std::printf("%s\n", to_json(result).c_str());
}

}  // namespace

int run_fos(const FosOptions& options) {
  Analysis a;
  try {
    a = analyse(options);
  } catch (const BadInput& bad) {
    if (options.json) print_failure("BAD_INPUT", bad.issues());
    throw;
  } catch (const std::exception& error) {
    if (options.json) print_failure("FAILED", {{true, error.what()}});
    throw;
  }
  std::printf("%s", options.json ? (to_json(a.result) + "\n").c_str() : to_text(a.result, a.scene_name).c_str());
  if (a.sheet)
    for (const std::string& file : options.pictures) write_picture(*a.sheet, file);
  return a.code;
}

}  // namespace cli
