// compile: the one place that sees all choices.
#include "geometry/check.h"
#include "simulation/flow_simulation.h"
#include "simulation/image_reader.h"

namespace vbgpd {

namespace {

/// The other grids of jobs have the same scene; what is wrong with it is said once.
bool is_first(const CompileOptions& options) { return options.spacing_factor == 1 && options.coarsening == 1; }

void tell(Log& log, const Simulation& made, std::string_view isa) noexcept {
  LogLine line;
  line << "Model of " << made.particle_count() << " particles and " << made.bond_count() << " bonds, "
       << made.section().lattice.spacing.x() << " m by " << made.section().lattice.spacing.y() << " m, "
       << made.memory().total() << " bytes, steps for " << isa << " on " << made.options().threads << " threads.";
  log.add(LogLevel::kInfo, line.text());
  constexpr double kOff = 0.1;  // as in the estimate of a job
  const double misfit = made.section().lattice.misfit.maxCoeff();
  if (!(misfit > kOff) || !is_first(made.options())) return;
  LogLine warning;
  warning << "Key lines of the profile lie up to " << misfit
          << " of a coarse cell off the cell edges; estimates are widened.";
  log.add(LogLevel::kWarning, warning.text());
}

}  // namespace

std::unique_ptr<Simulation> Simulation::compile(const SceneDef& scene, const CompileOptions& options) {
  Issue all;
  bool first = true;
  for (const Issue& issue : all_issues(scene)) {
    if (issue.severity != Severity::kError) {
      if (options.log && is_first(options)) options.log->add(LogLevel::kWarning, issue.text);
      continue;
    }
    if (first) all = issue;
    else all.text += "\n" + issue.text;
    first = false;
  }
  if (!first) throw Error(all);
  auto made = std::make_unique<LatticeSimulation>(scene, options, best_kernels());
  if (options.log) tell(*options.log, *made, best_kernels().isa);
  return made;
}

std::unique_ptr<Simulation> Simulation::restored(const SceneDef& scene, const CompileOptions& options,
                                                 const StateImage& image) {
  CompileOptions limited = options;
  // More particles than the image holds could only come from another scene. That of a run-out holds the soil; walls
  // come on top while the model it is made from lives.
  limited.max_particles = image.runs_out ? 16 * image.particles + 4096 : image.particles;
  std::unique_ptr<Simulation> made = compile(scene, limited);
  static_cast<LatticeSimulation&>(*made).limit_particles(options.max_particles);
  if (image.runs_out) {
    try {
      if (const Layers layers = layers_of(image, scene.layers.size()); !layers.empty()) made->set_layers(layers);
    } catch (const Error& error) {
      if (error.issue().status == Status::kArgument) refuse_image("has layers that cannot be: " + error.issue().text);
      throw;
    }
    made = make_runout(*made);
  }
  made->restore_image(image);
  return made;
}

}  // namespace vbgpd
