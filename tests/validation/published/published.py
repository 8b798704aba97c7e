#!/usr/bin/env python3
"""Factors of safety of the published scenes against their published values.

Usage: published.py VBGPD SCENES_DIR [--refine N] [--threads N] [--only NAME ...] [--check] [--markdown FILE] [--json FILE]

--refine N   spacing of the scene file divided by N (1 = H/20, 2 = H/40)
--check      exit 1 unless every scene lies within 5 % of its published span and the median distance is at most 1 %
Standard library only.
"""
import argparse
import datetime
import json
import pathlib
import platform
import statistics
import subprocess
import sys

# Closed-form or converged values; the other scenes are compared with the span of what was published.
EXACT = {"vertical_cut", "prandtl_strip", "prandtl_60", "slope_45", "slope_60"}
# Values that the sources themselves call wrong, and circles where the mechanism is not one, by words in their method.
DISOWNED = ("FALSE", "wrong mechanism", "circular")


def span(scene):
    values = []
    for entry in scene.get("published", []):
        if any(word in entry["method"] for word in DISOWNED) and "noncircular" not in entry["method"]:
            continue
        values.append(entry["factor_of_safety"])
        if entry.get("factor_of_safety_end") is not None:
            values.append(entry["factor_of_safety_end"])
    return (min(values), max(values)) if values else (None, None)


def distance(value, low, high):
    """Relative distance outside the span; 0 inside."""
    if value < low:
        return value / low - 1
    return value / high - 1 if value > high else 0.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes")
    parser.add_argument("--refine", type=float, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--markdown")
    parser.add_argument("--json")
    options = parser.parse_args()

    rows = []
    for path in sorted(pathlib.Path(options.scenes).glob("*.json")):
        if options.only and path.stem not in options.only:
            continue
        scene = json.loads(path.read_text(encoding="utf-8"))
        spacing = scene["spacing"] / options.refine
        run = subprocess.run([options.program, "fos", str(path), "--json", "--quiet", "--spacing", repr(spacing),
                              "--threads", str(options.threads)], capture_output=True, text=True)
        if run.returncode not in (0, 3):
            print(f"{path.stem}: exit {run.returncode}: {run.stderr.strip()}", file=sys.stderr)
            rows.append({"scene": path.stem, "failed": run.stderr.strip()})
            continue
        result = json.loads(run.stdout)
        low, high = span(scene)
        value = result["factor_of_safety"]
        level = result["levels"][-1] if result["levels"] else {}
        row = {
            "scene": path.stem, "low": low, "high": high, "factor_of_safety": value, "status": result["status"],
            "error_estimate": result["error_estimate"],
            "outside": None if value is None or low is None else distance(value, low, high),
            "grids": [l["factor_of_safety"] for l in result["levels"]],
            "particles": level.get("particles"), "steps": sum(l["steps"] for l in result["levels"]),
            "cpu_seconds": sum(l["cpu_seconds"] for l in result["levels"]),
            "wall_seconds": sum(l["wall_seconds"] for l in result["levels"]),
            "displacement_level": result["displacement_level"], "reason": result["reason"],
        }
        rows.append(row)
        shown = "-" if value is None else f"{value:.3f} {margin(row['error_estimate'], '+- ')}"
        print(f"{path.stem:18s} {shown:18s} published {low} .. {high}  outside "
              f"{'-' if row['outside'] is None else format(100 * row['outside'], '+.1f') + ' %'}  {row['status']}  "
              f"{row['particles']} particles  {row['cpu_seconds']:.1f} CPU-s", flush=True)

    judged = [abs(r["outside"]) for r in rows if r.get("outside") is not None]
    failed = [r["scene"] for r in rows if r.get("outside") is None]
    median, worst = (statistics.median(judged), max(judged)) if judged else (None, None)
    if judged:
        print(f"{len(judged)} scenes judged, {len(failed)} without a value {failed}; outside the published span: "
              f"median {100 * median:.2f} %, worst {100 * worst:.1f} %")
    if options.markdown:
        pathlib.Path(options.markdown).write_text(markdown(rows, options), encoding="utf-8")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1), encoding="utf-8")
    if options.check and (failed or median > 0.01 or worst > 0.05):
        print("not within the promise (median <= 1 %, worst <= 5 %, none without a value)", file=sys.stderr)
        return 1
    return 0



def margin(error, sign):
    """A grid that does not see a layer has no estimate."""
    return "no estimate" if error is None else f"{sign}{error:.3f}"


def markdown(rows, options):
    lines = ["| scene | published | VB-GPD | estimate | grids | outside | particles | steps | CPU s | wall s |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        if r.get("factor_of_safety") is None:
            lines.append(f"| {r['scene']} | {r.get('low')} to {r.get('high')} | {r.get('status', 'refused')} | | | | | | | |")
            continue
        grids = ", ".join("-" if g is None else f"{g:.3f}" for g in r["grids"])
        lines.append(f"| {r['scene']} | {r['low']:.3g} to {r['high']:.4g} | {r['factor_of_safety']:.3f} | {margin(r['error_estimate'], '±')} | {grids} | "
                     f"{100 * r['outside']:+.1f} % | {r['particles']} | {r['steps']} | {r['cpu_seconds']:.1f} | {r['wall_seconds']:.1f} |")
    lines.append("")
    lines.append(f"{datetime.date.today()}, {platform.machine()}, spacing of the scene files divided by {options.refine:g}, "
                 f"{options.threads} thread(s).")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.exit(main())
