#!/usr/bin/env python3
"""Virtual bonds and their rivals on the same problems, in the same program: who clumps, who breaks, what it costs.

Usage: study.py LIBVBGPD.so [--pictures DIRECTORY] [--law NAME ...] [CASE ...]. For every case and law one row of a
Markdown table; README.md beside it keeps the rows of a dated run. The laws are the names of the scene's `bond`; all of
them move the same particles with the same kernel, soil law, walls and time step. Colliding rings are a test of their
own: tests/physics/runout_pair_laws_test.cpp.
"""
import argparse
import math
import os
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "bindings" / "python"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "runout"))
import numpy  # noqa: E402
import vbgpd  # noqa: E402
from study import largest_mass, neighbours, noise_of  # noqa: E402

GRAVITY = 9.81
LAWS = ["virtual_bond", "none", "sph", "sph_artificial_stress", "pseudo_spring", "gpd"]
LINK = 1.6  # spacings: particles nearer than that hang together


def model_of(context, law, outline, soil, spacing, boundaries, weightless=False):
    """A run-out model. boundaries: (kind, side or polyline)."""
    with vbgpd.Profile(context) as profile:
        profile.set_exterior(outline)
        profile.add_layer(profile.add_material("soil", **soil))
        for kind, where in boundaries:
            profile.add_boundary(kind, **({"side": where} if isinstance(where, str) else {"xy": where}))
        profile.set("spacing", spacing)
        profile.set("bond", law)
        if weightless:
            profile.set("kv", -1 + 1e-12)  # an uplift that leaves nothing of the weight
        with vbgpd.Model(context, profile) as at_rest:
            return vbgpd.Model.runout_of(at_rest)


def material(law, density, modulus, cohesion=0.0, phi=0.0):
    soil = dict(law=law, unit_weight=density * GRAVITY, young_modulus=modulus, poisson_ratio=0.3)
    return soil if law == "elastic" else dict(soil, cohesion=cohesion, friction_angle=phi)


def wave_speed(soil):
    nu = soil["poisson_ratio"]
    return math.sqrt(soil["young_modulus"] * (1 - nu) / (1 + nu) / (1 - 2 * nu) * GRAVITY / soil["unit_weight"])


def pieces_of(x, link):
    label = numpy.full(len(x), -1)
    near = [found for found, _ in neighbours(x, link)]
    count = 0
    for seed in range(len(x)):
        if label[seed] >= 0:
            continue
        label[seed], ends, count = count, [seed], count + 1
        while ends:
            for j in near[ends.pop()]:
                if label[j] < 0:
                    label[j] = label[seed]
                    ends.append(j)
    return label, count


class Measured:
    """What every case tells: state at its end and the numbers common to all."""

    def __init__(self, model, scale, component):
        self.x, self.stress = model.field("position"), model.field("stress")
        self.strain = model.field("plastic_strain")
        if model.get("plastic_bonds") > 0 and not self.strain.any():  # springs break instead
            self.strain = model.field("plastic_bond_fraction")
        self.moved = numpy.hypot(*model.field("displacement").T)
        self.dx = math.sqrt(model.get("spacing_x") * model.get("spacing_y"))
        distances = [d.min() for _, d in neighbours(self.x, LINK * self.dx) if len(d)]
        self.least = min(distances, default=float("nan")) / self.dx
        self.labels, self.pieces = pieces_of(self.x, LINK * self.dx)
        self.lost = len(self.x) - int(largest_mass(self.x, LINK * self.dx).sum())
        self.noise = noise_of(self.x, self.stress[:, component], 2.6 * self.dx, scale)
        self.residual = model.get("energy_residual")
        self.verdict, self.own = "", {}


def march(model, seconds):
    """True when it came to the end of it, False when a particle crossed a spacing in one step."""
    try:
        model.step(math.ceil(seconds / model.get("time_step")))
        return True
    except vbgpd.Error as error:
        if error.status != vbgpd.Status.E_DIVERGED:
            raise
        return False


