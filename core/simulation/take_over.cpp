#include "simulation/take_over.h"

#include <algorithm>

#include "simulation/ground_water.h"
#include "simulation/scattered.h"

namespace vbgpd {

namespace {

std::vector<double> read(const Simulation& simulation, const char* field) {
  std::vector<double> rows;
  simulation.read(find_field(field), rows);
  return rows;
}

bool all_zero(const std::vector<double>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](double v) { return v == 0; });
}

std::vector<Point> places(const Simulation& simulation) {
  const std::vector<double> xy = read(simulation, "reference_position");
  std::vector<Point> out(xy.size() / 2);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = {xy[2 * k], xy[2 * k + 1]};
  return out;
}

/// Soil particles that are there.
std::vector<bool> present_soil(const Simulation& simulation) {
  const std::vector<double> boundary = read(simulation, "boundary"), active = read(simulation, "active");
  std::vector<bool> out(boundary.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = boundary[k] < 0 && active[k] > 0;
  return out;
}

/// Every force goes to the nearest soil particle of the other grid.
std::vector<double> moved_forces(const std::vector<Point>& from, const std::vector<double>& forces,
                                 const std::vector<double>& acts, const std::vector<Point>& to,
                                 const std::vector<bool>& there, double spacing) {
  std::vector<Point> soil;
  std::vector<std::size_t> id;
  for (std::size_t k = 0; k < to.size(); ++k)
    if (there[k]) soil.push_back(to[k]), id.push_back(k);
  const Buckets buckets(soil, spacing);
  std::vector<double> out(2 * to.size(), 0);
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (acts[k] == 0 || (forces[2 * k] == 0 && forces[2 * k + 1] == 0)) continue;
    const std::size_t k_to = id[buckets.nearest(soil, from[k].x, from[k].y)];
    out[2 * k_to] += forces[2 * k], out[2 * k_to + 1] += forces[2 * k + 1];
  }
  return out;
}

}  // namespace

void take_over(const Simulation& from, Simulation& to) {
  to.set_layers(from.layers());
  to.set_drive(from.drive());
  const std::vector<double> pressures = read(from, "pore_pressure"), forces = read(from, "external_force");
  // the other grid has the water of the scene already, better than it could be carried over
  const bool wetted = (has_ground_water(from.scene()) || !all_zero(pressures)) &&
                      pressures != scene_pore_pressure(from.scene(), from.section());
  if (!wetted && all_zero(forces)) return;
  const std::vector<Point> here = places(from), there = places(to);
  if (wetted) {
    const Scattered field(here, pressures, 1);
    std::vector<double> rows(there.size());
    for (std::size_t k = 0; k < there.size(); ++k) field.at(there[k].x, there[k].y, &rows[k]);
    to.write(find_field("pore_pressure"), rows);
  }
  if (!all_zero(forces))
    to.write(find_field("external_force"),
             moved_forces(here, forces, read(from, "active"), there, present_soil(to), to.get("spacing_x")));
}

}  // namespace vbgpd
