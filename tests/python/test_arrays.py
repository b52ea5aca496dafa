# SPDX-License-Identifier: Apache-2.0
"""Arrays in and out: used where they are, refused where they are wrong."""
import gc
import unittest
import weakref

import numpy as np

import cdsm
import scenes


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.engine = cdsm.Engine()

    def setUp(self):
        self.scene = scenes.scene()
        self.points = scenes.points()

    def refused(self, message, call, *arguments, **named):
        with self.assertRaises(cdsm.Error) as caught:
            call(*arguments, **named)
        self.assertIn(message, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))

    def transmittance(self, scene):
        self.engine.prepare(scene)
        return self.engine.transmittance("sun", self.points)

    def test_transmittance_is_that_of_the_formula(self):
        values = self.transmittance(self.scene)
        self.assertEqual((values.dtype, values.shape), (np.float32, (64,)))
        np.testing.assert_allclose(values, scenes.expected(self.points), atol=0.02)
        self.assertLess(values[-1], 0.1)

    def test_results_are_written_in_place(self):
        self.engine.prepare(self.scene)
        out = np.full(66, 7, np.float32)
        self.assertIs(self.engine.transmittance("sun", self.points, out=out[1:65]).base, out)
        np.testing.assert_array_equal(out[1:65], self.engine.transmittance("sun", self.points))
        self.assertEqual((out[0], out[65]), (7, 7))
        image = np.empty((24, 36, 4), np.float32)
        self.assertIs(self.engine.render(self.scene, out=image), image)
        np.testing.assert_array_equal(image, self.engine.render(self.scene))
        self.assertGreater(image[12, 18, 3], 0.5)

    def test_wrong_points_are_refused(self):
        self.engine.prepare(self.scene)
        ask = self.engine.transmittance
        self.refused("points are float64, must be float32", ask, "sun", self.points.astype(np.float64))
        self.refused("points are >f4, must be float32", ask, "sun", self.points.astype(">f4"))
        self.refused("points are of shape (64, 2), must be of shape (n, 3)", ask, "sun", self.points[:, :2].copy())
        self.refused("points are of shape (192,), must be of shape (n, 3)", ask, "sun", self.points.ravel())
        self.refused("points are not C-contiguous", ask, "sun", self.points[::2])
        self.refused("points are not C-contiguous", ask, "sun", np.asfortranarray(self.points))
        odd = np.zeros(64 * 12 + 1, np.uint8)[1:].view(np.float32).reshape(64, 3)
        self.refused("points are not C-contiguous and aligned", ask, "sun", odd)
        self.refused("points are of type list, must be a NumPy array", ask, "sun", [[0, 0, 0]])
        self.refused("points are of type NoneType", ask, "sun", None)
        self.points[3, 1] = np.nan
        self.refused("point 3 is not finite", ask, "sun", self.points)
        self.refused("there is no light 'moon'", ask, "moon", scenes.points())
        self.assertEqual(len(ask("sun", np.zeros((0, 3), np.float32))), 0)
        self.assertEqual(ask("sun", scenes.points())[0], 1)

    def test_wrong_results_arrays_are_refused(self):
        self.engine.prepare(self.scene)

        def ask(out):
            return self.engine.transmittance("sun", self.points, out=out)

        self.refused("out is float64, must be float32", ask, np.empty(64))
        self.refused("out is of shape (63,), must be of shape (64,)", ask, np.empty(63, np.float32))
        self.refused("out is not C-contiguous", ask, np.empty(128, np.float32)[::2])
        self.refused("out is memory that is read from", ask, self.points.ravel()[10:74])
        fixed = np.empty(64, np.float32)
        fixed.flags.writeable = False
        self.refused("out is read-only", ask, fixed)
        self.refused("out is of shape (36, 24, 4), must be of shape (24, 36, 4)", self.engine.render, self.scene,
                     np.empty((36, 24, 4), np.float32))

    def test_wrong_voxels_are_refused(self):
        def give(array):
            return cdsm.Volume(voxels=array)

        self.refused("voxels are float64, must be uint8", give, np.zeros((4, 4, 4)))
        self.refused("voxels are >i2, must be uint8", give, np.zeros((4, 4, 4), ">i2"))
        self.refused("voxels are of shape (4, 4), must be of shape (n, n, n)", give, np.zeros((4, 4), np.uint8))
        self.refused("voxels are one value again and again", give, np.broadcast_to(np.float32(1), (4, 4, 4)))
        self.refused("voxels are of type list", give, [[[1.0]]])
        self.refused("voxel", self.engine.prepare, scenes.scene(np.zeros((0, 4, 4), np.float32)))
        volume = scenes.slab(scenes.voxels())
        self.refused("must be uint8", setattr, volume, "voxels", np.zeros((4, 4, 4)))
        self.assertEqual(volume.voxels.dtype, np.float32)

    def test_all_voxel_types_and_strides_give_the_same(self):
        wanted = self.transmittance(self.scene)
        for number in [np.uint8, np.int8, np.uint16, np.int16]:
            data = scenes.voxels().astype(number)
            np.testing.assert_array_equal(self.transmittance(scenes.scene(data)), wanted)
            self.assertEqual(self.engine.stats["copied_bytes"], 0)
        wide = np.zeros((scenes.SIZE, scenes.SIZE, 2 * scenes.SIZE), np.float32)
        wide[:, :, ::2] = 1
        np.testing.assert_array_equal(self.transmittance(scenes.scene(wide[:, :, ::2])), wanted)
        np.testing.assert_array_equal(self.transmittance(scenes.scene(wide[:, :, -2::-2])), wanted)

    def test_the_axes_are_z_y_x(self):
        data = np.zeros((4, 5, 6), np.float32)
        data[1, :, 4] = 1
        scene = scenes.scene(data)
        scene.volumes[0].object_from_index = np.eye(4)
        x, z = np.meshgrid(np.arange(6), np.arange(4))
        below = np.stack([x, np.full_like(x, -3), z], axis=-1).reshape(-1, 3).astype(np.float32)
        self.engine.prepare(scene)
        values = self.engine.transmittance("sun", below).reshape(4, 6)
        self.assertEqual(np.unravel_index(values.argmin(), values.shape), (1, 4))
        self.assertLess(values[1, 4], 0.05)
        self.assertGreater(np.delete(values, 4, axis=1).min(), 0.3)  # beside it the voxels are blurred

    def test_voxels_stay_in_place(self):
        data = scenes.voxels()
        scene = scenes.scene(data)
        self.assertIs(scene.volumes[0].voxels, data)
        dense = self.transmittance(scene)[-1]
        data[:] = 0.25
        scene.volumes[0].revision += 1
        thin = self.transmittance(scene)
        self.assertLess(dense, 0.1)
        np.testing.assert_allclose(thin, scenes.expected(self.points, 0.25), atol=0.02)
        self.assertEqual(self.engine.stats["copied_bytes"], 0)

    def test_meshes_and_spheres_stay_in_place(self):
        for technique in "deep-shadow-map", "shadow-rays":
            scene = scenes.scene(technique=technique)
            vertices = np.zeros(3, [("id", np.uint8), ("position", np.float32, 3)])  # unaligned, at a stride
            vertices["position"] = [[-2, 1.2, -2], [2, 1.2, -2], [0, 1.2, 4]]
            triangles = np.array([[0, 1, 2]], np.uint32)
            leaf = cdsm.Mesh(positions=vertices["position"], triangles=triangles,
                             material=cdsm.Material(opacity=0.5))
            centers = np.array([[0, 2.2, 0], [4, 0, 0]], np.float32)
            balls = cdsm.Spheres(centers=centers[::-1], radii=np.broadcast_to(np.float32(0.6), 2))
            scene.meshes.append(leaf)
            scene.spheres.append(balls)
            self.assertIs(leaf.triangles, triangles)
            wanted = scenes.expected(self.points) * np.where(self.points[:, 1] < 1.2, 0.5, 1)
            self.assertEqual(self.transmittance(scene).max(), 0)
            centers[0, 0] = 3  # out of the way
            balls.revision += 1
            np.testing.assert_allclose(self.transmittance(scene), wanted, atol=0.02)
            vertices["position"][:, 1] = -1.05
            leaf.revision += 1
            wanted = scenes.expected(self.points) * np.where(self.points[:, 1] < -1.05, 0.5, 1)
            np.testing.assert_allclose(self.transmittance(scene), wanted, atol=0.02)

    def test_wrong_arrays_of_meshes_and_spheres_are_refused(self):
        positions = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
        mesh = cdsm.Mesh(positions=positions, triangles=np.array([[0, 1, 2]], np.uint32))
        self.refused("positions are float64, must be float32", setattr, mesh, "positions", np.zeros((3, 3)))
        self.refused("triangles are int64, must be uint32", setattr, mesh, "triangles", np.zeros((1, 3), np.int64))
        self.refused("normals are of shape (3,), must be of shape (n, 3)", setattr, mesh, "normals", positions[0])
        self.refused("positions are rows whose numbers lie apart, must lie side by side; numpy.ascontiguousarray()",
                     setattr, mesh, "positions", np.asfortranarray(positions))
        self.refused("radii are of shape (3, 3), must be of shape (n,)", cdsm.Spheres, radii=positions)
        self.refused("centers are of type list", cdsm.Spheres, centers=[[0, 0, 0]])
        self.assertIs(mesh.positions, positions)
        self.scene.meshes.append(mesh)
        self.engine.prepare(self.scene)
        positions[1, 2] = np.nan
        mesh.revision += 1
        self.refused("position 1 is not finite", self.engine.prepare, self.scene)
        mesh.positions = None
        self.refused("must be below the number of positions, 0", self.engine.prepare, self.scene)

    def test_arrays_live_as_long_as_they_are_needed(self):
        class Watched(np.ndarray):
            pass

        data = scenes.voxels().view(Watched)
        watch = weakref.ref(data)
        scene = scenes.scene(data)
        before = self.transmittance(scene)
        del data, scene
        gc.collect()
        self.assertIsNotNone(watch(), "the engine still has it")
        np.testing.assert_array_equal(self.engine.transmittance("sun", self.points), before)
        self.engine.drop()
        gc.collect()
        self.assertIsNone(watch(), "nobody has it any more")

    def test_light_maps_outlive_the_engine(self):
        engine = cdsm.Engine()
        maps = engine.light_maps(self.scene, "sun")
        nodes, first = maps[0].nodes, maps[0].first_node
        del engine, maps
        gc.collect()
        self.assertEqual(first.shape, (64 * 64 + 1,))
        self.assertEqual(nodes.shape, (first[-1], 2))
        last = nodes[first[32 * 64 + 32 + 1] - 1]
        self.assertAlmostEqual(float(last[1]), float(np.exp(-2 * scenes.DENSITY)), delta=0.01)


if __name__ == "__main__":
    unittest.main()
