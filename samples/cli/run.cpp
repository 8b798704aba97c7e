// vbgpd run: lets a slope move and writes down what it does.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "bad_input.h"
#include "commands.h"
#include "exit_code.h"
#include "format.h"
#include "interrupt.h"
#include "picture_file.h"
#include "progress.h"
#include "run_picture.h"
#include "run_result.h"
#include "vtk_file.h"

namespace cli {

namespace {

constexpr int kSamplesPerFrame = 10;

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw BadInput(file.string(), std::string("the file could not be written: ") + std::strerror(errno));
}

Scene load(vbgpd_context* context, const RunOptions& options, std::vector<std::string>& warnings) {
  Scene scene = read_scene(context, options.scene);
  if (options.spacing) set_number(scene, "--spacing", "spacing", *options.spacing);
  const std::vector<Issue> issues = validate(scene);
  if (has_error(issues)) throw BadInput(options.scene, issues);
  print_issues(issues, options.scene);
  for (const Issue& issue : issues) warnings.push_back(issue.text);
  return scene;
}

Model runout_of(vbgpd_model* at_rest, double factor) {
  if (vbgpd_model_set_f64(at_rest, "strength_reduction_factor", VBGPD_STRLEN, factor) < 0)
    throw BadInput("--factor", errors_of(error_text(at_rest)));
  vbgpd_model* handle = nullptr;
  require(vbgpd_model_create_runout(at_rest, &handle), at_rest);
  return Model(handle);
}

/// One run from start to rest, in pieces of a sample each.
class Run {
 public:
  Run(const RunOptions& options, const Scene& scene, vbgpd_model* model)
      : options_(options), scene_(scene), model_(model), line_(!options.quiet, 1) {
    result_.factor = options.factor;
    result_.particles = static_cast<std::int64_t>(number(model, "particles"));
    result_.spacing = std::sqrt(number(model, "spacing_x") * number(model, "spacing_y"));
    result_.viscosity = number(model, "viscosity");
    result_.kh = number(model, "kh"), result_.kv = number(model, "kv");
  }

  vbgpd_status go() {
    const auto start = std::chrono::steady_clock::now();
    const int samples = options_.frames * kSamplesPerFrame;
    vbgpd_status status = VBGPD_OK;
    bool ended = false;
    for (int k = 0; k <= samples && !ended; ++k) {
      status = advance(options_.time * std::max(k, 0) / samples, k == 0);
      ended = status != VBGPD_OK || result_.status == "AT_REST";
      if (k % kSamplesPerFrame == 0 || k == samples || ended) frame();
    }
    line_.clear();
    result_.peak_kinetic_energy = number(model_, "peak_kinetic_energy");
    result_.max_displacement = number(model_, "max_displacement");
    result_.steps = static_cast<std::int64_t>(number(model_, "steps"));
    result_.ground = ground_surface(model_);
    result_.hash = state_hash(model_);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    result_.wall_seconds = taken.count();
    if (!options_.output.empty()) {
      write_file(directory() / "series.csv", series_csv(result_.series));
      write_file(directory() / "ground.csv", ground_csv(result_.ground));
      write_file(directory() / "run.pvd", collection_pvd(frames_));
      remove_frames_of_a_longer_run();
    }
    return status;
  }
  RunResult& result() { return result_; }

 private:
  std::filesystem::path directory() const { return options_.output; }

  /// To `time`, or to rest. The first piece only brings gravity on.
  vbgpd_status advance(double time, bool first) {
    vbgpd_job* handle = nullptr;
    require(vbgpd_job_create_runout(model_, &handle), model_);
    const Job job(handle);
    const double end = first ? 1e-9 * options_.time : time;
    require(vbgpd_job_set_f64(handle, "end_time", VBGPD_STRLEN, end), handle);
    interrupt_.watch(handle);
    const auto on_progress = [](void* user, const vbgpd_progress* progress) -> std::int32_t {
      auto& run = *static_cast<Run*>(user);
      vbgpd_progress shown = *progress;
      shown.fraction = progress->phase == 6 ? progress->fraction * run.aim_ / run.options_.time : 0;
      run.line_.show(shown);
      return InterruptGuard::requested();
    };
    aim_ = end;
    vbgpd_status status = vbgpd_job_run(handle, 0, on_progress, this, nullptr);
    interrupt_.watch(nullptr);
    if (status != VBGPD_E_DIVERGED) require(status, handle);
    result_.status = status == VBGPD_CANCELLED ? "CANCELLED" : text(handle, "status");
    result_.reason = status == VBGPD_CANCELLED ? "stopped on request" : text(handle, "reason");
    if (status == VBGPD_E_DIVERGED) result_.status = "DIVERGED", result_.reason = error_text(handle);
    result_.scheme = text(handle, "scheme"), result_.flow_rule = text(handle, "flow_rule");
    if (status == VBGPD_CANCELLED) conclude_here();
    if (status != VBGPD_OK) return status;
    take_sample(handle);
    return status;
  }

