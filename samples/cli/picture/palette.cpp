#include "palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cli::picture {

namespace {

constexpr std::array<Rgb, 7> kSoils{{{0.86, 0.88, 0.84},    // pale sage
                                     {0.73, 0.81, 0.87},    // blue grey
                                     {0.80, 0.76, 0.70},    // taupe
                                     {0.70, 0.80, 0.73},    // green
                                     {0.82, 0.78, 0.88},    // lilac
                                     {0.62, 0.68, 0.75},    // slate
                                     {0.68, 0.66, 0.62}}};  // stone

constexpr std::array<Rgb, 5> kStrain{
    {{1.00, 0.97, 0.78}, {1.00, 0.83, 0.36}, {0.98, 0.57, 0.20}, {0.84, 0.21, 0.13}, {0.50, 0.02, 0.16}}};
constexpr double kOpaqueFrom = 0.15;  // below it the soil shows through more and more
constexpr double kLargestAlpha = 0.93;

/// Thin strokes across the current clip, one direction per round through the list of fills.
void hatch(cairo_t* cr, int round) {
  double x0, y0, x1, y1;
  cairo_clip_extents(cr, &x0, &y0, &x1, &y1);
  set_color(cr, kInk, 0.35);
  cairo_set_line_width(cr, 0.5);
  const double gap = 5, rise = round % 2 == 1 ? y1 - y0 : y0 - y1;
  for (double x = x0 - (y1 - y0); x < x1 + (y1 - y0); x += gap) {
    cairo_move_to(cr, x, (y0 + y1 - rise) / 2);
    cairo_line_to(cr, x + (y1 - y0), (y0 + y1 + rise) / 2);
  }
  cairo_stroke(cr);
}

}  // namespace

void fill_material(cairo_t* cr, int material) {
  const int colors = static_cast<int>(kSoils.size());
  cairo_save(cr);
  set_color(cr, kSoils[static_cast<std::size_t>(material % colors)]);
  cairo_fill_preserve(cr);
  if (material >= colors) {
    cairo_clip_preserve(cr);
    cairo_path_t* outline = cairo_copy_path(cr);
    cairo_new_path(cr);
    hatch(cr, material / colors);
    cairo_append_path(cr, outline);
    cairo_path_destroy(outline);
  }
  cairo_restore(cr);
}

Rgba strain_color(double t) {
  if (!(t > 0)) return {};
  const double place = std::min(t, 1.0) * (kStrain.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kStrain.size() - 2);
  const double w = place - static_cast<double>(below);
  const Rgb a = kStrain[below], b = kStrain[below + 1];
  const double alpha = kLargestAlpha * std::min(t / kOpaqueFrom, 1.0);
  return {a.r + w * (b.r - a.r), a.g + w * (b.g - a.g), a.b + w * (b.b - a.b), alpha};
}

}  // namespace cli::picture
