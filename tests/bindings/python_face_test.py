"""The thin face of Python where it does more than call: slices, Ctrl-C, numpy, failures, lives of objects.

Usage: python_face_test.py LIBRARY.
"""
import gc
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy

import vbgpd

LIBRARY = os.path.abspath(sys.argv.pop())
OUTLINE = [(0, 0), (40, 0), (40, 5), (25, 5), (15, 15), (0, 15)]


def make_profile(context, spacing=1.25, outline=OUTLINE):
    profile = vbgpd.Profile(context)
    profile.set_exterior(outline)
    soil = profile.add_material("soil", law="mohr_coulomb", unit_weight=20e3, cohesion=12e3, friction_angle=20)
    profile.add_layer(soil)
    profile.set("spacing", spacing)
    return profile


class PythonFace(unittest.TestCase):
    def setUp(self):
        self.context = vbgpd.Context(library=LIBRARY)

    def test_ctrl_c_stops_a_run_that_can_be_continued(self):
        model = vbgpd.Model(self.context, make_profile(self.context, 0.25))
        job = vbgpd.Job.strength_reduction(model, levels=1)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            job.run()
        self.assertEqual(job.run(seconds=0.01), vbgpd.Status.LIMIT_REACHED)

    def test_a_true_answer_of_the_callback_stops_the_run(self):
        model = vbgpd.Model(self.context, make_profile(self.context, 0.25))
        job = vbgpd.Job.strength_reduction(model)
        heard = []
        status = job.run(lambda progress: heard.append(progress.steps) or len(heard) == 3, slice_seconds=0.02)
        self.assertEqual((status, len(heard)), (vbgpd.Status.CANCELLED, 3))
        self.assertEqual(heard, sorted(heard))

    def test_slices_do_not_change_the_answer(self):
        jobs = []
        for slice_seconds in (0.01, 1000):
            model = vbgpd.Model(self.context, make_profile(self.context))
            jobs.append((vbgpd.Job.strength_reduction(model, levels=1, srf_tolerance=0.1), model))
            self.assertEqual(jobs[-1][0].run(slice_seconds=slice_seconds), vbgpd.Status.OK)
        self.assertEqual(jobs[0][0].get("factor_of_safety"), jobs[1][0].get("factor_of_safety"))
        self.assertEqual(jobs[0][1].state_hash, jobs[1][1].state_hash)

    def test_an_error_carries_the_object_and_the_value(self):
        profile = make_profile(self.context)
        profile.set("friction_angle", 120, vbgpd.Kind.MATERIAL, 0)
        with self.assertRaises(vbgpd.Error) as caught:
            vbgpd.Model(self.context, profile)
        error = caught.exception
        self.assertEqual((error.object_kind, error.object_id, error.value), (vbgpd.Kind.MATERIAL, 0, 120.0))
        self.assertIn("friction_angle", str(error))
        self.assertEqual([issue.text for issue in profile.validate()], [str(error)])

    def test_a_closed_object_says_so(self):
        profile = make_profile(self.context)
        profile.close()
        profile.close()
        with self.assertRaises(vbgpd.Error) as caught:
            profile.count(vbgpd.Kind.LAYER)
        self.assertEqual(caught.exception.status, vbgpd.Status.E_HANDLE)

    def test_a_job_outlives_its_parents_in_any_order_of_collection(self):
        context = vbgpd.Context(library=LIBRARY)
        job = vbgpd.Job.equilibrium(vbgpd.Model(context, make_profile(context, 2.5)))
        del context
        gc.collect()
        self.assertEqual(job.run(), vbgpd.Status.OK)
        self.assertGreater(job.get("max_displacement"), 0)

    def test_points_of_every_layout_are_the_same_polygon(self):
        rows = numpy.array(OUTLINE, dtype=float)
        wide = numpy.zeros((12, 5))
        wide[::2, 1:3] = rows
        layouts = [OUTLINE, rows, numpy.asfortranarray(rows), wide[::2, 1:3], rows[::-1][::-1], rows.astype(">f8"),
                   rows.astype(int), rows[:, ::-1].copy()[:, ::-1]]
        for layout in layouts:
            profile = make_profile(self.context, outline=layout)
            self.assertEqual(profile.polygon().tolist(), rows.tolist())
        with self.assertRaises(ValueError):
            profile.set_exterior(rows.T)

    def test_fields_fill_views_of_larger_arrays_and_nothing_else(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        n = model.item_count(vbgpd.Location.PARTICLE)
        positions = model.field("position")
        for order in "CF":
            larger = numpy.full((n, 4), -1.0, order=order)
            model.field("position", larger[:, 1:3])
            self.assertTrue((larger[:, 1:3] == positions).all() and (larger[:, [0, 3]] == -1).all())
        numbers = model.field("particle_id", numpy.empty(n))
        self.assertEqual(numbers.tolist(), model.field("particle_id").tolist())
        for wrong in (numpy.empty((n, 3)), numpy.empty((n, 2), numpy.float32), numpy.empty((n - 1, 2)),
                      numpy.broadcast_to(0.0, (n, 2)), numpy.empty((n, 2), ">f8")):
            with self.assertRaises(ValueError):
                model.field("position", wrong)

    def test_views_keep_their_lease_until_the_last_array_is_gone(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        model.step(3)
        with model.view("displacement") as view, model.view("particle_id") as ids:
            by_id = numpy.empty((model.item_count(vbgpd.Location.PARTICLE), 2))
            soil = ids.array >= 0
            by_id[ids.array[soil]] = view.array[soil]
            self.assertTrue((by_id == model.field("displacement")).all())
            kept = view.array[:, 1]
            with self.assertRaises(ValueError):
                kept[0] = 1
        with self.assertRaises(ValueError):
            view.array
        for call in (lambda: model.step(1), model.close):
            with self.assertRaises(vbgpd.Error) as caught:
                call()
            self.assertEqual(caught.exception.status, vbgpd.Status.E_LEASED)
        del kept
        model.step(1)
        model.close()

    def test_ctrl_c_stops_an_advance_that_can_be_continued(self):
        model = vbgpd.Model(self.context, make_profile(self.context, 0.25))
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            model.advance_to(1e6)
        reached = model.get("time")
        self.assertEqual(model.advance_to(reached + 0.01)[0], vbgpd.Status.OK)
        self.assertEqual(model.get("time"), reached + 0.01)

    def test_values_of_every_layout_are_written_alike(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        n = model.item_count(vbgpd.Location.PARTICLE)
        forces = numpy.random.default_rng(1).normal(size=(n, 2))
        wide = numpy.zeros((n, 5))
        wide[:, 1:3] = forces
        for layout in (forces, numpy.asfortranarray(forces), wide[:, 1:3], forces[::-1].copy()[::-1], forces.tolist()):
            model.write("external_force", numpy.zeros((n, 2)))
            model.write("external_force", layout)
            self.assertTrue((model.field("external_force") == forces).all())
        with self.assertRaises(vbgpd.Error):
            model.write("external_force", forces[:-1])

    def test_values_of_other_components_are_refused(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        n = model.item_count(vbgpd.Location.PARTICLE)
        for name, shape in (("velocity", (n,)), ("external_force", (n, 1)), ("pore_pressure", (n, 5))):
            with self.assertRaisesRegex(ValueError, "components"):
                model.write(name, numpy.zeros(shape))
        model.write("pore_pressure", numpy.ones((n, 1)))
        self.assertTrue((model.field("pore_pressure") == 1).all())

    def test_a_view_dropped_inside_a_call_ends_before_the_next_one(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        kept = [model.view("velocity").array]

        def sample():
            while True:
                try:
                    return model.sample_grid("stress", 0, 0, 0.08, 0.03, 500, 500)
                except vbgpd.Error:  # the main thread was just asking for the time
                    pass

        worker = threading.Thread(target=sample)
        worker.start()
        while worker.is_alive() and kept:
            try:
                model.get("time")
            except vbgpd.Error as busy:  # the other thread is in its call now
                self.assertEqual(busy.status, vbgpd.Status.E_BUSY)
                kept.clear()
        worker.join()
        self.assertFalse(kept)
        self.assertEqual(model.step(1)[0], vbgpd.Status.OK)

    def test_a_job_holds_its_model(self):
        job = vbgpd.Job.equilibrium(vbgpd.Model(self.context, make_profile(self.context)))
        gc.collect()
        self.assertEqual(job.run(), vbgpd.Status.OK)
        self.assertGreater(job.get("particles"), 0)

    def test_names_that_do_not_exist_are_errors(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        for call in (lambda: model.field("presure"), lambda: model.get("presure"), lambda: vbgpd.field("x", LIBRARY)):
            with self.assertRaises(vbgpd.Error) as caught:
                call()
            self.assertEqual(caught.exception.status, vbgpd.Status.E_UNKNOWN_NAME)
        with self.assertRaisesRegex(vbgpd.Error, "position, .*; did you mean \"pore_pressure\""):
            model.field("pore_presure")

    def test_ids_are_one_row_of_whole_numbers(self):
        model = vbgpd.Model(self.context, make_profile(self.context))
        n = model.item_count(vbgpd.Location.PARTICLE)
        mask = model.field("position")[:, 0] < 10
        with self.assertRaisesRegex(TypeError, "flatnonzero"):
            vbgpd.Selection(ids=mask)
        for wrong, fault in (([0.5, 1.5], TypeError), (numpy.zeros((2, 2), int), ValueError), (3, ValueError),
                             (numpy.array([2**64 - 1], numpy.uint64), OverflowError), (["1"], TypeError)):
            with self.assertRaises(fault):
                vbgpd.Selection(ids=wrong)
        for ids in (numpy.flatnonzero(mask), numpy.arange(n, dtype=numpy.uint8)[::-3], [4, 2], []):
            self.assertEqual(model.select(vbgpd.Selection(ids=ids)).tolist(), list(ids))

    def test_integers_that_do_not_fit_are_refused_and_do_not_wrap(self):
        profile = make_profile(self.context)
        profile.add_load(2, 6, 10e3)
        model = vbgpd.Model(self.context, profile)
        for call in (lambda: vbgpd.Context(library=LIBRARY, threads=2**40), lambda: model.step(2**64),
                     lambda: vbgpd.Context(library=LIBRARY, max_bytes=2**63), lambda: model.set_load(2**64, 7.0, 7.0),
                     lambda: model.boundary_reaction(-2**64), lambda: vbgpd.Selection(layer=2**64),
                     lambda: profile.get("cohesion", vbgpd.Kind.MATERIAL, 2**64), lambda: profile.count(2**32 + 3),
                     lambda: profile.add_layer(2**64)):
            with self.assertRaisesRegex(OverflowError, "must be between"):
                call()
        self.assertEqual((model.get("steps"), profile.count(vbgpd.Kind.LAYER)), (0, 1))
        with self.assertRaisesRegex(TypeError, "argument 2 of vbgpd_model_step must be a whole number, not 1.5"):
            model.step(1.5)
        self.assertEqual(model.step(numpy.int64(2))[1].steps, 2)

    def test_numbers_go_back_to_absent_by_none(self):
        profile = make_profile(self.context)
        profile.set("tension_cutoff", 5e3, vbgpd.Kind.MATERIAL)
        profile.set("tension_cutoff", None, vbgpd.Kind.MATERIAL)
        self.assertTrue(numpy.isnan(profile.get("tension_cutoff", vbgpd.Kind.MATERIAL)))

    def test_bytes_that_are_no_flatbuffer_are_refused(self):
        with self.assertRaises(vbgpd.Error) as caught:
            vbgpd.Profile.from_flatbuffer(self.context, b"not a scene")
        self.assertEqual(caught.exception.status, vbgpd.Status.E_FORMAT)

    def test_the_log_is_read_line_by_line(self):
        self.assertEqual(self.context.log(), [])
        model = vbgpd.Model(self.context, make_profile(self.context))
        with vbgpd.Job.equilibrium(model) as job:
            job.run()
        lines = self.context.log()
        self.assertEqual([line.sequence for line in lines], list(range(1, len(lines) + 1)))
        self.assertIn("Model of", lines[0].text)
        self.assertIn("The job ended", lines[-1].text)
        self.assertEqual(self.context.log(after=lines[0].sequence), lines[1:])

    def test_a_limit_of_bytes_names_what_would_be_needed(self):
        with vbgpd.Context(library=LIBRARY, max_bytes=100000) as small:
            with self.assertRaises(vbgpd.Error) as caught:
                vbgpd.Model(small, make_profile(small))
        self.assertEqual(caught.exception.status, vbgpd.Status.E_LIMIT)
        self.assertGreater(caught.exception.value, 100000)
        self.assertIn("would fit", str(caught.exception))

    def test_build_info_is_a_dict_of_texts(self):
        facts = vbgpd.build_info(library=LIBRARY)
        self.assertEqual(facts["version"], vbgpd.version(LIBRARY))
        self.assertEqual(facts["compiler"], vbgpd.build_info("compiler", LIBRARY))
        self.assertRaises(vbgpd.Error, vbgpd.build_info, "weather", LIBRARY)

    def test_the_library_is_found_beside_the_package(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "vbgpd")
            shutil.copytree(os.path.dirname(vbgpd.__file__), copy, ignore=shutil.ignore_patterns("__pycache__"))
            shutil.copy(LIBRARY, os.path.join(copy, "libvbgpd.so.1"))
            told = subprocess.run([sys.executable, "-B", "-c", "import vbgpd; print(vbgpd.Context().handle.value != 0)"],
                                  env={"PYTHONPATH": folder}, capture_output=True, text=True)
        self.assertEqual((told.stdout, told.stderr), ("True\n", ""))

    def test_a_library_that_is_missing_is_named(self):
        with self.assertRaisesRegex(ImportError, "nowhere/libvbgpd.so.1"):
            vbgpd.Context(library="/nowhere/libvbgpd.so.1")

    def test_a_context_that_cannot_be_made_says_why(self):
        with self.assertRaisesRegex(vbgpd.Error, "threads is -1; .* max_bytes is -5; ") as told:
            vbgpd.Context(library=LIBRARY, threads=-1, max_bytes=-5)
        self.assertEqual((told.exception.status, told.exception.value), (vbgpd.Status.E_RANGE, -1))

    def test_everything_public_has_a_docstring(self):
        for name in vbgpd.__all__:
            thing = getattr(vbgpd, name)
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type) and issubclass(thing, vbgpd._Object):
                for member, value in vars(thing).items():
                    self.assertTrue(member.startswith("_") or value.__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