def stretched_bar(context, law):
    """Elastic bar, 2 m x 0.4 m, free; its halves start to fly apart, v_x = 0.08 c x / (L/2), and pull each other back;
    after six wave travels to and fro."""
    soil = material("elastic", 1000, 1e6)
    wave = wave_speed(soil)
    with model_of(context, law, [(0, 0), (2, 0), (2, 0.4), (0, 0.4)], soil, 0.05,
                  [(vbgpd.Boundary.FREE, "base")], weightless=True) as model:
        x = model.field("position")
        length = numpy.ptp(x[:, 0])
        velocity = numpy.zeros_like(x)
        velocity[:, 0] = 0.08 * wave * (x[:, 0] - 1)
        model.write("velocity", velocity)
        given = model.get("kinetic_energy")
        whole = march(model, 24 / wave)
        m = Measured(model, soil["young_modulus"] * 0.08, 0)
        kept = (model.get("kinetic_energy") + model.get("elastic_energy")) / given
        m.own = {"length / length before": f"{numpy.ptp(m.x[:, 0]) / length:.3f}", "energy kept": f"{kept:.2f}"}
        m.verdict = ("diverged" if not whole else f"breaks into {m.pieces}" if m.pieces > 1 else
                     "clumps" if m.least < 0.6 else "whole")
        m.colour, m.colour_name = m.stress[:, 0] / soil["young_modulus"], "sigma_xx / E"
        return m


def band_angle(x, strain, dx):
    """Degrees from the horizontal of the strip, two spacings wide, that holds most of the plastic strain."""
    best = (0.0, 0.0)
    for degrees in numpy.arange(30.0, 75.0, 0.5):
        for lean in (1, -1):
            across = x @ numpy.array([-lean * math.sin(math.radians(degrees)), math.cos(math.radians(degrees))])
            for middle in numpy.arange(across.min(), across.max(), dx / 2):
                best = max(best, (strain[numpy.abs(across - middle) < dx].sum(), degrees))
    return best[1]


def compression(context, law):
    """Soil sample 1 m x 2 m, c 10 kPa, phi 20 degrees, tension up to 20 kPa, without weight, between a fixed base and a
    platen that comes down by 4 % of its height; the greatest mean stress at mid-height against the uniaxial strength
    2 c cos phi / (1 - sin phi), and that at the end. The band should lie between 45 + psi/2 = 45 degrees (Roscoe) and
    45 + phi/2 = 55 degrees (Coulomb)."""
    phi, spacing, speed = math.radians(20), 1 / 20, 0.02
    strength = 2 * 10e3 * math.cos(phi) / (1 - math.sin(phi))
    cap = 3 * spacing
    with vbgpd.Profile(context) as profile:
        profile.set_exterior([(0, 0), (1, 0), (1, 2 + cap), (0, 2 + cap)])
        profile.add_layer(profile.add_material(
            "soil", **dict(material("mohr_coulomb", 2000, 1e7, 10e3, 20.0), tension_cutoff=20e3)))
        # heavy, so that what pushes it back in one step is small against its speed
        profile.add_layer(profile.add_material("platen", **material("elastic", 40000, 1e7)),
                          [(0, 2), (1, 2), (1, 2 + cap), (0, 2 + cap)])
        profile.add_boundary(vbgpd.Boundary.FIXED, side="base")
        profile.set("spacing", spacing)
        profile.set("bond", law)
        profile.set("kv", -1 + 1e-12)
        with vbgpd.Model(context, profile) as at_rest:
            model = vbgpd.Model.runout_of(at_rest)
    with model:
        model.set("damping", 0.5)
        height = model.field("reference_position")[:, 1].copy()
        platen, middle = height > 2, numpy.abs(height - 1) < 0.25
        velocity = numpy.zeros((len(height), 2))
        velocity[:, 1] = -speed * numpy.minimum(height, 2) / 2
        model.write("velocity", velocity)
        whole, stress = True, []
        try:
            for step in range(math.ceil(0.08 / speed / model.get("time_step"))):
                model.step(1)
                velocity = model.field("velocity").copy()
                velocity[platen] = (0, -speed)
                model.write("velocity", velocity)
                if step % 20 == 0:
                    stress.append(-model.field("stress")[middle, 1].mean() / strength)
        except vbgpd.Error as error:
            if error.status != vbgpd.Status.E_DIVERGED:
                raise
            whole = False
        m = Measured(model, strength, 1)
    peak, end = max(stress), stress[-1]
    angle = band_angle(m.x[~platen], m.strain[~platen], m.dx)
    m.own = {"peak / closed form": f"{peak:.3f}", "at 4 %": f"{end:.2f}", "band": f"{angle:.0f} degrees"}
    m.verdict = ("diverged" if not whole else f"peak {100 * (peak - 1):+.0f} %" +
                 (", then breaks" if end < 0.5 else ""))
    m.colour, m.colour_name = m.strain, "plastic shear strain"
    return m


