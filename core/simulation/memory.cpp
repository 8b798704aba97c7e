#include "simulation/memory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "bond/bond_law.h"
#include "geometry/polygon.h"
#include "scene/names.h"
#include "scene/wording.h"
#include "simulation/build_model.h"
#include "simulation/ground_water.h"
#include "simulation/lattice_packs.h"
#include "state/records.h"

namespace vbgpd {

namespace {

/// What a scene stores per storage place and per bond record; the places are particles and padding.
struct Shape {
  bool bonded, plastic = false, volumetric = false, dilatant = false, gradient = false, uneven = false, placed = false;
};

Shape shape_of(const SceneDef& scene) {
  Shape s{bond_law_by_name(scene.bond)->at_rest != BondLaw::kNone};
  double softest = std::numeric_limits<double>::infinity(), stiffest = 0;
  for (const MaterialDef& m : scene.materials) {
    if (!yields(m)) continue;
    s.plastic = true;
    softest = std::min(softest, m.young_modulus), stiffest = std::max(stiffest, m.young_modulus);
    s.volumetric |= m.friction_angle > 0 || !std::isnan(m.tension_cutoff);
    s.gradient |= m.cohesion_gradient > 0;
    s.dilatant |= m.dilatancy_angle > 0;
  }
  s.placed = stiffest > kStiffnessContrast * softest;  // by a strength reduction, which evens stiffnesses out
  s.volumetric |= s.placed;
  s.uneven = s.dilatant && s.bonded && scene.materials.size() > 1;
  return s;
}

/// Places of a lattice: cells of soil, those and the hollows that its lines run through, walls along three sides of the
/// box, and padding.
struct Places {
  double soil, filled, walls, lines;
};

/// Area of an outline whose hollows between two pieces of one line along `axis` (0 = x) are filled.
double filled_area(const Vertices& outline, int axis, double step) {
  const int across = 1 - axis;
  const Box box = box_of(outline);
  double area = 0;
  for (double at = box.low[across] + step / 2; at < box.high[across]; at += step) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      const Vec2 &a = outline[i], &b = outline[j];
      if ((a[across] > at) == (b[across] > at)) continue;
      const double crossing = a[axis] + (at - a[across]) / (b[across] - a[across]) * (b[axis] - a[axis]);
      low = std::min(low, crossing), high = std::max(high, crossing);
    }
    area += step * std::max(0.0, high - low);
  }
  return area;
}

Places places_of(const SceneDef& scene, const Lattice& lattice) {
  const Polygon outline = counter_clockwise(scene.exterior);
  const Vec2 cells = box_of(outline).size().cwiseQuotient(lattice.spacing);
  const double reach = support_reach(scene);
  Places p;
  const Vertices corners = local(outline, lattice.origin);
  p.soil = signed_area(corners) / lattice.spacing.prod();
  p.filled = std::max({p.soil, filled_area(corners, 0, lattice.spacing.y()) / lattice.spacing.prod(),
                       filled_area(corners, 1, lattice.spacing.x()) / lattice.spacing.prod()});
  p.walls = reach * (cells.x() + 2 * cells.y() + 2 * reach);
  // the long lines waste least, and are taken unless they are too long
  p.lines = 2 * reach + (cells.maxCoeff() + 2 * reach <= kLongestLine ? cells.minCoeff() : cells.maxCoeff());
  return p;
}

/// Lattice offsets within the support, one of each pair.
double forward_offsets(const SceneDef& scene, const Lattice& lattice) {
  const double support = 2 * scene.smoothing_ratio * std::sqrt(lattice.spacing.prod());
  const int reach = static_cast<int>(std::ceil(support / lattice.spacing.minCoeff() + 2 * scene.jitter));
  const auto nearest = [&](int cells) { return std::max(0.0, std::abs(cells) - 2 * scene.jitter); };
  int inside = 0;
  for (int a = -reach; a <= reach; ++a)
    for (int b = -reach; b <= reach; ++b)
      inside += std::hypot(nearest(a) * lattice.spacing.x(), nearest(b) * lattice.spacing.y()) < support ? 1 : 0;
  return (inside - 1) / 2;
}

/// The first spacing above the one asked for that fits, as it is printed; "" where none does. Every one is tried on the
/// lattice it would get, and as it is printed: a section has its own way of rounding.
template <class Fits>
std::string wider_spacing(const SceneDef& scene, Real spacing, const Fits& fits) {
  constexpr double kWider = 1.02;
  const double widest = box_of(counter_clockwise(scene.exterior)).size().minCoeff() / 2;
  for (double wider = kWider * spacing; wider <= widest; wider *= kWider) {
    const std::string printed = number_text(wider, 3);
    double rounded = wider;
    std::from_chars(printed.data(), printed.data() + printed.size(), rounded);
    if (fits(rounded)) return printed;
  }
  return {};
}

}  // namespace

