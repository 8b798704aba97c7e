#include "simulation/sampler.h"

#include <cmath>

#include "geometry/polygon.h"
#include "simulation/linear_fit.h"

namespace vbgpd {

namespace {

std::vector<double> read(const Simulation& simulation, const char* field) {
  std::vector<double> rows;
  simulation.read(find_field(field), rows);
  return rows;
}

std::vector<Point> soil_places(const Simulation& simulation, bool deformed) {
  const std::vector<double> xy = read(simulation, deformed ? "position" : "reference_position");
  const std::vector<double> boundary = read(simulation, "boundary");
  std::vector<Point> places;  // soil particles come first
  for (std::size_t k = 0; k < boundary.size() && boundary[k] < 0; ++k) places.push_back({xy[2 * k], xy[2 * k + 1]});
  return places;
}

double length(const Simulation& simulation) {
  return simulation.scene().smoothing_ratio * std::sqrt(simulation.get("spacing_x") * simulation.get("spacing_y"));
}

}  // namespace

Sampler::Sampler(const Simulation& simulation, int field, bool deformed)
    : deformed_(deformed),
      components_(fields()[static_cast<std::size_t>(field)].components),
      kernel_(*kernel_by_name(simulation.scene().kernel)),
      smoothing_length_(length(simulation)),
      exterior_(simulation.section().exterior),
      layers_(simulation.layers()),
      places_(soil_places(simulation, deformed)),
      volumes_(read(simulation, "volume")),
      buckets_(places_, 2 * smoothing_length_) {
  if (!layers_.empty()) map_.emplace(simulation.scene());
  simulation.read(field, rows_);
  if (deformed_) displacement_ = read(simulation, "displacement");
}

void Sampler::fit(double x, double y, const std::vector<double>& rows, int components, bool& any, double* out) const {
  LinearFit plane;
  const double support = 2 * smoothing_length_;
  buckets_.near(x, y, support, [&](std::size_t k) {
    const double dx = places_[k].x - x, dy = places_[k].y - y, r = std::hypot(dx, dy);
    if (!(r < support)) return;
    plane.add(volumes_[k] * value(kernel_, r, smoothing_length_), dx / support, dy / support,
              rows.data() + k * static_cast<std::size_t>(components), components);
  });
  any = plane.weight() > 0;
  if (any) plane.value(out, components);
}

bool Sampler::soil_at(double x, double y) const {
  return contains(exterior_, Vec2(x, y)) && (!map_ || has_layer(layers_, map_->at(x, y)));
}

bool Sampler::at(double x, double y, double* out) const {
  bool any = true;
  double moved[2] = {0, 0};
  if (deformed_) fit(x, y, displacement_, 2, any, moved);
  if (any && soil_at(x - moved[0], y - moved[1])) fit(x, y, rows_, components_, any, out);
  else any = false;
  if (!any) std::fill_n(out, components_, kNone);
  return any;
}

bool Sampler::around(double x, double y, double* out) const {
  bool any = false;
  fit(x, y, rows_, components_, any, out);
  return any;
}

std::vector<Point> deformed_ground(const Simulation& simulation) {
  const std::vector<Point>& ground = simulation.section().ground;
  const Sampler displacement(simulation, find_field("displacement"), false);
  const double spacing = simulation.get("spacing_x");
  std::vector<Point> line;
  const auto add = [&](double x, double y) {
    double u[2] = {0, 0};
    displacement.around(x, y, u);
    line.push_back({x + u[0], y + u[1]});
  };
  for (std::size_t k = 0; k + 1 < ground.size(); ++k) {
    const Point &a = ground[k], &b = ground[k + 1];
    const double count = std::max(1.0, std::round(std::hypot(b.x - a.x, b.y - a.y) / spacing));
    for (double n = 0; n < count; ++n) add(a.x + (b.x - a.x) * n / count, a.y + (b.y - a.y) * n / count);
  }
  if (!ground.empty()) add(ground.back().x, ground.back().y);
  return line;
}

}  // namespace vbgpd
