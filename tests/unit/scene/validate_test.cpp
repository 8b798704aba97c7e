#include "scene/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "bond/bond_law.h"
#include "material/any_law.h"
#include "scene/properties.h"
#include "smoothing/any_kernel.h"

namespace vbgpd {
namespace {

SceneDef good_scene() {
  SceneDef scene;
  scene.exterior = {{0, 0}, {32, 0}, {12, 10}, {0, 10}};
  MaterialDef clay;
  clay.name = "clay";
  clay.unit_weight = 20000;
  clay.cohesion = 10000;
  clay.friction_angle = 20;
  scene.materials = {clay};
  scene.layers = {{"clay", {}}};
  scene.boundaries = {{"", "base", {}, BoundaryKind::kFixed, 0, 0}};
  scene.loads = {{0, 6, 20000, 20000}};
  scene.spacing = 0.5;
  return scene;
}

using Change = std::function<void(SceneDef&)>;

std::vector<Issue> issues_after(const Change& change) {
  SceneDef scene = good_scene();
  change(scene);
  return validate(scene);
}

/// The only issue after a change; a failure when there is none or more than one.
Issue only_issue(const Change& change) {
  const auto issues = issues_after(change);
  EXPECT_EQ(issues.size(), 1u);
  for (const Issue& issue : issues)
    if (issues.size() > 1) ADD_FAILURE() << issue.text;
  return issues.empty() ? Issue{} : issues.front();
}

void expect_error(const std::string& text, const Change& change) {
  const Issue issue = only_issue(change);
  EXPECT_EQ(issue.text, text);
  EXPECT_EQ(issue.severity, Severity::kError);
}

void expect_warning(const std::string& text, const Change& change) {
  const Issue issue = only_issue(change);
  EXPECT_EQ(issue.text, text);
  EXPECT_EQ(issue.severity, Severity::kWarning);
}

TEST(Validate, FindsNothingWrongWithAGoodScene) { EXPECT_TRUE(validate(good_scene()).empty()); }

/// The names of a list of the engine: AnyLaw, AnyKernel.
template <class... T>
std::vector<std::string> names_of(const std::variant<T...>*) {
  return {std::string(T::name)...};
}

TEST(Validate, AcceptsEverySoilLawOfTheEngine) {
  for (const std::string& law : names_of(static_cast<const AnyLaw*>(nullptr)))
    EXPECT_FALSE(has_error(issues_after([&](SceneDef& s) {
      s.materials[0].law = law, s.materials[0].friction_angle = 0;
    }))) << law;
}

TEST(Validate, AcceptsEveryKernelOfTheEngine) {
  for (const std::string& kernel : names_of(static_cast<const AnyKernel*>(nullptr)))
    EXPECT_TRUE(issues_after([&](SceneDef& s) { s.kernel = kernel; }).empty()) << kernel;
}

TEST(Validate, AcceptsEveryBondLawOfTheEngine) {
  for (const BondLawName& law : kBondLaws)
    EXPECT_TRUE(issues_after([&](SceneDef& s) { s.bond = law.name; }).empty()) << law.name;
}

TEST(Validate, AsksOnlySoilThatYieldsForItsStrength) {
  for (const std::string& law : names_of(static_cast<const AnyLaw*>(nullptr))) {
    const auto issues = issues_after([&](SceneDef& s) {
      s.materials[0].law = law, s.materials[0].friction_angle = 0, s.materials[0].cohesion = kNone;
    });
    EXPECT_EQ(has_error(issues), yields(*law_by_name(law))) << law;
  }
}

TEST(Validate, SaysWhichMaterialWhichNumberAndWhatWouldBeRight) {
  const Issue issue = only_issue([](SceneDef& s) {
    s.materials.insert(s.materials.begin(), 2, s.materials[0]);
    s.materials[0].name = "sand", s.materials[1].name = "silt";
    s.materials[2].friction_angle = 95;
  });
  EXPECT_EQ(issue.text, "materials[2] 'clay': friction_angle = 95 degrees: must be in [0, 90)");
  EXPECT_EQ(issue.object, ObjectKind::kMaterial);
  EXPECT_EQ(issue.object_id, 2);
  EXPECT_EQ(issue.value, 95);
  EXPECT_EQ(issue.status, Status::kRange);
}

TEST(Validate, RefusesEveryNumberThatIsNotFinite) {
  for (const Property& p : properties())
    for (const double bad : {kNone, kInfinity, -kInfinity}) {
      SceneDef scene = good_scene();
      *find_property(scene, p.object, 0, p.name) = bad;
      const bool may_be_absent = std::isnan(p.default_value) && !p.required && std::string(p.name) != "cohesion";
      const auto issues = validate(scene);
      EXPECT_EQ(has_error(issues), !(std::isnan(bad) && may_be_absent)) << p.name << " = " << bad;
      bool named = false;
      for (const Issue& issue : issues) named = named || issue.text.find(p.name) != std::string::npos;
      EXPECT_EQ(named, has_error(issues)) << p.name << " = " << bad;
    }
}

TEST(Validate, RefusesEveryNumberJustOutsideItsRange) {
  for (const Property& p : properties()) {
    const auto has_range_error = [&](double value) {
      SceneDef scene = good_scene();
      *find_property(scene, p.object, 0, p.name) = value;
      for (const Issue& issue : validate(scene))
        if (issue.text.find(std::string(p.name) + " = ") != std::string::npos &&
            issue.text.find("must be ") != std::string::npos)
          return true;
      return false;
    };
    if (std::isfinite(p.min_value)) {
      EXPECT_TRUE(has_range_error(p.min_open ? p.min_value : std::nextafter(p.min_value, -kInfinity))) << p.name;
    }
    if (std::isfinite(p.max_value)) {
      EXPECT_TRUE(has_range_error(p.max_open ? p.max_value : std::nextafter(p.max_value, kInfinity))) << p.name;
    }
  }
}

TEST(Validate, SaysWhatIsMissing) {
  expect_error("materials[0] 'clay': unit_weight is missing: a number in N/m3 is needed. Total unit weight.",
               [](SceneDef& s) { s.materials[0].unit_weight = kNone; });
  expect_error(
      "materials[0] 'clay': cohesion is missing: law \"mohr_coulomb\" needs it (Pa, 0 is allowed with friction)",
      [](SceneDef& s) { s.materials[0].cohesion = kNone; });
  expect_error(
      "scene: spacing is missing: a number in m is needed. Distance between particles; a twentieth of the slope height "
      "is a "
      "good start.",
      [](SceneDef& s) { s.spacing = kNone; });
  expect_error("loads[0]: x1 is missing: a number in m is needed. Right end of the load, right of x0.",
               [](SceneDef& s) { s.loads[0].x1 = kNone; });
}

TEST(Validate, AsksNoCohesionOfElasticSoil) {
  EXPECT_TRUE(
      issues_after([](SceneDef& s) { s.materials[0].law = "elastic", s.materials[0].cohesion = kNone; }).empty());
}

TEST(Validate, ListsKnownNamesAndSuggestsTheNearest) {
  expect_error(
      "materials[0] 'clay': law \"mohr_colomb\" is not known: use one of elastic, drucker_prager, mohr_coulomb, "
      "undrained; did "
      "you mean \"mohr_coulomb\"?",
      [](SceneDef& s) { s.materials[0].law = "mohr_colomb"; });
  expect_error(
      "scene: bond \"vb\" is not known: use one of virtual_bond, none, sph, sph_artificial_stress, pseudo_spring, gpd",
      [](SceneDef& s) { s.bond = "vb"; });
  expect_error(
      "scene: kernel \"cubic\" is not known: use one of wendland_c2, cubic_spline; did you mean \"cubic_spline\"?",
      [](SceneDef& s) { s.kernel = "cubic"; });
  expect_error("layers[0] 'caly': material \"caly\" is not known: use one of clay; did you mean \"clay\"?",
               [](SceneDef& s) { s.layers[0].material = "caly"; });
  expect_error("boundaries[0] 'bottom': side \"bottom\" is not known: use one of base, left, right",
               [](SceneDef& s) { s.boundaries[0].side = "bottom"; });
}

TEST(Validate, RefusesStrengthThatContradictsItself) {
  expect_error("materials[0] 'clay': dilatancy_angle = 21 degrees: must not exceed friction_angle = 20 degrees",
               [](SceneDef& s) { s.materials[0].dilatancy_angle = 21; });
  expect_error(
      "materials[0] 'clay': friction_angle = 20 degrees: law \"undrained\" has cohesion only; use law \"mohr_coulomb\" "
      "for soil "
      "with friction",
      [](SceneDef& s) { s.materials[0].law = "undrained"; });
  expect_error("materials[0] 'clay': cohesion = 0 and friction_angle = 0: soil without any strength cannot stand",
               [](SceneDef& s) { s.materials[0].cohesion = s.materials[0].friction_angle = 0; });
  expect_error(
      "materials[0] 'clay': cohesion_gradient = 2000 Pa/m needs cohesion_datum, the elevation below which cohesion "
      "grows",
      [](SceneDef& s) {
        s.materials[0].law = "undrained", s.materials[0].friction_angle = 0, s.materials[0].cohesion_gradient = 2000;
      });
  expect_error(
      "materials[0] 'clay': cohesion_gradient = 2000 Pa/m: only law \"undrained\" has cohesion that grows with depth",
      [](SceneDef& s) { s.materials[0].cohesion_gradient = 2000, s.materials[0].cohesion_datum = 5; });
}

TEST(Validate, AllowsCohesionThatStartsAtZeroAndGrows) {
  EXPECT_TRUE(issues_after([](SceneDef& s) {
                MaterialDef& m = s.materials[0];
                m.law = "undrained", m.friction_angle = m.cohesion = 0, m.cohesion_gradient = 2000,
                m.cohesion_datum = 10;
              }).empty());
}

TEST(Validate, SuggestsAPoissonRatioForUndrainedSoil) {
  expect_error("materials[0] 'clay': poisson_ratio = 0.5: must be in (-1, 0.5); use 0.49 for undrained soil",
               [](SceneDef& s) { s.materials[0].poisson_ratio = 0.5; });
}

TEST(Validate, RefusesTwoMaterialsOfOneName) {
  expect_error("materials[1] 'clay': the name is already that of materials[0]: names must differ",
               [](SceneDef& s) { s.materials.push_back(s.materials[0]); });
}

TEST(Validate, RefusesMissingParts) {
  expect_error("profile: exterior has 2 vertices: an area needs at least 3", [](SceneDef& s) { s.exterior.resize(2); });
  expect_error("profile: exterior has 2 vertices: an area needs at least 3",  // the last repeats the first
               [](SceneDef& s) {
                 s.exterior = {{0, 0}, {1, 1}, {0, 0}};
               });
  expect_error("layers[0] 'clay': polygon has 1 vertex: an area needs at least 3", [](SceneDef& s) {
    s.layers[0].polygon = {{1, 1}};
  });
  expect_error("layers: the list is empty: a layer with a material and no polygon fills the whole exterior",
               [](SceneDef& s) { s.layers.clear(); });
  expect_error("materials[1]: name is missing: layers refer to a soil by its name", [](SceneDef& s) {
    s.materials.push_back(s.materials[0]);
    s.materials[1].name.clear();
  });
  EXPECT_TRUE(has_error(issues_after([](SceneDef& s) { s.materials.clear(); })));
}

TEST(Validate, WantsEachBoundaryPlacedOnce) {
  expect_error("boundaries[0]: where is missing: give side (base, left, right) or a polyline along the exterior",
               [](SceneDef& s) { s.boundaries[0].side.clear(); });
  expect_error("boundaries[0] 'base': side and polyline are both given: keep the one that is meant", [](SceneDef& s) {
    s.boundaries[0].polyline = {{0, 0}, {32, 0}};
  });
  expect_error("boundaries[0]: polyline has 1 point: a line needs at least 2", [](SceneDef& s) {
    s.boundaries[0].side.clear();
    s.boundaries[0].polyline = {{0, 0}};
  });
}

TEST(Validate, NamesTheVertexThatIsNotFinite) {
  const Issue issue = only_issue([](SceneDef& s) { s.exterior[2].y = kNone; });
  EXPECT_EQ(issue.text, "profile: exterior[2].y = nan: must be a finite number");
  EXPECT_EQ(issue.item, 2);
  EXPECT_EQ(issue.x, 12);
}

TEST(Validate, ReportsAHandfulOfManyBadVertices) {
  const auto issues = issues_after([](SceneDef& s) { s.exterior.assign(100000, {kInfinity, 0}); });
  EXPECT_EQ(issues.size(), 10u);
  EXPECT_NE(issues.back().text.find("further points"), std::string::npos);
}

TEST(Validate, RefusesReversedIntervals) {
  expect_error("loads[0]: x0 = 6 m: must be left of x1 = 6 m", [](SceneDef& s) { s.loads[0].x0 = 6; });
  expect_error("scene: srf_max = 1: must be greater than srf_min = 2", [](SceneDef& s) {
    s.strength_reduction = {2, 1, 0.005};
  });
}

TEST(Validate, ReportsAllProblemsInTheOrderOfTheScene) {
  const auto issues = issues_after([](SceneDef& s) {
    s.spacing = 0;
    s.layers[0].material = "rock";
    s.materials[0].young_modulus = 0;
    s.exterior.clear();
  });
  ASSERT_EQ(issues.size(), 4u);
  EXPECT_EQ(issues[0].object, ObjectKind::kProfile);
  EXPECT_EQ(issues[1].object, ObjectKind::kMaterial);
  EXPECT_EQ(issues[2].object, ObjectKind::kLayer);
  EXPECT_EQ(issues[3].text, "scene: spacing = 0 m: must be > 0");
}

TEST(Validate, NamesTheLikelySlipOfUnits) {
  expect_warning(
      "materials[0] 'clay': unit_weight = 20 N/m3 looks like 20 kN/m3: with units SI write 20000, or set units to kPa",
      [](SceneDef& s) { s.materials[0].unit_weight = 20; });
  expect_warning(
      "materials[0] 'clay': unit_weight = 20000 kN/m3 looks like 20000 N/m3: with units kPa write 20, or set units to "
      "SI",
      [](SceneDef& s) { s.materials[0].unit_weight = 2e7, s.units = Units::kKilopascal; });
  expect_warning(
      "materials[0] 'clay': unit_weight = 1900 kN/m3 looks like a density of 1900 kg/m3: with units kPa write the "
      "weight, 18.6 kN/m3",
      [](SceneDef& s) { s.materials[0].unit_weight = 1.9e6, s.units = Units::kKilopascal; });
  expect_warning(
      "materials[0] 'clay': unit_weight = 1.9 kN/m3 is less than any soil weighs: 15 to 25 is usual; if a density of "
      "1.9 t/m3 is meant, write the weight, 18.6 kN/m3",
      [](SceneDef& s) { s.materials[0].unit_weight = 1900, s.units = Units::kKilopascal; });
  expect_warning("materials[0] 'clay': unit_weight = 60000 N/m3 is more than any soil weighs: 15000 to 25000 is usual",
                 [](SceneDef& s) { s.materials[0].unit_weight = 60000; });
  expect_warning("materials[0] 'clay': friction_angle = 0.35 degrees looks like radians: 0.35 rad is 20.0535 degrees",
                 [](SceneDef& s) { s.materials[0].friction_angle = 0.35; });
  expect_warning("materials[0] 'clay': friction_angle = 65 degrees is more than any soil has: 15 to 45 is usual",
                 [](SceneDef& s) { s.materials[0].friction_angle = 65; });
  expect_warning(
      "materials[0] 'clay': cohesion = 10 Pa is next to nothing; if 10 kPa are meant, write 10000 Pa or set "
      "units to kPa",
      [](SceneDef& s) { s.materials[0].cohesion = 10; });
  expect_warning("materials[0] 'clay': cohesion = 20000 kPa is that of rock; if 20000 Pa is meant, set units to SI",
                 [](SceneDef& s) { s.materials[0].cohesion = 2e7, s.units = Units::kKilopascal; });
  expect_warning("materials[0] 'clay': cohesion = 2e+07 Pa is that of rock",
                 [](SceneDef& s) { s.materials[0].cohesion = 2e7; });
  expect_warning("materials[0] 'clay': young_modulus = 100 Pa is softer than any soil: 1e+06 to 1e+09 is usual",
                 [](SceneDef& s) { s.materials[0].young_modulus = 100; });
}

TEST(Validate, SpeaksTheUnitsOfTheScene) {
  const auto texts = [](Units units) {
    const auto issues = issues_after([&](SceneDef& s) {
      s.units = units;
      s.materials[0].cohesion = -1000, s.materials[0].unit_weight = -2000;
      s.materials[0].cohesion_gradient = 3000;
      s.spacing = -2;
    });
    std::string all;
    for (const Issue& issue : issues) all += issue.text + "\n";
    return all;
  };
  const std::string si = texts(Units::kSI), kilo = texts(Units::kKilopascal);
  for (const char* said : {"unit_weight = -2000 N/m3: must", "cohesion = -1000 Pa: must",
                           "cohesion_gradient = 3000 Pa/m needs", "spacing = -2 m: must"})
    EXPECT_NE(si.find(said), std::string::npos) << said << " in " << si;
  for (const char* said : {"unit_weight = -2 kN/m3: must", "cohesion = -1 kPa: must",
                           "cohesion_gradient = 3 kPa/m needs", "spacing = -2 m: must"})
    EXPECT_NE(kilo.find(said), std::string::npos) << said << " in " << kilo;
}

TEST(Validate, TakesWeightlessSoilAsMeant) {
  EXPECT_TRUE(issues_after([](SceneDef& s) { s.materials[0].unit_weight = 0; }).empty());
  EXPECT_TRUE(issues_after([](SceneDef& s) { s.materials[0].unit_weight = 1e-3; }).empty());
}

TEST(Validate, WarnsOfValuesWithoutEffect) {
  // apex = 10000 / tan(20 degrees) = 27474.8
  expect_warning(
      "materials[0] 'clay': tension_cutoff = 30000 Pa has no effect: the apex of the cone, cohesion / "
      "tan(friction_angle), is at "
      "27474.8 Pa",
      [](SceneDef& s) { s.materials[0].tension_cutoff = 30000; });
  EXPECT_TRUE(issues_after([](SceneDef& s) { s.materials[0].tension_cutoff = 27000; }).empty());
  expect_warning("boundaries[0] 'base': vx and vy have no effect: only a boundary of kind \"velocity\" moves",
                 [](SceneDef& s) { s.boundaries[0].vx = 1; });
  expect_warning(
      "boundaries[0] 'base': friction_angle = 20 degrees has no effect: only on a boundary of kind \"fixed\" soil can "
      "slide by friction",
      [](SceneDef& s) { s.boundaries[0].kind = BoundaryKind::kRoller, s.boundaries[0].friction_angle = 20; });
}

TEST(Validate, ChecksTheFrictionOfABoundaryAndSaysWhereItActs) {
  expect_warning(
      "boundaries[0] 'base': friction_angle = 20 degrees acts in a run-out only: until then, and in a strength "
      "reduction, the boundary is fixed",
      [](SceneDef& s) { s.boundaries[0].friction_angle = 20; });
  const auto slips = issues_after([](SceneDef& s) { s.boundaries[0].friction_angle = 0.35; });
  ASSERT_EQ(slips.size(), 2u);
  EXPECT_NE(slips[0].text.find("looks like radians"), std::string::npos);
  for (const double angle : {-1.0, 90.0, kInfinity})
    EXPECT_TRUE(has_error(issues_after([&](SceneDef& s) { s.boundaries[0].friction_angle = angle; }))) << angle;
}

TEST(Validate, WarnsOfASectionThatNothingHoldsUp) {
  expect_warning(
      "boundaries: nothing holds the section up, so that it will fall: fix its base, or leave the list of boundaries "
      "out",
      [](SceneDef& s) {
        s.boundaries = {{"", "left", {}, BoundaryKind::kRoller, 0, 0}};
      });
  EXPECT_TRUE(issues_after([](SceneDef& s) { s.boundaries.clear(); }).empty());
}

TEST(Validate, WarnsOfAnEarthquakeThatPushesAwayFromTheToe) {
  expect_warning(
      "scene: kh = -0.1 pushes the soil to the left, away from the low side of the section; the slope is the less safe "
      "with 0.1",
      [](SceneDef& s) { s.kh = -0.1; });
  EXPECT_TRUE(issues_after([](SceneDef& s) { s.kh = 0.1; }).empty());
}

TEST(Validate, NamesEveryFaultOfAWaterTable) {
  const auto with = [](Polygon table) { return [table](SceneDef& s) { s.water_table = table; }; };
  EXPECT_TRUE(issues_after(with({{0, 2}, {32, 1}})).empty());
  expect_error("water: table[1]: x and y must be finite numbers of m", with({{0, 2}, {16, kInfinity}, {32, 1}}));
  expect_error("water: table[1]: x = 0 m: must be right of x = 0 m of the point before",
               with({{0, 2}, {0, 3}, {32, 1}}));
  EXPECT_EQ(issues_after(with({{1, 2}, {31, 1}})).size(), 2u);
}

TEST(Validate, WarnsOfASaturatedWeightThatIsNeverUsed) {
  const Issue issue = only_issue([](SceneDef& s) { s.materials[0].saturated_unit_weight = 21e3; });
  EXPECT_EQ(issue.severity, Severity::kWarning);
  EXPECT_NE(issue.text.find("'clay' is never used"), std::string::npos);
}

TEST(Validate, AcceptsAsManySoilsAsPairsCanBeNumbered) {
  const auto soils = [](std::size_t count) {
    return [count](SceneDef& s) {
      s.materials.resize(count, s.materials[0]);
      for (std::size_t m = 0; m < count; ++m) s.materials[m].name = "clay " + std::to_string(m);
      s.layers[0].material = "clay 0";
    };
  };
  EXPECT_FALSE(has_error(issues_after(soils(256))));
  EXPECT_EQ(only_issue(soils(257)).text, "materials: the list has 257 entries: at most 256 are accepted");
}

TEST(Validate, WarnsOfFrictionThatMayHaveBeenForgotten) {
  const Change without = [](SceneDef& s) { s.materials[0].friction_angle = 0; };
  expect_warning(
      "materials[0] 'clay': friction_angle = 0 with law \"mohr_coulomb\": if it was forgotten, give it; soil without "
      "friction is law \"undrained\"",
      without);
  EXPECT_TRUE(issues_after([&](SceneDef& s) { without(s), s.materials[0].law = "undrained"; }).empty());
}

TEST(Validate, WarnsOfLoadsAndWaterInOtherUnits) {
  const auto kilo = [](SceneDef& s) { s.units = Units::kKilopascal; };
  expect_warning(
      "loads[0]: a pressure of 20000 kPa is more than any foundation puts on soil; if 20000 Pa is meant, set units to "
      "SI",
      [&](SceneDef& s) { kilo(s), s.loads[0].pressure = s.loads[0].pressure_end = 2e7; });
  const auto wet = [](SceneDef& s) { s.water_table = {{0, 5}, {32, 0}}; };
  EXPECT_TRUE(issues_after(wet).empty());
  expect_warning("water: water_unit_weight = 9.81 N/m3: water weighs 9810 N/m3",
                 [&](SceneDef& s) { wet(s), s.water_unit_weight = 9.81; });
}

TEST(Validate, WarnsOfAWaterTableThatAPorePressureRatioReplaces) {
  expect_warning(
      "water: the pore pressure of 'clay' is that of its pore_pressure_ratio; the water table does not count there",
      [](SceneDef& s) {
        s.water_table = {{0, 5}, {32, 0}}, s.materials[0].pore_pressure_ratio = 0.2;
      });
}

TEST(Validate, WarnsOfALoadThatPullsUp) {
  expect_warning("loads[0]: a negative pressure pulls the ground up: loads are positive downwards",
                 [](SceneDef& s) { s.loads[0].pressure = -20000; });
}

TEST(Validate, ANegativeFrictionAngleIsOneError) {
  EXPECT_EQ(issues_after([](SceneDef& s) { s.materials[0].friction_angle = -24; }).size(), 1u);
}

TEST(HasError, IsTrueForErrorsOnly) {
  EXPECT_FALSE(has_error({}));
  EXPECT_FALSE(has_error(issues_after([](SceneDef& s) { s.materials[0].unit_weight = 20; })));
  EXPECT_TRUE(has_error(issues_after([](SceneDef& s) { s.materials[0].unit_weight = -20; })));
}

}  // namespace
}  // namespace vbgpd
