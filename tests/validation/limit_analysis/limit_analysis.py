#!/usr/bin/env python3
"""Rigorous bounds on factors of safety by finite-element limit analysis, and what the engine says of the same sections.

Usage: limit_analysis.py VBGPD [CASE ...]; needs Python 3 with numpy and scipy (Debian: python3-scipy), a few minutes
a case. Prints a Markdown table; README.md beside it keeps a dated run.

Plane strain, Mohr-Coulomb, associated flow, as linear programs: stress fields in equilibrium (linear triangles,
tractions continuous across every edge, yield polygon inside the circle; Sloan 1988) and velocity fields (constant
strain triangles, jumps across every edge, yield polygon outside; Sloan & Kleeman 1995). Both look for the multiplier m
of the weight at collapse with c/F and tan(phi)/F. m at F shows more than whether m > 1: a stress field that bears m W
with those strengths bears W with c/(F m) and tan(phi)/F, so FS >= F m where m <= 1 from below, and FS <= F m where m >= 1
from above. Stress: tension positive.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import scipy.optimize
import scipy.sparse

Soil = collections.namedtuple("Soil", "cohesion friction_angle unit_weight")
# a fill of `height` with its crest up to x = crest and a face of `run` to one on a base `depth` thick up to x = right
Case = collections.namedtuple("Case", "depth height run crest right fill clay start rows")
CASES = {
    "vertical cut": Case(0, 1, 0, 2, 2, Soil(1, 0, 3.776), None, 1.0, 7),
    "example 1": Case(0, 10, 2, 12, 32, Soil(10, 20, 20), None, 1.39, 10),
    "fill 5 m on clay": Case(8, 5, 2, 15, 45, Soil(0.5, 35, 20), Soil(20, 0, 17), 1.13, 6),
    "fill 4 m on clay": Case(5, 4, 1.5, 12, 35, Soil(0.5, 38, 20), Soil(18, 0, 17), 1.25, 6),
    "fill 5 m on thin clay": Case(3, 5, 1.5, 15, 35, Soil(1, 38, 20), Soil(20, 0, 17), 1.22, 6),
    "fill 8 m on clay": Case(5, 8, 1.5, 24, 56, Soil(2, 38, 20), Soil(30, 0, 17), 1.16, 6),
}
SIDES = 24  # of the yield polygon


def reduced(soil, factor):
    """Cohesion, friction angle in radians and unit weight at strength reduction factor `factor`."""
    return soil.cohesion / factor, numpy.arctan(numpy.tan(numpy.radians(soil.friction_angle)) / factor), soil.unit_weight


class Mesh:
    """Cells of the section cut into four triangles, cells under the face into three."""

    def __init__(self, case):
        self.case = case
        size = case.height / case.rows
        width, toe = (case.run or 1) * size, case.crest + case.run * case.height
        x = list(numpy.linspace(0, case.crest, max(1, round(case.crest / width)) + 1))
        if case.run:
            x += list(case.crest + width * numpy.arange(1, case.rows + 1))
        columns_of_fill = len(x) - 1
        if case.right > toe + 1e-9:
            x += list(numpy.linspace(toe, case.right, max(1, round((case.right - toe) / width)) + 1)[1:])
        rows_of_clay = max(1, round(case.depth / size)) if case.depth else 0
        y = list(numpy.linspace(0, case.depth, rows_of_clay + 1)) + list(case.depth + size * numpy.arange(1, case.rows + 1))
        self.triangles, self.is_clay = [], []
        for i in range(len(x) - 1):
            for j in range(len(y) - 1):
                clay = j < rows_of_clay
                behind_crest = i - (columns_of_fill - case.rows) if case.run else -1
                room = case.rows - 1 - behind_crest - (j - rows_of_clay)  # cells between this one and the face
                if not clay and (i >= columns_of_fill or (behind_crest >= 0 and room < 0)):
                    continue
                corners = numpy.array([(x[i], y[j]), (x[i + 1], y[j]), (x[i + 1], y[j + 1]), (x[i], y[j + 1])])
                if not clay and behind_crest >= 0 and room == 0:
                    corners = corners[[0, 1, 3]]
                middle = corners.mean(axis=0)
                for k in range(len(corners)):
                    self.triangles.append((corners[k], corners[(k + 1) % len(corners)], middle))
                    self.is_clay.append(clay)
        self.edges = collections.defaultdict(list)  # two ends -> [(triangle, its corners there)], one or two
        for t, corners in enumerate(self.triangles):
            for k in range(3):
                ends = tuple(sorted(self.name(corners[n]) for n in (k, (k + 1) % 3)))
                self.edges[ends].append((t, k, (k + 1) % 3))

    @staticmethod
    def name(point):
        return round(point[0] * 1e6), round(point[1] * 1e6)

    def soils(self, factor):
        pair = [reduced(self.case.fill, factor), self.case.clay and reduced(self.case.clay, factor)]
        return [pair[clay] for clay in self.is_clay]

    def kind(self, p, q):
        """Of an edge with soil on one side only."""
        if p[1] == q[1] == 0:
            return "base"
        if p[0] == q[0] == 0 or (self.case.run and p[0] == q[0] == self.case.right):
            return "side"
        return "free"

    def each_edge(self):
        """triangle, its two corners, along, normal (outward), length, kind (None inside), the corners of the other one."""
        for sharing in self.edges.values():
            t, k, l = sharing[0]
            p, q = self.triangles[t][k], self.triangles[t][l]
            length = numpy.linalg.norm(q - p)
            along = (q - p) / length
            other = {}
            if len(sharing) == 2:
                t2, k2, l2 = sharing[1]
                for corner in (k, l):
                    same = self.name(self.triangles[t2][k2]) == self.name(self.triangles[t][corner])
                    other[corner] = (t2, k2 if same else l2)
            yield t, (k, l), along, numpy.array([along[1], -along[0]]), length, None if other else self.kind(p, q), other


class Rows:
    """Rows of a sparse matrix and their right sides."""

    def __init__(self):
        self.row, self.column, self.value, self.right = [], [], [], []

    def add(self, columns, values, right=0.0):
        self.row += [len(self.right)] * len(columns)
        self.column += list(columns)
        self.value += list(values)
        self.right.append(right)

    def matrix(self, unknowns):
        return scipy.sparse.csr_matrix((self.value, (self.row, self.column)), shape=(len(self.right), unknowns))


def shape_gradients(corners):
    """d/dx and d/dy of the three linear shape functions, area."""
    (x0, y0), (x1, y1), (x2, y2) = corners
    b, c = numpy.array([y1 - y2, y2 - y0, y0 - y1]), numpy.array([x2 - x1, x0 - x2, x1 - x0])
    twice_area = x0 * b[0] + x1 * b[1] + x2 * b[2]
    return b / twice_area, c / twice_area, twice_area / 2


def least(cost, equal, bounds, below=None):
    unknowns = len(cost)
    answer = scipy.optimize.linprog(cost, A_eq=equal.matrix(unknowns), b_eq=equal.right, bounds=bounds, method="highs-ipm",
                                    A_ub=below and below.matrix(unknowns), b_ub=below and below.right)
    if answer.status != 0:
        raise RuntimeError(answer.message)
    return answer.fun


def multiplier_from_below(mesh, factor):
    """Largest multiplier of the weight that a stress field bears. Unknowns: xx, yy, xy at every corner, and it."""
    equal, below, count = Rows(), Rows(), len(mesh.triangles)
    multiplier, inside = 9 * count, numpy.cos(numpy.pi / SIDES)
    at = lambda t, k: [9 * t + 3 * k + n for n in range(3)]
    for t, soil in enumerate(mesh.soils(factor)):
        cohesion, phi, weight = soil
        dx, dy, _ = shape_gradients(mesh.triangles[t])
        xx, yy, xy = zip(*(at(t, k) for k in range(3)))
        equal.add(xx + xy, list(dx) + list(dy))
        equal.add(xy + yy + (multiplier,), list(dx) + list(dy) + [-weight])
        for k in range(3):
            for a in 2 * numpy.pi * numpy.arange(SIDES) / SIDES:
                pressure = numpy.sin(phi) * inside
                below.add(at(t, k), [numpy.cos(a) + pressure, -numpy.cos(a) + pressure, 2 * numpy.sin(a)],
                          2 * cohesion * numpy.cos(phi) * inside)
    for t, corners, _, (nx, ny), _, kind, other in mesh.each_edge():
        normal, shear = [nx * nx, ny * ny, 2 * nx * ny], [-nx * ny, nx * ny, nx * nx - ny * ny]
        for k in corners:
            if kind is None:
                for traction in (normal, shear):
                    equal.add(at(t, k) + at(*other[k]), traction + [-s for s in traction])
            if kind == "free":
                equal.add(at(t, k), normal)
            if kind in ("free", "side"):
                equal.add(at(t, k), shear)
    cost = numpy.zeros(multiplier + 1)
    cost[multiplier] = -1
    return -least(cost, equal, (None, None), below)


def multiplier_from_above(mesh, factor):
    """Least dissipation of a velocity field whose weight does unit work. Unknowns: two velocities at every corner, then
    rates of plastic flow: of every side of the polygon in a triangle, both ways at the ends of an edge."""
    equal, count, soils = Rows(), len(mesh.triangles), mesh.soils(factor)
    cost, work = [0.0] * (6 * count), ([], [])
    x_of, y_of = lambda t, k: 6 * t + 2 * k, lambda t, k: 6 * t + 2 * k + 1
    angle = 2 * numpy.pi * numpy.arange(SIDES) / SIDES
    for t, (cohesion, phi, weight) in enumerate(soils):
        dx, dy, area = shape_gradients(mesh.triangles[t])
        x, y = [x_of(t, k) for k in range(3)], [y_of(t, k) for k in range(3)]
        flow = list(len(cost) + numpy.arange(SIDES))
        cost += [2 * cohesion * numpy.cos(phi) * area] * SIDES
        equal.add(x + flow, list(dx) + list(-(numpy.cos(angle) + numpy.sin(phi))))
        equal.add(y + flow, list(dy) + list(numpy.cos(angle) - numpy.sin(phi)))
        equal.add(x + y + flow, list(dy) + list(dx) + list(-2 * numpy.sin(angle)))
        work[0].extend(y)
        work[1].extend([-weight * area / 3] * 3)
    for t, corners, along, normal, length, kind, other in mesh.each_edge():
        if kind == "free":
            continue
        for k in corners:
            if kind == "side":
                equal.add([x_of(t, k)], [1.0])
                continue
            place, shear, opening, sharing = [x_of(t, k), y_of(t, k)], list(-along), list(-normal), {soils[t]}
            if kind is None:
                place += [x_of(*other[k]), y_of(*other[k])]
                shear, opening = shear + list(along), opening + list(normal)
                sharing.add(soils[other[k][0]])
            slip, signs, dilation = [], [], []
            for cohesion, phi, _ in sharing:  # where two soils meet either may flow
                slip += [len(cost), len(cost) + 1]
                cost += [cohesion * length / 2] * 2
                signs += [-1.0, 1.0]
                dilation += [-numpy.tan(phi)] * 2
            equal.add(place + slip, shear + signs)
            equal.add(place + slip, opening + dilation)
    equal.add(*work, 1.0)
    velocities = 6 * count
    return least(cost, equal, [(None, None)] * velocities + [(0, None)] * (len(cost) - velocities))


def bound(multiplier, mesh, tighter):
    """Secant steps on log m(log F) towards m = 1; each program is a bound by itself. tighter: max from below, min from
    above."""
    usual_slope, programs = -1.3, 3
    at, found, before = numpy.log(mesh.case.start), [], None
    for _ in range(programs):
        m = numpy.log(multiplier(mesh, numpy.exp(at)))
        further_out = min if tighter is max else max
        found.append(numpy.exp(at + further_out(m, 0)))
        slope = usual_slope if before is None else (m - before[1]) / (at - before[0])
        before, at = (at, m), at - m / slope
    return tighter(found)


def bishop(case):
    """Least factor of safety of Bishop's simplified method over circles inside the section, as text."""
    if not case.run:
        return "no circle"  # through a vertical face the slices are not those of a slope
    toe, top, clay, none = case.crest + case.run * case.height, case.depth + case.height, case.clay or case.fill, 9.0
    across = (numpy.arange(400) + 0.5) / 200 - 1

    def of_circle(circle):
        x0, y0, low = circle
        radius = y0 - max(low, 0)
        x, base = x0 + radius * across, y0 - radius * numpy.sqrt(1 - across**2)
        ground = numpy.interp(x, [case.crest, toe], [top, case.depth])
        cut = numpy.flatnonzero(base < ground)
        if len(cut) < 20 or cut[-1] - cut[0] >= len(cut) or cut[0] == 0 or cut[-1] == len(across) - 1:
            return none
        x, base, ground, sine = x[cut], base[cut], ground[cut], -across[cut]
        if x[0] < 0 or x[-1] > case.right:
            return none
        weight = case.fill.unit_weight * (ground - numpy.maximum(base, case.depth)) + (
            clay.unit_weight * numpy.maximum(numpy.minimum(ground, case.depth) - base, 0))
        in_clay, driving, factor = base < case.depth, (weight * sine).sum(), 1.0
        cohesion = numpy.where(in_clay, clay.cohesion, case.fill.cohesion)
        friction = numpy.tan(numpy.radians(numpy.where(in_clay, clay.friction_angle, case.fill.friction_angle)))
        for _ in range(15):
            share = numpy.sqrt(1 - sine**2) + sine * friction / factor
            if driving <= 0 or share.min() < 0.05:
                return none
            factor = ((cohesion + weight * friction) / share).sum() / driving
        return factor

    tried = sorted((of_circle((x, y, low)), x, y, low)
                   for x in numpy.linspace(case.crest, toe + case.height, 12)
                   for y in top + case.height * numpy.linspace(0.05, 3, 12)
                   for low in numpy.linspace(0, case.depth + 0.2 * case.height, 8))
    best = min(scipy.optimize.minimize(of_circle, start[1:], method="Nelder-Mead").fun for start in tried[:12])
    return f"{best:.3f}"


