#include "simulation/build_flow.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/outline.h"
#include "scene/quantity.h"
#include "simulation/cohesion_gradient.h"
#include "simulation/ground_water.h"
#include "simulation/outside.h"
#include "step/flow_kernels.h"

namespace vbgpd {

namespace {

static_assert(std::all_of(kBondLaws.begin(), kBondLaws.end(),
                          [](const BondLawName& law) { return static_cast<int>(law.in_runout) < kFlowBondLaws; }));

[[noreturn]] void unsupported(ObjectKind object, std::int64_t id, const std::string& text) {
  Issue issue;
  issue.status = Status::kUnsupported, issue.object = object, issue.object_id = id, issue.text = text;
  throw Error(issue);
}

void add_materials(const SceneDef& scene, FlowModel& m) {
  m.materials = static_cast<int>(scene.materials.size());
  for (const MaterialDef& d : scene.materials) {
    const AnyLaw law = *law_by_name(d.law);
    Strength s;
    s.cohesion = std::isnan(d.cohesion) ? 0 : d.cohesion;
    s.friction_angle = radians(d.friction_angle);
    const bool springs = m.bond == FlowBondLaw::kPseudoSpring;
    if (springs && d.cohesion_gradient > 0)
      unsupported(ObjectKind::kMaterial, static_cast<std::int64_t>(m.law.size()),
                  "material '" + d.name +
                      "': cohesion_gradient = " + quantity_text(d.cohesion_gradient, "Pa m-1", scene.units) +
                      " cannot be had with bond \"pseudo_spring\", whose springs have one strength; leave it out");
    if (!std::isnan(d.tension_cutoff) && yields(law)) s.tension_cutoff = d.tension_cutoff;
    else if (yields(law) && !springs) s.tension_cutoff = 0;
    m.law.push_back(law);
    m.strength.push_back(s);
    m.moduli.push_back(derive(Elastic{}, d.young_modulus, d.poisson_ratio, {}));
  }
}

/// One wall for each straight run of held edges; where nothing adjoins, the wall goes on beyond the section.
std::vector<FlowWall> walls_of(const Section& section, const SceneDef& scene) {
  const Vertices exterior = local(counter_clockwise(scene.exterior), section.lattice.origin);
  std::vector<HeldEdge> edges = held_edges(section.boundaries, exterior, section.lattice.origin);
  const Real same = 1e-9 * box_of(exterior).extent();
  const auto straight = [&](const HeldEdge& e, const HeldEdge& f) {
    return e.hold == f.hold && e.boundary == f.boundary && (e.b - f.a).norm() <= same &&
           e.normal.dot(f.normal) > 1 - 1e-12;
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < edges.size();) {
      if (i == j || !straight(edges[i], edges[j])) {
        ++j;
        continue;
      }
      edges[i].b = edges[j].b;
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(j));
      if (j < i) --i;
      j = 0;
    }
  std::vector<FlowWall> walls;
  for (const HeldEdge& e : edges) {
    if (e.hold == Hold::kVelocity)
      unsupported(ObjectKind::kBoundary, e.boundary,
                  "a boundary that moves with a prescribed velocity cannot be carried over into a run-out; make it "
                  "fixed or a roller");
    const auto starts_here = [&](const HeldEdge& f) { return (f.a - e.b).norm() <= same; };
    const auto ends_here = [&](const HeldEdge& f) { return (f.b - e.a).norm() <= same; };
    FlowWall w;
    w.x = e.a.x(), w.y = e.a.y(), w.nx = -e.normal.x(), w.ny = -e.normal.y();
    w.low = std::any_of(edges.begin(), edges.end(), ends_here) ? 0 : -kInfinity;
    w.high = std::any_of(edges.begin(), edges.end(), starts_here) ? (e.b - e.a).norm() : kInfinity;
    w.rough = e.hold == Hold::kFixed ? 1 : 0;
    w.boundary = e.boundary;
    const double angle = section.boundaries[static_cast<std::size_t>(e.boundary)].friction_angle;
    if (e.hold == Hold::kFixed && !std::isnan(angle)) w.rough = 0, w.friction = std::tan(radians(angle));
    const auto next = std::find_if(edges.begin(), edges.end(), starts_here);
    if (next != edges.end()) w.next = static_cast<std::int32_t>(next - edges.begin());
    walls.push_back(w);
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    FlowWall& w = walls[k];
    if (w.next < 0) continue;
    FlowWall& next = walls[static_cast<std::size_t>(w.next)];
    next.previous = static_cast<std::int32_t>(k);
    w.hollow_high = next.hollow_low = next.ny * w.nx - next.nx * w.ny > 0;
  }
  return walls;
}

bool is_soil(const Seed& seed) { return seed.hold == Hold::kFree && seed.active; }

/// Loads press on the outermost particle of every column. The discrete normal of the operators (surface_load.h) has
/// parts of both signs in the rows below: they cancel while the rows stay together, and throw soil up once it comes
/// apart.
std::vector<bool> outermost(const Section& section) {
  std::map<Index, std::size_t> top;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (!is_soil(seed)) continue;
    const auto [at, fresh] = top.try_emplace(seed.ix, k);
    if (!fresh && section.seeds[at->second].iy < seed.iy) at->second = k;
  }
  std::vector<bool> outermost(section.seeds.size(), false);
  for (const auto& [column, k] : top) outermost[k] = true;
  return outermost;
}

