// The lattice that meets the key lines of a section. Coarse cells are counted, not measured, in x (the extent must
// fit); in y the spacing is free and candidates come from the levels themselves, so that an exact fit is found when
// there is one.
#include <algorithm>
#include <cmath>

#include "geometry/format.h"
#include "geometry/outline.h"
#include "geometry/section.h"

namespace vbgpd {
namespace {

constexpr Real kReach = 0.1;         // spacings within 10 % of the one asked
constexpr Real kKeepSpacing = 0.02;  // price of ln(spacing / asked)^2 against misfit^2
constexpr Real kKeepSquare = 0.03;   // price of ln(dx / dy)^2
constexpr Real kSame = 1e-9;         // of the extent: edges this straight are horizontal or vertical

// Weights of misfit^2. Levels of the exterior count most: off the edges they cost per cents of the factor of safety.
constexpr Real kCrestToe = 0.5;
constexpr Real kExterior = 1.0;  // times length / width (height)
constexpr Real kLoadEnd = 0.5;
constexpr Real kLayer = 0.25;  // times length / width
constexpr Real kBreakPoint = 0.05;

struct KeyLine {
  Real at;  // from the left end or the base
  Real weight;
  bool important;
};

struct KeyLines {
  std::vector<KeyLine> x, y;
  Vec2 size;
};

Real misfit(Real at, Real spacing) {
  const Real cells = at / spacing;
  return std::abs(cells - std::round(cells));
}

Real cost(const std::vector<KeyLine>& lines, Real spacing, Real asked) {
  const Real change = std::log(spacing / asked);
  Real sum = kKeepSpacing * change * change;
  for (const KeyLine& line : lines) {
    const Real d = misfit(line.at, spacing);
    sum += line.weight * d * d;
  }
  return sum;
}

Real largest_misfit(const std::vector<KeyLine>& lines, Real spacing) {
  Real largest = 0;
  for (const KeyLine& line : lines)
    if (line.important) largest = std::max(largest, misfit(line.at, spacing));
  return largest;
}

void add_exterior_lines(const Vertices& exterior, KeyLines& lines) {
  const Real straight = kSame * lines.size.maxCoeff();
  for (std::size_t i = 0, j = exterior.size() - 1; i < exterior.size(); j = i++) {
    const Vec2 &a = exterior[j], &b = exterior[i];
    const Vec2 edge = (b - a).cwiseAbs();
    if (edge.y() <= straight) lines.y.push_back({a.y(), kExterior * edge.x() / lines.size.x(), true});
    if (edge.x() <= straight) lines.x.push_back({a.x(), kExterior * edge.y() / lines.size.y(), true});
  }
  const std::vector<std::size_t> ground = outline_of(exterior).ground;
  Real toe = exterior[ground.front()].y(), crest = toe;
  for (std::size_t i : ground) {
    toe = std::min(toe, exterior[i].y());
    crest = std::max(crest, exterior[i].y());
    lines.x.push_back({exterior[i].x(), kBreakPoint, false});
    lines.y.push_back({exterior[i].y(), kBreakPoint, false});
  }
  lines.y.push_back({toe, kCrestToe, true});
  lines.y.push_back({crest, kCrestToe, true});
}

KeyLines key_lines(const SceneDef& scene, const Polygon& outline, const Vec2& origin) {
  const Vertices exterior = local(outline, origin);
  KeyLines lines;
  lines.size = box_of(exterior).size();
  add_exterior_lines(exterior, lines);
  const Real straight = kSame * lines.size.maxCoeff();
  for (const LayerDef& layer : scene.layers) {
    const Vertices polygon = local(open_polygon(layer.polygon), origin);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if (std::abs(a.y() - b.y()) > straight || a.y() < 0 || a.y() > lines.size.y()) continue;
      const Real length =
          std::abs(std::clamp(b.x(), Real(0), lines.size.x()) - std::clamp(a.x(), Real(0), lines.size.x()));
      lines.y.push_back({a.y(), kLayer * length / lines.size.x(), false});
    }
  }
  for (const LoadDef& load : scene.loads)
    for (const Real x : {load.x0 - origin.x(), load.x1 - origin.x()})
      if (std::isfinite(x) && x >= 0 && x <= lines.size.x()) lines.x.push_back({x, kLoadEnd, true});
  return lines;
}

struct Candidate {
  Real spacing, cost;
};

// The cheapest first, and few enough that all pairs of x and y can be tried.
void keep_best(std::vector<Candidate>& candidates) {
  constexpr std::size_t kKeep = 300;
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  if (candidates.size() > kKeep) candidates.resize(kKeep);
}

// Whole numbers of cells between one end of the reach and the other; the nearest one when none lies within.
template <class Use>
void for_counts(Real length, Real asked, Use use) {
  const Real first = std::ceil(length / (asked * (1 + kReach)) - kSame), last = length / (asked * (1 - kReach)) + kSame;
  for (Real n = std::max(first, Real(1)); n <= last; ++n) use(n);
}

std::vector<Candidate> candidates_x(const KeyLines& lines, Real asked) {
  std::vector<Candidate> result;
  const auto add = [&](Real n) {
    const Real spacing = lines.size.x() / n;
    result.push_back({spacing, cost(lines.x, spacing, asked)});
  };
  for_counts(lines.size.x(), asked, add);
  if (result.empty()) add(std::max(std::round(lines.size.x() / asked), Real(1)));
  keep_best(result);
  return result;
}

// Least squares of sum w (at / s - k)^2 with the counts k that `spacing` suggests.
Real refined(const std::vector<KeyLine>& lines, Real spacing) {
  Real up = 0, down = 0;
  for (const KeyLine& line : lines) {
    up += line.weight * line.at * line.at;
    down += line.weight * line.at * std::round(line.at / spacing);
  }
  return down > 0 ? up / down : spacing;
}

// An outline traced in thousands of points must not propose a spacing for each of them.
std::vector<KeyLine> heaviest(std::vector<KeyLine> lines) {
  constexpr std::size_t kKeep = 64;
  std::stable_sort(lines.begin(), lines.end(), [](const KeyLine& a, const KeyLine& b) { return a.weight > b.weight; });
  if (lines.size() > kKeep) lines.resize(kKeep);
  return lines;
}

std::vector<Candidate> candidates_y(const KeyLines& lines, Real asked) {
  constexpr int kSamples = 100;  // a side
  std::vector<Candidate> result;
  const auto add = [&](Real spacing) {
    if (std::abs(spacing / asked - 1) <= kReach * (1 + kSame))
      result.push_back({spacing, cost(lines.y, spacing, asked)});
  };
  add(asked);
  for (const KeyLine& line : heaviest(lines.y))
    if (line.at > kSame * lines.size.y()) for_counts(line.at, asked, [&](Real n) { add(line.at / n); });
  for (int k = -kSamples; k <= kSamples; ++k) {
    const Real spacing = asked * (1 + kReach * k / kSamples);
    add(spacing);
    add(refined(lines.y, spacing));
  }
  keep_best(result);
  return result;
}

Vec2 best_pair(const std::vector<Candidate>& xs, const std::vector<Candidate>& ys) {
  Vec2 best = Vec2::Zero();
  Real least = std::numeric_limits<Real>::infinity();
  for (const Candidate& x : xs)
    for (const Candidate& y : ys) {
      const Real shape = std::log(x.spacing / y.spacing);
      const Real total = x.cost + y.cost + kKeepSquare * shape * shape;
      if (total < least) {
        least = total;
        best = Vec2(x.spacing, y.spacing);
      }
    }
  return best;
}

[[noreturn]] void fail(Status status, Real value, const std::string& text) {
  throw Error(Issue{.status = status, .object = ObjectKind::kProfile, .value = value, .text = text});
}

}  // namespace

