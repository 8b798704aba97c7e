// A model as others see it, as bytes.
#include "exchange/snapshot.h"

#include <algorithm>

#include "arrays.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

template <class Number>
std::vector<Number> rows_of(const Simulation& simulation, const char* field) {
  std::vector<Number> rows;
  simulation.read(find_field(field), rows);
  return rows;
}

std::vector<double> pressures_of(const Simulation& simulation) {
  std::vector<double> pressures = rows_of<double>(simulation, "pore_pressure");
  const bool dry = std::all_of(pressures.begin(), pressures.end(), [](double p) { return p == 0; });
  return dry ? std::vector<double>() : pressures;
}

Snapshot snapshot_of(const Simulation& simulation) {
  Snapshot s;
  s.version = VBGPD_VERSION_STRING;
  s.name = simulation.scene().name;
  for (const MaterialDef& m : simulation.scene().materials) s.materials.push_back(m.name);
  s.time = simulation.get("time");
  s.steps = static_cast<std::int64_t>(simulation.get("steps"));
  s.strength_reduction_factor = simulation.get("strength_reduction_factor");
  s.spacing_x = simulation.get("spacing_x"), s.spacing_y = simulation.get("spacing_y");
  s.state_hash = simulation.state_hash();
  s.particle_id = rows_of<std::int64_t>(simulation, "particle_id");
  s.material = rows_of<std::int64_t>(simulation, "material");
  s.boundary = rows_of<std::int64_t>(simulation, "boundary");
  s.position = rows_of<double>(simulation, "position");
  s.displacement = rows_of<double>(simulation, "displacement");
  s.velocity = rows_of<double>(simulation, "velocity");
  s.stress = rows_of<double>(simulation, "stress");
  s.plastic_strain = rows_of<double>(simulation, "plastic_strain");
  s.volume = rows_of<double>(simulation, "volume");
  s.pore_pressure = pressures_of(simulation);
  return s;
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_snapshot(const vbgpd_model* model, void* buf, int64_t cap, int64_t* needed) {
  return with(model, [&](ModelObject& object) {
    bytes_out(snapshot_to_bytes(snapshot_of(*object.engine->simulation)), buf, cap, needed, 2);
    return Status::kOk;
  });
}
