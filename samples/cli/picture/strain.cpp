// Plastic strain as one image, a square of equal pixels per cell: no seams between cells in any file format.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>

#include "palette.h"
#include "parts.h"

namespace cli::picture {

namespace {

/// Strain by cell of the lattice, NaN where there is no particle.
struct Grid {
  int nx = 0, ny = 0;
  std::vector<double> values;
  double at(int ix, int iy) const {
    return ix < 0 || iy < 0 || ix >= nx || iy >= ny ? NAN : values[static_cast<std::size_t>(iy * nx + ix)];
  }
};

Grid grid_of(const Sheet& sheet, const Box& world) {
  Grid grid;
  grid.nx = static_cast<int>(std::ceil(world.width() / sheet.spacing_x - 1e-6));
  grid.ny = static_cast<int>(std::ceil(world.height() / sheet.spacing_y - 1e-6));
  grid.values.assign(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny), NAN);
  for (const Cell& cell : sheet.cells) {
    const int ix = static_cast<int>(std::floor((cell.x - world.x0) / sheet.spacing_x));
    const int iy = static_cast<int>(std::floor((cell.y - world.y0) / sheet.spacing_y));
    if (ix < 0 || iy < 0 || ix >= grid.nx || iy >= grid.ny) continue;
    grid.values[static_cast<std::size_t>(iy * grid.nx + ix)] = cell.strain;
  }
  return grid;
}

/// Slivers of soil at the outline belong to a neighbour's particle: they show the mean of their neighbours.
double shown(const Grid& grid, int ix, int iy) {
  if (const double own = grid.at(ix, iy); !std::isnan(own)) return own;
  double sum = 0;
  int n = 0;
  for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    if (const double value = grid.at(ix + dx, iy + dy); !std::isnan(value)) sum += value, ++n;
  return n ? sum / n : 0;
}

std::uint32_t pixel(const Rgba& color) {
  const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(255 * value)); };
  return byte(color.a) << 24 | byte(color.a * color.r) << 16 | byte(color.a * color.g) << 8 | byte(color.a * color.b);
}

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

/// `zoom` pixels per cell each way.
Surface image_of(const Grid& grid, double largest, int zoom) {
  Surface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, grid.nx * zoom, grid.ny * zoom));
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS) return nullptr;
  unsigned char* bytes = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int row = 0; row < grid.ny * zoom; ++row) {
    auto* out = reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(row) * stride);
    const int iy = grid.ny - 1 - row / zoom;
    for (int ix = 0; ix < grid.nx; ++ix)
      std::fill_n(out + ix * zoom, zoom, pixel(strain_color(shown(grid, ix, iy) / largest)));
  }
  cairo_surface_mark_dirty(image.get());
  return image;
}

}  // namespace

namespace {

template <class Items>
double largest_of(const Items& items) {
  std::vector<double> yielding;
  for (const auto& item : items)
    if (item.strain > 0) yielding.push_back(item.strain);
  if (yielding.empty()) return 0;
  const auto place = yielding.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(yielding.size() - 1));
  std::nth_element(yielding.begin(), place, yielding.end());
  const double step = round_step(*place / 5);
  return std::ceil(*place / step - 0.1) * step;
}

}  // namespace

double largest_shown(const std::vector<Cell>& cells) { return largest_of(cells); }
double largest_shown(const std::vector<Grain>& grains) { return largest_of(grains); }

void draw_strain(cairo_t* cr, const Sheet& sheet, const Layout& layout, double largest) {
  if (!(largest > 0)) return;
  const Grid grid = grid_of(sheet, layout.world);
  const int zoom = std::clamp(1600 / std::max(grid.nx, grid.ny), 1, 8);
  const Surface image = image_of(grid, largest, zoom);
  if (!image) return;
  cairo_save(cr);
  trace(cr, layout.to_page(sheet.exterior), true);
  cairo_clip(cr);
  const Point corner = layout.to_page(Point{layout.world.x0, layout.world.y0 + grid.ny * sheet.spacing_y});
  cairo_translate(cr, corner.x, corner.y);
  cairo_scale(cr, layout.scale * sheet.spacing_x / zoom, layout.scale * sheet.spacing_y / zoom);
  cairo_set_source_surface(cr, image.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_restore(cr);
}

}  // namespace cli::picture