def scene_of(case, psi):
    """As JSON of the engine; psi: of the fill, degrees."""
    toe, top = case.crest + case.run * case.height, case.depth + case.height
    face = [(toe, case.depth), (case.crest, top)]
    foreground = [(case.right, 0), (case.right, case.depth)] if case.depth else []
    points = lambda corners: [{"x": x, "y": y} for x, y in corners]
    soil = dict(law="mohr_coulomb", unit_weight=case.fill.unit_weight, young_modulus=1e5, poisson_ratio=0.3,
                cohesion=case.fill.cohesion, friction_angle=case.fill.friction_angle, dilatancy_angle=psi)
    materials, layers = [dict(soil, name="fill")], [{"material": "fill"}]
    if case.clay:
        materials.append(dict(name="clay", law="undrained", unit_weight=case.clay.unit_weight, young_modulus=1e5,
                              poisson_ratio=0.3, cohesion=case.clay.cohesion))
        layers = [{"material": "clay"},
                  {"material": "fill", "polygon": points([(0, case.depth), *face, (0, top)])}]
    boundaries = [{"side": "base", "kind": "fixed"}, {"side": "left", "kind": "roller"}]
    if case.depth:
        boundaries.append({"side": "right", "kind": "roller"})
    return {"name": "limit analysis", "units": "kPa", "profile": {"exterior": points([(0, 0), *foreground, *face, (0, top)])},
            "materials": materials, "layers": layers, "boundaries": boundaries, "spacing": case.height / 20}


def engine(program, case, psi):
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.json"
        scene.write_text(json.dumps(scene_of(case, psi)), encoding="utf-8")
        done = subprocess.run([program, "fos", str(scene), "--json", "--quiet"], stdout=subprocess.PIPE, text=True, check=False)
    result = json.loads(done.stdout)
    error = result["error_estimate"]
    told = f"{result['factor_of_safety']:.3f}" + ("" if error is None else f" ±{error:.3f}")
    return told if result["status"] == "OK" else f"{told} {result['status']}"


def main(program, *chosen):
    print("| section | triangles | Bishop | lower bound | upper bound | engine, psi = phi | engine, psi = 0 |")
    print("|" + "---|" * 7)
    for name, case in CASES.items():
        if chosen and name not in chosen:
            continue
        mesh = Mesh(case)
        low, high = bound(multiplier_from_below, mesh, max), bound(multiplier_from_above, mesh, min)
        print(f"| {name} | {len(mesh.triangles)} | {bishop(case)} | {low:.3f} | {high:.3f} | "
              f"{engine(program, case, case.fill.friction_angle)} | {engine(program, case, 0)} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
