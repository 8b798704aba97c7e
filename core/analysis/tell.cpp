#include "analysis/tell.h"

#include <cmath>

namespace vbgpd {

namespace {

const char* name_of(Phase phase) {
  switch (phase) {
    case Phase::kGravity:
      return "elastic equilibrium under weight and loads";
    case Phase::kSearch:
      return "search";
    case Phase::kStableEnd:
      return "lower end of the bracket";
    case Phase::kFailedEnd:
      return "upper end of the bracket";
    case Phase::kSlipSurface:
      return "slip surface";
    case Phase::kRunout:
      return "run-out";
  }
  return "";
}

void tell(Log& log, const Trial& t) noexcept {
  static constexpr const char* kVerdicts[] = {"is undecided", "stands", "fails"};
  const bool undecided = t.verdict == Verdict::kUndecided;
  LogLine line;
  line << "Grid " << t.level + 1 << ": the slope " << kVerdicts[static_cast<int>(t.verdict)] << " at factor "
       << t.strength_reduction_factor << " after " << t.steps << " steps; unbalanced force ratio "
       << t.unbalanced_force_ratio << ".";
  log.add(undecided ? LogLevel::kWarning : LogLevel::kDetail, line.text());
}

void tell(Log& log, std::size_t number, const Level& l) noexcept {
  LogLine line;
  line << "Grid " << number << ", " << l.spacing_x << " m by " << l.spacing_y << " m, " << l.particles
       << " particles: ";
  if (std::isnan(l.factor_of_safety)) line << "no bracket";
  else line << "the slope stands at " << l.srf_stable << " and fails at " << l.srf_unstable;
  line << "; " << l.trials << " trials, " << l.steps << " steps, " << l.wall_seconds << " s.";
  log.add(LogLevel::kInfo, line.text());
}

}  // namespace

void Teller::look(Log* log, const Progress& progress, const JobResult& result) noexcept {
  if (log == nullptr) return;
  for (; trials_ < result.trials.size(); ++trials_) tell(*log, result.trials[trials_]);
  for (; levels_ < result.levels.size(); ++levels_) tell(*log, levels_ + 1, result.levels[levels_]);
  const int phase = static_cast<int>(progress.phase);
  if (progress.level == level_ && phase == phase_) return;
  level_ = progress.level, phase_ = phase;
  LogLine line;
  line << "Grid " << level_ + 1 << ", step " << progress.steps << ": " << name_of(progress.phase) << ".";
  log->add(LogLevel::kDetail, line.text());
}

void Teller::end(Log* log, Status outcome, const JobResult& result) const noexcept {
  if (log == nullptr) return;
  LogLine line;
  line << "The job ended: " << result.status;
  if (!std::isnan(result.factor_of_safety))
    line << ", factor of safety " << result.factor_of_safety << " +- " << result.error_estimate;
  line << "; " << result.steps << " steps, " << result.wall_seconds << " s";
  if (!result.reason.empty()) line << "; " << result.reason;
  line << ".";
  const bool smooth = outcome == Status::kOk && (result.status == "OK" || result.status == "STABLE" ||
                                                 result.status == "AT_REST" || result.status == "TIME_REACHED");
  log->add(smooth ? LogLevel::kInfo : LogLevel::kWarning, line.text());
}

}  // namespace vbgpd
