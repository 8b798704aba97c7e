// What the colours mean.
#include <algorithm>
#include <cmath>

#include "palette.h"
#include "parts.h"

namespace cli::picture {

namespace {

/// A name and, where there is room, a note behind it or below. Gives the baseline of the next entry.
double write_entry(cairo_t* cr, const Layout& layout, double baseline, const std::string& name,
                   const std::string& note) {
  const double left = layout.soils.x0 + kLegendSwatch + kLegendGap, right = layout.soils.x1;
  const std::string shown = fitted(cr, name, kLegendStyle, right - left);
  write(cr, {left, baseline}, shown, kLegendStyle);
  if (note.empty()) return baseline + kLegendRow;
  const Point place = layout.notes_below ? Point{left, baseline + kLegendNoteRow}
                                         : Point{left + text_width(cr, shown, kLegendStyle) + kLegendNoteGap, baseline};
  const double least = 40;  // less room than this holds nothing that can be read
  if (place.x + least < right) write(cr, place, fitted(cr, note, kLegendNoteStyle, right - place.x), kLegendNoteStyle);
  return place.y + kLegendRow;
}

}  // namespace

void draw_soil_legend(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  const Box& box = layout.soils;
  double baseline = box.y0 + 10;
  for (std::size_t i = 0; i < sheet.materials.size(); ++i) {
    cairo_rectangle(cr, box.x0, baseline - 8.5, kLegendSwatch, 10);
    fill_material(cr, static_cast<int>(i));
    set_color(cr, kInk);
    cairo_set_line_width(cr, 0.6);
    cairo_stroke(cr);
    baseline = write_entry(cr, layout, baseline, sheet.materials[i].name, sheet.materials[i].parameters);
  }
  if (!sheet.water.empty()) {
    draw_water_line(cr, {{box.x0, baseline - 3.5}, {box.x0 + kLegendSwatch, baseline - 3.5}}, 1.6);
    baseline = write_entry(cr, layout, baseline, "water table", "");
  }
  if (sheet.slip.empty()) return;
  set_color(cr, {0.05, 0.05, 0.08});
  cairo_set_line_width(cr, 2);
  line(cr, {box.x0, baseline - 3.5}, {box.x0 + kLegendSwatch, baseline - 3.5});
  write_entry(cr, layout, baseline, "critical slip surface", "");
}

void draw_color_bar(cairo_t* cr, const Layout& layout, double largest) {
  const Box& box = layout.colors;
  if (!(largest > 0)) {
    write(cr, {box.x0, box.y0 + 10}, "no particle yields", kLegendStyle);
    return;
  }
  write(cr, {box.x0, box.y0 + 9}, "plastic shear strain (%)", kLegendStyle);
  const double left = box.x0, right = box.x1 - 14, top = box.y0 + 15, height = 10;
  constexpr int kBands = 105;
  for (int i = 0; i < kBands; ++i) {
    const Rgba color = strain_color((i + 0.5) / kBands);
    set_color(cr, {1 - color.a * (1 - color.r), 1 - color.a * (1 - color.g), 1 - color.a * (1 - color.b)});
    const double x = left + i * (right - left) / kBands;
    cairo_rectangle(cr, x, top, std::min((right - left) / kBands + 0.5, right - x), height);
    cairo_fill(cr);
  }
  set_color(cr, kInk);
  cairo_set_line_width(cr, 0.6);
  cairo_rectangle(cr, left, top, right - left, height);
  cairo_stroke(cr);
  const double percent = 100 * largest, step = round_step(percent / 5);
  const int steps = static_cast<int>(std::lround(percent / step));
  for (int i = 0; i <= steps; ++i) {
    const double x = left + (right - left) * i / steps;
    set_color(cr, kInk);
    line(cr, {x, top + height}, {x, top + height + 3});
    const std::string number = step_label(i * step, step);
    write(cr, {x, top + height + 13}, i == steps ? "≥ " + number : number, kTickStyle, Align::kCenter);
  }
}

}  // namespace cli::picture
