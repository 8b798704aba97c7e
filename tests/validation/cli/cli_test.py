"""The program `vbgpd` as a user meets it. Run with the name of a test class; paths come from the environment."""

import copy
import json
import os
import pty
import re
import signal
import struct
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree
import zlib
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


class Check(ProgramTest):
    def test_a_sound_scene_is_described(self):
        done = self.run_program("check", self.scene_file())
        self.assertEqual(done.stderr, "")
        self.assert_words(done.stdout, "the scene is sound", "a small slope", "mohr_coulomb", "virtual bonds", "wendland_c2",
                          "c 10 kPa", "φ 20°")
        particles = int(re.search(r"particles +([\d ]+)\n", done.stdout)[1].replace(" ", ""))
        self.assertGreater(particles, 220)  # the section has 220 m2 of soil; walls come on top
        used, left_out = re.search(r"uses +(.*)\n +left out +(.*)\n", done.stdout).groups()
        self.assert_words(left_out, "dilatancy", "surface loads", "seismic coefficients", "tension cut-off")
        self.assertNotIn("dilatancy", used)

    def test_memory_and_time_are_foretold(self):
        text = self.run_program("check", self.scene_file()).stdout
        total, per_particle, per_bond = map(float, re.search(
            r"memory +([\d.]+) MB: (\d+) bytes per particle \+ ([\d.]+) per bond\n", text).groups())
        particles, bonds = (int(re.search(kind + r" +([\d ]+)\n", text)[1].replace(" ", "")) for kind in ("particles", "bonds"))
        self.assertAlmostEqual(total * 1e6, per_particle * particles + per_bond * bonds, delta=0.1e6)
        self.assertRegex(text, r"plasticity +[\d.]+ bytes per bond\n")
        self.assertRegex(text, r"expected +factor of safety on this grid about .*an estimate")
        elastic = dict(SLOPE["materials"][0], law="elastic")
        self.assertNotRegex(self.run_program("check", self.scene_file(materials=[elastic])).stdout, r"plasticity +[\d.]+ bytes")

    def test_what_the_scene_uses_is_not_left_out(self):
        material = dict(SLOPE["materials"][0], dilatancy_angle=5, tension_cutoff=2)
        scene = self.scene_file(materials=[material], seismic={"kh": 0.1}, numerics={"bond": "none", "kernel": "cubic_spline"},
                                loads=[{"x0": 2, "x1": 8, "pressure": 20}])
        used = re.search(r"uses +(.*)\n", self.run_program("check", scene).stdout)[1]
        self.assert_words(used, "dilatancy", "tension cut-off", "seismic coefficients", "surface loads")
        self.assertNotIn("virtual bonds", used)

    def test_what_drives_and_holds_the_soil_is_said(self):
        scene = self.scene_file(seismic={"kh": 0.1}, loads=[{"x0": 2, "x1": 8, "pressure": 20, "pressure_end": 30}],
                                boundaries=[{"side": "base", "kind": "fixed", "friction_angle": 24}, {"side": "left", "kind": "roller"}])
        self.assert_words(self.run_program("check", scene).stdout, "load       20 to 30 kPa from x = 2 to 8 m", "seismic    kh 0.1, kv 0",
                          "boundary   base fixed, friction 24 degrees in a run-out", "boundary   left roller")
        self.assert_words(self.run_program("check", self.scene_file()).stdout, "boundary   base fixed, left and right roller")

    def test_warnings_are_said_and_do_not_forbid(self):
        material = dict(SLOPE["materials"][0], friction_angle=0.35)  # radians by mistake
        done = self.run_program("check", self.scene_file(materials=[material]))
        self.assertRegex(done.stderr, r"slope\.json:\d+:\d+: warning: .*friction_angle.*0\.35")
        self.assert_words(done.stdout, "the scene is sound, 1 warning")

    def test_errors_come_before_warnings_one_per_line(self):
        materials = [dict(SLOPE["materials"][0], friction_angle=0.35), dict(SLOPE["materials"][0], name="other", cohesion=-1)]
        lines = self.refused("check", self.scene_file(materials=materials, spacing=-2)).splitlines()
        kinds = [re.match(r".*slope\.json:\d+:\d+: (error|warning): ", line)[1] for line in lines]
        self.assertEqual(kinds, sorted(kinds))
        self.assertGreaterEqual(kinds.count("error"), 2)
        self.assertGreaterEqual(kinds.count("warning"), 1)

    def test_every_scene_of_the_samples_is_sound(self):
        scenes = sorted(SCENES.glob("*.json"))
        self.assertTrue(scenes)
        for scene in scenes:
            with self.subTest(scene.name):
                self.assert_words(self.run_program("check", scene).stdout, "the scene is sound")


