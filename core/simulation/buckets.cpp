#include "simulation/buckets.h"

#include <limits>

namespace vbgpd {

Buckets::Buckets(const std::vector<Point>& points, double size) : size_(size) {
  start_.assign(2, 0);
  if (points.empty()) return;
  double x1 = x0_ = points[0].x, y1 = y0_ = points[0].y;
  for (const Point& p : points) {
    x0_ = std::min(x0_, p.x), x1 = std::max(x1, p.x);
    y0_ = std::min(y0_, p.y), y1 = std::max(y1, p.y);
  }
  const double most = 4.0 * static_cast<double>(points.size()) + 16;
  const auto count = [&](double length) { return std::floor(length / size_) + 1; };
  if (!(size_ > 0)) size_ = std::max({x1 - x0_, y1 - y0_, 1e-300});
  while (count(x1 - x0_) * count(y1 - y0_) > most) size_ *= 2;
  columns_ = static_cast<long>(count(x1 - x0_)), rows_ = static_cast<long>(count(y1 - y0_));
  start_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  const auto bucket = [&](const Point& p) { return static_cast<std::size_t>(row(p.y) * columns_ + column(p.x)); };
  for (const Point& p : points) ++start_[bucket(p) + 1];
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  order_.resize(points.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t k = 0; k < points.size(); ++k) order_[next[bucket(points[k])]++] = k;
}

std::size_t Buckets::nearest(const std::vector<Point>& points, double x, double y) const {
  double best = std::numeric_limits<double>::infinity();
  std::size_t found = 0;
  for (double reach = size_; best > reach * reach && reach < 4 * extent(); reach *= 2)
    near(x, y, reach, [&](std::size_t n) {
      const double dx = points[n].x - x, dy = points[n].y - y, d2 = dx * dx + dy * dy;
      if (d2 < best || (d2 == best && n < found)) best = d2, found = n;
    });
  return found;
}

}  // namespace vbgpd
