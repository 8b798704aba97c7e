#include "outline.h"

#include <algorithm>

namespace cli {

namespace {

using picture::Point;
using picture::Polyline;

double twice_area(const Polyline& polygon) {
  double sum = 0;
  const Point o = polygon.front();  // differences first: map coordinates are large
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
  }
  return sum;
}

/// An extreme corner of the outline, by sign: {-1, 1} is the highest vertex at the left end.
struct Corner {
  int x, y;
};

std::size_t find(const Polyline& polygon, Corner corner) {
  const auto best = std::max_element(polygon.begin(), polygon.end(), [&](Point a, Point b) {
    return a.x != b.x ? corner.x * a.x < corner.x * b.x : corner.y * a.y < corner.y * b.y;
  });
  return static_cast<std::size_t>(best - polygon.begin());
}

/// Counter-clockwise, both ends included.
Polyline walk(const Polyline& polygon, Corner from, Corner to) {
  const std::size_t last = find(polygon, to);
  Polyline line{polygon[find(polygon, from)]};
  for (std::size_t i = find(polygon, from); i != last;) line.push_back(polygon[i = (i + 1) % polygon.size()]);
  return line;
}

}  // namespace

Polyline side_of(const Polyline& exterior, const std::string& side) {
  if (exterior.empty()) return {};
  Polyline polygon = exterior;
  if (twice_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  if (side == "base") return walk(polygon, {-1, -1}, {1, -1});
  if (side == "left") return walk(polygon, {-1, 1}, {-1, -1});
  if (side == "right") return walk(polygon, {1, -1}, {1, 1});
  return {};
}

}  // namespace cli
