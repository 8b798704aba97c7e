#!/usr/bin/env python3
"""The factor of safety of a slope given by four corners, in Python. Usage: hello_slope.py [libvbgpd.so.1]"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings" / "python"))
import vbgpd  # noqa: E402

library = sys.argv[1] if len(sys.argv) > 1 else None  # otherwise the system's
with vbgpd.Context(library=library) as context, vbgpd.Profile(context) as slope:
    # Griffiths and Lane (1999), example 1: 10 m high, 2 to 1, c = 10 kPa, phi = 20 degrees; their answer is 1.4.
    slope.set_exterior([(0, 0), (32, 0), (12, 10), (0, 10)])
    clay = slope.add_material("clay", unit_weight=20e3, young_modulus=1e8, poisson_ratio=0.3, cohesion=10e3,
                              friction_angle=20)  # SI units
    slope.add_layer(clay)  # fills the section; base fixed, rollers at the sides
    slope.set("spacing", 0.5)
    # A call that fails raises vbgpd.Error; that of a model says all that is wrong with the slope.
    with vbgpd.Model(context, slope) as model, vbgpd.Job.strength_reduction(model) as job:
        status = job.run()  # Ctrl-C stops it
        print(f"factor of safety {job.get('factor_of_safety'):.3f}, error estimate {job.get('error_estimate'):.3f} "
              f"({vbgpd.status_name(status, library)})")
sys.exit(0 if status == vbgpd.Status.OK else 1)
