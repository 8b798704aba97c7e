// Ground water: its table, and what stands on the ground.
#include <algorithm>

#include "parts.h"

namespace cli::picture {

namespace {

constexpr Rgb kWaterLine{0.10, 0.35, 0.75}, kStanding{0.80, 0.89, 0.97};

/// The table across the section; it goes on level beyond its ends.
Polyline across(const Polyline& table, const Box& world) {
  const auto level = [&](double x) {
    for (std::size_t k = 1; k < table.size(); ++k)
      if (x < table[k].x && x >= table[k - 1].x)
        return table[k - 1].y + (table[k].y - table[k - 1].y) * (x - table[k - 1].x) / (table[k].x - table[k - 1].x);
    return x < table.front().x ? table.front().y : table.back().y;
  };
  Polyline line{{world.x0, level(world.x0)}};
  for (const Point& p : table)
    if (p.x > world.x0 && p.x < world.x1) line.push_back(p);
  line.push_back({world.x1, level(world.x1)});
  return line;
}

void clip_to_plot(cairo_t* cr, const Layout& layout) {
  cairo_rectangle(cr, layout.section.x0, layout.plot.y0, layout.section.width(), layout.section.y1 - layout.plot.y0);
  cairo_clip(cr);
}

}  // namespace

void draw_standing_water(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  if (sheet.water.empty()) return;
  Polyline area = layout.to_page(across(sheet.water, layout.world));
  area.push_back({layout.section.x1, layout.section.y1}), area.push_back({layout.section.x0, layout.section.y1});
  cairo_save(cr);
  clip_to_plot(cr, layout);
  set_color(cr, kStanding);
  trace(cr, area, true);
  cairo_fill(cr);
  // soil is drawn over it, also where the picture shows particles only
  set_color(cr, {1, 1, 1});
  trace(cr, layout.to_page(sheet.exterior), true);
  cairo_fill(cr);
  cairo_restore(cr);
}

void draw_water_line(cairo_t* cr, const Polyline& on_page, double width) {
  set_color(cr, kWaterLine);
  cairo_set_line_width(cr, width);
  trace(cr, on_page, false);
  cairo_stroke(cr);
}

void draw_water_table(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  if (sheet.water.empty()) return;
  cairo_save(cr);
  clip_to_plot(cr, layout);
  draw_water_line(cr, layout.to_page(across(sheet.water, layout.world)), 1.6);
  cairo_restore(cr);
}

}  // namespace cli::picture
