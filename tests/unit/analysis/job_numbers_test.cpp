#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/job.h"

namespace vbgpd {
namespace {

std::unique_ptr<Simulation> block() {
  SceneDef s;
  MaterialDef soil;
  soil.name = "soil", soil.unit_weight = 20e3, soil.cohesion = 10e3, soil.friction_angle = 20;
  s.materials = {soil};
  s.exterior = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  s.layers = {{"soil", {}}};
  s.spacing = 1;
  return Simulation::compile(s, {});
}

TEST(JobNumbers, AreAllAnsweredAndNamedOnce) {
  const auto simulation = block();
  const auto job = make_strength_reduction(*simulation);
  std::vector<std::string_view> names = job_numbers();
  for (const std::string_view name : names) EXPECT_NO_THROW(job->get(name)) << name;
  EXPECT_THROW(job->get("factor_of_safty"), Error);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace vbgpd
