// Axes in metres with ticks at round numbers.
#include "parts.h"

namespace cli::picture {

void draw_axes(cairo_t* cr, const Layout& layout) {
  constexpr double tick = 4;
  const Box& plot = layout.plot;
  set_color(cr, kPaleGrey);
  cairo_set_line_width(cr, 0.8);
  trace(cr, {{plot.x0, layout.section.y0}, {plot.x0, plot.y1}, {layout.section.x1, plot.y1}}, false);
  cairo_stroke(cr);
  for (int i = 0; i < layout.x_ticks.count; ++i) {
    const double value = layout.x_ticks.first + i * layout.x_ticks.step;
    const double x = layout.to_page(Point{value, 0}).x;
    set_color(cr, kPaleGrey);
    line(cr, {x, plot.y1}, {x, plot.y1 + tick});
    write(cr, {x, plot.y1 + tick + 9}, step_label(value, layout.x_ticks.step), kTickStyle, Align::kCenter);
  }
  for (int i = 0; i < layout.y_ticks.count; ++i) {
    const double value = layout.y_ticks.first + i * layout.y_ticks.step;
    const double y = layout.to_page(Point{0, value}).y;
    set_color(cr, kPaleGrey);
    line(cr, {plot.x0 - tick, y}, {plot.x0, y});
    write(cr, {plot.x0 - tick - 2, y + 3.2}, step_label(value, layout.y_ticks.step), kTickStyle, Align::kRight);
  }
  const double middle_x = (layout.section.x0 + layout.section.x1) / 2,
               middle_y = (layout.section.y0 + layout.section.y1) / 2;
  write(cr, {middle_x, plot.y1 + tick + 22}, "x (m)", kTickStyle, Align::kCenter);
  cairo_save(cr);
  cairo_translate(cr, plot.x0 - tick - 2 - layout.y_label_width - 6, middle_y);
  cairo_rotate(cr, -1.5707963267948966);
  write(cr, {0, 0}, "y (m)", kTickStyle, Align::kCenter);
  cairo_restore(cr);
}

}  // namespace cli::picture