void require_spacing(Real spacing, const Vec2& size) {
  const std::string said = "spacing = " + number(spacing) + " m ";
  if (!(spacing > 0) || !std::isfinite(spacing))
    fail(Status::kRange, spacing, said + "must be a finite length above 0");
  if (spacing > size.minCoeff() / 2 * (1 + kSame))
    fail(Status::kRange, spacing,
         said + "is larger than half the section's smaller extent (" + number(size.x()) + " m wide, " +
             number(size.y()) + " m high): at most " + number(size.minCoeff() / 2) + " m would be right");
  constexpr Real kMostCells = 1 << 30;
  const Real cells = (size.x() / spacing) * (size.y() / spacing);
  if (!(cells <= kMostCells))
    fail(Status::kLimit, spacing,
         said + "would give " + number(cells) + " cells in a section " + number(size.x()) + " m wide and " +
             number(size.y()) + " m high; at most " + number(kMostCells) + " are possible: use a larger spacing");
}

Lattice fit_lattice(const SceneDef& scene, Real spacing, int multiple) {
  if (multiple < 1)
    throw Error(Status::kArgument, "the lattice multiple is " + std::to_string(multiple) + "; it must be at least 1");
  const Polygon exterior = counter_clockwise(scene.exterior);
  const Vec2 origin = box_of(exterior).low;
  const Vec2 size = box_of(exterior).size();
  if (exterior.size() < 3 || !(size.minCoeff() > 0) || !size.allFinite())
    fail(Status::kGeometry, kNone,
         "the exterior of the profile encloses no area; it needs at least 3 vertices that do");
  require_spacing(spacing, size);
  const KeyLines lines = key_lines(scene, exterior, origin);
  const Real asked = spacing * multiple;
  const Vec2 coarse = best_pair(candidates_x(lines, asked), candidates_y(lines, asked));
  Lattice lattice;
  lattice.origin = origin;
  lattice.spacing = coarse / multiple;
  lattice.misfit = Vec2(largest_misfit(lines.x, coarse.x()), largest_misfit(lines.y, coarse.y()));
  return lattice;
}

Lattice coarsened(const Lattice& lattice, int factor) {
  if (factor < 1)
    throw Error(Status::kArgument,
                "a lattice cannot be made " + std::to_string(factor) + " times coarser; the factor must be at least 1");
  Lattice result = lattice;
  result.spacing *= factor;
  return result;
}

}  // namespace vbgpd
