// vbgpd: factor of safety and critical slip surface of a soil slope, from the command line.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>

#include "bad_input.h"
#include "commands.h"
#include "exit_code.h"
#include "scene_file.h"

namespace {

/// CLI11's own says "not in range 0 to 1797693134862315...".
CLI::Validator positive_number() {
  const auto check = [](std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value);
    return good ? std::string() : "'" + text + "' is not a number greater than 0";
  };
  return {check, "POSITIVE", "POSITIVE"};
}

using namespace cli;

void describe_check(CLI::App& app, CheckOptions& options) {
  app.add_option("SCENE", options.scene, "scene file (JSON)")->required();
}

void describe_fos(CLI::App& app, FosOptions& options) {
  app.add_option("SCENE", options.scene, "scene file (JSON)")->required();
  app.add_option("--spacing", options.spacing, "m between particles of the finest grid, instead of the scene's")
      ->type_name("H")
      ->check(positive_number());
  app.add_option("--levels", options.levels,
                 "grids, coarse to fine, the last with the scene's spacing (default 2); 1 = no extrapolation")
      ->type_name("N")
      ->check(CLI::Range(1, 5));
  app.add_option("--target-error", options.target_error,
                 "end when the error estimate, a factor of safety, is this small; without --levels grids may get finer "
                 "than the scene's spacing")
      ->type_name("E")
      ->check(CLI::Range(1e-3, 1.0));
  app.add_option("--budget", options.budget,
                 "seconds: begin no grid that would outlast them; may get finer like that too")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e9));
  app.add_option("--scheme", options.scheme, "virtual_bond or none (corrected nodal SPH), instead of the scene's")
      ->type_name("NAME")
      ->check(CLI::IsMember({"virtual_bond", "none"}));
  app.add_option("--threads", options.threads, "threads (default 1), 0 = all cores; the result does not depend on it")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  app.add_option("--tolerance", options.tolerance,
                 "width of the bracket asked for, a factor of safety, instead of the scene's")
      ->type_name("T")
      ->check(positive_number());
  app.add_option("--stiffness-contrast", options.stiffness_contrast,
                 "soils count as at most this many times as stiff as the softest one (default 3)")
      ->type_name("R")
      ->check(CLI::Range(1.0, 1e12));
  app.add_option("--picture", options.pictures,
                 "draw the section, the plastic strain and the slip surface; may be repeated")
      ->type_name("FILE.svg|.png|.pdf")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_flag("--json", options.json, "print the result as one JSON object");
  app.add_flag("--quiet", options.quiet, "no progress line");
  app.add_flag("--careful", options.careful, "plain bisection from the gravity state instead of the fast search");
}

void describe_run(CLI::App& app, RunOptions& options) {
  app.add_option("SCENE", options.scene, "scene file (JSON)")->required();
  app.add_option("--time", options.time, "simulated time to stop at, s; the run ends before when all is at rest")
      ->type_name("T")
      ->required()
      ->check(positive_number());
  app.add_option("--factor", options.factor, "strength reduction factor: c and tan phi are divided by it (default 1)")
      ->type_name("F")
      ->check(positive_number());
  app.add_option("--frames", options.frames, "how many pictures and particle files between start and T (default 10)")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  app.add_option("--output", options.output,
                 "directory for series.csv, ground.csv, run.pvd and a .vtu and .png a frame (those of a run before are "
                 "replaced)")
      ->type_name("DIR");
  app.add_option("--spacing", options.spacing, "m between particles, instead of the scene's")
      ->type_name("H")
      ->check(positive_number());
  app.add_option("--threads", options.threads, "threads (default 1), 0 = all cores; the result does not depend on it")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  app.add_option("--picture", options.pictures, "draw the final state; may be repeated")
      ->type_name("FILE.svg|.png|.pdf")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_flag("--json", options.json, "print the result as one JSON object");
  app.add_flag("--quiet", options.quiet, "no progress line");
}

/// The command's exit code; whatever the user can put right is said in one line per problem.
template <class Command, class Options>
int guarded(Command command, const Options& options) {
  try {
    return command(options);
  } catch (const BadInput& bad) {
    print_issues(bad.issues(), bad.subject());
    return kBadInput;
  } catch (const EngineError& error) {
    std::fprintf(stderr, "%s: error: %s (%s)\n", options.scene.c_str(), error.what(),
                 vbgpd_status_name(error.status()));
    return error.status() == VBGPD_E_UNSUPPORTED ? kBadInput : kFailure;  // the scene asks for what the engine lacks
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: error: %s\n", options.scene.c_str(), error.what());
    return kFailure;
  }
}

}  // namespace

/// What was printed must have arrived: a full disk is a failure.
int delivered(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fprintf(stderr, "error: the output could not be written: %s\n", std::strerror(errno));
  return kFailure;
}

int main(int argc, char** argv) {
  CLI::App app{"Stability of soil slopes by virtual-bond general particle dynamics"};
  app.set_version_flag("--version", std::string("vbgpd ") + vbgpd_version_string());
  app.require_subcommand(1);
  app.footer("Exit code: 0 done, 1 failure, 2 bad input, 3 not converged, 4 diverged, 130 cancelled.");
  CheckOptions check_options;
  FosOptions fos_options;
  RunOptions run_options;
  CLI::App* check = app.add_subcommand("check", "say what is wrong with a scene, or what it holds");
  CLI::App* fos = app.add_subcommand("fos", "factor of safety and critical slip surface by strength reduction");
  CLI::App* run = app.add_subcommand("run", "let the slope move, from the first plastic bonds to rest");
  describe_check(*check, check_options);
  describe_fos(*fos, fos_options);
  describe_run(*run, run_options);
  const auto is_known = [&](const CLI::App* command) { return command->check_name(argv[1]); };
  const CLI::App* const commands[] = {check, fos, run};
  if (argc > 1 && argv[1][0] != '-' && std::none_of(std::begin(commands), std::end(commands), is_known)) {
    std::fprintf(stderr, "There is no command \"%s\": use check, fos or run.\nRun with --help for more information.\n",
                 argv[1]);
    return kBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  if (run->parsed()) return delivered(guarded(run_run, run_options));
  return delivered(check->parsed() ? guarded(run_check, check_options) : guarded(run_fos, fos_options));
}
