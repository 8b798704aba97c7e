// Dynamic steps at and past the stable time step, free bodies, long rests, restarts in the middle of failure.
#include <algorithm>

#include "analysis/job.h"
#include "row.h"
#include "simulation/flow_simulation.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd::stability {

namespace {

std::unique_ptr<LatticeSimulation> compiled(const SceneDef& s) {
  return std::make_unique<LatticeSimulation>(s, CompileOptions{}, best_kernels());
}

SceneDef with_law(const char* law) {
  SceneDef s = base_slope();
  s.materials[0].law = law;
  return s;
}

bool readable(const Simulation& simulation) {
  for (const char* field : {"displacement", "velocity", "stress", "plastic_strain"}) {
    std::vector<double> values;
    simulation.read(find_field(field), values);
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) return false;
  }
  return true;
}

/// So many dynamic steps, and whether all that can be read is finite after them.
Outcome stepped(Simulation& simulation, std::int64_t steps) {
  const StepReport r = simulation.step(steps, nullptr);
  Outcome o;
  o.steps = static_cast<double>(r.steps);
  o.verdict = r.status == Status::kDiverged ? "diverged" : "stable";
  if (!readable(simulation)) o.verdict += ", unreadable";
  if (r.status == Status::kOk) o.energy_residual = simulation.get("energy_residual");
  else o.note = "back at its last good step, max |u| " + std::to_string(simulation.get("max_displacement")) + " m";
  return o;
}

/// A slope let go under its weight, at a share of the stable time step.
Case time_step(const char* law, double factor, bool fast) {
  char name[80];
  std::snprintf(name, sizeof name, "%s, time step %.3g of the stable one", law, factor);
  Case c{name, factor > 1 ? "diverged" : "stable", kNone, kNone, kNone, fast, {}};
  if (factor < 1) c.most_residual = law == std::string("elastic") ? 1e-6 : 1e-3;
  c.run = [law, factor] {
    const auto simulation = compiled(with_law(law));
    simulation->set("time_step_factor", factor);
    return stepped(*simulation, 4000);
  };
  if (factor > 0.3) c.known = "residual grows with the time step";
  return c;
}

struct Momentum {
  double x = 0, y = 0, angular = 0, size = 0, angular_size = 0;
};

Momentum momentum(const Simulation& simulation) {
  std::vector<double> v, m, x;
  simulation.read(find_field("velocity"), v);
  simulation.read(find_field("mass"), m);
  simulation.read(find_field("reference_position"), x);
  Momentum p;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double px = m[i] * v[2 * i], py = m[i] * v[2 * i + 1];
    p.x += px, p.y += py, p.size += std::hypot(px, py);
    p.angular += x[2 * i] * py - x[2 * i + 1] * px,
        p.angular_size += std::hypot(x[2 * i], x[2 * i + 1]) * std::hypot(px, py);
  }
  return p;
}

SceneDef free_body(double unit_weight) {
  SceneDef s = with_law("elastic");
  s.materials[0].unit_weight = unit_weight;
  s.exterior = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  BoundaryDef base;
  base.side = "base", base.kind = BoundaryKind::kFree;
  s.boundaries = {base};
  return s;
}

Case free_fall() {
  Case c{"free body falling, 2000 steps", "stable", kNone, kNone, 1e-10, true, {}};
  c.run = [] {
    const auto simulation = compiled(free_body(20e3));
    const StepReport r = simulation->step(2000, nullptr);
    Outcome o;
    o.verdict = r.status == Status::kOk ? "stable" : "diverged", o.steps = static_cast<double>(r.steps);
    const Momentum p = momentum(*simulation);
    const double impulse = simulation->get("total_mass") * simulation->scene().gravity * simulation->get("time");
    o.momentum_drift = std::hypot(p.x, p.y + impulse) / impulse;
    return o;
  };
  return c;
}

Case ringing() {
  Case c{"free body ringing from random velocities, 20000 steps", "stable", kNone, 1e-2, 1e-10, true, {}};
  c.run = [] {
    SceneDef s = free_body(20e3);
    const auto simulation = compiled(s);
    for (std::int64_t i = 0; i < simulation->model().storage; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (simulation->model().seed_of[k] < 0) continue;
      simulation->state().velocity_x[k] = std::sin(12.9898 * static_cast<double>(i));
      simulation->state().velocity_y[k] = std::sin(78.233 * static_cast<double>(i));
    }
    const Momentum before = momentum(*simulation);
    const double start = simulation->get("kinetic_energy");
    const StepReport r = simulation->step(20000, nullptr);
    Outcome o;
    o.verdict = r.status == Status::kOk ? "stable" : "diverged", o.steps = static_cast<double>(r.steps);
    const Momentum after = momentum(*simulation);
    const double impulse = simulation->get("total_mass") * simulation->scene().gravity * simulation->get("time");
    o.momentum_drift = std::hypot(after.x - before.x, after.y - before.y + impulse) / (before.size + impulse);
    const double end = simulation->get("kinetic_energy") + simulation->get("elastic_energy");
    o.energy_residual = std::fabs(end - start - simulation->get("external_work")) / std::max(start, end);
    return o;
  };
  return c;
}

