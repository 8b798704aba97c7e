#include "layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cli::picture {

namespace {

// Points. A page about 640 wide keeps its smallest letters readable when a report prints it 16 cm wide.
constexpr double kMargin = 22, kGap = 14;
constexpr double kLeastPageWidth = 520;
constexpr double kColorBarHeight = 44, kColorBarWidth = 210;
constexpr double kSupportRoom = 16, kAirAbove = 10, kLoadRoom = 44, kSeismicRoom = 44;
constexpr double kTickLabelHeight = 16, kAxisLabelHeight = 15;

Box bounds(const Polyline& line) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{inf, inf, -inf, -inf};
  for (const Point& p : line)
    box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x), std::max(box.y1, p.y)};
  return box;
}

/// Long and deep sections get a larger page, up to twice, before they get thin.
double page_scale(const Box& world) {
  constexpr double width = 560, height = 340;
  const double slender = world.width() / world.height();
  const double wider = std::clamp(slender / 9, 1.0, 2.0), taller = std::clamp(0.6 / slender, 1.0, 1.5);
  return std::min(width * wider / world.width(), height * taller / world.height());
}

Ticks ticks_between(double low, double high, double step) {
  Ticks ticks;
  ticks.step = step;
  ticks.first = std::ceil(low / step - 1e-9) * step;
  ticks.count = static_cast<int>(std::floor((high - ticks.first) / step + 1e-9)) + 1;
  return ticks;
}

double widest_label(cairo_t* cr, const Ticks& ticks) {
  double widest = 0;
  for (int i = 0; i < ticks.count; ++i)
    widest = std::max(widest, text_width(cr, step_label(ticks.first + i * ticks.step, ticks.step), kTickStyle));
  return widest;
}

Ticks x_ticks(cairo_t* cr, const Box& world, double scale) {
  double step = round_step(45 / scale);
  Ticks ticks = ticks_between(world.x0, world.x1, step);
  while (ticks.count > 1 && widest_label(cr, ticks) + 10 > step * scale) {
    step = round_step(step * 1.5);
    ticks = ticks_between(world.x0, world.x1, step);
  }
  return ticks;
}

/// Stacks blocks of text from `y` down and gives the y below the last one.
double stack(std::vector<TextBlock>& blocks, cairo_t* cr, const std::string& text, const TextStyle& style, double width,
             std::size_t most, double y) {
  const double line_height = std::round(1.35 * style.size);
  const auto lines = wrapped(cr, text, style, width, most);
  blocks.push_back({lines, style, {kMargin, y + style.size}, line_height});
  return y + line_height * static_cast<double>(lines.size());
}

double room_above(const Sheet& sheet, const Box& world, double scale, bool corner_left) {
  double room = kAirAbove + (sheet.loads.empty() ? 0 : kLoadRoom);
  if (sheet.kh == 0 && sheet.kv == 0) return room;
  const double inset = 60 / scale;
  const double corner = corner_left ? std::min(world.x0 + inset, world.x1) : std::max(world.x1 - inset, world.x0);
  const double free = room + (world.y1 - ground_elevation(sheet.exterior, corner)) * scale;
  return room + std::max(0.0, kSeismicRoom - free);
}

/// The plot box around the section, its upper left corner at (left, top).
void place_plot(Layout& l, const Sheet& sheet, double left, double top) {
  const double above = room_above(sheet, l.world, l.scale, l.free_corner_left);
  l.section.x0 = left + kSupportRoom;
  l.section.x1 = l.section.x0 + l.world.width() * l.scale;
  l.section.y0 = top + above;
  l.section.y1 = l.section.y0 + l.world.height() * l.scale;
  l.plot = {left, top, l.section.x1 + kSupportRoom, l.section.y1 + kSupportRoom};
}

double legend_height(const Sheet& sheet, bool notes_below) {
  const double slip = sheet.slip.empty() ? 0 : kLegendRow;
  const double water = sheet.water.empty() ? 0 : kLegendRow;
  return slip + water + (kLegendRow + (notes_below ? kLegendNoteRow : 0)) * static_cast<double>(sheet.materials.size());
}

/// Whether a soil's parameters are too long to stand behind its name.
bool notes_need_a_row(cairo_t* cr, const Sheet& sheet, double width) {
  return std::any_of(sheet.materials.begin(), sheet.materials.end(), [&](const Material& m) {
    return kLegendSwatch + kLegendGap + text_width(cr, m.name, kLegendStyle) + kLegendNoteGap +
               text_width(cr, m.parameters, kLegendNoteStyle) >
           width;
  });
}

