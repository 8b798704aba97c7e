#include "simulation/scattered.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "simulation/linear_fit.h"

namespace vbgpd {

namespace {

constexpr std::size_t kNearest = 8, kMost = 512;

/// A bucket for about two nodes.
double bucket_size(const std::vector<Point>& nodes) {
  double x0 = nodes[0].x, x1 = x0, y0 = nodes[0].y, y1 = y0;
  for (const Point& p : nodes) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
  const double area = std::max((x1 - x0) * (y1 - y0), 0.0), length = std::max(x1 - x0, y1 - y0);
  return std::max(std::sqrt(2 * area / static_cast<double>(nodes.size())),
                  2 * length / static_cast<double>(nodes.size() + 1));
}

}  // namespace

Scattered::Scattered(std::vector<Point> nodes, std::vector<double> values, int components)
    : nodes_(std::move(nodes)),
      values_(std::move(values)),
      components_(components),
      buckets_(nodes_, bucket_size(nodes_)) {}

void Scattered::at(double x, double y, double* out) const {
  struct Near {
    double d2;
    std::size_t node;
    bool operator<(const Near& o) const { return d2 != o.d2 ? d2 < o.d2 : node < o.node; }
  };
  std::vector<Near> found;
  const auto find = [&](std::size_t want) {
    for (double reach = buckets_.size();; reach *= 2) {
      found.clear();
      std::size_t within = 0;  // nodes nearer than the reach: no other node is nearer
      buckets_.near(x, y, reach, [&](std::size_t k) {
        const double dx = nodes_[k].x - x, dy = nodes_[k].y - y, d2 = dx * dx + dy * dy;
        found.push_back({d2, k});
        if (d2 <= reach * reach) ++within;
      });
      if (within >= want || found.size() == nodes_.size()) break;
    }
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(want), found.end());
  };
  const auto value = [&](std::size_t k) { return values_.data() + k * static_cast<std::size_t>(components_); };
  const std::size_t most = std::min(kMost, nodes_.size());
  for (std::size_t want = std::min(kNearest, most);; want = std::min(4 * want, most)) {
    find(want);
    const double scale = std::sqrt(found[want - 1].d2);
    if (scale == 0 || found[0].d2 == 0) {
      std::copy_n(value(found[0].node), components_, out);
      return;
    }
    LinearFit fit;
    for (std::size_t k = 0; k < want; ++k) {
      const Point& p = nodes_[found[k].node];
      fit.add(scale * scale / found[k].d2, (p.x - x) / scale, (p.y - y) / scale, value(found[k].node), components_);
    }
    if (!fit.spans() && want < most) continue;
    fit.value(out, components_);
    return;
  }
}

double Raster::at(double x, double y) const {
  const auto cell = [](double s, std::int64_t n) {
    return static_cast<std::int64_t>(std::clamp(std::floor(s), 0.0, std::max(0.0, static_cast<double>(n - 2))));
  };
  const double s = (x - x0) / dx, t = (y - y0) / dy;
  const std::int64_t i = cell(s, nx), j = cell(t, ny), i1 = std::min(i + 1, nx - 1), j1 = std::min(j + 1, ny - 1);
  const auto v = [&](std::int64_t a, std::int64_t b) { return values[static_cast<std::size_t>(b * nx + a)]; };
  const double f = nx > 1 ? s - static_cast<double>(i) : 0, g = ny > 1 ? t - static_cast<double>(j) : 0;
  return (1 - g) * ((1 - f) * v(i, j) + f * v(i1, j)) + g * ((1 - f) * v(i, j1) + f * v(i1, j1));
}

}  // namespace vbgpd
