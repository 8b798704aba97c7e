#!/usr/bin/env python3
"""Collapsing columns and slopes that run out, each to rest: how far, how clean, how well the books balance.

Usage: study.py LIBVBGPD.so [--repeat N] [CASE ...]. Prints one row of a Markdown table per case; README.md beside it
keeps the rows of a dated run. --repeat N: N runs of each case whose moduli differ by 1e-9, mean and standard deviation. Columns: `front` is the foremost particle of the connected mass plus half a spacing, `q995` the 99.5 %
quantile of x, `lost` the particles that do not hang together with the rest, `noise` the RMS of the vertical stress
against a linear fit over the neighbours, relative to gamma H, when at rest and (where that is later) at 10 sqrt(H/g),
`residual` what the energy ledger does not explain.
"""
import collections
import math
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "bindings" / "python"))
import numpy  # noqa: E402
import vbgpd  # noqa: E402

GRAVITY = 9.81
Case = collections.namedtuple("Case", "name width height spacing phi cohesion density modulus seconds rough_left law outline jitter",
                              defaults=(None, 0))  # outline: a slope between rollers instead of a rectangle on the left wall
BARS = dict(phi=19.8, cohesion=0.0, density=2650, rough_left=False, law="drucker_prager")


def bars(name, rows, modulus=0.84e6, jitter=0):
    return Case(name, 0.2, 0.1, 0.1 / rows, modulus=modulus, seconds=2, jitter=jitter, **BARS)


def column(aspect):
    """0.1 m wide, 800 particles; (L - L0)/L0 = 1.2 a, above a = 1.8 1.9 a^(2/3) (Lube et al. 2005)."""
    height = 0.1 * aspect
    return Case(f"column a = {aspect:g}", 0.1, height, math.sqrt(0.1 * height / 800), 30.0, 0.0, 2650,
                330 * 2650 * GRAVITY * height, 4, False, "drucker_prager")


def rods(aspect):
    """True 2D: aluminium rods 0.1 m high or as wide, rough base and wall (Nguyen et al. 2017)."""
    width, height = (0.1 / aspect, 0.1) if aspect < 1 else (0.1, 0.1 * aspect)
    return Case(f"rods a = {aspect:g}", width, height, math.sqrt(width * height / 800), 21.9, 0.0, 2040, 5.84e6, 3, True,
                "drucker_prager")


CASES = [bars("bars H/10", 10), bars("bars H/20", 20), bars("bars H/40", 40), bars("bars H/20, E x 7", 20, 5.88e6),
         bars("bars H/20, 0.2 spacings off the lattice", 20, jitter=0.2),
         column(0.5), column(1), column(2), column(4), rods(0.5), rods(1), rods(2),
         Case("vertical cut 10 m, c 5 kPa, phi 25", 10, 10, 0.5, 25.0, 5e3, 1998, 1e7, 20, False, "mohr_coulomb"),
         Case("clay slope 2:1 on 5 m of clay, c 15 kPa, phi 0", 55, 10, 0.5, 0.0, 15e3, 1998, 1e7, 40, False, "undrained",
              ((0, 0), (55, 0), (55, 5), (35, 5), (15, 15), (0, 15)))]


def outline_of(case):
    w, h = case.width, case.height
    return case.outline or ((0, 0), (w, 0), (w, h), (0, h))


def area_of(corners):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1])) / 2


def model_of(context, case):
    with vbgpd.Profile(context) as profile:
        profile.set_exterior(outline_of(case))
        soil = profile.add_material("soil", law=case.law, unit_weight=case.density * GRAVITY,
                                    young_modulus=case.modulus, poisson_ratio=0.3, cohesion=case.cohesion,
                                    friction_angle=case.phi)
        profile.add_layer(soil)
        profile.add_boundary(vbgpd.Boundary.FIXED, side="base")
        profile.add_boundary(vbgpd.Boundary.FIXED if case.rough_left else vbgpd.Boundary.ROLLER, side="left")
        if case.outline:
            profile.add_boundary(vbgpd.Boundary.ROLLER, side="right")
        profile.set("spacing", case.spacing)
        profile.set("jitter", case.jitter)
        with vbgpd.Model(context, profile) as at_rest:
            return vbgpd.Model.runout_of(at_rest)


def neighbours(x, reach):
    cells = collections.defaultdict(list)
    keys = [tuple(k) for k in numpy.floor(x / reach).astype(int)]
    for i, key in enumerate(keys):
        cells[key].append(i)
    for i, (a, b) in enumerate(keys):
        near = [j for da in (-1, 0, 1) for db in (-1, 0, 1) for j in cells.get((a + da, b + db), ()) if j != i]
        near = numpy.array(near, dtype=int)
        distance = numpy.hypot(*(x[near] - x[i]).T) if len(near) else numpy.array([])
        yield near[distance < reach], distance[distance < reach]