/// Legends under the plot, or beside it when it is narrow. Gives the y below everything.
double place_legends(Layout& l, cairo_t* cr, const Sheet& sheet, bool beside) {
  l.notes_below = beside || notes_need_a_row(cr, sheet, l.page_width - 2 * kMargin - kColorBarWidth - 2 * kGap);
  const double soils_height = legend_height(sheet, l.notes_below);
  const double below_axis = l.plot.y1 + kTickLabelHeight + kAxisLabelHeight + kGap;
  const double right = l.page_width - kMargin;
  if (beside) {
    const double left = l.plot.x1 + 2 * kGap;
    l.soils = {left, l.plot.y0 + kAirAbove, right, l.plot.y0 + kAirAbove + soils_height};
    l.colors = {left, l.soils.y1 + kGap, std::min(left + kColorBarWidth, right), l.soils.y1 + kGap + kColorBarHeight};
    return std::max(below_axis, l.colors.y1 + kGap);
  }
  l.colors = {right - kColorBarWidth, below_axis, right, below_axis + kColorBarHeight};
  l.soils = {kMargin, below_axis, l.colors.x0 - 2 * kGap, below_axis + soils_height};
  return std::max(l.colors.y1, l.soils.y1) + kGap;
}

}  // namespace

Polyline Layout::to_page(const Polyline& line) const {
  Polyline result;
  for (const Point& p : line) result.push_back(to_page(p));
  return result;
}

double ground_elevation(const Polyline& exterior, double x) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < exterior.size(); ++i) {
    const Point a = exterior[i], b = exterior[(i + 1) % exterior.size()];
    if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
    highest = std::max(highest, a.x == b.x ? std::max(a.y, b.y) : a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  }
  return highest;
}

Layout arrange(cairo_t* cr, const Sheet& sheet) {
  Layout l;
  l.world = bounds(sheet.exterior);
  for (const Point& p : sheet.water)
    if (p.x >= l.world.x0 && p.x <= l.world.x1) l.world.y1 = std::max(l.world.y1, p.y);
  for (const Grain& g : sheet.grains) {
    l.world.x0 = std::min(l.world.x0, g.x - g.radius), l.world.x1 = std::max(l.world.x1, g.x + g.radius);
    l.world.y0 = std::min(l.world.y0, g.y - g.radius), l.world.y1 = std::max(l.world.y1, g.y + g.radius);
  }
  l.scale = page_scale(l.world);
  l.free_corner_left = ground_elevation(sheet.exterior, l.world.x0) < ground_elevation(sheet.exterior, l.world.x1);
  l.x_ticks = x_ticks(cr, l.world, l.scale);
  l.y_ticks = ticks_between(l.world.y0, l.world.y1, round_step(26 / l.scale));
  l.y_label_width = widest_label(cr, l.y_ticks);

  const double axis_room = l.y_label_width + 8 + kAxisLabelHeight;
  const double plot_width = l.world.width() * l.scale + 2 * kSupportRoom;
  const double needed = 2 * kMargin + axis_room + plot_width;
  const bool beside = needed + 2 * kGap + 250 < kLeastPageWidth + 60;
  l.page_width = std::max(needed + (beside ? 2 * kGap + 250 : 0), kLeastPageWidth);
  const double text_room = l.page_width - 2 * kMargin;

  double y = stack(l.texts, cr, sheet.title, kTitleStyle, text_room, 2, kMargin - 6);
  y = stack(l.texts, cr, sheet.subtitle, kSubtitleStyle, text_room, 2, y + 1);
  y = stack(l.texts, cr, sheet.result, kResultStyle, text_room, 2, y + 5);
  y = stack(l.texts, cr, sheet.note, kSubtitleStyle, text_room, 3, y);
  y = stack(l.texts, cr, sheet.remark, kRemarkStyle, text_room, 10, y);
  const double left = kMargin + axis_room + (beside ? 0 : (l.page_width - needed) / 2);
  place_plot(l, sheet, left, y + 4);
  y = place_legends(l, cr, sheet, beside);
  y = stack(l.texts, cr, sheet.footer, kFooterStyle, text_room, 3, y);
  l.page_height = std::ceil(y + kMargin - 8);
  l.page_width = std::ceil(l.page_width);
  return l;
}

}  // namespace cli::picture
