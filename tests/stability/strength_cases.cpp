// Factors of safety that must not change, or must change to a known value, or must be refused by name.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "analysis/job.h"
#include "row.h"

namespace vbgpd::stability {

namespace {

using Change = std::function<void(SceneDef&)>;

constexpr double kAsTheyAre = 1e12;  // soils are as stiff as they are, however long that takes

Outcome solve(const SceneDef& s, int levels, double must_be, double contrast = kNone) {
  Outcome o;
  std::unique_ptr<Simulation> simulation;
  try {
    simulation = Simulation::compile(s, {});
  } catch (const Error& error) {
    o.verdict = "refused", o.note = error.issue().text;
    return o;
  }
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", levels);
  if (!std::isnan(contrast)) job->set("stiffness_contrast", contrast);
  job->run(0, {});
  const JobResult& r = job->result();
  o.verdict = r.status;
  o.factor_of_safety = r.factor_of_safety;
  o.deviation = r.factor_of_safety / must_be - 1;
  o.energy_residual = r.energy_residual;
  o.steps = static_cast<double>(r.steps);
  if (r.status != "OK") o.note = r.reason;
  return o;
}

double base_factor() {
  static const double factor = solve(base_slope(), 1, 1).factor_of_safety;
  return factor;
}

constexpr double kResidual = 1e-3;

/// A row that is not as it must be, with the reason, and the verdict where that differs too.
Case but(Case c, const char* known, const char* verdict = "") {
  c.known = known, c.known_verdict = verdict;
  return c;
}
const char* const kVolume = "plastic volume of large or uneven steps";
const char* const kDisorder = "uniform volumes of disordered particles";
const char* const kJump = "a mechanism through a jump of stiffness";
const char* const kUndecided = "neither rest nor steady failure in the steps allowed";

Case varied(const std::string& name, double most_deviation, bool fast, const Change& change) {
  Case c{name, "OK", most_deviation, kResidual, kNone, fast, {}};
  c.run = [change] {
    SceneDef s = base_slope();
    change(s);
    return solve(s, 1, base_factor());
  };
  return c;
}

/// A case of its own, with its own known factor of safety.
Case known(const std::string& name, const std::string& expected, double must_be, double most_deviation, bool fast,
           const SceneDef& s, int levels = 1) {
  Case c{name, expected, most_deviation, expected == "OK" ? kResidual : kNone, kNone, fast, {}};
  c.run = [=] { return solve(s, levels, must_be); };
  return c;
}

SceneDef changed(const Change& change) {
  SceneDef s = base_slope();
  change(s);
  return s;
}

void scale(SceneDef& s, double by) {
  for (Point& p : s.exterior) p.x *= by, p.y *= by;
  for (MaterialDef& m : s.materials) m.cohesion *= by, m.young_modulus *= by;
  s.spacing *= by;
}

/// The lowest two metres as a soil of the same strength.
void add_foundation(SceneDef& s, double young_modulus) {
  s.materials.push_back(s.materials[0]);
  s.materials[1].name = "foundation", s.materials[1].young_modulus = young_modulus;
  s.layers.push_back({"foundation", {{0, 0}, {32, 0}, {28, 2}, {0, 2}}});
}

SceneDef vertical_cut(double spacing) {
  SceneDef s = base_slope();
  s.exterior = {{0, 0}, {30, 0}, {30, 15}, {10, 15}, {10, 5}, {0, 5}};
  s.boundaries.clear();
  s.materials[0].law = "undrained", s.materials[0].friction_angle = 0;
  s.materials[0].cohesion = 20e3 * 10 / 3.776;  // exact factor of safety 1
  s.spacing = spacing;
  return s;
}

void add_stiffness(std::vector<Case>& all) {
  for (const double e : {1e3, 1e5, 1e7, 1e12}) {
    char name[40];
    std::snprintf(name, sizeof name, "E = %.0e Pa", e);
    all.push_back(varied(name, 0.01, e == 1e3 || e == 1e12, [e](SceneDef& s) { s.materials[0].young_modulus = e; }));
  }
  for (const char* times : {"30", "1e3", "1e6", "1e-3"}) {
    const double stiffer = std::atof(times);
    for (const double psi : {0.0, 20.0}) {
      Case c{std::string("foundation ") + times + " times as stiff" + (psi > 0 ? ", psi = phi (of that alone)" : ""),
             "OK",
             0.01,
             kResidual,
             kNone,
             true,
             {}};
      c.run = [=] {
        SceneDef s = base_slope();
        s.materials[0].dilatancy_angle = psi;
        const double alike = solve(s, 1, 1).factor_of_safety;
        add_foundation(s, stiffer * s.materials[0].young_modulus);
        return solve(s, 1, alike);
      };
      all.push_back(c);
    }
  }
  for (const char* times : {"30", "1e3", "1e-3"}) {
    const double stiffer = std::atof(times);
    Case c{std::string("foundation ") + times + " times as stiff, searched as it is",
           "OK",
           0.01,
           kResidual,
           kNone,
           times[0] == '3',
           {}};
    c.run = [=] {
      SceneDef s = base_slope();
      add_foundation(s, stiffer * s.materials[0].young_modulus);
      return solve(s, 1, base_factor(), kAsTheyAre);
    };
    all.push_back(times[0] == '3' ? c : but(c, kJump, stiffer < 1 ? "NOT_CONVERGED" : ""));
  }
  for (const double nu : {0.0, 0.49, 0.499, 0.4999}) {
    char name[40];
    std::snprintf(name, sizeof name, "nu = %g", nu);
    all.push_back(
        but(varied(name, 0.01, nu == 0.4999, [nu](SceneDef& s) { s.materials[0].poisson_ratio = nu; }), kVolume));
  }
  SceneDef undrained = vertical_cut(0.5);
  undrained.materials[0].poisson_ratio = 0.4999;
  all.push_back(known("undrained vertical cut, nu = 0.4999", "OK", 1, 0.02, false, undrained, 2));
  all.push_back(
      known("nu = 0.5", "refused", 1, kNone, true, changed([](SceneDef& s) { s.materials[0].poisson_ratio = 0.5; })));
}

void add_strength(std::vector<Case>& all) {
  // a cohesionless slope fails along its face: FS = tan phi / tan beta, beta = atan(1/2)
  all.push_back(but(known("c = 0, phi = 40", "OK", 2 * std::tan(40 * M_PI / 180), 0.1, true, changed([](SceneDef& s) {
                            s.materials[0].cohesion = 0, s.materials[0].friction_angle = 40;
                          })),
                    kVolume));
  all.push_back(known("phi = 0, vertical face", "OK", 1, 0.02, true, vertical_cut(1.25), 2));
  all.push_back(but(
      known("phi = 45", "OK", kNone, kNone, false, changed([](SceneDef& s) { s.materials[0].friction_angle = 45; })),
      kVolume));
  all.push_back(but(varied("psi = phi", 0.1, true, [](SceneDef& s) { s.materials[0].dilatancy_angle = 20; }), kVolume));
  all.push_back(
      but(varied("psi = phi, Drucker-Prager", 0.15, false,
                 [](SceneDef& s) { s.materials[0].law = "drucker_prager", s.materials[0].dilatancy_angle = 20; }),
          kVolume));
  all.push_back(
      but(varied("tension cut-off 0", 0.1, true, [](SceneDef& s) { s.materials[0].tension_cutoff = 0; }), kVolume));
  all.push_back(known("no strength at all", "refused", 1, kNone, true,
                      changed([](SceneDef& s) { s.materials[0].cohesion = 0, s.materials[0].friction_angle = 0; })));
  all.push_back(known("elastic: never fails", "ABOVE_MAX", 1, kNone, true,
                      changed([](SceneDef& s) { s.materials[0].law = "elastic"; })));
}

void add_shape(std::vector<Case>& all) {
  all.push_back(varied("slope 1 mm high", 1e-6, true, [](SceneDef& s) { scale(s, 1e-4); }));
  all.push_back(varied("slope 10 km high", 1e-6, true, [](SceneDef& s) { scale(s, 1e3); }));
  all.push_back(varied("coordinates of a map, 5.4e6 m", 1e-6, true, [](SceneDef& s) {
    for (Point& p : s.exterior) p.x += 512345.25, p.y += 5412345.5;
  }));
  all.push_back(but(varied("needle of 1 degree at the toe", 0.05, false,
                           [](SceneDef& s) {
                             s.exterior = {{0, 0}, {60, 0}, {31, 0.5}, {12, 10}, {0, 10}};
                           }),
                    kVolume));
  all.push_back(varied("edge of 1e-6 m at the crest", 1e-3, true, [](SceneDef& s) {
    s.exterior = {{0, 0}, {32, 0}, {12 + 1e-6, 10 - 5e-7}, {12, 10}, {0, 10}};
  }));
  all.push_back(varied("slivers along the face, 1e-3 of a cell", 0.02, false, [](SceneDef& s) {
    s.exterior = {{0, 0}, {32, 0}, {12.001, 9.999}, {12.001, 10}, {0, 10}};
  }));
  SceneDef overhang = vertical_cut(1.25);
  overhang.exterior = {{0, 0}, {30, 0}, {30, 15}, {9, 15}, {10, 5}, {0, 5}};
  all.push_back(but(known("face overhanging by 1 in 10", "OK", kNone, kNone, false, overhang, 2), kVolume));
  all.push_back(
      known("hole joined to the outline by a slit", "refused", 1, kNone, true, changed([](SceneDef& s) {
              s.exterior = {{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 5}, {6, 5}, {6, 0}, {32, 0}, {12, 10}, {0, 10}};
            })));
  for (const double jitter : {0.1, 0.3, 0.49}) {
    char name[60];
    std::snprintf(name, sizeof name, "particles up to %g spacings off the lattice", jitter);
    all.push_back(but(varied(name, 0.01, jitter == 0.1, [jitter](SceneDef& s) { s.jitter = jitter; }), kDisorder));
  }
  SceneDef thin = base_slope();
  thin.materials.push_back(thin.materials[0]);
  thin.materials[1].name = "seam", thin.materials[1].cohesion = 5e3;
  thin.layers.push_back({"seam", {{0, 4}, {32, 4}, {32, 5}, {0, 5}}});
  all.push_back(known("seam one particle thick", "THIN_LAYER", kNone, kNone, true, thin));
  all.push_back(
      known("spacing larger than the slope", "refused", 1, kNone, true, changed([](SceneDef& s) { s.spacing = 30; })));
  all.push_back(
      known("spacing for 1e10 particles", "refused", 1, kNone, true, changed([](SceneDef& s) { s.spacing = 1.5e-4; })));
}

void add_weight(std::vector<Case>& all) {
  all.push_back(known("no weight at all", "ABOVE_MAX", kNone, kNone, true,
                      changed([](SceneDef& s) { s.materials[0].unit_weight = 0; })));
  all.push_back(varied("gravity x 100 with its cohesion", 1e-6, true, [](SceneDef& s) {
    s.gravity *= 100, s.materials[0].unit_weight *= 100, s.materials[0].cohesion *= 100;
    s.materials[0].young_modulus *= 100;
  }));
  all.push_back(but(known("gravity x 100: c hardly counts", "THIN_SLIDE", 2 * std::tan(20 * M_PI / 180), 0.15, true,
                          changed([](SceneDef& s) { s.gravity *= 100, s.materials[0].unit_weight *= 100; }), 2),
                    kVolume));
}

}  // namespace

SceneDef base_slope() {
  SceneDef s;
  s.exterior = {{0, 0}, {32, 0}, {12, 10}, {0, 10}};
  MaterialDef m;
  m.name = "soil", m.law = "mohr_coulomb", m.unit_weight = 20e3, m.cohesion = 10e3, m.friction_angle = 20;
  s.materials = {m};
  s.layers = {{"soil", {}}};
  BoundaryDef base, left;
  base.side = "base", left.side = "left", left.kind = BoundaryKind::kRoller;
  s.boundaries = {base, left};
  s.spacing = 1;
  return s;
}

std::vector<Case> strength_cases() {
  std::vector<Case> all = {varied("base: H = 10 spacings, E = 1e8, nu = 0.3, psi = 0", 0, true, [](SceneDef&) {})};
  add_stiffness(all);
  add_strength(all);
  add_shape(all);
  add_weight(all);
  return all;
}

}  // namespace vbgpd::stability
