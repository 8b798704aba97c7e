// How the program ends; the only list of its exit codes.
#pragma once

namespace cli {

enum ExitCode : int { kDone = 0, kFailure = 1, kBadInput = 2, kNotConverged = 3, kDiverged = 4, kCancelled = 130 };

}  // namespace cli
