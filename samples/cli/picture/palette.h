// Colours with a meaning: soils are calm and cool, plastic strain is warm, so that one shows through the other.
#pragma once

#include "ink.h"

namespace cli::picture {

struct Rgba {
  double r = 0, g = 0, b = 0, a = 0;
};

/// Fill of material i; beyond the list the fills repeat and the hatching tells them apart.
void fill_material(cairo_t* cr, int material);

/// Colour of a plastic strain, t = strain / largest shown, from transparent through yellow, orange and red to dark red.
/// Lightness falls evenly, so that the order also survives a grey print.
Rgba strain_color(double t);

}  // namespace cli::picture
