// The section itself: soils, their borders, the slip surface.
#include "palette.h"
#include "parts.h"

namespace cli::picture {

namespace {

void clip_to_exterior(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  trace(cr, layout.to_page(sheet.exterior), true);
  cairo_clip(cr);
}

}  // namespace

void draw_materials(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  cairo_save(cr);
  clip_to_exterior(cr, sheet, layout);
  for (const Layer& layer : sheet.layers) {
    trace(cr, layout.to_page(layer.polygon.empty() ? sheet.exterior : layer.polygon), true);
    fill_material(cr, layer.material);
    cairo_new_path(cr);
  }
  cairo_restore(cr);
}

void draw_outlines(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  cairo_save(cr);
  clip_to_exterior(cr, sheet, layout);
  set_color(cr, kInk, 0.55);
  cairo_set_line_width(cr, 0.6);
  for (const Layer& layer : sheet.layers) {
    if (layer.polygon.empty()) continue;
    trace(cr, layout.to_page(layer.polygon), true);
    cairo_stroke(cr);
  }
  cairo_restore(cr);
  set_color(cr, kInk);
  cairo_set_line_width(cr, 1.1);
  trace(cr, layout.to_page(sheet.exterior), true);
  cairo_stroke(cr);
}

void draw_slip(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  if (sheet.slip.empty()) return;
  const Polyline line = layout.to_page(sheet.slip);
  trace(cr, line, false);
  cairo_set_line_width(cr, 4.2);
  cairo_set_source_rgba(cr, 1, 1, 1, 0.75);
  cairo_stroke_preserve(cr);
  cairo_set_line_width(cr, 2);
  set_color(cr, {0.05, 0.05, 0.08});
  cairo_stroke(cr);
  for (const Point& end : {line.front(), line.back()}) {
    cairo_arc(cr, end.x, end.y, 2.6, 0, 6.2832);
    cairo_fill(cr);
  }
}

}  // namespace cli::picture
