"""Scene files: what `vbgpd check` says of good ones and of bad ones. Run with the name of a test class."""

import json
import re
import unittest

from program import BAD_SCENES, ProgramTest, RESULT_FIELDS, SCENES, SLOPE


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


if __name__ == "__main__":
    unittest.main()
