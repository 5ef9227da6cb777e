# SPDX-License-Identifier: MIT
"""Lights that stand in a scene, for scripts."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Light


class Lights(unittest.TestCase):
    def setUp(self):
        self.scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        self.scene.lights = []
        self.scene.set_lighting(crowdbrush.Lighting.ready("night"))

    def spot(self, **given):
        return Light(id=1, name="Left", kind="spot", position=(0, 12, 6), target=(0, 1, -8), strength=3.0, **given)

    def picture(self):
        return np.asarray(self.scene.render(160, 90, camera="Audience", look="lit")).astype(int)

    def test_are_entries_of_the_scene(self):
        self.assertEqual(self.scene.lights, [])
        self.scene.lights = [self.spot(cone=0.8, softness=0.5), Light(id=2, kind="point", color="#ff8040")]
        self.assertEqual(len(self.scene.lights), 2)
        self.assertAlmostEqual(self.scene.lights["Left"].cone, 0.8, places=6)
        self.assertEqual((self.scene.lights[1].color, self.scene.lights[1].on), ("#ff8040", True))
        self.scene.undo()
        self.assertEqual(self.scene.lights, [])

    def test_are_in_files_and_pictures(self):
        dark = self.picture()
        self.scene.lights = [self.spot(cone=1.2)]
        lit = self.picture()
        self.assertGreater(lit.sum(), dark.sum() * 1.1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lit.crowd")
            self.scene.save(path)
            again = crowdbrush.open(path)
            self.assertEqual(again.lights, self.scene.lights)

    def test_ready_made_ones_go_on_after_dark(self):
        for name in ("theatre", "city", "stadium", "meadow"):
            scene = crowdbrush.open(f"builtin:scenes/{name}.crowd")
            camera = next(iter(scene.cameras))
            picture = lambda: np.asarray(scene.render(160, 90, camera=camera, look="lit")).astype(int)
            lamps = scene.lights
            self.assertTrue(lamps and all(each.after_dark for each in lamps), name)
            shown = []
            for hours in (12, 23):
                scene.set_lighting(crowdbrush.Lighting.of_day(hours))
                scene.lights = lamps
                with_them = picture()
                scene.lights = []
                shown.append(int((with_them - picture()).sum()))
            self.assertEqual(shown[0], 0, name)  # by day
            self.assertGreater(shown[1], 20_000, name)

    def test_refuses_what_cannot_be(self):
        for wrong in ({"cone": 0.0}, {"cone": 3.2}, {"strength": -1}, {"strength": float("nan")}, {"strength": 1e30},
                      {"kind": "laser"}, {"position": (0, float("inf"), 0)}, {"color": "red"}):
            with self.assertRaises(crowdbrush.Error, msg=str(wrong)):
                self.scene.lights = [Light(id=1, **wrong)]
        self.assertEqual(self.scene.lights, [])


if __name__ == "__main__":
    unittest.main()
