# SPDX-License-Identifier: MIT
"""Scenes and templates from and to files, by script."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_saves_and_opens_the_same_bytes(self):
        scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        self.assertGreater(len(scene), 500)
        self.assertEqual(scene.path, "")
        scene.save(self.path("a.crowd"))
        self.assertFalse(scene.modified)
        again = crowdbrush.open(self.path("a.crowd"))
        again.save(self.path("b.crowd"))
        with open(self.path("a.crowd"), "rb") as a, open(self.path("b.crowd"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_saving_needs_a_place(self):
        with self.assertRaisesRegex(crowdbrush.Error, "no file yet"):
            crowdbrush.Scene().save()

    def test_what_cannot_be_read_says_why(self):
        with open(self.path("broken.crowd"), "w") as file:
            file.write("{")
        for name, part in [("missing.crowd", "missing.crowd"), ("broken.crowd", "broken.crowd")]:
            with self.assertRaisesRegex(crowdbrush.Error, part):
                crowdbrush.open(self.path(name))
        scene = crowdbrush.Scene()
        with open(self.path("dancer.fbx"), "w") as file:
            file.write("Kaydara FBX Binary")
        with self.assertRaisesRegex(crowdbrush.Error, "glTF"):
            scene.add_template(self.path("dancer.fbx"))
        self.assertEqual(scene.templates, [])

    def test_bytes_that_are_no_text_are_said_as_text(self):
        for content in (b'{"\xff', b'{"format": "m\xff\xfe"}', b"\xff\xfe\x00"):
            with open(self.path("odd.crowd"), "wb") as file:
                file.write(content)
            with self.assertRaisesRegex(crowdbrush.Error, "odd.crowd.*not valid JSON at line 1"):
                crowdbrush.open(self.path("odd.crowd"))
        with open(self.path("odd.gltf"), "wb") as file:
            file.write(b'{"asset": {"version": "2.0\xff"}}')
        with self.assertRaisesRegex(crowdbrush.Error, "odd.gltf"):
            crowdbrush.Scene().add_template(self.path("odd.gltf"))
        odd = os.path.join(os.fsencode(self.folder.name), b"m\xff.crowd")
        with self.assertRaisesRegex(crowdbrush.Error, "m\ufffd.crowd"):
            crowdbrush.open(os.fsdecode(odd))

    def test_what_is_missing_is_said_and_not_drawn(self):
        scene = crowdbrush.Scene()
        man = scene.add_template("builtin:templates/man.glb", name="Somebody")
        scene.create(count=2, template=man, position=(0, 0, 0))
        scene.save(self.path("a.crowd"))
        with open(self.path("a.crowd"), encoding="utf-8") as file:
            text = file.read()
        with open(self.path("a.crowd"), "w", encoding="utf-8") as file:
            file.write(text.replace("man.glb", "nobody.glb"))
        with self.assertWarnsRegex(UserWarning, "Somebody.*nobody.glb"):
            scene = crowdbrush.open(self.path("a.crowd"))
        camera = crowdbrush.Camera((0, 2, 5), (0, 1, 0))
        with self.assertRaisesRegex(crowdbrush.Error, "Somebody.*of whom there are 2"):
            scene.render(16, 9, camera=camera)
        picture = scene.render(16, 9, camera=camera, allow_missing=True)
        self.assertEqual(picture.shape, (9, 16, 4))

    def test_non_ascii_names(self):
        scene = crowdbrush.Scene()
        scene.add_template("builtin:templates/man.glb", name="Mädchen 男")
        scene.save(self.path("naïve 群衆.crowd"))
        again = crowdbrush.open(self.path("naïve 群衆.crowd"))
        self.assertEqual(again.template("Mädchen 男").id, 1)


class Templates(unittest.TestCase):
    def setUp(self):
        self.scene = crowdbrush.Scene()
        self.man = self.scene.add_template("builtin:templates/man.glb")

    def test_what_it_is_made_of(self):
        self.assertIn("skin", self.man.slots)
        self.assertIn("walk", [clip.name for clip in self.man.clips])
        self.assertGreater(self.man.levels[0], self.man.levels[1])
        self.assertTrue(1.5 < self.man.height_m < 2.0)

    def test_keyframes(self):
        walk = next(clip for clip in self.man.clips if clip.name == "walk")
        first = self.man.keyframe_vertices("walk", 0)
        self.assertEqual(first.dtype, np.float32)
        self.assertEqual(first.shape[1], 3)
        self.assertLess(self.man.triangles.max(), len(first))
        middle = self.man.keyframe_vertices("walk", walk.keyframes // 2)
        self.assertGreater(np.abs(middle - first).max(), 0.1)
        normals = self.man.keyframe_normals("walk", 0)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-4)

    def test_bad_clips_and_keyframes(self):
        for clip, k in [("swim", 0), ("walk", -1), ("walk", 10_000), (99, 0)]:
            with self.assertRaises(crowdbrush.Error):
                self.man.keyframe_vertices(clip, k)


if __name__ == "__main__":
    unittest.main()
