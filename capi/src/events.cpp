#include "events.h"

#include <algorithm>
#include <cstring>

#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

/// The bond that turned plastic most: its ends and its middle.
void find_yielded(const Simulation& simulation, vbgpd_event& event) {
  std::vector<double> strain, xy;
  std::vector<std::int64_t> ends;
  simulation.read(find_field("bond_plastic_strain"), strain);
  simulation.read(find_field("bond_particles"), ends);
  simulation.read(find_field("position"), xy);
  if (strain.empty()) return;
  const auto bond = static_cast<std::size_t>(std::max_element(strain.begin(), strain.end()) - strain.begin());
  event.id_a = ends[2 * bond], event.id_b = ends[2 * bond + 1];
  const auto a = static_cast<std::size_t>(event.id_a), b = static_cast<std::size_t>(event.id_b);
  event.x = (xy[2 * a] + xy[2 * b]) / 2, event.y = (xy[2 * a + 1] + xy[2 * b + 1]) / 2;
  event.value = strain[bond];
}

}  // namespace

vbgpd_event& EventLog::add(std::int32_t kind, const Simulation& simulation, double value) noexcept {
  vbgpd_event& event = ring_[static_cast<std::size_t>(++newest_ % kKept)];
  event = {};
  event.struct_size = sizeof event;
  event.kind = kind;
  event.sequence = newest_;
  event.id_a = event.id_b = -1;
  event.x = event.y = kNone;
  event.value = value;
  event.step = static_cast<std::int64_t>(simulation.get("steps"));
  event.time = simulation.get("time");
  return event;
}

void EventLog::look(const Simulation& simulation, const Monitors& monitors, const StepReport& report) noexcept {
  constexpr double kRest = 1e-5;                    // of the forces, as in the search for the factor of safety
  constexpr double kFast = 0.2, kUnbalanced = 0.5;  // shares of the limits: an unstable speed trebles from step to step
  const bool near = report.speed_share > kFast || report.energy_share > kUnbalanced;
  if (near && !near_divergence_)
    add(VBGPD_EVENT_NEAR_DIVERGENCE, simulation, std::max(report.speed_share, report.energy_share));
  near_divergence_ = near;
  if (report.status == Status::kDiverged) add(VBGPD_EVENT_DIVERGED, simulation, kNone);
  if (monitors.plastic_bonds > 0 && !yielded_) {
    vbgpd_event& event = add(VBGPD_EVENT_FIRST_YIELD, simulation, kNone);
    try {
      find_yielded(simulation, event);
    } catch (...) {  // out of memory: that it yielded is known, where is not
    }
  }
  yielded_ = monitors.plastic_bonds > 0;
  const bool rest = monitors.unbalanced_force_ratio < kRest && simulation.get("steps") > 0;
  if (rest && !at_rest_) add(VBGPD_EVENT_AT_REST, simulation, monitors.unbalanced_force_ratio);
  at_rest_ = rest;
}

void EventLog::mechanism(const Simulation& simulation) noexcept {
  add(VBGPD_EVENT_MECHANISM, simulation, simulation.get("strength_reduction_factor"));
  yielded_ = true, at_rest_ = near_divergence_ = false;
}

void EventLog::forget(const Simulation& simulation) {
  yielded_ = simulation.get("plastic_bonds") > 0;
  at_rest_ = near_divergence_ = false;
}

}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_events_read(vbgpd_model* model, int64_t after, vbgpd_event* dst, int64_t stride, int64_t cap,
                                     int64_t* n, int64_t* dropped) {
  return with(model, [&](ModelObject& object) {
    const EventLog& events = object.engine->events;
    if (cap < 0)
      throw ArgumentError(5, Status::kArgument,
                          "The capacity is " + std::to_string(cap) + " events; it must be 0 or more.");
    const std::int64_t seen = std::clamp<std::int64_t>(after, 0, events.newest());
    const std::int64_t first = std::max(events.oldest(), seen + 1);
    const std::int64_t count = std::max<std::int64_t>(0, events.newest() - first + 1);
    if (cap > 0) {
      require_struct(dst, 3);
      if (stride < static_cast<std::int64_t>(dst->struct_size))
        throw ArgumentError(4, Status::kArgument,
                            "The stride is " + std::to_string(stride) + " bytes; an event of the caller has " +
                                std::to_string(dst->struct_size) + ".");
    }
    const std::int64_t given = std::min(count, cap);
    const std::uint32_t size = cap > 0 ? dst->struct_size : 0;
    for (std::int64_t k = 0; k < given; ++k) {
      vbgpd_event event = events.at(first + k);
      event.struct_size = size;
      // at a stride of the caller nothing need be aligned
      std::memcpy(reinterpret_cast<char*>(dst) + k * stride, &event, std::min<std::size_t>(size, sizeof event));
    }
    if (n != nullptr) *n = cap == 0 ? count : given;
    if (dropped != nullptr) *dropped = first - 1 - seen;
    return Status::kOk;
  });
}