double predicted_bytes(const SceneDef& scene, const Lattice& lattice, int width) {
  const Shape shape = shape_of(scene);
  const Places places = places_of(scene, lattice);
  const double particles = places.soil + places.walls, blocks = particles / width + places.lines;
  constexpr double kPadding = 1.5;  // packs but one lane at the end of a line, in the mean
  const double storage = places.filled + places.walls + kPadding * (width - 1) * places.lines + 2 * width;
  const double offsets = forward_offsets(scene, lattice), packs = blocks * (shape.bonded ? offsets : 1);
  // the state, the motion for the monitors, the state of the energy audit
  constexpr double kCopies = 2, kMotions = 3;
  const double motion = 4 + (shape.volumetric ? 2 : 0),
               strain = shape.plastic && !shape.bonded ? (shape.placed ? 6 : 3) : 0;
  const double shifted = scene.jitter > 0 ? 1 : 0, weights = shifted * width * sizeof(float);
  const double model = 12 + (shape.bonded ? 1 : 0) + (shape.gradient ? 1 : 0) + (shape.uneven ? 1 : 0) + 2 * shifted +
                       (has_ground_water(scene) ? 1 : 0);
  const double scratch = 11 + (shape.bonded ? 2 : 0) + (shape.volumetric ? 2 : 0) + (shape.dilatant ? 2 : 0);
  const double record = shape.plastic && shape.bonded ? (shape.placed ? 6.0 : 3.0) * width * sizeof(double) : 0;
  return storage *
             (sizeof(double) * (model + scratch + kMotions * motion + kCopies * strain) + 2 * sizeof(std::int32_t)) +
         particles * (sizeof(Seed) + shifted * sizeof(Vec2) + 2 * sizeof(std::int32_t)) + blocks * sizeof(Block) +
         2 * offsets * blocks * (sizeof(NeighbourPack) + weights) + packs * (sizeof(BondPack) + kCopies * record);
}

void require_bytes(const SceneDef& scene, const LatticeOf& lattice_of, Real spacing, int width,
                   std::int64_t max_bytes) {
  if (max_bytes <= 0) return;
  const Lattice lattice = lattice_of(spacing);
  const double needed = predicted_bytes(scene, lattice, width), most = static_cast<double>(max_bytes);
  if (needed <= most) return;
  Issue issue{.status = Status::kLimit, .object = ObjectKind::kContext, .value = std::ceil(needed), .text = {}};
  issue.text = "spacings of " + number_text(lattice.spacing.x()) + " m and " + number_text(lattice.spacing.y()) +
               " m need about " + number_text(std::ceil(needed), 12) + " bytes, more than the " +
               std::to_string(max_bytes) + " allowed: ";
  const std::string fits = wider_spacing(
      scene, spacing, [&](Real wider) { return predicted_bytes(scene, lattice_of(wider), width) <= most; });
  issue.text += fits.empty() ? "no spacing would fit" : "a spacing of " + fits + " m would fit";
  throw Error(issue);
}

Section section_within(const SceneDef& scene, const LatticeOf& lattice_of, Real spacing, std::int64_t max_particles) {
  const int reach = support_reach(scene);
  const Lattice lattice = lattice_of(spacing);
  try {
    return discretise(scene, lattice, reach, max_particles);
  } catch (const Error& error) {
    if (error.issue().status != Status::kLimit || max_particles <= 0) throw;
  }
  const auto predicted = [&](const Lattice& on) {  // walls on three sides: rather too many
    const Places places = places_of(scene, on);
    return places.soil + places.walls;
  };
  constexpr double kCounted = 3e5;  // what is few enough to be cut is counted; a limit is there to save memory
  const bool counted = predicted(lattice) < kCounted;
  const double needed =
      counted ? static_cast<double>(discretise(scene, lattice, reach, 0).seeds.size()) : std::ceil(predicted(lattice));
  int tries = 30;  // cuts of a section, the first of them almost always good
  const std::string fits = wider_spacing(scene, spacing, [&](Real wider) {
    const Lattice on = lattice_of(wider);
    if (tries == 0 || predicted(on) > 1.2 * static_cast<double>(max_particles)) return false;
    --tries;
    try {
      discretise(scene, on, reach, max_particles);
      return true;
    } catch (const Error&) {  // the next one
      return false;
    }
  });
  throw Error(
      Issue{.status = Status::kLimit,
            .object = ObjectKind::kProfile,
            .value = needed,
            .text = "spacings of " + number_text(lattice.spacing.x()) + " m and " + number_text(lattice.spacing.y()) +
                    " m need " + (counted ? "" : "about ") + number_text(needed, 12) +
                    " particles (walls included), more than the " + std::to_string(max_particles) + " allowed: " +
                    (fits.empty() ? "no spacing was found that fits" : "a spacing of " + fits + " m would fit")});
}

}  // namespace vbgpd
