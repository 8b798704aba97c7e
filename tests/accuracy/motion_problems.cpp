// Run-outs with closed forms: a block that slides, a disk that turns, a block that is sheared.
#include <cmath>
#include <numbers>

#include "problem.h"
#include "simulation/flow_simulation.h"

namespace vbgpd::accuracy {

namespace {

constexpr auto go_on = [] { return Status::kOk; };

/// An elastic block on a Coulomb plane, pushed by kh: v = g (kh - mu) t.
Outcome sliding_block(const SceneDef& choice, const CompileOptions& options) {
  constexpr double kPush = 0.3, kFriction = 0.2, kSeconds = 0.5;
  MaterialDef rock = elastic_material();
  rock.young_modulus = 1e7;
  SceneDef s = rectangle(choice, rock, 1, 0.5);
  s.boundaries = {held("base", BoundaryKind::kFixed)};
  s.boundaries[0].friction_angle = std::atan(kFriction) * 180 / std::numbers::pi;
  s.kh = kPush;
  const auto block = make_runout(*Simulation::compile(s, options));
  relax_to_rest(*block, 1e-7);
  block->halt();
  block->advance_to(kSeconds, go_on);
  const std::vector<double> v = field(*block, "velocity"), m = field(*block, "mass");
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < m.size(); ++i) momentum += m[i] * v[2 * i], mass += m[i];
  const double exact = s.gravity * (kPush - kFriction) * kSeconds;
  return outcome(*block, std::fabs(momentum / mass / exact - 1), static_cast<std::int64_t>(block->get("steps")));
}

/// A disk strained by its centrifugal force is let go with the velocities that belong to it; its stress after one turn.
/// The rim goes at a twentieth of the wave speed, so that the strain is a tenth of a per cent.
Outcome disk_turn(const SceneDef& choice, const CompileOptions& options) {
  constexpr double kRadius = 1, kRimSpeed = 0.05;
  constexpr int kChords = 256;
  const MaterialDef rock = elastic_material();
  const double nu = rock.poisson_ratio, density = rock.unit_weight / choice.gravity;
  const double wave = std::sqrt(rock.young_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / density);
  const double spin = kRimSpeed * wave / kRadius, unit = density * spin * spin / (8 * (1 - nu));
  SceneDef s = rectangle(choice, rock, 1, 1);
  s.exterior.clear();
  for (int k = 0; k < kChords; ++k) {
    const double angle = 2 * std::numbers::pi * k / kChords;
    s.exterior.push_back({kRadius * std::cos(angle), kRadius * std::sin(angle)});
  }
  s.kv = kNoWeight;
  const auto still = Simulation::compile(s, options);
  auto& lattice = dynamic_cast<LatticeSimulation&>(*still);
  // plane strain: u = rho w^2 r / (8 E') ((1 - nu') (3 + nu') R^2 - (1 - nu'^2) r^2), E' = E / (1 - nu^2), nu' = nu /
  // (1 - nu)
  const double plane_e = rock.young_modulus / (1 - nu * nu), plane_nu = nu / (1 - nu);
  for (std::size_t k = 0; k < lattice.section().seeds.size(); ++k) {
    const Seed& seed = lattice.section().seeds[k];
    const Vec2 x = lattice.section().lattice.center(seed.ix, seed.iy);
    const double stretch =
        density * spin * spin / (8 * plane_e) *
        ((1 - plane_nu) * (3 + plane_nu) * kRadius * kRadius - (1 - plane_nu * plane_nu) * x.squaredNorm());
    const auto i = static_cast<std::size_t>(lattice.model().storage_of[k]);
    lattice.state().displacement_x[i] = stretch * x.x(), lattice.state().displacement_y[i] = stretch * x.y();
  }
  const auto disk = make_runout(*still);
  std::vector<double> velocity = field(*disk, "position");
  for (std::size_t k = 0; k < velocity.size(); k += 2) {
    const double x = velocity[k];
    velocity[k] = -spin * velocity[k + 1], velocity[k + 1] = spin * x;
  }
  disk->write(find_field("velocity"), velocity);
  disk->advance_to(2 * std::numbers::pi / spin, go_on);
  const double error = polar_stress_error(
      *disk, {0, 0}, unit * (3 - 2 * nu) * kRadius * kRadius,
      [=](double r) { return unit * (3 - 2 * nu) * (kRadius * kRadius - r * r); },
      [=](double r) { return unit * ((3 - 2 * nu) * kRadius * kRadius - (1 + 2 * nu) * r * r); });
  return outcome(*disk, error, static_cast<std::int64_t>(disk->get("steps")));
}

/// Simple shear up to 1, prescribed particle by particle; the step is a fortieth of spacing / side. Jaumann's rate
/// makes sigma_xy = G sin(shear), sigma_xx = -sigma_yy = G (1 - cos(shear)).
Outcome simple_shear(const SceneDef& choice, const CompileOptions& options) {
  SceneDef s = rectangle(choice, elastic_material(), 1, 1);
  s.kv = kNoWeight;
  const auto still = Simulation::compile(s, options);
  FlowSimulation body(dynamic_cast<const LatticeSimulation&>(*still));
  FlowState& state = body.state();
  const int steps = static_cast<int>(std::lround(40 / choice.spacing));
  const double each = 1.0 / steps, dt = body.get("time_step");
  for (int k = 1; k <= steps; ++k) {
    for (std::size_t i = 0; i < state.particle.size(); ++i) {
      const auto id = static_cast<std::size_t>(state.particle[i]);
      const double y = body.model().reference_y[id];
      double* const m = state.motion.data() + 4 * i;
      m[0] = body.model().reference_x[id] + k * each * y, m[1] = y, m[2] = each * y / dt, m[3] = 0;
    }
    body.step(1, nullptr);
  }
  const MaterialDef& m = s.materials[0];
  const double g = m.young_modulus / (2 * (1 + m.poisson_ratio));
  const double exact[4] = {g * (1 - std::cos(1.0)), -g * (1 - std::cos(1.0)), 0, g * std::sin(1.0)};
  const std::vector<double> stress = field(body, "stress");
  double sum = 0;
  for (std::size_t k = 0; k < stress.size(); ++k) sum += std::pow(stress[k] - exact[k % 4], 2);
  return outcome(body, std::sqrt(sum / static_cast<double>(stress.size())) / g, steps);
}

constexpr Problem kProblems[] = {
    {"sliding_block", "relative error of the speed", "a = g (kh - mu), closed form; rungs of the height", 0.5, 20,
     sliding_block, Schemes::kPairLaws},
    {"disk_turn", "RMS of the stress / stress at the centre", "turning disk in plane strain, closed form", 1, 20,
     disk_turn, Schemes::kPairLaws},
    {"simple_shear", "RMS of the stress / G", "Jaumann rate, closed form", 1, 20, simple_shear, Schemes::kPairLaws},
};

}  // namespace

std::span<const Problem> motion_problems() { return kProblems; }

}  // namespace vbgpd::accuracy
