// The parts of a picture, in the order in which they are painted.
#pragma once

#include "layout.h"

namespace cli::picture {

/// Materials, then later the lines over them.
void draw_materials(cairo_t* cr, const Sheet& sheet, const Layout& layout);
/// Under the materials: what stands on the ground. Over them: the water table.
void draw_standing_water(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_water_table(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_water_line(cairo_t* cr, const Polyline& on_page, double width);
void draw_outlines(cairo_t* cr, const Sheet& sheet, const Layout& layout);
/// Plastic strain, a coloured square per particle cut by the outline. `largest` is the strain of the last colour.
void draw_strain(cairo_t* cr, const Sheet& sheet, const Layout& layout, double largest);
/// Soil in motion: its particles in the colour of their material, plastic strain over it.
void draw_grains(cairo_t* cr, const Sheet& sheet, const Layout& layout, double largest);
double largest_shown(const std::vector<Grain>& grains);
void draw_slip(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_supports(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_loads(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_seismic(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_axes(cairo_t* cr, const Layout& layout);
void draw_soil_legend(cairo_t* cr, const Sheet& sheet, const Layout& layout);
void draw_color_bar(cairo_t* cr, const Layout& layout, double largest);

/// The strain that gets the last colour: the 98th percentile of the yielding particles, rounded up; 0 when none yields.
double largest_shown(const std::vector<Cell>& cells);

}  // namespace cli::picture
