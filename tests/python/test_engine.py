# SPDX-License-Identifier: Apache-2.0
"""The engine among Python's threads, signals, exceptions and garbage."""
import gc
import signal
import sys
import threading
import time
import unittest
import weakref

import numpy as np

import cdsm
import scenes


class Engine(unittest.TestCase):
    def setUp(self):
        self.scene = scenes.scene()
        self.points = scenes.points()

    def usable(self, engine):
        engine.prepare(self.scene)
        np.testing.assert_allclose(engine.transmittance("sun", self.points), scenes.expected(self.points), atol=0.02)

    def test_errors_leave_it_usable(self):
        engine = cdsm.Engine()
        with self.assertRaisesRegex(cdsm.Error, "prepare"):
            engine.transmittance("sun", self.points)
        bad = scenes.scene()
        bad.camera.fov = 200
        for call in [engine.render, engine.prepare, cdsm.validate]:
            with self.assertRaisesRegex(RuntimeError, "fov"):
                call(bad)
        with self.assertRaisesRegex(cdsm.Error, "there is no view 'x'"):
            engine.view(self.scene, "x")
        self.usable(engine)
        with self.assertRaises(cdsm.Error):
            cdsm.Engine(device="no such device")
        self.assertTrue(issubclass(cdsm.DeviceError, cdsm.Error) and issubclass(cdsm.Error, RuntimeError))

    def test_coloured_light_has_three_values(self):
        self.scene.shadows.transmittance = "rgb"
        self.scene.volumes[0].transfer.transmission = [(0, 1.0, 0.5, 0.0)]
        engine = cdsm.Engine()
        engine.prepare(self.scene)
        red, green, blue = engine.transmittance("sun", self.points).T
        np.testing.assert_allclose(red, 1.0, atol=0.002)
        np.testing.assert_allclose(green, np.sqrt(scenes.expected(self.points)), atol=0.02)
        np.testing.assert_allclose(blue, scenes.expected(self.points), atol=0.02)
        with self.assertRaisesRegex(cdsm.Error, "out is of shape"):
            engine.transmittance("sun", self.points, out=np.empty(len(self.points), np.float32))
        maps = engine.light_maps(self.scene, "sun")
        self.assertEqual(maps[0].colors.shape, (len(maps[0].nodes), 3))
        np.testing.assert_allclose(maps[0].colors.mean(axis=1), maps[0].nodes[:, 1], atol=1e-6)
        self.scene.shadows.transmittance = "grey"
        self.usable(engine)

    def test_exceptions_of_callbacks_end_the_call(self):
        def failing(step, done):
            if step == wanted:
                raise ValueError(step)

        engine = cdsm.Engine(progress=failing)
        for wanted in ["upload", "shadows", "render"]:
            self.scene.volumes[0].revision += 1
            with self.assertRaisesRegex(ValueError, wanted):
                engine.render(self.scene)
        wanted = ""
        self.usable(engine)

    def test_it_refuses_to_be_used_in_its_own_callback(self):
        engine = cdsm.Engine(progress=lambda step, done: engine.stats)
        with self.assertRaisesRegex(cdsm.Error, "its own callback"):
            engine.render(self.scene)

    def test_ctrl_c_between_steps(self):
        size = 192
        big = scenes.scene(np.ones((size, size, 2 * size), np.float32)[:, :, ::2])  # takes a while to be copied
        engine = cdsm.Engine()
        before = signal.signal(signal.SIGALRM, signal.default_int_handler)
        try:
            with self.assertRaises(KeyboardInterrupt):
                signal.setitimer(signal.ITIMER_REAL, 0.001)
                engine.prepare(big)
        finally:
            signal.signal(signal.SIGALRM, before)
        with self.assertRaisesRegex(cdsm.Error, "no scene is ready"):  # it ended before the maps were made
            engine.transmittance("sun", self.points)
        self.usable(engine)

    def test_other_threads_run_while_it_works(self):
        self.scene.shadows = cdsm.ShadowSettings(technique="shadow-rays")
        self.scene.image = cdsm.ImageSettings(width=360, height=240)
        steps, counts, count = [], [], 0
        engine = cdsm.Engine(progress=lambda step, done: (steps.append((step, done)), counts.append(count)))
        engine.render(self.scene)  # compiles
        done = threading.Event()

        def work():
            nonlocal count
            while not done.is_set():
                count += 1
                time.sleep(0)  # gives others their turn

        worker = threading.Thread(target=work)
        counts.clear()
        interval = sys.getswitchinterval()
        sys.setswitchinterval(10)  # seconds: nobody is given a turn by a thread that keeps the lock
        worker.start()
        try:
            engine.render(self.scene)
        finally:
            done.set()
            worker.join()
            sys.setswitchinterval(interval)
        self.assertEqual(steps[-2:], [("render", 0), ("render", 1)])
        self.assertGreater(counts[-1] - counts[-2], 10)  # from one step to the next

    def test_threads_take_turns(self):
        engine = cdsm.Engine()
        engine.prepare(self.scene)
        wanted = engine.transmittance("sun", self.points)
        image = engine.render(self.scene)
        failed = []

        def ask():
            for _ in range(10):
                if not np.array_equal(engine.transmittance("sun", self.points), wanted):
                    failed.append("transmittance")
                if not np.array_equal(engine.render(self.scene), image):
                    failed.append("render")

        threads = [threading.Thread(target=ask) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])

    def test_engines_of_many_threads(self):
        errors = []

        def ask(value):
            try:
                engine = cdsm.Engine()
                engine.prepare(scenes.scene(scenes.voxels(value)))
                values = engine.transmittance("sun", self.points)
                np.testing.assert_allclose(values, scenes.expected(self.points, value), atol=0.02)
            except Exception as error:  # of a thread, else only printed
                errors.append(error)

        threads = [threading.Thread(target=ask, args=(value,)) for value in [0.25, 0.5, 1.0]]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])

    def test_garbage_with_callbacks_is_collected(self):
        class Viewer:
            def __init__(self):
                self.engine = cdsm.Engine(progress=self.tell)

            def tell(self, step, done):
                pass

        viewer = Viewer()
        viewer.engine.prepare(self.scene)
        watch = weakref.ref(viewer)
        del viewer
        gc.collect()
        self.assertIsNone(watch())

    def test_stats_and_warnings(self):
        told = []
        engine = cdsm.Engine(warning=told.append)
        engine.prepare(self.scene)
        stats = engine.stats
        self.assertEqual(stats["lights"][0]["name"], "sun")
        self.assertEqual(stats["lights"][0]["maps"][0]["texels"], 64 * 64)
        self.assertGreater(stats["time_ms"]["total"], 0)
        self.assertEqual(stats["memory"]["strategy"], "exact")
        self.assertEqual(told, stats["warnings"])
        self.assertIn(engine.device["id"], [device["id"] for device in cdsm.list_devices()])

    def test_views(self):
        engine = cdsm.Engine()
        for view in ["clusters", "nodes", "layers", "steps", "texels"]:
            image = engine.view(self.scene, view)
            self.assertEqual((image.shape, engine.stats["view"]["name"]), ((24, 36, 4), view))
        self.assertGreater(engine.view(self.scene, "nodes", light="sun").max(), 0)


if __name__ == "__main__":
    unittest.main()
