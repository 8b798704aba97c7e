#!/usr/bin/env python3
"""Work-precision diagrams of the CSV of vbgpd_accuracy: error against CPU time, one line per scheme, observed order written in.

Usage: diagrams.py FILE.csv PICTURE.png|.svg|.pdf      (needs python3-matplotlib; one picture per group, its name put in)
       diagrams.py FILE.csv --table                    (error, order and time as markdown tables; standard library only)
       diagrams.py FILE.csv --threads                  (what a second thread changes, as a markdown table)
"""
import collections
import csv
import math
import pathlib
import sys

# Every case belongs to one picture; `patch` is round-off at every spacing and has no diagram.
GROUPS = {
    "elastic": ["column_stress", "column_settlement", "column_period", "wave_compression", "wave_shear", "plate_period",
                "cavity_stress", "disk_stress"],
    "limit": ["vertical_cut", "vertical_cut_two_grids", "prandtl", "prandtl_two_grids", "strip_on_slope",
              "strip_on_slope_two_grids", "slope_45", "slope_45_two_grids", "cavity_limit", "cavity_limit_two_grids",
              "uniaxial", "biaxial_mohr_coulomb", "biaxial_drucker_prager", "shear_band", "rankine_active",
              "rankine_passive", "infinite_slope"],
    "runout": ["sliding_block", "disk_turn", "simple_shear", "column_half", "column_1", "column_2", "column_4", "bars"],
}
COLOURS = {"virtual_bond": "tab:blue", "none": "tab:red", "sph": "tab:gray", "sph_artificial_stress": "tab:olive",
           "pseudo_spring": "tab:green", "gpd": "tab:purple"}


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def read(path):
    """{case: {(bond, kernel): [(spacing, error, cpu seconds)]}}, coarse to fine; one thread; rows without an answer left out."""
    cases = collections.OrderedDict()
    for row in rows_of(path):
        if row["threads"] != "1":
            continue
        error = float(row["error"])
        points = cases.setdefault(row["case"], collections.OrderedDict()).setdefault((row["bond"], row["kernel"]), [])
        if math.isfinite(error) and error > 0:
            points.append((float(row["spacing"]), error, max(float(row["cpu_s"]), 1e-4)))
    return cases


def order(points):
    """Slope of log error over log spacing, least squares; nan with fewer than two points."""
    if len(points) < 2:
        return math.nan
    x = [math.log(p[0]) for p in points]
    y = [math.log(p[1]) for p in points]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def table(cases):
    """One table for every set of schemes that cases have been run with."""
    kinds = collections.OrderedDict()
    for case, lines in cases.items():
        kinds.setdefault(tuple(lines), []).append(case)
    for schemes, names in kinds.items():
        print("| case | " + " | ".join(", ".join(s) for s in schemes) + " |")
        print("|---" * (len(schemes) + 1) + "|")
        for case in names:
            cells = []
            for s in schemes:
                points = cases[case][s]
                cells.append(f"{points[-1][1]:.2g} ({order(points):.1f}, {points[-1][2]:.2g})" if points else "-")
            print(f"| {case} | " + " | ".join(cells) + " |")
        print()


def threads(rows):
    """The finest spacing of every case and scheme: wall and CPU seconds, and whether error and hash agree on all spacings."""
    runs = collections.OrderedDict()
    for row in rows:
        scheme = runs.setdefault((row["case"], row["bond"], row["kernel"]), collections.OrderedDict())
        scheme.setdefault(row["spacing"], {})[row["threads"]] = row
    counts = sorted({row["threads"] for row in rows}, key=int)
    print("| case | bond | kernel | particles | same error and hash | " +
          " | ".join(f"wall s ({n})" for n in counts) + " | " + " | ".join(f"CPU s ({n})" for n in counts) + " |")
    print("|---" * (5 + 2 * len(counts)) + "|")
    for (case, bond, kernel), ladder in runs.items():
        agree = all(len({(row["error"], row["hash"]) for row in rung.values()}) == 1 for rung in ladder.values())
        finest = list(ladder.values())[-1]
        cells = [finest[n][column] for column in ("wall_s", "cpu_s") for n in counts]
        print(f"| {case} | {bond} | {kernel} | {finest[counts[0]]['particles']} | {'yes' if agree else 'NO'} | " +
              " | ".join(f"{float(cell):.2g}" for cell in cells) + " |")


def draw_group(cases, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    columns = 4
    rows = math.ceil(len(cases) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.6 * columns, 3.1 * rows + 0.5), squeeze=False)
    shown = collections.OrderedDict()
    for axis, (case, lines) in zip(axes.flat, cases.items()):
        for (bond, kernel), points in lines.items():
            if not points:
                continue
            style = "-" if kernel == "wendland_c2" else "--"
            line, = axis.loglog([p[2] for p in points], [p[1] for p in points], style, color=COLOURS.get(bond, "black"),
                                marker="o" if style == "-" else "s", markersize=3.5, linewidth=1.2,
                                label=f"{order(points):.1f}")
            shown.setdefault(f"{bond}, {kernel}" if len({k for _, k in lines}) > 1 else bond, line)
        axis.set_title(case, fontsize=10)
        axis.tick_params(labelsize=8, which="both")
        axis.grid(True, which="major", linewidth=0.4)
        axis.legend(title="order", title_fontsize=7, fontsize=7, handlelength=1.8, labelspacing=0.2, framealpha=0.7)
    for row in axes:
        row[0].set_ylabel("error", fontsize=9)
    for axis in list(axes.flat)[:len(cases)][-columns:]:
        axis.set_xlabel("CPU seconds", fontsize=9)
    for axis in list(axes.flat)[len(cases):]:
        axis.axis("off")
    figure.legend(shown.values(), shown.keys(), loc="upper center", ncol=6, fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.3 / (3.1 * rows + 0.5)))
    figure.savefig(path, dpi=90)


def draw(cases, path):
    path = pathlib.Path(path)
    for group, names in GROUPS.items():
        chosen = collections.OrderedDict((n, cases[n]) for n in names if n in cases)
        if chosen:
            draw_group(chosen, path.with_name(f"{path.stem}_{group}{path.suffix}"))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if sys.argv[2] == "--threads":
        threads(rows_of(sys.argv[1]))
    elif sys.argv[2] == "--table":
        table(read(sys.argv[1]))
    else:
        draw(read(sys.argv[1]), sys.argv[2])


if __name__ == "__main__":
    main()