def largest_mass(x, link):
    near = [found for found, _ in neighbours(x, link)]
    label = numpy.full(len(x), -1)
    for seed in range(len(x)):
        if label[seed] >= 0:
            continue
        label[seed], open_ends = seed, [seed]
        while open_ends:
            for j in near[open_ends.pop()]:
                if label[j] < 0:
                    label[j] = seed
                    open_ends.append(j)
    return label == numpy.bincount(label).argmax()


def noise_of(x, stress, reach, scale):
    errors = []
    for i, (near, _) in enumerate(neighbours(x, reach)):
        if len(near) < 8:
            continue
        fit = numpy.column_stack([numpy.ones(len(near)), x[near] - x[i]])
        errors.append(stress[i] - numpy.linalg.lstsq(fit, stress[near], rcond=None)[0][0])
    return math.sqrt(numpy.mean(numpy.square(errors))) / scale


def run(case, library):
    with vbgpd.Context(library=library) as context, model_of(context, case) as model:
        started = time.process_time()
        with vbgpd.Job.runout(model, end_time=float(case.seconds)) as job:
            job.run()
            status = job.get_text("status")
        seconds = time.process_time() - started
        x, stress = model.field("position"), model.field("stress")
        dx = math.sqrt(model.get("spacing_x") * model.get("spacing_y"))
        mass = largest_mass(x, 1.6 * dx)
        ground = model.ground_surface()
        least = min(distance.min() for _, distance in neighbours(x, 1.6 * dx) if len(distance))
        external = model.get("external_work")
        noise = noise_of(x, stress[:, 1], 2.6 * dx, case.density * GRAVITY * case.height)
        cells = [case.name, f"{len(x)}", f"{x[mass, 0].max() + dx / 2:.4g}", f"{numpy.quantile(x[:, 0], 0.995):.4g}",
                 f"{ground[0, 1]:.4g}", f"{ground[:, 1].sum() * dx / area_of(outline_of(case)):.3f}",
                 f"{(~mass).sum()}", f"{least / dx:.2f}",
                 f"{noise:.4f}",
                 f"{model.get('kinetic_energy') / model.get('peak_kinetic_energy'):.0e}",
                 f"{100 * model.get('energy_residual'):.2f} %",
                 f"{100 * model.get('viscous_dissipation') / external:.0f} %", f"{model.get('viscosity'):.3g}",
                 f"{model.get('time'):.3g} s, {status.lower().replace('_', ' ')}", f"{model.get('steps'):.0f}",
                 f"{seconds:.0f}"]
        later = 10 * math.sqrt(case.height / GRAVITY)
        if model.get("time") < later:
            model.advance_to(later)
            noise = noise_of(model.field("position"), model.field("stress")[:, 1], 2.6 * dx,
                             case.density * GRAVITY * case.height)
        cells.insert(9, f"{noise:.4f}")
        print("| " + " | ".join(cells) + " |", flush=True)


def scatter(case, library, runs):
    q995, lost, noise = [], [], []
    for k in range(runs):
        with vbgpd.Context(library=library) as context, \
                model_of(context, case._replace(modulus=case.modulus * (1 + 1e-9 * k))) as model:
            with vbgpd.Job.runout(model, end_time=float(case.seconds)) as job:
                job.run()
            later = 10 * math.sqrt(case.height / GRAVITY)
            if model.get("time") < later:
                model.advance_to(later)
            x = model.field("position")
            dx = math.sqrt(model.get("spacing_x") * model.get("spacing_y"))
            q995.append(numpy.quantile(x[:, 0], 0.995))
            lost.append((~largest_mass(x, 1.6 * dx)).sum())
            noise.append(noise_of(x, model.field("stress")[:, 1], 2.6 * dx, case.density * GRAVITY * case.height))
    print(f"| {case.name} | {runs} | {numpy.mean(q995):.4f} | {numpy.std(q995):.4f} | {min(lost)} to {max(lost)} | "
          f"{numpy.mean(lost):.1f} | {numpy.mean(noise):.4f} |", flush=True)


def main(library, *chosen):
    if chosen[:1] == ("--repeat",):
        print("| case | runs | q995, mean | standard deviation | lost | lost, mean | noise later, mean |")
        print("|" + "---|" * 7)
        for case in CASES:
            if len(chosen) == 2 or any(word in case.name for word in chosen[2:]):
                scatter(case, library, int(chosen[1]))
        return
    print("| case | particles | front | q995 | height at the wall | area | lost | least distance / dx | noise | later | "
          "KE end / peak | residual | viscous share | alpha c h, m2/s | end | steps | CPU s |")
    print("|" + "---|" * 17)
    for case in CASES:
        if not chosen or any(word in case.name for word in chosen):
            run(case, library)


if __name__ == "__main__":
    main(*sys.argv[1:])
