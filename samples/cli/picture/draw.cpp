// One picture on one page: measure, open a page of that size, paint the parts.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "parts.h"

namespace cli::picture {

namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cr) const { cairo_destroy(cr); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Pen = std::unique_ptr<cairo_t, Destroy>;

constexpr double kPixelsPerPoint = 3;  // 216 per inch

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Letters keep their shape and width at every size, so that what was measured is what is drawn.
Pen pen_on(cairo_surface_t* surface) {
  Pen pen(cairo_create(surface));
  std::unique_ptr<cairo_font_options_t, Destroy> options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(pen.get(), options.get());
  return pen;
}

Layout measure(const Sheet& sheet) {
  const Surface scratch(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Pen pen = pen_on(scratch.get());
  return arrange(pen.get(), sheet);
}

Surface open_page(Format format, const Layout& layout, std::string& bytes) {
  switch (format) {
    case Format::kSvg:
      return Surface(cairo_svg_surface_create_for_stream(append, &bytes, layout.page_width, layout.page_height));
    case Format::kPdf:
      return Surface(cairo_pdf_surface_create_for_stream(append, &bytes, layout.page_width, layout.page_height));
    case Format::kPng:
      break;
  }
  Surface page(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                          static_cast<int>(std::ceil(layout.page_width * kPixelsPerPoint)),
                                          static_cast<int>(std::ceil(layout.page_height * kPixelsPerPoint))));
  cairo_surface_set_device_scale(page.get(), kPixelsPerPoint, kPixelsPerPoint);
  return page;
}

void paint(cairo_t* cr, const Sheet& sheet, const Layout& layout) {
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  const bool moving = !sheet.grains.empty();
  const double largest = sheet.full_strain > 0 ? sheet.full_strain
                         : moving              ? largest_shown(sheet.grains)
                                               : largest_shown(sheet.cells);
  draw_axes(cr, layout);
  draw_standing_water(cr, sheet, layout);
  if (moving) {
    draw_grains(cr, sheet, layout, largest);
  } else {
    draw_materials(cr, sheet, layout);
    draw_strain(cr, sheet, layout, largest);
  }
  draw_outlines(cr, sheet, layout);
  draw_water_table(cr, sheet, layout);
  draw_supports(cr, sheet, layout);
  draw_loads(cr, sheet, layout);
  draw_seismic(cr, sheet, layout);
  draw_slip(cr, sheet, layout);
  draw_soil_legend(cr, sheet, layout);
  draw_color_bar(cr, layout, largest);
  for (const TextBlock& block : layout.texts)
    for (std::size_t i = 0; i < block.lines.size(); ++i)
      write(cr, {block.first_baseline.x, block.first_baseline.y + static_cast<double>(i) * block.line_height},
            block.lines[i], block.style);
}

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

std::string draw(const Sheet& sheet, Format format) {
  std::string bytes;
  const Layout layout = measure(sheet);
  const Surface page = open_page(format, layout, bytes);
  require(cairo_surface_status(page.get()));
  {
    const Pen pen = pen_on(page.get());
    paint(pen.get(), sheet, layout);
    require(cairo_status(pen.get()));
  }
  if (format == Format::kPng) require(cairo_surface_write_to_png_stream(page.get(), append, &bytes));
  cairo_surface_finish(page.get());
  require(cairo_surface_status(page.get()));
  return bytes;
}

}  // namespace cli::picture