/// Rows of the soil that is there, one after the other as a run-out numbers it.
std::vector<double> soil_rows(const LatticeSimulation& from, const char* field, std::size_t components) {
  std::vector<double> all, rows;
  from.read(find_field(field), all);
  for (std::size_t k = 0; k < from.section().seeds.size(); ++k) {
    if (!is_soil(from.section().seeds[k])) continue;
    const std::size_t row = components * static_cast<std::size_t>(from.model().id_of[k]);
    for (std::size_t c = 0; c < components; ++c) rows.push_back(all[row + c]);
  }
  return rows;
}

void add_particles(const LatticeSimulation& from, FlowModel& m) {
  const Section& section = from.section();
  const Model& lattice = from.model();
  m.particles = std::count_if(section.seeds.begin(), section.seeds.end(), is_soil);
  const auto n = static_cast<std::size_t>(m.particles);
  for (Array* a : {&m.volume, &m.mass, &m.force_x, &m.force_y, &m.weight, &m.reference_x, &m.reference_y, &m.size})
    a->allocate(n, 0, m.heap);
  const bool loaded = !from.drive().loads.empty();
  const std::vector<bool> bears = loaded ? outermost(section) : std::vector<bool>();
  m.surface_area.allocate(loaded ? n : 0, 0, m.heap);
  m.extra_cohesion.allocate(lattice.extra_cohesion.present() ? n : 0, 0, m.heap);
  m.material.resize(n);
  std::size_t next = 0;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& seed = section.seeds[k];
    if (!is_soil(seed)) continue;
    const std::size_t id = next++;
    const auto i = static_cast<std::size_t>(lattice.storage_of[k]);
    m.volume[id] = seed.volume, m.mass[id] = lattice.mass[i], m.size[id] = std::sqrt(seed.volume);
    m.weight[id] = unit_weight_at(from.scene(), seed.material, section.place(k)) * seed.volume;
    if (loaded) m.surface_area[id] = bears[k] ? section.lattice.spacing.x() : 0;
    const Vec2 at = section.shifts.empty() ? seed.centroid : Vec2(seed.centroid + section.shifts[k]);
    const Vec2 reference = at - m.origin;
    m.reference_x[id] = reference.x(), m.reference_y[id] = reference.y();
    m.material[id] = seed.material;
    if (m.extra_cohesion.present())
      m.extra_cohesion[id] = extra_cohesion(from.scene().materials[static_cast<std::size_t>(seed.material)],
                                            section.place(k).y());
  }
}

/// The springs of Coulomb walls carry from the start what the shear stress of the row next to them carried there.
void load_contacts(const FlowModel& m, FlowState& s) {
  for (const FlowWall& w : m.walls) {
    if (w.friction < 0) continue;
    for (std::size_t id = 0; id < static_cast<std::size_t>(m.particles); ++id) {
      const double x = s.motion[4 * id] - w.x, y = s.motion[4 * id + 1] - w.y;
      const double along = x * w.ny - y * w.nx, distance = x * w.nx + y * w.ny;
      if (along < w.low || along > w.high || !(distance < m.size[id])) continue;
      const double xx = s.stress[4 * id], yy = s.stress[4 * id + 1], xy = s.stress[4 * id + 2];
      const double shear = (xx - yy) * w.nx * w.ny + xy * (w.ny * w.ny - w.nx * w.nx);  // along (ny, -nx) on face n
      const LawConstants& moduli = m.moduli[static_cast<std::size_t>(m.material[id])];
      s.wall_shear[id] = shear * m.size[id] / moduli.shear_modulus;
      const double pressure = -(s.stress[4 * id + 3] + xx * w.nx * w.nx + yy * w.ny * w.ny + 2 * xy * w.nx * w.ny);
      s.wall_limit[id] = w.friction * std::max(pressure, 0.0) * m.size[id];
    }
  }
}

}  // namespace

