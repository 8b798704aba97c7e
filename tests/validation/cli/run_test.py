"""`vbgpd run`: time series, frames and pictures. Run with the name of a test class."""

import json
import struct
import unittest
import xml.etree.ElementTree
import zlib

from program import ProgramTest, SLOPE


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


if __name__ == "__main__":
    unittest.main()
