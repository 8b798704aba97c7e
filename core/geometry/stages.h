// Soil that was taken away or is not placed yet: the section with some of the scene's layers switched off.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "geometry/section.h"

namespace vbgpd {

/// Which layers of a scene are there; empty = all of them.
using Layers = std::vector<bool>;

/// Whether the layer is among them; what belongs to no layer (-1) always is.
inline bool has_layer(const Layers& layers, Index layer) {
  return layers.empty() || layer < 0 || layers[static_cast<std::size_t>(layer)];
}

/// Finds the layer painted last at a place of the undeformed section.
class LayerMap {
 public:
  explicit LayerMap(const SceneDef& scene);
  /// -1 where there is none.
  Index at(Real x, Real y) const;

 private:
  Vec2 origin_;
  std::vector<Vertices> polygons_;
};

/// Makes the section that of the layers given: which seeds are there, its outline, ground, area and height, and the
/// pairs that the outline cuts. What a layer painted over does not come back when that layer goes. The outline follows
/// the polygons exactly from above and from below; what is hollow between them counts as within it.
/// Throws Error(kArgument) when no soil is left; the section is then as it was.
void keep_layers(const SceneDef& scene, const Layers& layers, Section& section);

}  // namespace vbgpd
