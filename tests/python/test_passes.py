# SPDX-License-Identifier: MIT
"""Pictures in numbers, for scripts."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush


class Passes(unittest.TestCase):
    def setUp(self):
        self.scene = crowdbrush.open("builtin:scenes/theatre.crowd")

    def test_are_arrays(self):
        passes = self.scene.render_passes(
            64, 36, ["template", "colour", "depth", "normal", "position", "id"], camera="Audience", time=1.0)
        self.assertEqual(set(passes), {"colour", "depth", "normal", "position", "id", "template"})
        self.assertEqual(passes["colour"].shape, (36, 64, 4))
        self.assertEqual(passes["normal"].shape, (36, 64, 3))
        self.assertEqual(passes["depth"].shape, (36, 64))
        mattes = self.scene.render_passes(64, 36, ["cryptomatte"], camera="Audience", time=1.0)["cryptomatte"]
        self.assertEqual(mattes.shape, (36, 64, 24))
        shares = mattes[:, :, 1:12:2].sum(axis=2)
        self.assertTrue((shares >= 0).all() and (shares <= 1.0001).all() and (shares > 0.99).any())
        self.assertEqual((passes["depth"].dtype, passes["id"].dtype), (np.float32, np.uint32))

    def test_agree_with_the_scene(self):
        passes = self.scene.render_passes(160, 90, ["id", "template", "position", "depth"], camera="Audience")
        ids = passes["id"]
        self.assertGreater((ids > 0).sum(), 500)
        where = dict(zip(self.scene.ids.tolist(), self.scene.column("position")))
        kinds = dict(zip(self.scene.ids.tolist(), self.scene.column("template")))
        for y, x in np.argwhere(ids > 0)[::50]:
            person = int(ids[y, x])
            self.assertEqual(passes["template"][y, x], kinds[person])
            self.assertLess(np.linalg.norm(passes["position"][y, x] - where[person]), 2.5)
        self.assertTrue((passes["depth"] > 0).all())

    def test_motion_is_against_a_frame_before(self):
        away = crowdbrush.Camera((0, 6, 12), (0, 0, 0))
        still = self.scene.render_passes(64, 36, ["motion"], camera=away, time=0.0)["motion"]
        self.assertEqual((still.shape, still.dtype), ((36, 64, 2), np.float32))
        self.assertLess(np.abs(still).max(), 0.01)
        self.scene.timeline = [crowdbrush.Mark(id=1, seconds=1.0, kind="camera", move="around", travel=4.0)]
        moving = self.scene.render_passes(64, 36, ["motion"], time=3.0)["motion"]
        self.assertGreater(np.abs(moving[:, :, 0]).mean(), 0.2)

    def test_of_a_session(self):
        scene = crowdbrush.Scene()
        man = scene.add_template("builtin:templates/man.glb")
        scene.set_environment({"places": [{"id": 1, "name": "far", "position": [0, 0, 20], "radius": 2}],
                               "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}]})
        scene.create(template=[man.id], position=[(0, 0, 0)], path=[1], walkSpeed=[1.4])
        camera = crowdbrush.Camera((6, 1, 2), (0, 1, 2))
        session = crowdbrush.Session(scene, record=True)
        with self.assertRaises(crowdbrush.Error) as said:
            session.render_passes(64, 36, ["motion"], camera=camera)
        self.assertIn("record=True", str(said.exception))
        session.step(60)
        passes = session.render_passes(64, 36, ["id", "motion"], camera=camera)
        person = passes["id"] == scene.ids[0]
        self.assertGreater(person.sum(), 20)
        # He walks to the left in the picture, so he was at the right of it a step before.
        self.assertGreater(np.median(passes["motion"][person][:, 0]), 0.1)
        clear = session.render(64, 36, camera=camera, transparent=True)
        self.assertEqual((int(clear[0, 0, 3]), int(clear[person][:, 3].max())), (0, 255))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            session.render_passes(32, 18, ["colour", "depth", "id"], camera=camera, path=path)
            self.assertEqual(sorted(os.listdir(folder)), ["a.depth.png", "a.id.png", "a.png"])
            with self.assertRaises(crowdbrush.Error) as said:
                session.render_passes(32, 18, ["cryptomatte"], camera=camera, path=path)
            self.assertIn("OpenEXR", str(said.exception))

    def test_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.exr")
            self.scene.render_passes(32, 18, ["depth", "id"], path=path)
            with open(path, "rb") as file:
                content = file.read()
            self.assertEqual(content[:4], b"\x76\x2f\x31\x01")
            self.assertIn(b"depth.Z", content)
            with self.assertRaises(crowdbrush.Error) as said:
                self.scene.render_passes(32, 18, ["id"], path=os.path.join(folder, "no", "a.exr"))
            self.assertIn("a.exr", str(said.exception))

    def test_refuse_what_is_none(self):
        for wrong in ([], ["smell"], ["depth", ""], ["depth,id,"]):
            with self.assertRaises(crowdbrush.Error) as said:
                self.scene.render_passes(8, 8, wrong)
            self.assertIn("colour, depth", str(said.exception))
        for size in ((0, 8), (8, -1), (20_000, 8)):
            with self.assertRaises(crowdbrush.Error):
                self.scene.render_passes(*size, ["depth"])