class BadScenes(ProgramTest):
    # What a person must be told: the object, the place, the value, what would be right.
    WORDS = {
        "binary": ["not text"],
        "dilatancy_above_friction": ["dilatancy_angle", "friction_angle"],
        "duplicate_material": ["material"],
        "empty": ["empty"],
        "friction_angle_95": ["friction_angle", "95", "90"],
        "layer_outside": ["layer"],
        "load_off_the_ground": ["load", "ground"],
        "misspelt_field": ["did you mean"],
        "negative_young_modulus": ["young_modulus"],
        "poisson_ratio_half": ["poisson_ratio", "0.5"],
        "self_crossing_exterior": ["cross", "("],
        "several_problems": ["young_modulus", "cohesion", "sand", "spacing"],
        "spacing_missing": ["spacing"],
        "units_missing": ["units", "kPa", "SI"],
        "units_unknown": ["units", "kPa", "SI"],
        "unknown_law": ["law", "mohr_coulomb"],
        "unknown_material": ["material"],
    }

    def test_each_is_refused_by_both_commands_and_named(self):
        files = sorted(BAD_SCENES.glob("*.json"))
        self.assertTrue(files)
        for file in files:
            for command in "check", "fos":
                with self.subTest(file.name, command=command):
                    said = self.refused(command, file)
                    for line in said.splitlines():
                        self.assertTrue(line.startswith(str(file)), line)
                    self.assert_words(said, *self.WORDS.get(file.stem, []))

    def test_each_with_expected_words_exists(self):
        self.assertEqual([name for name in self.WORDS if not (BAD_SCENES / (name + ".json")).exists()], [])

    def test_syntax_errors_say_line_and_column(self):
        said = self.refused("check", BAD_SCENES / "trailing_comma.json")
        self.assertRegex(said, r"trailing_comma\.json:\d+:\d+: ")

    def test_faults_of_every_kind_are_told_at_once_in_the_order_of_the_file(self):
        said = self.refused("check", BAD_SCENES / "faults_of_every_kind.json").splitlines()
        told = [re.match(r".*\.json:(\d+):(\d+): error: (.*)", line).groups() for line in said]
        places = [(int(line), int(column)) for line, column, _ in told]
        self.assertEqual(places, sorted(places))
        starts = ["materials[0].unit_weight: expected a number", "materials[1] 'sand': law", "materials[1] 'sand': cohesion = -1 kPa",
                  "materials[1] 'sand': friction_angle = 95", "layers[1] 'sandd': material \"sandd\" is not known",
                  "layers[1] 'sandd': polygon has 2 vertices", "boundaries[0].kind \"fxed\" is not known", "scene: spacing = -0.5 m",
                  "unknown field \"watr\""]
        self.assertEqual([text[:len(start)] for (_, _, text), start in zip(told, starts, strict=True)], starts)

    def test_commands_that_are_none_are_told_with_those_there_are(self):
        self.assert_words(self.refused("fso", SCENES / "gl_1.json"), 'There is no command "fso"', "check, fos or run")

    def test_values_from_the_command_line_have_no_place_in_the_file(self):
        said = self.refused("fos", SCENES / "gl_1.json", "--tolerance", "5")
        self.assertTrue(said.startswith(str(SCENES / "gl_1.json") + ": error: --tolerance: srf_tolerance = 5"), said)

    def test_of_very_many_faults_the_first_hundred_are_told(self):
        text = (SCENES / "gl_1.json").read_text()
        bad = self.folder / "s"
        bad.write_text(text.replace("{", "{" + ", ".join(f'"extra_{i}": {i}' for i in range(150)) + ", ", 1))
        said = self.refused("check", bad).splitlines()
        self.assertEqual(len(said), 101)
        self.assertEqual(said[-1], f"{bad}: and 50 more")

    def test_json_output_of_a_bad_scene_is_one_object_that_lists_the_errors(self):
        done = self.run_program("fos", BAD_SCENES / "several_problems.json", "--json", exit_code=2)
        result = json.loads(done.stdout)
        self.assertEqual(set(result), RESULT_FIELDS)
        self.assertEqual(result["status"], "BAD_INPUT")
        self.assertIsNone(result["factor_of_safety"])
        self.assertGreaterEqual(len(result["errors"]), 4)


