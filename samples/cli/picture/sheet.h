// What a picture of a slope shows, as plain data in metres; drawing it needs no engine.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace cli::picture {

struct Point {
  double x = 0, y = 0;
};
using Polyline = std::vector<Point>;

struct Material {
  std::string name, parameters;
};

/// Painted in order; an empty polygon fills the exterior.
struct Layer {
  int material = 0;
  Polyline polygon;
};

enum class Hold { kFixed, kRoller, kMoving };

/// A held piece of the outline.
struct Support {
  Hold hold = Hold::kFixed;
  Polyline line;
};

/// Pressure on the ground surface in kPa, down positive.
struct Load {
  double x0 = 0, x1 = 0, pressure = 0, pressure_end = 0;
};

/// One particle where it was before it moved.
struct Cell {
  double x = 0, y = 0, strain = 0;
};

/// One particle where it is now: a disc of its own volume.
struct Grain {
  double x = 0, y = 0, radius = 0, strain = 0;
  int material = 0;
};

struct Sheet {
  std::string title, subtitle, result, footer;
  std::string note;    ///< how the result came about, "" = nothing to say
  std::string remark;  ///< what to beware of, in a warning colour, "" = nothing
  Polyline exterior;
  std::vector<Material> materials;
  std::vector<Layer> layers;
  std::vector<Support> supports;
  std::vector<Load> loads;
  Polyline water;  ///< the water table, left to right; empty = dry
  double kh = 0, kv = 0;
  std::vector<Cell> cells;
  double spacing_x = 1, spacing_y = 1;
  double full_strain = 0;     ///< strain of the darkest colour; 0 = that of the particles
  std::vector<Grain> grains;  ///< not empty: soil in motion, drawn instead of cells and layers
  Polyline slip;              ///< empty = none found
};

enum class Format { kSvg, kPng, kPdf };

/// The bytes of the picture file. Throws std::runtime_error with the drawing library's reason.
std::string draw(const Sheet& sheet, Format format);

}  // namespace cli::picture
