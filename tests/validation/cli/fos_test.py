"""`vbgpd fos`: what it prints and writes of a factor of safety. Run with the name of a test class."""

import json
import time
import unittest

from program import LEVEL_FIELDS, ProgramTest, RESULT_FIELDS, SLOPE, TRIAL_FIELDS


class FactorOfSafety(ProgramTest):
    def result(self, *arguments, **changes):
        done = self.run_program("fos", self.scene_file(**changes), "--json", *arguments)
        self.assertEqual(done.stderr, "")
        return json.loads(done.stdout)

    def test_json_has_every_field_and_agrees_with_itself(self):
        r = self.result()
        self.assertEqual(set(r), RESULT_FIELDS)
        self.assertEqual(r["status"], "OK")
        self.assertEqual(r["errors"], [])
        self.assertEqual(len(r["levels"]), 2)
        for level in r["levels"]:
            self.assertLessEqual(LEVEL_FIELDS, set(level))
            self.assertLess(level["srf_stable"], level["srf_unstable"])
        coarse, fine = r["levels"]
        self.assertAlmostEqual(coarse["spacing"] / fine["spacing"], 2, delta=0.2)
        self.assertAlmostEqual(fine["spacing"], 1.0, delta=0.1)
        self.assertGreater(fine["particles"], coarse["particles"])
        for trial in r["trials"]:
            self.assertEqual(set(trial), TRIAL_FIELDS)
            self.assertIn(trial["verdict"], ("stable", "failed", "undecided"))
        self.assertIn("stable", {trial["verdict"] for trial in r["trials"]})
        self.assertIn("failed", {trial["verdict"] for trial in r["trials"]})
        self.assertRegex(r["hash"], "^[0-9a-f]{16}$")
        self.assertRegex(r["version"], r"^\d+\.\d+\.\d+$")

    def test_value_and_slip_surface_are_those_of_the_published_slope(self):
        r = self.result()
        self.assertGreater(r["factor_of_safety"], 1.30)  # published 1.35 to 1.43; the grid here is coarse
        self.assertLess(r["factor_of_safety"], 1.48)
        slip = r["slip_surface"]
        xs = [x for x, _ in slip]
        self.assertEqual(xs, sorted(xs))
        self.assertAlmostEqual(slip[0][1], 10, delta=1.5)  # enters behind the crest
        self.assertLess(slip[-1][1], 2.5)  # leaves at the toe
        self.assertTrue(0 < r["sliding_area"] < 220)

    def test_text_gives_the_same_value(self):
        scene = self.scene_file()
        r = json.loads(self.run_program("fos", scene, "--json").stdout)
        done = self.run_program("fos", scene)
        self.assertEqual(done.stderr, "")
        self.assertIn("FS = %.3f" % r["factor_of_safety"], done.stdout)
        self.assert_words(done.stdout, "slip surface", "sliding area", "grid 1", "grid 2", "status         OK")

    def test_one_level_is_the_middle_of_its_bracket(self):
        r = self.result("--levels", "1", "--spacing", "2")
        self.assertEqual(len(r["levels"]), 1)
        self.assertAlmostEqual(r["factor_of_safety"], (r["srf_stable"] + r["srf_unstable"]) / 2, places=9)
        self.assertLessEqual(r["srf_unstable"] - r["srf_stable"], 0.02 * 1.001)

    def test_tolerance_narrows_the_bracket(self):
        r = self.result("--levels", "1", "--spacing", "2", "--tolerance", "0.002")
        self.assertLessEqual(r["srf_unstable"] - r["srf_stable"], 0.002 * 1.001)

    def test_threads_do_not_change_a_bit(self):
        one, two = (self.result("--levels", "1", "--threads", n) for n in ("1", "2"))
        self.assertEqual(one["hash"], two["hash"])
        self.assertEqual(one["factor_of_safety"], two["factor_of_safety"])

    def test_scheme_is_that_asked_for(self):
        self.assertEqual(self.result("--levels", "1", "--spacing", "2", "--scheme", "none")["levels"][0]["bonds"], 0)
        self.assertGreater(self.result("--levels", "1", "--spacing", "2")["levels"][0]["bonds"], 0)

    def test_a_value_outside_the_range_ends_with_3_and_says_so(self):
        scene = self.scene_file(strength_reduction={"srf_min": 0.5, "srf_max": 1.1, "tolerance": 0.02})
        done = self.run_program("fos", scene, "--levels", "1", "--spacing", "2", "--json", exit_code=3)
        r = json.loads(done.stdout)
        self.assertEqual(r["status"], "ABOVE_MAX")
        self.assertIsNone(r["factor_of_safety"])
        self.assertIn("1.1", r["reason"])

    def test_warnings_of_the_scene_are_in_the_result(self):
        material = dict(SLOPE["materials"][0], unit_weight=20000)  # N/m3 in a kPa scene
        done = self.run_program("check", self.scene_file(materials=[material]))
        self.assertIn("warning", done.stderr)
        material = dict(SLOPE["materials"][0], friction_angle=0.35, cohesion=60)
        done = self.run_program("fos", self.scene_file(materials=[material]), "--levels", "1", "--spacing", "2", "--json")
        self.assertEqual(len(json.loads(done.stdout)["warnings"]), 1)


class ErrorAgainstTime(ProgramTest):
    def result(self, *arguments, exit_code=0, **changes):
        return json.loads(self.run_program("fos", self.scene_file(**changes), "--json", *arguments, exit_code=exit_code).stdout)

    def test_a_target_is_met_on_finer_grids(self):
        r = self.result("--target-error", "0.05")
        self.assertEqual(r["status"], "OK")
        self.assertLessEqual(r["error_estimate"], 0.05)
        self.assertLess(r["levels"][-1]["spacing"], 0.9)
        self.assertLessEqual(LEVEL_FIELDS, set(r["levels"][-1]))
        self.assertLess(r["next_level"]["spacing"], r["levels"][-1]["spacing"])
        self.assertGreater(r["next_level"]["wall_seconds"], 0)

    def test_a_target_out_of_reach_ends_with_3_and_the_best_value(self):
        r = self.result("--target-error", "0.001", "--levels", "2", exit_code=3)
        self.assertEqual(r["status"], "TARGET_NOT_MET")
        self.assertEqual(len(r["levels"]), 2)
        self.assertIsNotNone(r["factor_of_safety"])
        self.assertIn("0.001", r["reason"])

    def test_a_budget_is_kept(self):
        start = time.monotonic()
        r = self.result("--budget", "4")
        self.assertLess(time.monotonic() - start, 15)
        self.assertGreaterEqual(len(r["levels"]), 2)
        self.assertIn("budget", r["reason"])

    def test_more_levels_check_the_order(self):
        r = self.result("--levels", "4")
        self.assertEqual(len(r["levels"]), 4)
        self.assertEqual(r["levels"][-1]["estimate"], r["factor_of_safety"])

    def test_a_budget_too_small_for_anything_ends_with_3(self):
        r = self.result("--budget", "0.001", spacing=0.3, exit_code=3)
        self.assertEqual(r["status"], "NOT_CONVERGED")
        self.assertIsNone(r["factor_of_safety"])


if __name__ == "__main__":
    unittest.main()
