// A field of a simulation at any place, by the kernel of the method.
#pragma once

#include <optional>
#include <vector>

#include "geometry/stages.h"
#include "simulation/buckets.h"
#include "simulation/simulation.h"
#include "smoothing/any_kernel.h"

namespace vbgpd {

/// Weights are V_j W(|x - x_j|); the plane fitted with them reproduces linear fields exactly. Wall particles take no
/// part.
class Sampler {
 public:
  /// `deformed`: places are meant in the present shape of the section, otherwise in the undeformed one.
  Sampler(const Simulation& simulation, int field, bool deformed);
  /// False, and NaN, where there is no soil.
  bool at(double x, double y, double* out) const;
  /// The same on the rim and a little beyond it: false only where no soil particle is within reach.
  bool around(double x, double y, double* out) const;
  int components() const { return components_; }

 private:
  bool soil_at(double x, double y) const;
  void fit(double x, double y, const std::vector<double>& rows, int components, bool& any, double* out) const;
  bool deformed_;
  int components_;
  AnyKernel kernel_;
  double smoothing_length_;
  Polygon exterior_;
  std::optional<LayerMap> map_;  ///< where layers are switched off
  Layers layers_;
  std::vector<Point> places_;
  std::vector<double> volumes_, rows_, displacement_;
  Buckets buckets_;
};

/// The ground surface in its present shape, left to right, a point about every particle spacing.
std::vector<Point> deformed_ground(const Simulation& simulation);

}  // namespace vbgpd