/// At rest under its weight, then left alone for so many dynamic steps without damping.
Case rest(std::int64_t steps, bool fast) {
  Case c{"at rest for " + std::to_string(steps) + " steps", "at rest", kNone, kNone, 1e-6, fast, {}};
  c.run = [steps] {
    const auto simulation = compiled(base_slope());
    RelaxReport settled;
    for (int n = 0; n < 2000; ++n) {
      settled = simulation->relax(50, {});
      if (settled.unbalanced_force_ratio < 1e-13) break;
    }
    simulation->halt();
    const double before = settled.max_displacement;
    const StepReport r = simulation->step(steps, nullptr);
    Outcome o;
    o.steps = static_cast<double>(r.steps);
    const double creep = std::fabs(simulation->get("max_displacement") / before - 1);
    const double wave = std::sqrt(1e8 * 9.81 / 20e3);  // sqrt(E / rho), m/s
    o.momentum_drift = creep;
    o.verdict = r.status == Status::kOk && creep < 1e-6 ? "at rest" : "creeps";
    char note[120];
    std::snprintf(note, sizeof note, "drift = creep of max |u|; velocity noise %.1e of the wave speed",
                  simulation->get("max_velocity") / wave);
    o.note = note;
    return o;
  };
  return c;
}

Case restart() {
  Case c{"restart in the middle of failure", "same bits", kNone, kNone, kNone, true, {}};
  c.run = [] {
    const auto simulation = compiled(base_slope());
    simulation->set("strength_reduction_factor", 1.8);
    simulation->relax(800, {});
    const auto saved = simulation->save();
    simulation->relax(400, {});
    const std::uint64_t through = simulation->state_hash();
    simulation->restore(*saved);
    simulation->relax(400, {});
    const std::uint64_t again = simulation->state_hash();
    const auto other = compiled(base_slope());
    other->restore(*saved);
    other->relax(400, {});
    Outcome o;
    o.steps = 1600;
    o.verdict = through == again && other->state_hash() == through ? "same bits" : "different";
    o.note = std::to_string(static_cast<long long>(simulation->get("plastic_bonds"))) + " plastic bonds";
    return o;
  };
  return c;
}

/// Soil thrown on its base at a share of the wave speed sqrt(E / rho). Strains grow with that share: at the wave speed
/// itself small displacements mean nothing any more, but nothing may become infinite unseen.
Case impact(const char* where, bool runs_out, double share) {
  char name[80];
  std::snprintf(name, sizeof name, "impact at %g of the wave speed, %s", share, where);
  Case c{name, "stable", kNone, 1e-2, kNone, true, {}};
  if (!runs_out) c.known = "plastic volume of large or uneven steps";
  c.run = [runs_out, share] {
    SceneDef s = with_law("mohr_coulomb");
    const auto lattice = Simulation::compile(s, {});
    const double wave = std::sqrt(s.materials[0].young_modulus * s.gravity / s.materials[0].unit_weight);
    std::vector<double> v(2 * static_cast<std::size_t>(lattice->particle_count()), 0.0);
    for (std::size_t k = 1; k < v.size(); k += 2) v[k] = -share * wave;
    lattice->write(find_field("velocity"), v);
    const auto flow = runs_out ? make_runout(*lattice) : nullptr;
    return stepped(runs_out ? *flow : *lattice, 3000);
  };
  return c;
}

/// Pore pressure of a share of the overburden in all of the soil: less and less friction is left.
Case pore_pressure(double share) {
  char name[80];
  std::snprintf(name, sizeof name, "pore pressure %g of the overburden", share);
  Case c{name, "OK", kNone, kNone, kNone, true, {}};
  c.run = [share] {
    const SceneDef s = base_slope();
    const auto simulation = Simulation::compile(s, {});
    std::vector<double> x, p;
    simulation->read(find_field("reference_position"), x);
    for (std::size_t i = 0; i < x.size() / 2; ++i) {
      const double ground = x[2 * i] < 12 ? 10 : 10 - (x[2 * i] - 12) / 2;
      p.push_back(share * s.materials[0].unit_weight * std::max(0.0, ground - x[2 * i + 1]));
    }
    simulation->write(find_field("pore_pressure"), p);
    const auto job = make_strength_reduction(*simulation);
    job->set("levels", 1);
    job->run(0, {});
    Outcome o;
    o.verdict = job->result().status, o.factor_of_safety = job->result().factor_of_safety;
    o.steps = static_cast<double>(job->result().steps);
    if (o.verdict != "OK") o.note = job->result().reason;
    return o;
  };
  return c;
}

Case million() {
  Case c{"a million particles", "stable", kNone, kNone, kNone, false, {}};
  c.run = [] {
    SceneDef s = base_slope();
    s.spacing = 0.0148;
    const auto simulation = compiled(s);
    const RelaxReport r = simulation->relax(50, {});
    Outcome o;
    o.steps = static_cast<double>(r.steps);
    o.verdict = r.diverged ? "diverged" : "stable";
    char note[80];
    std::snprintf(note, sizeof note, "%lld particles, %.0f bytes each",
                  static_cast<long long>(simulation->particle_count()),
                  simulation->get("bytes") / static_cast<double>(simulation->particle_count()));
    o.note = note;
    return o;
  };
  return c;
}

}  // namespace

std::vector<Case> dynamic_cases() {
  std::vector<Case> all;
  for (const char* law : {"elastic", "mohr_coulomb"})
    for (const double factor : {0.1, 0.5, 0.9, 0.99, 1.01, 2.0}) all.push_back(time_step(law, factor, true));
  all.push_back(free_fall());
  all.push_back(ringing());
  all.push_back(rest(20000, true));
  all.push_back(rest(1000000, false));
  all.push_back(restart());
  for (const double share : {0.01, 0.1, 1.0}) all.push_back(impact("fixed bonds", false, share));
  for (const double share : {0.01, 0.1}) all.push_back(impact("run-out", true, share));
  for (const double share : {0.5, 0.95}) all.push_back(pore_pressure(share));
  all.push_back(million());
  return all;
}

}  // namespace vbgpd::stability