class CommandLine(ProgramTest):
    def test_missing_file_is_named(self):
        self.assert_words(self.refused("fos", self.folder / "nowhere.json"), "nowhere.json", "no such file")

    def test_directory_is_not_a_scene(self):
        self.assert_words(self.refused("check", self.folder), str(self.folder), "directory")

    def test_binary_file_is_not_a_scene(self):
        file = self.folder / "program.json"
        file.write_bytes(Path(PROGRAM).read_bytes()[:5000])
        self.assert_words(self.refused("check", file), "program.json", "text")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_unreadable_file_is_named(self):
        scene = self.scene_file()
        scene.chmod(0)
        self.assert_words(self.refused("check", scene), "slope.json", "cannot be read")

    def test_bad_command_lines_end_with_2(self):
        scene = self.scene_file()
        for arguments in ([], ["fly"], ["fos"], ["fos", scene, "--levels", "9"], ["fos", scene, "--levels", "two"],
                          ["fos", scene, "--spacing", "-1"], ["fos", scene, "--scheme", "magic"],
                          ["fos", scene, "--threads", "-1"], ["fos", scene, "--tolerance", "0"], ["fos", scene, "--budget", "0"],
                          ["fos", scene, "--budget", "soon"], ["fos", scene, "--target-error", "0"],
                          ["fos", scene, "another.json"], ["check", scene, "--json"]):
            with self.subTest(arguments):
                self.refused(*arguments)

    def test_options_out_of_range_are_named(self):
        said = self.refused("fos", self.scene_file(), "--tolerance", "0.9")
        self.assertRegex(said, "tolerance")
        self.assertIn("0.9", said)

    def test_pictures_that_cannot_be_written_are_refused_before_the_run(self):
        scene = self.scene_file(spacing=0.05)  # would run for long
        for picture, word in (("slope.gif", ".svg"), ("slope", ".svg"), ("nowhere/slope.svg", "No such file"), (".svg", ".svg")):
            with self.subTest(picture):
                said = self.refused("fos", scene, "--picture", self.folder / picture)
                self.assert_words(said, picture, word)
        (self.folder / "folder.svg").mkdir()
        self.assert_words(self.refused("fos", scene, "--picture", self.folder / "folder.svg"), "directory")

    def test_a_refused_run_leaves_no_picture_behind(self):
        picture = self.folder / "slope.svg"
        self.refused("fos", BAD_SCENES / "several_problems.json", "--picture", picture)
        self.assertFalse(picture.exists())

    def test_help_and_version_end_with_0(self):
        self.assert_words(self.run_program("--help").stdout, "check", "fos", "130")
        self.assert_words(self.run_program("fos", "--help").stdout, "--spacing", "--picture", "--careful")
        self.assertRegex(self.run_program("--version").stdout, r"^vbgpd \d+\.\d+\.\d+\n$")


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


class Run(ProgramTest):
    def test_a_failed_slope_leaves_series_frames_and_ground(self):
        folder = self.folder / "out"
        done = self.run_program("run", self.scene_file(), "--factor", 2, "--time", 1, "--frames", 2, "--output", folder,
                                "--json", "--quiet")
        result = json.loads(done.stdout)
        self.assertGreater(result["crest_settlement"], 0.05)
        self.assertLess(result["energy_residual"], 0.01)
        rows = (folder / "series.csv").read_text(encoding="utf-8").splitlines()
        self.assertTrue(rows[0].startswith("time_s,kinetic_energy"))
        self.assertEqual(len(rows) - 1, len(result["series"]))
        frames = [entry.get("file") for entry in xml.etree.ElementTree.parse(folder / "run.pvd").iter("DataSet")]
        self.assertEqual(len(frames), 3)
        for name in frames:
            points = xml.etree.ElementTree.parse(folder / name).find(".//Points/DataArray").text.split()
            self.assertEqual(len(points), 3 * result["particles"])
            self.assertTrue((folder / name).with_suffix(".png").read_bytes().startswith(b"\x89PNG"))
        self.assertGreater(len(result["ground_surface"]), 10)

    def test_a_shorter_run_leaves_no_frames_of_the_one_before(self):
        folder = self.folder / "out"
        for frames in (4, 2):
            self.run_program("run", self.scene_file(), "--factor", 2, "--time", 0.2, "--frames", frames, "--output", folder,
                             "--quiet")
        self.assertEqual(sorted(path.name for path in folder.glob("frame_*")),
                         [f"frame_000{k}.{kind}" for k in range(3) for kind in ("png", "vtu")])

    def test_a_standing_slope_does_not_move(self):
        done = self.run_program("run", self.scene_file(), "--time", 2, "--json", "--quiet")
        self.assertEqual(json.loads(done.stdout)["moved_area"], 0)


