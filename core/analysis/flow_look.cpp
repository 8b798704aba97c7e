#include "analysis/flow_look.h"

#include <algorithm>
#include <cmath>

namespace vbgpd {

namespace {

/// F_e weighs as much as the flow: where the momentum has just restarted next to nothing moves, and it means nothing.
struct FlowMean {
  double sum = 0, weight = 0;
  void add(const Window& w, double what) { sum += w.external_power * what, weight += w.external_power; }
  double value() const { return sum / weight; }
};

}  // namespace

std::optional<Flow> flow_in(std::span<const Window> history, const Look& look, const TrialRules& rules,
                            std::int64_t response_steps, double elastic_displacement) {
  const auto span =
      static_cast<std::size_t>(2 * look.times * std::max<std::int64_t>(2, response_steps / (2 * kWindow)));
  if (history.size() <= span) return std::nullopt;
  const Window &now = history.back(), &half = history[history.size() - 1 - span / 2],
               &then = history[history.size() - 1 - span];
  // means of the earlier and of the later half: a flow trembles
  const auto mean = [&](std::size_t from, std::size_t to, double Window::*what) {
    double sum = 0;
    for (std::size_t k = history.size() - from; k < history.size() - to; ++k) sum += history[k].*what;
    return sum / static_cast<double>(from - to);
  };
  const auto flowing = [&](std::size_t from, std::size_t to, const auto& what) {
    FlowMean m;
    for (std::size_t k = to; k < from; ++k) {
      const Window& w = history[history.size() - 1 - k];
      m.add(w, what(w, k));
    }
    return m.value();
  };
  const auto power_ratio = [](const Window& w, std::size_t) { return w.power_ratio; };
  const double earlier = mean(span, span / 2, &Window::ratio), later = mean(span / 2, 0, &Window::ratio);
  const double power = flowing(span / 2, 0, power_ratio),
               hardening = 2 * (power - flowing(span, span / 2, power_ratio)) / look.times;
  // F_e of a jerky flow strays: RMS about the line through its two means
  const auto square = [&](const Window& w, std::size_t k) {
    const double line =
        power + (hardening * look.times / 2) * (0.5 - 2 * static_cast<double>(k) / static_cast<double>(span));
    return (w.power_ratio - line) * (w.power_ratio - line);
  };
  Flow flow;
  flow.slope = earlier > 0 && later > 0 ? 2 * std::log(later / earlier) : 0;
  flow.growth = elastic_displacement > 0 ? (now.displacement - then.displacement) / elastic_displacement : 0;
  flow.unsteadiness = std::sqrt(flowing(span, 0, square));
  const bool flows = flow.growth > look.growth && now.ratio > rules.plateau_level * rules.equilibrium;
  const bool plateau = flow.slope > rules.plateau_slope;
  const bool lasts = now.displacement - half.displacement >= half.displacement - then.displacement;
  flow.fails = flows && (look.far ? power < 1 : plateau && lasts && power + look.catching_up * hardening < 1);
  return flow;
}

std::optional<Hardening> hardening_in(std::span<const Window> history) {
  const double start = history.front().displacement, moved = history.back().displacement - start;
  if (!(moved > 0)) return std::nullopt;
  constexpr double kFrom = 0.5, kHalf = 0.75;  // shares of the displacement: two parts with middles of 5/8 and 7/8
  FlowMean earlier, later;
  for (const Window& w : history) {
    const double share = (w.displacement - start) / moved;
    if (share >= kFrom) (share < kHalf ? earlier : later).add(w, w.power_ratio);
  }
  if (!(earlier.weight > 0 && later.weight > 0)) return std::nullopt;
  const double rise = later.value() - earlier.value();
  return Hardening{later.value(), rise * std::log(16.0 / 7) / std::log(7.0 / 5)};
}

}  // namespace vbgpd
