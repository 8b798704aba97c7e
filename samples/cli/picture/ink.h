// Small drawing vocabulary over cairo: colours, text, arrows. Lengths are points (1/72 inch), y down.
#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include "sheet.h"

namespace cli::picture {

struct Rgb {
  double r = 0, g = 0, b = 0;
};
constexpr Rgb kInk{0.13, 0.14, 0.17};
constexpr Rgb kGrey{0.42, 0.44, 0.48};
constexpr Rgb kPaleGrey{0.72, 0.74, 0.77};
constexpr Rgb kAlarm{0.70, 0.10, 0.10};
constexpr Rgb kForce{0.10, 0.25, 0.55};  ///< loads and earthquake arrows

struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
};

struct TextStyle {
  double size = 9;
  Rgb color = kInk;
  bool bold = false;
};
enum class Align { kLeft, kCenter, kRight };

void set_color(cairo_t* cr, Rgb color, double alpha = 1);
/// Adds an open or closed line to the current path.
void trace(cairo_t* cr, const Polyline& line, bool closed);
void line(cairo_t* cr, Point from, Point to);

double text_width(cairo_t* cr, const std::string& text, const TextStyle& style);
void write(cairo_t* cr, Point baseline, const std::string& text, const TextStyle& style, Align align = Align::kLeft);
/// The text cut at `width` with an ellipsis, never inside a UTF-8 character.
std::string fitted(cairo_t* cr, const std::string& text, const TextStyle& style, double width);
/// Broken at spaces into at most `most` lines, the last one fitted.
std::vector<std::string> wrapped(cairo_t* cr, const std::string& text, const TextStyle& style, double width,
                                 std::size_t most);

/// A line with a filled head at `to`.
void arrow(cairo_t* cr, Point from, Point to, double head);

/// 1, 2 or 5 times a power of ten, not below `least` (> 0).
double round_step(double least);
/// A multiple of `step` with just the decimals the step needs.
std::string step_label(double value, double step);

}  // namespace cli::picture
