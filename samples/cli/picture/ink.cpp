#include "ink.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../format.h"

namespace cli::picture {

void set_color(cairo_t* cr, Rgb color, double alpha) { cairo_set_source_rgba(cr, color.r, color.g, color.b, alpha); }

void trace(cairo_t* cr, const Polyline& line, bool closed) {
  cairo_new_sub_path(cr);
  for (const Point& p : line) cairo_line_to(cr, p.x, p.y);
  if (closed) cairo_close_path(cr);
}

void line(cairo_t* cr, Point from, Point to) {
  cairo_move_to(cr, from.x, from.y);
  cairo_line_to(cr, to.x, to.y);
  cairo_stroke(cr);
}

namespace {

void set_font(cairo_t* cr, const TextStyle& style) {
  cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, style.size);
}

/// The text without its last character.
void drop_last(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

double text_width(cairo_t* cr, const std::string& text, const TextStyle& style) {
  set_font(cr, style);
  cairo_text_extents_t extents;
  cairo_text_extents(cr, text.c_str(), &extents);
  return extents.x_advance;
}

void write(cairo_t* cr, Point baseline, const std::string& text, const TextStyle& style, Align align) {
  const double width = align == Align::kLeft ? 0 : text_width(cr, text, style);
  set_font(cr, style);
  set_color(cr, style.color);
  cairo_move_to(cr, baseline.x - (align == Align::kCenter ? width / 2 : width), baseline.y);
  cairo_show_text(cr, text.c_str());
}

std::string fitted(cairo_t* cr, const std::string& text, const TextStyle& style, double width) {
  if (text_width(cr, text, style) <= width) return text;
  std::string cut = text;
  while (!cut.empty() && text_width(cr, cut + "…", style) > width) drop_last(cut);
  return cut + "…";
}

std::vector<std::string> wrapped(cairo_t* cr, const std::string& text, const TextStyle& style, double width,
                                 std::size_t most) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool starts_line =
        lines.empty() || (lines.size() < most && text_width(cr, lines.back() + " " + word, style) > width);
    if (starts_line) lines.push_back(word);
    else lines.back() += " " + word;
  }
  for (std::string& line : lines) line = fitted(cr, line, style, width);
  return lines;
}

void arrow(cairo_t* cr, Point from, Point to, double head) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length <= 0) return;
  const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
  const double reach = std::min(head, length);
  const Point neck{to.x - reach * along.x, to.y - reach * along.y};
  line(cr, from, neck);
  const double half = 0.38 * reach;
  trace(cr,
        {to, {neck.x - half * along.y, neck.y + half * along.x}, {neck.x + half * along.y, neck.y - half * along.x}},
        true);
  cairo_fill(cr);
}

double round_step(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least * (1 - 1e-12)) return factor * decade;
  return 10 * decade;
}

std::string step_label(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  const std::string text = format("%.*f", decimals, value);
  return std::all_of(text.begin(), text.end(), [](char c) { return c == '-' || c == '0' || c == '.'; }) ? "0" : text;
}

}  // namespace cli::picture
