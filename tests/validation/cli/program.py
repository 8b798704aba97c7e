"""What the tests of the program `vbgpd` share: where it is, a small slope, how it is run. Paths come from the environment."""

import copy
import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ["VBGPD_PROGRAM"]
HELLO = os.environ["VBGPD_HELLO"]
SCENES = Path(os.environ["VBGPD_SCENES"])
BAD_SCENES = Path(os.environ["VBGPD_BAD_SCENES"])

# Griffiths & Lane (1999), example 1; published factors of safety lie between 1.35 and 1.43.
SLOPE = {
    "name": "a small slope",
    "units": "kPa",
    "profile": {"exterior": [{"x": 0, "y": 0}, {"x": 32, "y": 0}, {"x": 12, "y": 10}, {"x": 0, "y": 10}]},
    "materials": [{"name": "sandy clay", "law": "mohr_coulomb", "unit_weight": 20, "young_modulus": 100000,
                   "poisson_ratio": 0.3, "cohesion": 10, "friction_angle": 20}],
    "layers": [{"material": "sandy clay"}],
    "spacing": 1.0,
    "strength_reduction": {"tolerance": 0.02},
}

RESULT_FIELDS = {
    "factor_of_safety", "srf_stable", "srf_unstable", "status", "reason", "error_estimate", "scheme", "reduced", "flow_rule",
    "displacement_level", "levels", "trials", "slip_surface", "sliding_area", "energy_residual", "hash", "version",
    "warnings", "errors", "wall_seconds", "cpu_seconds", "observed_order", "next_level"}
LEVEL_FIELDS = {"spacing", "particles", "bonds", "srf_stable", "srf_unstable", "factor_of_safety", "steps", "wall_seconds",
                "cpu_seconds", "estimate", "error_estimate", "sliding_area"}
TRIAL_FIELDS = {"level", "strength_reduction_factor", "verdict", "band_connected", "unbalanced_force_ratio",
                "unbalanced_force_slope", "displacement_level", "displacement_growth", "power_ratio", "steps",
                "wall_seconds"}


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def scene_file(self, name="slope.json", **changes):
        """A file with the small slope, its top-level fields replaced by `changes`."""
        scene = copy.deepcopy(SLOPE)
        scene.update(changes)
        path = self.folder / name
        path.write_text(json.dumps(scene), encoding="utf-8")
        return path

    def run_program(self, *arguments, exit_code=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, encoding="utf-8",
                              timeout=280, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, exit_code, done.stdout + done.stderr)
        return done

    def refused(self, *arguments):
        """stderr of a run that must end with 2 before anything is computed."""
        start = time.monotonic()
        done = self.run_program(*arguments, exit_code=2)
        self.assertLess(time.monotonic() - start, 20)
        self.assertEqual(done.stdout, "")
        self.assertNotEqual(done.stderr, "")
        return done.stderr

    def assert_words(self, text, *words):
        for word in words:
            self.assertIn(word, text)
