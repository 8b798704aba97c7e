// The ladder of features: each rung adds one to the scene of the rung before, so that the difference between two rows
// is what that feature costs in time and in bytes.
#include <functional>

#include "scenes.h"

namespace vbgpd::bench {
namespace {

struct Rung {
  const char* name;
  std::function<void(SceneDef&)> add;
};

const std::vector<Rung>& rungs() {
  static const std::vector<Rung> list = {
      {"elastic_nodal", [](SceneDef& s) { s.bond = "none", s.materials[0].law = "elastic"; }},
      {"bonds", [](SceneDef& s) { s.bond = "virtual_bond"; }},
      {"plasticity_undrained",
       [](SceneDef& s) {
         s.materials[0].law = "undrained", s.materials[0].friction_angle = 0, s.materials[0].cohesion = 30e3;
       }},
      {"cohesion_gradient",
       [](SceneDef& s) { s.materials[0].cohesion_gradient = 1e3, s.materials[0].cohesion_datum = 10; }},
      {"friction",
       [](SceneDef& s) {
         s.materials[0].cohesion_gradient = 0, s.materials[0].cohesion_datum = kNone;
         s.materials[0].law = "drucker_prager", s.materials[0].cohesion = 10e3, s.materials[0].friction_angle = 20;
       }},
      {"dilatancy", [](SceneDef& s) { s.materials[0].dilatancy_angle = 5; }},
      {"tension_cutoff", [](SceneDef& s) { s.materials[0].tension_cutoff = 1e3; }},
      {"mohr_coulomb", [](SceneDef& s) { s.materials[0].law = "mohr_coulomb"; }},
      {"seismic_and_load",
       [](SceneDef& s) {
         s.kh = 0.05, s.loads.push_back({2, 8, 20e3, 20e3});
       }},
      {"second_material",
       [](SceneDef& s) {
         MaterialDef clay = s.materials[0];
         clay.name = "clay", clay.law = "undrained", clay.friction_angle = clay.dilatancy_angle = 0,
         clay.cohesion = 30e3;
         clay.cohesion_gradient = 1e3, clay.cohesion_datum = 10;
         s.materials.push_back(clay);
         s.layers.push_back({"clay", {{0, 0}, {32, 0}, {28, 2}, {0, 2}}});
       }},
  };
  return list;
}

void ladder(benchmark::State& state, std::size_t rung) {
  SceneDef s = sample_scene("gl_1");
  for (std::size_t k = 0; k <= rung; ++k) rungs()[k].add(s);
  s.spacing = spacing_for(s, state.range(0));
  step_cost(state, s, 1.3);
}

const bool registered = [] {
  for (std::size_t k = 0; k < rungs().size(); ++k) {
    const std::string number = std::to_string(k);
    benchmark::RegisterBenchmark(("ladder/" + number + "_" + rungs()[k].name).c_str(),
                                 [k](benchmark::State& state) { ladder(state, k); })
        ->Arg(10000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace vbgpd::bench
