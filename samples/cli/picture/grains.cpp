// Soil in motion: a disc per particle.
#include <cmath>

#include "palette.h"
#include "parts.h"

namespace cli::picture {

namespace {

constexpr double kTwoPi = 6.283185307179586;

void disc(cairo_t* cr, const Layout& layout, const Grain& g) {
  const Point p = layout.to_page(Point{g.x, g.y});
  cairo_new_sub_path(cr);
  cairo_arc(cr, p.x, p.y, g.radius * layout.scale, 0, kTwoPi);
}

}  // namespace

void draw_grains(cairo_t* cr, const Sheet& sheet, const Layout& layout, double largest) {
  for (std::size_t m = 0; m < sheet.materials.size(); ++m) {
    for (const Grain& g : sheet.grains)
      if (g.material == static_cast<int>(m)) disc(cr, layout, g);
    fill_material(cr, static_cast<int>(m));
    cairo_new_path(cr);
  }
  if (!(largest > 0)) return;
  for (const Grain& g : sheet.grains) {
    const Rgba color = strain_color(std::fmin(1, g.strain / largest));
    if (color.a == 0) continue;
    disc(cr, layout, g);
    cairo_set_source_rgba(cr, color.r, color.g, color.b, color.a);
    cairo_fill(cr);
  }
}

}  // namespace cli::picture
