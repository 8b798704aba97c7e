// What every job shares: running its coroutine in wall-clock slices, cancel, progress, options.
#pragma once

#include <map>

#include "analysis/job.h"
#include "analysis/slices.h"
#include "analysis/tell.h"
#include "analysis/trial.h"

namespace vbgpd {

class SliceJob : public Job {
 public:
  explicit SliceJob(Simulation& simulation);
  Status run(double wall_seconds, const Callback& callback) final;
  void cancel() noexcept final { cancel_.store(true, std::memory_order_relaxed); }
  void set(std::string_view name, double value) final;
  double get(std::string_view name) const final;
  bool started() const final { return started_; }
  bool finished() const final { return finished_; }
  const Progress& progress() const final { return progress_; }
  const JobResult& result() const final { return result_; }

 protected:
  /// The whole analysis as one coroutine; fills result_ and returns the final status through outcome_.
  virtual Slices analysis() = 0;
  /// Before the first run: throws Error(kRange) for options that contradict each other; they can then be set again.
  virtual void check_options() const {}
  double option(std::string_view name) const { return options_.at(std::string(name)); }

  Simulation& simulation_;
  Progress progress_;
  JobResult result_;
  Status outcome_ = Status::kOk;

 private:
  std::map<std::string, double> options_;
  Slices slices_;
  Teller teller_;
  std::atomic<bool> cancel_{false};
  bool started_ = false, finished_ = false;
};

/// Throws Error(kState) for a model that runs out: its bonds come and go, so there is no section left to search.
void require_fixed_bonds(const Simulation& simulation, std::string_view what);

}  // namespace vbgpd
