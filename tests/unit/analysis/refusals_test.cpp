// Analyses that refuse a scene say why and what would do.
#include <gtest/gtest.h>

#include "analysis/job.h"
#include "bond/bond_law.h"
#include "physics/scenes.h"
#include "simulation/simulation.h"

namespace vbgpd {
namespace {

TEST(StrengthReduction, RefusesTheLawsThatAreForComparisonInARunoutOnly) {
  for (const BondLawName& law : kBondLaws) {
    SceneDef scene = test::slope(test::soil("mohr_coulomb", 10e3, 20), 2);
    scene.bond = law.name;
    const auto simulation = Simulation::compile(scene, {});
    if (law.name == "virtual_bond" || law.name == "none") {
      EXPECT_NO_THROW(make_strength_reduction(*simulation)) << law.name;
      continue;
    }
    try {
      make_strength_reduction(*simulation);
      ADD_FAILURE() << law.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.issue().status, Status::kUnsupported);
      EXPECT_EQ(std::string(error.what()),
                "strength reduction is not offered with bond \"" + scene.bond +
                    "\": it exists to be compared with in a run-out; use virtual_bond or none");
    }
  }
}

TEST(StrengthReduction, RefusesARangeUpsideDownAndTakesARightOneAfterwards) {
  const auto simulation = Simulation::compile(test::slope(test::soil("mohr_coulomb", 10e3, 20), 2), {});
  const auto job = make_strength_reduction(*simulation);
  job->set("srf_min", 3);
  job->set("srf_max", 2);
  try {
    job->run(0, {});
    ADD_FAILURE() << "ran";
  } catch (const Error& error) {
    EXPECT_EQ(error.issue().status, Status::kRange);
    EXPECT_EQ(error.issue().object, ObjectKind::kJob);
    EXPECT_EQ(std::string(error.what()), "srf_max = 2: must be greater than srf_min = 3");
  }
  job->set("srf_min", 0.5);
  EXPECT_EQ(job->run(0, {}), Status::kOk);
}

}  // namespace
}  // namespace vbgpd
