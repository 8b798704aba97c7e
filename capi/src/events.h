// What happened to a model: a ring of the last events, to be polled.
#pragma once

#include <array>
#include <cstdint>

#include "simulation/simulation.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {

class EventLog {
 public:
  /// Looks at a model after dynamic steps; events are told with the time at which they were noticed.
  void look(const Simulation& simulation, const Monitors& monitors, const StepReport& report) noexcept;
  void mechanism(const Simulation& simulation) noexcept;
  /// The model was taken back or forth: nothing has happened, but what counts as new has changed.
  void forget(const Simulation& simulation);
  /// Number of the newest event, 0 = none yet; the last kKept of them are there.
  std::int64_t newest() const { return newest_; }
  std::int64_t oldest() const { return newest_ > kKept ? newest_ - kKept + 1 : 1; }
  const vbgpd_event& at(std::int64_t sequence) const { return ring_[static_cast<std::size_t>(sequence % kKept)]; }

 private:
  static constexpr std::int64_t kKept = 256;
  vbgpd_event& add(std::int32_t kind, const Simulation& simulation, double value) noexcept;
  std::array<vbgpd_event, kKept> ring_{};
  std::int64_t newest_ = 0;
  bool yielded_ = false, at_rest_ = false, near_divergence_ = false;
};

}  // namespace vbgpd::capi
