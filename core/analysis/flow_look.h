// What the last steps of a trial show: a flow that fails, or one on its way to rest? Numbers only, no simulation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace vbgpd {

/// Thresholds of a verdict. Ratios of forces, steps and displacements only: nothing has a dimension.
struct TrialRules {
  double equilibrium = 1e-5;    ///< stable: unbalanced force ratio below this ...
  int equilibrium_windows = 5;  ///< ... in so many windows of ten steps on end
  double plateau_slope = -0.1;  ///< failed: ln R fell by less than this over a response time ...
  double plateau_level = 3;     ///< ... and R stays above so many times `equilibrium`
  double growth =
      0.02;  ///< failed: u_max grew by this share of its elastic value over a response time, not slower than before
  double drive = 0;             ///< failed: F_e = F (internal power / external power) lies below F by this share of it
  double catching_up = 8;       ///< ... and would not have risen to it in so many response times at its present rate
  double far = 24;              ///< ... or has come to this displacement level: then it need not last
  int long_look = 12;           ///< response times over which the same growth tells a slow flow from creep to rest
  double balanced = 0;          ///< undecided at once where the flow would balance at the factor tried to within this
  int patience = 30;            ///< undecided after so many response times, or ...
  std::int64_t step_limit = 0;  ///< ... after so many steps, if any
};

inline constexpr std::int64_t kWindow = 10;  ///< relaxation steps between two readings

/// Read at the end of a window.
struct Window {
  double ratio;           ///< unbalanced force ratio
  double displacement;    ///< u_max
  double external_power;  ///< sum f_ext.v, not below 0: how fast the flow is
  double power_ratio;     ///< internal over external power
};

/// Over how many response times a flow is looked at, what it has to grow by meanwhile, and how many response times it
/// has to catch up with the factor tried; `far`: it has moved so far that whether it would come to rest in the end no
/// longer counts.
struct Look {
  int times;
  double growth, catching_up;
  bool far = false;
};

/// What a look shows: change of ln R, growth of the displacement over its elastic value, RMS by which the power ratio
/// strays, and whether that is failure.
struct Flow {
  double slope = 0, growth = 0, unsteadiness = 0;
  bool fails = false;
};

/// None before there is so much to look at. A flow that would balance at the very factor tried, or is hardening towards
/// that, is creep on the way to rest, not failure.
std::optional<Flow> flow_in(std::span<const Window> history, const Look& look, const TrialRules& rules,
                            std::int64_t response_steps, double elastic_displacement);

/// The power ratio a flow has come to, and by how much it would rise while the slope moves as far again as it has since
/// the history began: with the logarithm of the displacement, as over the later half of it.
struct Hardening {
  double power_ratio, rise;
};
/// None where nothing moved.
std::optional<Hardening> hardening_in(std::span<const Window> history);

}  // namespace vbgpd
