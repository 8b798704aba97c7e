"""The command line, the terminal, an interrupt, and the example program. Run with the name of a test class."""

import json
import os
import pty
import re
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import BAD_SCENES, HELLO, PROGRAM, ProgramTest, RESULT_FIELDS


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
