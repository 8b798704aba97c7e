#!/usr/bin/env python3
"""Slopes of soil without tension, against limit equilibrium with a dry tension crack.

Usage: tension.py VBGPD. Prints the table of README.md beside it. The values to compare with are of our own search
(Spencer, circles, each with its best crack): no published ones were at hand.
"""
import json
import math
import subprocess
import sys
import tempfile

# degrees, height, foundation, kPa, degrees, kN/m3, limit equilibrium with crack (None = not searched)
SLOPES = [(26.6, 10, 6, 8, 20, 19, 1.284), (45, 10, 6, 15, 20, 19, 1.087), (55, 8, 5, 22, 18, 19, 1.223),
          (60, 6, 3.6, 18, 25, 19, 1.374), (70, 6, 3.6, 25, 25, 19, 1.425), (80, 5, 3, 25, 30, 19, None)]


def scene(angle, height, depth, cohesion, friction, weight):
    crest, run = 1.8 * height, height / math.tan(math.radians(angle))
    points = [(0, 0), (crest + run + 1.8 * height, 0), (crest + run + 1.8 * height, depth), (crest + run, depth),
              (crest, depth + height), (0, depth + height)]
    return {"name": f"{angle:g} degrees, no tension", "units": "kPa",
            "profile": {"exterior": [{"x": x, "y": y} for x, y in points]},
            "materials": [{"name": "soil", "law": "mohr_coulomb", "unit_weight": weight, "cohesion": cohesion,
                           "friction_angle": friction, "tension_cutoff": 0}],
            "layers": [{"material": "soil"}], "spacing": height / 20}


def main(program):
    print("| face | height, m | c, kPa | phi | limit equilibrium with crack | VB-GPD | status | CPU s |")
    print("|" + "---|" * 8)
    for angle, height, depth, cohesion, friction, weight, known in SLOPES:
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(scene(angle, height, depth, cohesion, friction, weight), file)
            file.flush()
            run = subprocess.run([program, "fos", file.name, "--json", "--quiet"], capture_output=True, text=True)
        result = json.loads(run.stdout)
        value, error = result["factor_of_safety"], result["error_estimate"]
        print(f"| {angle:g} degrees | {height} | {cohesion} | {friction} | {'' if known is None else f'{known:.3f}'} | "
              f"{'' if value is None else f'{value:.3f} ±{error:.3f}'} | {result['status']} | "
              f"{result['cpu_seconds']:.0f} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