class Pictures(ProgramTest):
    def test_each_kind_is_a_whole_file_of_that_kind(self):
        files = {kind: self.folder / ("slope." + kind) for kind in ("svg", "png", "pdf")}
        arguments = [argument for file in files.values() for argument in ("--picture", file)]
        self.run_program("fos", self.scene_file(), "--levels", "1", "--spacing", "2", *arguments)
        pdf = files["pdf"].read_bytes()
        self.assertTrue(pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF"))
        self.assertTrue(xml.etree.ElementTree.parse(files["svg"]).getroot().tag.endswith("svg"))
        self.check_png(files["png"].read_bytes())

    def check_png(self, png):
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        width, height = struct.unpack(">II", png[16:24])
        self.assertGreater(width, 1000)
        self.assertGreater(height, 500)
        at, data, chunks = 8, b"", []
        while at < len(png):
            length, kind = struct.unpack(">I4s", png[at:at + 8])
            chunks.append(kind)
            data += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
            at += length + 12
        self.assertEqual(chunks[-1], b"IEND")
        pixels = zlib.decompress(data)
        self.assertEqual(len(pixels), height * (width * 3 + 1))  # 8-bit RGB, one filter byte per row
        self.assertGreater(len(set(pixels)), 50)  # not a blank page

    def test_every_kind_of_scene_can_be_drawn(self):
        loads = [{"x0": 2, "x1": 8, "pressure": 20, "pressure_end": 5}]
        boundaries = [{"side": "base", "kind": "fixed"}, {"polyline": [{"x": 0, "y": 10}, {"x": 0, "y": 0}], "kind": "roller"}]
        scene = self.scene_file(loads=loads, boundaries=boundaries, seismic={"kh": 0.05, "kv": -0.02}, name="Böschung <&> 测试")
        self.run_program("fos", scene, "--levels", "1", "--spacing", "2", "--picture", self.folder / "a.svg")
        self.assertGreater((self.folder / "a.svg").stat().st_size, 10000)

    def test_an_existing_picture_is_replaced(self):
        picture = self.folder / "SLOPE.PNG"
        picture.write_bytes(b"old")
        self.run_program("fos", self.scene_file(), "--levels", "1", "--spacing", "2", "--picture", picture)
        self.check_png(picture.read_bytes())


class Terminal(ProgramTest):
    def on_terminal(self, *arguments):
        """What a run shows on stderr when that is a terminal."""
        leader, follower = pty.openpty()
        with subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=follower) as process:
            os.close(follower)
            shown = b""
            while True:
                try:
                    chunk = os.read(leader, 4096)
                except OSError:  # Linux says so when the other end is closed
                    break
                if not chunk:
                    break
                shown += chunk
            process.communicate(timeout=280)
        os.close(leader)
        self.assertEqual(process.returncode, 0, shown)
        return shown.decode()

    def test_progress_is_one_line_rewritten_in_place(self):
        shown = self.on_terminal("fos", self.scene_file(), "--spacing", "0.25")  # a second, even on a fast machine
        self.assertRegex(shown, r"\rgrid \d/2  ")
        self.assertRegex(shown, r"trial \d+  F=\d\.\d{3}.*R=\d\.\de[-+]\d\d  \d+ %")
        self.assertNotIn("\n", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"), repr(shown[-40:]))  # the line is gone at the end

    def test_quiet_shows_nothing(self):
        self.assertEqual(self.on_terminal("fos", self.scene_file(), "--quiet", "--levels", "1"), "")


class Interrupt(ProgramTest):
    def interrupt(self, *arguments):
        scene = self.scene_file(spacing=0.1)  # runs for minutes
        process = subprocess.Popen([PROGRAM, "fos", str(scene), *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.addCleanup(process.kill)
        time.sleep(3)
        self.assertIsNone(process.poll(), "the run ended before it could be interrupted")
        process.send_signal(signal.SIGINT)
        start = time.monotonic()
        out, _ = process.communicate(timeout=60)
        self.assertLess(time.monotonic() - start, 20)
        self.assertEqual(process.returncode, 130)
        return out

    def test_ctrl_c_ends_with_130_and_says_so(self):
        self.assertIn("CANCELLED", self.interrupt())

    def test_ctrl_c_still_gives_one_json_object(self):
        result = json.loads(self.interrupt("--json"))
        self.assertEqual(result["status"], "CANCELLED")
        self.assertEqual(set(result), RESULT_FIELDS)


class Hello(ProgramTest):
    def test_the_c_sample_finds_the_published_value(self):
        done = subprocess.run([HELLO], capture_output=True, text=True, timeout=280)
        self.assertEqual(done.returncode, 0, done.stderr)
        value = float(re.match(r"factor of safety (\d\.\d+), error estimate", done.stdout)[1])
        self.assertGreater(value, 1.33)  # published 1.35 to 1.43
        self.assertLess(value, 1.43)


if __name__ == "__main__":
    unittest.main()