FlowModel build_flow_model(const LatticeSimulation& from, const FlowOptions& options) {
  const SceneDef& scene = from.scene();
  if (scene.kernel != "wendland_c2")
    unsupported(ObjectKind::kProfile, -1,
                "kernel '" + scene.kernel + "': a run-out knows wendland_c2 only; set the profile's kernel to it");
  if (water_stands(scene, from.section()))
    unsupported(
        ObjectKind::kProfile, -1,
        "water stands on the ground (the water table runs above it); a run-out into standing water is not known: "
        "its thrust would have to follow the moving surface. Lower the water table to the ground");
  FlowModel m;
  m.options = options;
  m.heap = from.options().heap;
  m.bond = bond_law_by_name(scene.bond)->in_runout;
  m.origin = from.section().lattice.origin;
  const Vec2 spacing = from.section().lattice.spacing;
  m.spacing = std::sqrt(spacing.prod());
  m.support = 2 * scene.smoothing_ratio * m.spacing;
  m.height = from.section().height, m.gravity = scene.gravity;
  m.stress_scale = from.model().stress_scale;
  m.stiffness = from.model().stiffness;
  add_materials(scene, m);
  m.walls = walls_of(from.section(), scene);
  add_particles(from, m);
  Real fastest = 0;
  for (std::size_t id = 0; id < m.material.size(); ++id) {
    const LawConstants& c = m.moduli[static_cast<std::size_t>(m.material[id])];
    const Real wave = c.bulk_modulus + 4 * c.shear_modulus / 3;
    fastest = std::max(fastest, std::sqrt(wave * m.volume[id] / m.mass[id]));
  }
  if (m.bond == FlowBondLaw::kVirtual || m.bond == FlowBondLaw::kNone)
    m.viscosity = options.viscosity * std::sqrt(m.gravity * m.height) * options.viscosity_length * m.height;
  else
    m.viscosity = (std::any_of(m.law.begin(), m.law.end(), [](const AnyLaw& law) { return yields(law); })
                       ? options.wave_viscosity
                       : options.elastic_wave_viscosity) *
                  fastest * m.support / 2;
  m.time_step = options.time_step * spacing.minCoeff() / fastest;
  return m;
}

FlowState handed_over(const LatticeSimulation& from, const FlowModel& m) {
  FlowState s;
  s.allocate(m);
  const std::vector<double> displacement = soil_rows(from, "displacement", 2), stress = soil_rows(from, "stress", 4),
                            plastic = soil_rows(from, "plastic_strain", 1);
  for (std::size_t id = 0; id < static_cast<std::size_t>(m.particles); ++id) {
    s.particle[id] = static_cast<double>(id);
    s.motion[4 * id] = m.reference_x[id] + displacement[2 * id];
    s.motion[4 * id + 1] = m.reference_y[id] + displacement[2 * id + 1];
    const double mean = (stress[4 * id] + stress[4 * id + 1] + stress[4 * id + 2]) / 3;
    s.stress[4 * id] = stress[4 * id] - mean, s.stress[4 * id + 1] = stress[4 * id + 1] - mean;
    s.stress[4 * id + 2] = stress[4 * id + 3], s.stress[4 * id + 3] = mean;
    s.plastic_strain[id] = plastic[id];
  }
  load_contacts(m, s);
  return s;
}

Outside handed_over_forces(const LatticeSimulation& from, const FlowModel& m) {
  Outside outside;
  push_by(soil_rows(from, "external_force", 2), m.heap, outside);
  outside.pore_pressure = pressure_of(soil_rows(from, "pore_pressure", 1), m.heap);
  return outside;
}

void push_by(const std::vector<double>& forces, const Heap& heap, Outside& outside) {
  outside.external_x = outside.external_y = Array{};
  if (std::all_of(forces.begin(), forces.end(), [](double f) { return f == 0; })) return;
  outside.external_x.allocate(forces.size() / 2, 3, heap), outside.external_y.allocate(forces.size() / 2, 4, heap);
  for (std::size_t id = 0; id < forces.size() / 2; ++id)
    outside.external_x[id] = forces[2 * id], outside.external_y[id] = forces[2 * id + 1];
}

Array pressure_of(const std::vector<double>& rows, const Heap& heap) {
  Array pressure;
  if (std::all_of(rows.begin(), rows.end(), [](double p) { return p == 0; })) return pressure;
  pressure.allocate(rows.size(), 2, heap);
  std::copy(rows.begin(), rows.end(), pressure.data());
  return pressure;
}

}  // namespace vbgpd