def job_of(model, seconds):
    with vbgpd.Job.runout(model, end_time=float(seconds)) as job:
        try:
            job.run()
        except vbgpd.Error as error:
            if error.status != vbgpd.Status.E_DIVERGED:
                raise
        return job.get_text("status"), {name: job.get(name) for name in ("crest_settlement", "toe_displacement",
                                                                         "runout_distance")}


def cut(context, law):
    """Vertical cut of 10 m, c 5 kPa, phi 25 degrees, runs out over its rough base."""
    soil = material("mohr_coulomb", 1998, 1e7, 5e3, 25.0)
    with model_of(context, law, [(0, 0), (10, 0), (10, 10), (0, 10)], soil, 0.5,
                  [(vbgpd.Boundary.FIXED, "base"), (vbgpd.Boundary.ROLLER, "left")]) as model:
        status, _ = job_of(model, 15)
        m = Measured(model, 1998 * GRAVITY * 10, 1)
        kept = model.get("kinetic_energy") / max(model.get("peak_kinetic_energy"), 1e-300)
        m.own = {"q995, m": f"{numpy.quantile(m.x[:, 0], 0.995):.1f}", "KE end / peak": f"{kept:.0e}"}
        m.verdict = verdict_of_soil(status, m)
        m.colour, m.colour_name = m.moved, "displacement, m"
        return m


def slope_model(context, law):
    outline = [(0, 0), (60, 0), (60, 5), (35, 5), (25, 15), (0, 15)]
    return model_of(context, law, outline, material("mohr_coulomb", 2000, 1e7, 8e3, 15.0), 5 / 6,
                    [(vbgpd.Boundary.FIXED, "base"), (vbgpd.Boundary.ROLLER, "left"),
                     (vbgpd.Boundary.ROLLER, "right")])


def slope(context, law):
    """Slope of 10 m at 45 degrees on 5 m of the same soil, c 8 kPa, phi 15 degrees: far too weak, it slides."""
    with slope_model(context, law) as model:
        status, shape = job_of(model, 8)
        m = Measured(model, 2000 * GRAVITY * 10, 1)
        m.own = {"crest settles, m": f"{shape['crest_settlement']:.2f}",
                 "toe moves, m": f"{shape['toe_displacement']:.2f}",
                 "farthest particle moves, m": f"{m.moved.max():.1f}"}
        m.verdict = verdict_of_soil(status, m)
        m.colour, m.colour_name = m.moved, "displacement, m"
        return m


def verdict_of_soil(status, m):
    faults = []
    if status == "DIVERGED":
        faults.append("diverged")
    if m.lost > 0.005 * len(m.x):
        faults.append(f"sheds {m.lost} particles")
    if m.least < 0.5:
        faults.append("clumps")
    if m.noise > 0.05:
        faults.append("noisy stress")
    return ", ".join(faults) or "one mass, smooth"


