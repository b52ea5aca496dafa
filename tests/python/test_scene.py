# SPDX-License-Identifier: Apache-2.0
"""Scenes as Python objects: what one writes is what the engine gets, and what the stubs say."""
import ast
import pathlib
import unittest

import numpy as np

import cdsm
import scenes


def names_of(body):
    """Public names of a module's or a class's body in the stubs, with the bodies of classes."""
    names = {}
    for node in body:
        if isinstance(node, ast.AnnAssign):
            names[node.target.id] = []
        elif isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            names[node.name] = node.body if isinstance(node, ast.ClassDef) else []
    return {name: inner for name, inner in names.items() if not name.startswith("_")}


def public(names):
    return {name for name in names if not name.startswith("_")}


class Scenes(unittest.TestCase):
    def test_values_are_kept(self):
        for kind in [cdsm.Camera, cdsm.ImageSettings, cdsm.ShadowSettings, cdsm.Light, cdsm.Material]:
            default = kind()
            values = {name: getattr(default, name) for name in public(dir(kind))}
            changed = {name: self.other(value) for name, value in values.items()}
            made = kind(**changed)
            self.assertEqual({name: getattr(made, name) for name in changed}, changed)
            for name, value in values.items():
                setattr(made, name, value)
            self.assertEqual({name: getattr(made, name) for name in values}, values)

    def other(self, value):
        if isinstance(value, bool):
            return not value
        if isinstance(value, str):
            return "omni" if value == "spot" else value + "x"
        return tuple(2 * v or 1 for v in value) if isinstance(value, tuple) else 2 * value or 1

    def test_objects_are_shared_with_the_scene(self):
        scene = scenes.scene()
        scene.camera.position = np.array([1, 2, 3], np.float32)
        scene.lights[0].name = "moon"
        self.assertEqual((scene.camera.position, scene.lights[0].name), ((1, 2, 3), "moon"))
        engine = cdsm.Engine()
        engine.prepare(scene)
        self.assertEqual(engine.transmittance("moon", scenes.points())[0], 1)
        matrix = np.arange(16).reshape(4, 4)
        scene.volumes[0].world_from_object = matrix
        np.testing.assert_array_equal(scene.volumes[0].world_from_object, matrix)
        with self.assertRaises(ValueError):
            scene.volumes[0].world_from_object[0, 3] = 1  # a copy, so it must not seem to work
        glass = cdsm.Material(opacity=0.5)
        mesh = cdsm.Mesh(material=glass)
        self.assertIs(mesh.material, glass)

    def test_a_moved_object_uploads_no_voxel(self):
        scene = scenes.scene()
        engine = cdsm.Engine()
        engine.prepare(scene)
        first = engine.transmittance("sun", scenes.points())
        matrix = np.eye(4)
        matrix[0, 3] = 5
        scene.volumes[0].world_from_object = matrix
        engine.prepare(scene)
        stats = engine.stats
        self.assertEqual(stats["copied_bytes"], 0)
        self.assertLess(stats["uploaded_bytes"], scene.volumes[0].voxels.nbytes / 4)
        self.assertEqual(engine.transmittance("sun", scenes.points())[-1], 1)
        self.assertLess(first[-1], 0.1)

    def test_materials_and_boundaries_go_by_reference(self):
        cube = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)], np.float32)
        sides = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                 [0, 6, 4], [1, 5, 7], [1, 7, 3]]
        mesh = cdsm.Mesh(name="cut", positions=cube, triangles=np.array(sides, np.uint32), casts=False,
                         material=cdsm.Material(opacity=0))
        scene = scenes.scene()
        scene.volumes[0].boundary = mesh
        engine = cdsm.Engine()
        with self.assertRaisesRegex(cdsm.Error, "boundary 'cut' is not in the scene"):
            engine.prepare(scene)
        scene.meshes = (mesh,)
        engine.prepare(scene)
        last = engine.transmittance("sun", scenes.points())[-1]
        self.assertAlmostEqual(float(last), float(np.exp(-scenes.DENSITY)), delta=0.02)

    def test_spheres(self):
        ball = cdsm.Spheres(name="balls", centers=np.zeros((1, 3), np.float32), radii=np.full(1, 0.5, np.float32),
                            material=cdsm.Material(opacity=0.5))
        scene = scenes.scene()
        scene.volumes, scene.spheres = [], [ball]
        engine = cdsm.Engine()
        engine.prepare(scene)
        values = engine.transmittance("sun", np.array([[0, 1, 0], [0, 0, 0], [0, -1, 0]], np.float32))
        np.testing.assert_allclose(values, [1, 0.5, 0.25], atol=0.01)

    def test_ambient_occlusion(self):
        centers = np.array([[0, 0, 0], [0, 1, 0], [1, 0.5, 0]], np.float32)
        scene = scenes.scene()
        scene.volumes = []
        scene.spheres = [cdsm.Spheres(name="balls", centers=centers, radii=np.full(3, 0.5, np.float32))]
        engine = cdsm.Engine()
        plain = engine.render(scene)
        scene.ambient_occlusion = cdsm.AmbientOcclusion(directions=8, resolution=16)
        darker = engine.render(scene)
        self.assertTrue(engine.stats["ambient_occlusion"]["filled"])
        self.assertTrue(np.all(darker <= plain) and np.any(darker < plain))
        with self.assertRaisesRegex(cdsm.Error, "ambient_occlusion needs"):
            cdsm.validate(cdsm.Scene(ambient_occlusion=cdsm.AmbientOcclusion()))

    def test_wrong_values_say_what_would_be_right(self):
        wrong = [(lambda: cdsm.Camera(fow=3), "Camera has no 'fow'; known: fov, position"),
                 (lambda: cdsm.Camera(fov="wide"), "Camera.fov is 'wide', must be a number"),
                 (lambda: cdsm.Camera(position=(1, 2)), r"Camera.position is \(1, 2\), must be three numbers"),
                 (lambda: cdsm.Camera(up=5), "must be three numbers"),
                 (lambda: cdsm.ImageSettings(width=3.5), "ImageSettings.width is 3.5, must be an integer"),
                 (lambda: cdsm.Mesh(material="red"), "Mesh.material is 'red', must be a cdsm.Material"),
                 (lambda: cdsm.Volume(revision=-1), "must be an integer of at least 0"),
                 (lambda: cdsm.Volume(world_from_object=np.eye(3)), "must be a matrix of 4 x 4"),
                 (lambda: cdsm.TransferFunction(opacity=["x"]), "no rows of numbers"),
                 (lambda: cdsm.Scene(lights=5), "Scene.lights must be a list"),
                 (lambda: cdsm.validate(cdsm.Scene(lights=[cdsm.Mesh()])),
                  r"Scene.lights\[0\] is .*, must be a cdsm.Light"),
                 (lambda: cdsm.validate(cdsm.Scene(meshes=[None])), r"Scene.meshes\[0\] is None")]
        for make, message in wrong:
            with self.assertRaisesRegex(TypeError, message):
                make()
        with self.assertRaisesRegex(cdsm.Error, "Light.type is 'lamp', must be 'spot'"):
            cdsm.Light(type="lamp")
        with self.assertRaisesRegex(cdsm.Error, r"color is of shape \(1, 2\), must be of shape \(n, 4\)"):
            cdsm.TransferFunction(color=[(0, 1)])

    def test_the_stubs_name_everything(self):
        stubs = pathlib.Path(cdsm.__file__).with_name("cdsm.pyi")
        declared = names_of(ast.parse(stubs.read_text()).body)
        self.assertEqual(set(declared), public(dir(cdsm)))
        for name, body in declared.items():
            if body and not issubclass(getattr(cdsm, name), Exception):
                self.assertEqual(set(names_of(body)), public(dir(getattr(cdsm, name))), name)

    def test_everything_is_described(self):
        for name in public(dir(cdsm)):
            self.assertTrue(getattr(cdsm, name).__doc__ or name.endswith("Error"), name)


if __name__ == "__main__":
    unittest.main()
