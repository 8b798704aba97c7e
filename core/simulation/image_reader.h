// Reading a StateImage that may come from anywhere: what is missing, too much or out of range is refused.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/state_image.h"
#include "simulation/simulation.h"

namespace vbgpd {

[[noreturn]] inline void refuse_image(const std::string& text) {
  throw Error(Status::kFormat, "the checkpoint " + text);
}

inline double image_number(const StateImage& image, std::string_view name, double low, double high) {
  for (const StateImage::Number& n : image.numbers) {
    if (n.name != name) continue;
    if (n.value >= low && n.value <= high) return n.value;
    refuse_image("has an impossible " + n.name);
  }
  refuse_image("lacks the number " + std::string(name));
}

/// A number that images of earlier versions do not have.
inline double image_number_or(const StateImage& image, std::string_view name, double low, double high, double absent) {
  const bool there =
      std::any_of(image.numbers.begin(), image.numbers.end(), [&](const auto& n) { return n.name == name; });
  return there ? image_number(image, name, low, high) : absent;
}

/// Values of an array of that many rows, or nullptr when the checkpoint has none of that name.
inline const std::vector<double>* image_rows(const StateImage& image, std::string_view name, int components,
                                             std::size_t count) {
  for (const StateImage::Rows& r : image.rows) {
    if (r.name != name) continue;
    if (r.components != components || r.values.size() != count * static_cast<std::size_t>(components))
      refuse_image("has the wrong number of values of " + r.name);
    for (const double v : r.values)
      if (!std::isfinite(v)) refuse_image("has a value of " + r.name + " that is not finite");
    return &r.values;
  }
  return nullptr;
}

inline void add_layers(const Layers& layers, StateImage& image) {
  if (!layers.empty()) image.rows.push_back({"active_layer", 1, {layers.begin(), layers.end()}});
}

/// Which layers are there; images of models that never switched any do not say.
inline Layers layers_of(const StateImage& image, std::size_t count) {
  const auto* there = image_rows(image, "active_layer", 1, count);
  Layers layers;
  if (there == nullptr) return layers;
  for (const double v : *there) {
    if (v != 0 && v != 1) refuse_image("has a layer that is neither there nor not");
    layers.push_back(v == 1);
  }
  return std::find(layers.begin(), layers.end(), false) == layers.end() ? Layers() : layers;
}

inline void add_drive(const Drive& drive, StateImage& image) {
  image.numbers.push_back({"kh", drive.kh});
  image.numbers.push_back({"kv", drive.kv});
  std::vector<double> pressures, velocities;
  for (const LoadDef& l : drive.loads) pressures.insert(pressures.end(), {l.pressure, l.pressure_end});
  for (const Vec2& v : drive.velocities) velocities.insert(velocities.end(), {v.x(), v.y()});
  image.rows.push_back({"load_pressure", 2, std::move(pressures)});
  image.rows.push_back({"boundary_velocity", 2, std::move(velocities)});
}

/// The drive of an image; where loads act and what else it does not tell is that of `drive`.
inline Drive drive_from(const StateImage& image, Drive drive) {
  drive.kh = image_number(image, "kh", -1, 1), drive.kv = image_number(image, "kv", -1, 1);
  if (const auto* p = image_rows(image, "load_pressure", 2, drive.loads.size()))
    for (std::size_t k = 0; k < drive.loads.size(); ++k)
      drive.loads[k].pressure = (*p)[2 * k], drive.loads[k].pressure_end = (*p)[2 * k + 1];
  if (const auto* v = image_rows(image, "boundary_velocity", 2, drive.velocities.size()))
    for (std::size_t k = 0; k < drive.velocities.size(); ++k) drive.velocities[k] = Vec2((*v)[2 * k], (*v)[2 * k + 1]);
  return drive;
}

}  // namespace vbgpd
