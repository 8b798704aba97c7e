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

}  // namespace
}  // namespace vbgpd
