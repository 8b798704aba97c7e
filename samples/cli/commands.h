// The commands of the program and what each may be told.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct CheckOptions {
  std::string scene;
};

/// What is not given is taken from the scene or is the engine's default.
struct FosOptions {
  std::string scene;
  std::optional<double> spacing;               ///< m
  std::optional<int> levels;                   ///< grids
  std::optional<double> target_error, budget;  ///< of the factor of safety; wall seconds
  std::optional<std::string> scheme;
  std::optional<double> tolerance;           ///< width of the bracket
  std::optional<double> stiffness_contrast;  ///< soils at most so many times as stiff as the softest
  int threads = 1;
  std::vector<std::string> pictures;
  bool json = false, quiet = false, careful = false;
};

struct RunOptions {
  std::string scene;
  std::optional<double> spacing;  ///< m
  double time = 0;                ///< s
  double factor = 1;              ///< strength reduction factor
  int frames = 10;
  int threads = 1;
  std::string output;  ///< directory, "" = no files
  std::vector<std::string> pictures;
  bool json = false, quiet = false;
};

/// Each gives the exit code of the program, or throws BadInput.
int run_check(const CheckOptions& options);
int run_fos(const FosOptions& options);
int run_run(const RunOptions& options);

}  // namespace cli