  /// A run that was stopped on request tells what it has done, too.
  void conclude_here() {
    if (!result_.series.empty() && result_.series.back().time == number(model_, "time")) return;
    vbgpd_job* handle = nullptr;
    require(vbgpd_job_create_runout(model_, &handle), model_);
    const Job job(handle);
    if (vbgpd_job_set_f64(handle, "end_time", VBGPD_STRLEN, number(model_, "time")) < 0) return;  // it has not begun
    require(vbgpd_job_run(handle, 0, nullptr, nullptr, nullptr), handle);
    take_sample(handle);
  }

  void take_sample(vbgpd_job* handle) {
    Sample s;
    s.time = number(model_, "time"), s.kinetic_energy = number(model_, "kinetic_energy");
    s.plastic_fraction = number(handle, "plastic_fraction"), s.crest_settlement = number(handle, "crest_settlement");
    s.toe_displacement = number(handle, "toe_displacement"), s.runout_distance = number(handle, "runout_distance");
    s.moved_area = number(handle, "moved_area"), s.energy_residual = number(handle, "energy_residual");
    if (result_.series.empty()) settled_under_gravity_ = s.crest_settlement;
    s.crest_settlement = std::max(0.0, s.crest_settlement - settled_under_gravity_);
    result_.series.push_back(s);
  }

  void frame() {
    if (options_.output.empty()) return;
    const std::string name = frame_name(frames_.size());
    write_file(directory() / (name + ".vtu"), particles_vtu(model_));
    write_picture(run_sheet(scene_, model_, result_), (directory() / (name + ".png")).string());
    frames_.emplace_back(name + ".vtu", number(model_, "time"));
  }

  static std::string frame_name(std::size_t number) { return format("frame_%04zu", number); }

  /// A directory used before would go on, in an animation, with frames of the run before.
  void remove_frames_of_a_longer_run() const {
    const auto removed = [&](std::size_t number, const char* kind) {
      std::error_code none;
      return std::filesystem::remove(directory() / (frame_name(number) + kind), none);
    };
    bool any = true;
    for (std::size_t number = frames_.size(); any; ++number) {
      const bool particles = removed(number, ".vtu"), picture = removed(number, ".png");
      any = particles || picture;
    }
  }

  const RunOptions& options_;
  const Scene& scene_;
  vbgpd_model* model_;
  ProgressLine line_;
  InterruptGuard interrupt_;
  double settled_under_gravity_ = 0;  // elastic, by weight alone: no movement of a slope
  RunResult result_;
  std::vector<std::pair<std::string, double>> frames_;
  double aim_ = 0;
};

int exit_code(vbgpd_status outcome) {
  if (outcome == VBGPD_OK) return kDone;
  if (outcome == VBGPD_CANCELLED) return kCancelled;
  return outcome == VBGPD_E_DIVERGED ? kDiverged : kNotConverged;
}

void prepare(const RunOptions& options) {
  for (const std::string& file : options.pictures) require_writable_picture(file);
  if (options.output.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(options.output, error);
  if (error) throw BadInput("--output", "the directory '" + options.output + "' cannot be made: " + error.message());
}

int run_scene(const RunOptions& options, RunResult& result) {
  prepare(options);
  const Context context = create_context(options.threads);
  const Scene scene = load(context.get(), options, result.warnings);
  Model model;
  {
    const Model at_rest = create_model(context.get(), scene.profile.get(), options.scene);
    model = runout_of(at_rest.get(), options.factor);
  }
  Run run(options, scene, model.get());
  run.result().warnings = result.warnings;
  const vbgpd_status outcome = run.go();
  result = run.result();
  const std::string name = text(scene.profile.get(), VBGPD_OBJECT_PROFILE, 0, "name");
  std::printf("%s", options.json ? (to_json(result) + "\n").c_str() : to_text(result, name).c_str());
  if (outcome != VBGPD_CANCELLED)
    for (const std::string& file : options.pictures) write_picture(run_sheet(scene, model.get(), result), file);
  return exit_code(outcome);
}

}  // namespace

int run_run(const RunOptions& options) {
  RunResult result;
  const auto fail = [&](const char* status) {
    if (!options.json) return;
    result.status = status;
    std::printf("%s\n", to_json(result).c_str());
  };
  try {
    return run_scene(options, result);
  } catch (const BadInput& bad) {
    for (const Issue& issue : bad.issues()) (issue.error ? result.errors : result.warnings).push_back(issue.text);
    fail("BAD_INPUT");
    throw;
  } catch (const std::exception& error) {
    result.errors.push_back(error.what());
    fail("FAILED");
    throw;
  }
}

}  // namespace cli
