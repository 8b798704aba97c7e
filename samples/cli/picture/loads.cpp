// What acts on the soil besides its weight: pressure on the ground, earthquake coefficients.
#include <algorithm>
#include <cmath>

#include "../format.h"
#include "parts.h"

namespace cli::picture {

namespace {

constexpr double kLongest = 26, kShortest = 6, kArrowGap = 11, kHead = 5;

double largest_pressure(const std::vector<Load>& loads) {
  double largest = 0;
  for (const Load& load : loads) largest = std::max({largest, std::fabs(load.pressure), std::fabs(load.pressure_end)});
  return largest;
}

std::string label(const Load& load) {
  const std::string begin = plain_number(load.pressure, 4), end = plain_number(load.pressure_end, 4);
  return (begin == end ? begin : begin + " to " + end) + " kPa";
}

void draw_load(cairo_t* cr, const Sheet& sheet, const Layout& layout, const Load& load, double largest) {
  const int n = std::max(1, static_cast<int>((load.x1 - load.x0) * layout.scale / kArrowGap));
  Polyline tails;
  for (int i = 0; i <= n; ++i) {
    const double w = static_cast<double>(i) / n, x = load.x0 + w * (load.x1 - load.x0);
    const double pressure = load.pressure + w * (load.pressure_end - load.pressure);
    const Point ground = layout.to_page(Point{x, ground_elevation(sheet.exterior, x)});
    const double length = std::max(kLongest * std::fabs(pressure) / largest, kShortest);
    const Point tail{ground.x, ground.y - length};
    tails.push_back(tail);
    if (pressure > 0) arrow(cr, tail, {ground.x, ground.y - 0.8}, kHead);
    if (pressure < 0) arrow(cr, {ground.x, ground.y - 0.8}, tail, kHead);
  }
  trace(cr, tails, false);
  cairo_stroke(cr);
  const double top = std::min_element(tails.begin(), tails.end(), [](Point a, Point b) { return a.y < b.y; })->y;
  const std::string text = label(load);
  const double half = text_width(cr, text, kForceStyle) / 2;
  const double middle = std::clamp((tails.front().x + tails.back().x) / 2,
                                   std::min(layout.plot.x0 + half, layout.plot.x1 - half), layout.plot.x1 - half);
  write(cr, {middle, top - 4}, text, kForceStyle, Align::kCenter);
}

/// The tail of an arrow of that length towards `direction` whose middle is `center`.
void draw_acceleration(cairo_t* cr, Point center, Point direction) {
  constexpr double half = 17;
  set_color(cr, kForce);
  cairo_set_line_width(cr, 2.2);
  arrow(cr, {center.x - half * direction.x, center.y - half * direction.y},
        {center.x + half * direction.x, center.y + half * direction.y}, 9);
}

}  // namespace

void draw_loads(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  const double largest = largest_pressure(sheet.loads);
  if (!(largest > 0)) return;
  for (const Load& load : sheet.loads) {
    set_color(cr, kForce);
    cairo_set_line_width(cr, 1);
    draw_load(cr, sheet, layout, load, largest);
  }
}

void draw_seismic(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  double x = layout.free_corner_left ? layout.section.x0 + 30 : layout.section.x1 - 30;
  const double y = layout.plot.y0 + 14, towards_middle = layout.free_corner_left ? 1 : -1;
  if (sheet.kh != 0) {
    draw_acceleration(cr, {x, y}, {sheet.kh > 0 ? 1.0 : -1.0, 0});
    write(cr, {x, y + 17}, "kh = " + plain_number(std::fabs(sheet.kh), 3), kForceStyle, Align::kCenter);
    x += 75 * towards_middle;
  }
  if (sheet.kv == 0) return;
  draw_acceleration(cr, {x, y + 6}, {0, sheet.kv > 0 ? 1.0 : -1.0});
  write(cr, {x + 8 * towards_middle, y + 10}, "kv = " + plain_number(std::fabs(sheet.kv), 3), kForceStyle,
        layout.free_corner_left ? Align::kLeft : Align::kRight);
}

}  // namespace cli::picture
