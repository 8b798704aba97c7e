#!/usr/bin/env python3
"""Work-precision diagrams of the CSV of vbgpd_accuracy: error against CPU time, one line per scheme, observed order written in.

Usage: diagrams.py FILE.csv PICTURE.png|.svg|.pdf      (needs python3-matplotlib)
       diagrams.py FILE.csv --table                    (observed orders as a markdown table; standard library only)
"""
import collections
import csv
import math
import sys


def read(path):
    """{case: {scheme: [(spacing, error, cpu seconds)]}}, coarse to fine, rows without an answer left out."""
    cases = collections.OrderedDict()
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            error = float(row["error"])
            schemes = cases.setdefault(row["case"], collections.OrderedDict())
            points = schemes.setdefault(f"{row['bond']}, {row['kernel']}", [])
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
    schemes = list(next(iter(cases.values())))
    print("| case | " + " | ".join(f"{s}: error at the finest spacing (order, CPU s)" for s in schemes) + " |")
    print("|---" * (len(schemes) + 1) + "|")
    for case, lines in cases.items():
        cells = []
        for s in schemes:
            points = lines.get(s, [])
            cells.append(f"{points[-1][1]:.2g} ({order(points):.1f}, {points[-1][2]:.2g})" if points else "-")
        print(f"| {case} | " + " | ".join(cells) + " |")


def draw(cases, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    columns = 3
    rows = math.ceil(len(cases) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4.6 * columns, 3.6 * rows), squeeze=False)
    for axis, (case, lines) in zip(axes.flat, cases.items()):
        for scheme, points in lines.items():
            if points:
                axis.loglog([p[2] for p in points], [p[1] for p in points], marker="o", markersize=4,
                            label=f"{scheme} (order {order(points):.1f})")
        axis.set_title(case)
        axis.set_xlabel("CPU seconds")
        axis.set_ylabel("error")
        axis.grid(True, which="both", linewidth=0.3)
        axis.legend(fontsize=7)
    for axis in list(axes.flat)[len(cases):]:
        axis.axis("off")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    cases = read(sys.argv[1])
    if sys.argv[2] == "--table":
        table(cases)
    else:
        draw(cases, sys.argv[2])


if __name__ == "__main__":
    main()
