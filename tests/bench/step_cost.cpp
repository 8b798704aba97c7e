// One step: every law with and without bonds on the same slope, from 1e3 to 1e6 particles, and the named scenes as they
// are.
#include "scenes.h"

namespace vbgpd::bench {
namespace {

/// Griffiths & Lane's example 1 well above its factor of safety, most bonds plastic where steps suffice.
void law(benchmark::State& state, const char* bond, const char* name) {
  SceneDef s = sample_scene("gl_1");
  s.bond = bond;
  s.materials[0].law = name;
  if (s.materials[0].law == "undrained") s.materials[0].friction_angle = 0, s.materials[0].cohesion = 30e3;
  s.spacing = spacing_for(s, state.range(0));
  step_cost(state, s, 1.5, static_cast<int>(state.range(1)));
}
#define VBGPD_LAW(bond, name)                              \
  BENCHMARK_CAPTURE(law, bond##_##name, #bond, #name)      \
      ->ArgsProduct({{1000, 10000, 100000, 1000000}, {1}}) \
      ->Unit(benchmark::kMillisecond)
VBGPD_LAW(virtual_bond, elastic);
VBGPD_LAW(virtual_bond, undrained);
VBGPD_LAW(virtual_bond, drucker_prager);
VBGPD_LAW(virtual_bond, mohr_coulomb);
VBGPD_LAW(none, elastic);
VBGPD_LAW(none, drucker_prager);
VBGPD_LAW(none, mohr_coulomb);

/// Particles off the lattice, each coordinate by up to 0.3 spacings.
void off_lattice(benchmark::State& state, const char* bond, const char* name) {
  SceneDef s = sample_scene("gl_1");
  s.bond = bond, s.materials[0].law = name, s.jitter = 0.3;
  s.spacing = spacing_for(s, state.range(0));
  step_cost(state, s, 1.5);
}
#define VBGPD_OFF_LATTICE(bond, name)                         \
  BENCHMARK_CAPTURE(off_lattice, bond##_##name, #bond, #name) \
      ->RangeMultiplier(10)                                   \
      ->Range(1000, 1000000)                                  \
      ->Unit(benchmark::kMillisecond)
VBGPD_OFF_LATTICE(virtual_bond, elastic);
VBGPD_OFF_LATTICE(virtual_bond, drucker_prager);
VBGPD_OFF_LATTICE(none, drucker_prager);

/// Two workers against one, in wall-clock time.
BENCHMARK_CAPTURE(law, workers, "virtual_bond", "drucker_prager")
    ->ArgsProduct({{100000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A scene file at its own spacing: several materials, loads, foundations.
void named(benchmark::State& state, const char* name) { step_cost(state, sample_scene(name), 1.2); }
BENCHMARK_CAPTURE(named, vertical_cut, "vertical_cut")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(named, gl_1, "gl_1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(named, gl_3_r0_6, "gl_3_r0_6")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(named, low_3layer, "low_3layer")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(named, prandtl_strip, "prandtl_strip")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(named, james_bay, "james_bay")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vbgpd::bench
