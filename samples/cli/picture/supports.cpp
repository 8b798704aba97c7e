// Held parts of the outline: hatching where fixed, small wheels where rolling.
#include <cmath>

#include "parts.h"

namespace cli::picture {

namespace {

constexpr double kHatchGap = 6, kHatchLength = 7, kWheel = 2.6, kWheelGap = 13;

bool inside(const Polyline& polygon, Point p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
  }
  return in;
}

/// A straight piece of the outline on the page: `along` points from `from`, `out` away from the soil.
struct Piece {
  Point from, along, out;
  double length = 0;
  Point at(double s, double distance) const {
    return {from.x + s * along.x + distance * out.x, from.y + s * along.y + distance * out.y};
  }
};

Piece piece_between(Point a, Point b, const Polyline& exterior) {
  Piece piece;
  piece.length = std::hypot(b.x - a.x, b.y - a.y);
  if (piece.length == 0) return piece;
  piece.from = a;
  piece.along = {(b.x - a.x) / piece.length, (b.y - a.y) / piece.length};
  piece.out = {piece.along.y, -piece.along.x};
  if (inside(exterior, piece.at(piece.length / 2, 0.5))) piece.out = {-piece.along.y, piece.along.x};
  return piece;
}

void draw_fixed(cairo_t* cr, const Piece& piece) {
  set_color(cr, kInk, 0.8);
  cairo_set_line_width(cr, 0.7);
  const int n = std::max(1, static_cast<int>(piece.length / kHatchGap));
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) * piece.length / n;
    const double slant = piece.along.x >= 0 ? 0.7 : -0.7;
    line(cr, piece.at(s + slant * kHatchLength / 2, 0), piece.at(s - slant * kHatchLength / 2, kHatchLength));
  }
}

void draw_rolling(cairo_t* cr, const Piece& piece) {
  set_color(cr, kInk, 0.8);
  cairo_set_line_width(cr, 0.7);
  const int n = std::max(1, static_cast<int>(piece.length / kWheelGap));
  for (int i = 0; i < n; ++i) {
    const Point center = piece.at((i + 0.5) * piece.length / n, kWheel + 0.8);
    cairo_arc(cr, center.x, center.y, kWheel, 0, 6.2832);
    cairo_stroke(cr);
  }
  line(cr, piece.at(0, 2 * kWheel + 1.6), piece.at(piece.length, 2 * kWheel + 1.6));
}

void draw_moving(cairo_t* cr, const Piece& piece) {
  set_color(cr, kForce);
  cairo_set_line_width(cr, 1.6);
  const double dashes[] = {4, 2};
  cairo_set_dash(cr, dashes, 2, 0);
  line(cr, piece.at(0, 3), piece.at(piece.length, 3));
  cairo_set_dash(cr, nullptr, 0, 0);
}

}  // namespace

void draw_supports(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  const Polyline exterior = layout.to_page(sheet.exterior);
  for (const Support& support : sheet.supports) {
    const Polyline held = layout.to_page(support.line);
    for (std::size_t i = 0; i + 1 < held.size(); ++i) {
      const Piece piece = piece_between(held[i], held[i + 1], exterior);
      if (piece.length == 0) continue;
      switch (support.hold) {
        case Hold::kFixed:
          draw_fixed(cr, piece);
          break;
        case Hold::kRoller:
          draw_rolling(cr, piece);
          break;
        case Hold::kMoving:
          draw_moving(cr, piece);
          break;
      }
    }
  }
}

}  // namespace cli::picture
