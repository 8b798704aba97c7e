// Where everything stands on the page.
#pragma once

#include "ink.h"

namespace cli::picture {

constexpr TextStyle kTitleStyle{13, kInk, true};
constexpr TextStyle kSubtitleStyle{8.5, kGrey, false};
constexpr TextStyle kResultStyle{17, kInk, true};
constexpr TextStyle kRemarkStyle{9, kAlarm, false};
constexpr TextStyle kTickStyle{9, kInk, false};
constexpr TextStyle kLegendStyle{9, kInk, false};
constexpr TextStyle kLegendNoteStyle{8.5, kGrey, false};
constexpr TextStyle kForceStyle{9, kForce, true};
constexpr TextStyle kFooterStyle{7.5, kGrey, false};

/// Lines of text that were broken to fit, and the box they fill.
struct TextBlock {
  std::vector<std::string> lines;
  TextStyle style;
  Point first_baseline;
  double line_height = 0;
};

struct Ticks {
  double first = 0, step = 1;
  int count = 0;
};

struct Layout {
  double page_width = 0, page_height = 0;
  std::vector<TextBlock> texts;
  Box world;         ///< m, the box of the section; y0 = lowest
  Box section;       ///< that box on the page
  Box plot;          ///< the section with room around it for supports and loads
  double scale = 1;  ///< points per metre, the same both ways
  Ticks x_ticks, y_ticks;
  double y_label_width = 0;
  Box soils, colors;              ///< legends: materials and slip line; colour bar
  bool notes_below = false;       ///< the parameters of a soil stand below its name
  bool free_corner_left = false;  ///< where the ground is low and arrows find room
  Point to_page(Point p) const {
    return {section.x0 + (p.x - world.x0) * scale, section.y1 - (p.y - world.y0) * scale};
  }
  Polyline to_page(const Polyline& line) const;
};

Layout arrange(cairo_t* cr, const Sheet& sheet);

/// Elevation of the ground surface at x: the highest crossing of the outline.
double ground_elevation(const Polyline& exterior, double x);

/// From one soil of the legend to the next.
constexpr double kLegendRow = 15, kLegendNoteRow = 12;
/// A swatch, the gap to its name, the gap from there to a note behind it.
constexpr double kLegendSwatch = 18, kLegendGap = 7, kLegendNoteGap = 8;

}  // namespace cli::picture