def cost(context, law):
    """The slope again, its first 400 steps: processor time of one thread."""
    with slope_model(context, law) as model:
        model.step(50)
        started = time.process_time()
        model.step(400)
        seconds = time.process_time() - started
        n = model.get("particles")
        return [law, f"{n:.0f}", f"{400 * n / seconds / 1e6:.2f}", f"{model.get('bytes') / n:.0f}"]


CASES = {"bar": stretched_bar, "compression": compression, "cut": cut, "slope": slope}


def draw(name, results, directory):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    wide = name in ("bar", "slope")
    columns = 2 if wide else 3
    rows = math.ceil(len(results) / columns)
    x = results[0][1].x  # what flies out of the first law's picture is in the table
    low, high = x.min(axis=0), x.max(axis=0)
    room = 0.15 * (high - low).max()
    tall = 9 / columns * (high[1] - low[1] + 2 * room) / (high[0] - low[0] + 2 * room)
    figure, axes = pyplot.subplots(rows, columns, figsize=(9.5, rows * (min(tall, 4) + 0.5)), squeeze=False,
                                   layout="constrained")
    scale = dict(vmin=0, vmax=max(numpy.quantile(results[0][1].colour, 0.98), 1e-9), cmap="viridis")
    for axis in axes.flat:
        axis.set_axis_off()
    for axis, (law, m) in zip(axes.flat, results):
        size = (72 * 9 / columns / (high[0] - low[0] + 2 * room) * m.dx * 0.9) ** 2
        dots = axis.scatter(*m.x.T, c=m.colour, s=min(size, 30), linewidths=0, **scale)
        axis.set_aspect("equal")
        axis.set_xlim(low[0] - room, high[0] + room)
        axis.set_ylim(low[1] - room, high[1] + room)
        axis.set_title(f"{law}\n{m.verdict}", fontsize=8)
    figure.colorbar(dots, ax=axes, label=results[0][1].colour_name, shrink=0.7)
    picture = directory / f"{name}.png"
    figure.savefig(picture, dpi=90)
    pyplot.close(figure)
    from PIL import Image
    Image.open(picture).convert("RGB").quantize(64).save(picture, optimize=True)


def main():
    parse = argparse.ArgumentParser(usage=__doc__)
    parse.add_argument("library")
    parse.add_argument("cases", nargs="*")
    parse.add_argument("--pictures", type=pathlib.Path)
    parse.add_argument("--law", action="append")
    options = parse.parse_intermixed_args()
    for name, case in CASES.items():
        if options.cases and name not in options.cases:
            continue
        print(f"\n**{name}.** {case.__doc__}\n")
        results = []
        for law in options.law or LAWS:
            with vbgpd.Context(library=os.path.abspath(options.library)) as context:
                m = case(context, law)
            if not results:
                titles = ["law", "particles", "least distance / dx", "lost", "noise", "residual", *m.own, "verdict"]
                print("| " + " | ".join(titles) + " |\n|" + "---|" * len(titles))
            results.append((law, m))
            cells = [law, f"{len(m.x)}", f"{m.least:.2f}", f"{m.lost}", f"{m.noise:.3f}", f"{100 * m.residual:.2f} %",
                     *m.own.values(), m.verdict]
            print("| " + " | ".join(cells) + " |", flush=True)
        if options.pictures:
            draw(name, results, options.pictures)
    if not options.cases or "cost" in options.cases:
        print(f"\n**cost.** {cost.__doc__}\n\n| law | particles | M particle-steps / s | bytes / particle |\n" + "|---" * 4 + "|")
        for law in options.law or LAWS:
            with vbgpd.Context(library=os.path.abspath(options.library)) as context:
                print("| " + " | ".join(cost(context, law)) + " |", flush=True)


if __name__ == "__main__":
    main()
