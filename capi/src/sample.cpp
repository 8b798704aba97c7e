// Fields at any place: points, lines, rasters, the ground surface.
#include <cmath>

#include "analysis/runout_shape.h"
#include "arrays.h"
#include "guard.h"
#include "selection.h"
#include "simulation/sampler.h"

namespace vbgpd::capi {
namespace {

/// Where the values and the marks go; the numbers are those of the arguments.
struct Target {
  double* dst;
  std::int64_t stride_item, stride_component;
  std::int64_t* inside;
  std::int64_t stride_inside;
  int argument;  // of dst; its strides, inside and the stride of inside follow
};

const FieldInfo& sampled_field(std::int32_t field) {
  const FieldInfo& info = field_in(field, 2);
  if (info.location == Location::kParticle && info.type == FieldType::kReal) return info;
  throw ArgumentError(2, Status::kArgument,
                      std::string("The field ") + info.name + " cannot be sampled: only real fields of particles can.");
}

/// Samples at place(i) for i = 0 .. n - 1.
template <class Place>
void sample(const Simulation& simulation, std::int32_t field, std::int64_t n, const Target& target,
            const Place& place) {
  const FieldInfo& info = sampled_field(field);
  if (n == 0) return;
  require_not_null(target.dst, target.argument, "dst");
  const Strides strides =
      strides_in(target.stride_item, target.stride_component, info.components, n, target.argument + 1);
  const std::int64_t mark_stride =
      target.inside == nullptr ? 8 : stride_in(target.stride_inside, n, target.argument + 4);
  const Sampler sampler(simulation, field, true);
  std::vector<double> rows(static_cast<std::size_t>(n * info.components));
  std::vector<std::int64_t> marks(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) {
    const Point p = place(i);
    marks[static_cast<std::size_t>(i)] = sampler.at(p.x, p.y, &rows[static_cast<std::size_t>(i * info.components)]);
  }
  scatter(rows, info.components, strides, target.dst);
  if (target.inside != nullptr) scatter(marks, 1, {mark_stride, 8}, target.inside);
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_sample_points(const vbgpd_model* model, int32_t field, const double* xy, int64_t stride_xy,
                                       int64_t n, double* dst, int64_t stride_item, int64_t stride_component,
                                       int64_t* inside, int64_t stride_inside) {
  return with(model, [&](ModelObject& object) {
    const Polygon places = points_in(xy, stride_xy, n, 3);
    sample(*object.engine->simulation, field, n, {dst, stride_item, stride_component, inside, stride_inside, 6},
           [&](std::int64_t i) { return places[static_cast<std::size_t>(i)]; });
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_sample_line(const vbgpd_model* model, int32_t field, double x0, double y0, double x1,
                                     double y1, int64_t n, double* dst, int64_t stride_item, int64_t stride_component,
                                     int64_t* inside, int64_t stride_inside) {
  return with(model, [&](ModelObject& object) {
    require_count(n, 7, "places");
    sample(*object.engine->simulation, field, n, {dst, stride_item, stride_component, inside, stride_inside, 8},
           [&](std::int64_t i) {
             const double t = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
             return Point{x0 + t * (x1 - x0), y0 + t * (y1 - y0)};
           });
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_sample_grid(const vbgpd_model* model, int32_t field, double x0, double y0, double dx,
                                     double dy, int64_t nx, int64_t ny, double* dst, int64_t stride_item,
                                     int64_t stride_component, int64_t* inside, int64_t stride_inside) {
  return with(model, [&](ModelObject& object) {
    require_count(nx, 7, "columns");
    require_count(ny, 8, "rows");
    if (ny > 0 && nx > (std::int64_t{1} << 31) / ny)
      throw ArgumentError(7, Status::kArgument, "A raster has at most 2^31 places.");
    sample(*object.engine->simulation, field, nx * ny, {dst, stride_item, stride_component, inside, stride_inside, 9},
           [&](std::int64_t i) {
             return Point{x0 + static_cast<double>(i % nx) * dx, y0 + static_cast<double>(i / nx) * dy};
           });
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_ground_surface(const vbgpd_model* model, double* xy, int64_t stride, int64_t cap, int64_t* n) {
  return with(model, [&](ModelObject& object) {
    const Simulation& simulation = *object.engine->simulation;
    points_out(simulation.runs_out() ? ground_surface(simulation) : deformed_ground(simulation), xy, stride, cap, n, 2);
    return Status::kOk;
  });
}
