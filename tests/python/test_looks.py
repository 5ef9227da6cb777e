# SPDX-License-Identifier: MIT
"""Looks that belong to a scene, for scripts."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Look, LookLight


class Looks(unittest.TestCase):
    def setUp(self):
        self.scene = crowdbrush.open("builtin:scenes/theatre.crowd")

    def picture(self, **how):
        return np.asarray(self.scene.render(160, 90, **how)).astype(int)

    def same(self, one, other):
        return bool(np.array_equal(one, other))

    def test_are_entries_of_the_scene(self):
        self.assertEqual(self.scene.looks, [])
        self.scene.looks = [Look(id=9, name="Late", light="dusk", lamps=False),
                            Look(id=2, name="Ink", style="cartoon", own_outline=True, outline="#ff8040")]
        self.assertEqual([each.name for each in self.scene.looks], ["Late", "Ink"])  # their order stays
        self.assertEqual((self.scene.looks["Ink"].outline, self.scene.looks[0].lamps), ("#ff8040", False))
        self.scene.undo()
        self.assertEqual(self.scene.looks, [])

    def test_pictures_take_their_names(self):
        self.scene.looks = [Look(id=1, name="Late", light="night", lamps=False),
                            Look(id=2, name="Ink", style="cartoon")]
        lit = self.picture(camera="Audience")
        self.assertLess(self.picture(camera="Audience", look="Late").sum(), lit.sum())
        self.assertTrue(self.same(self.picture(camera="Audience", look="Ink"),
                                  self.picture(camera="Audience", look="cartoon")))
        with self.assertRaisesRegex(crowdbrush.Error, 'no look "Early".*lit.*Late, Ink'):
            self.picture(look="Early")

    def test_have_a_light_of_their_own(self):
        lit = self.picture(camera="Audience")
        light = self.scene.lighting
        self.scene.looks = [Look(id=1, name="Same", light="own", own_light=light)]
        self.assertTrue(self.same(self.picture(camera="Audience", look="Same"), lit))
        light.sun_strength = 0.0
        dark = Look(id=1, name="Dark", light="own", own_light=light)
        self.assertEqual(dark.own_light.sun_strength, 0.0)
        self.scene.looks = [dark, Look(id=2, name="Red", light="own", own_light=LookLight(sun_color=(1, 0, 0)))]
        self.assertLess(self.picture(camera="Audience", look="Dark").sum(), lit.sum())
        self.assertEqual(tuple(self.scene.looks["Red"].own_light.sun_color), (1, 0, 0))
        self.assertEqual(self.scene.looks["Dark"], dark)
        with self.assertRaisesRegex(crowdbrush.Error, "LookLight.sun_strength must lie between"):
            self.scene.looks = [Look(id=1, name="A", own_light={"sunStrength": -1})]

    def test_cameras_have_them(self):
        self.scene.looks = [Look(id=1, name="Ink", style="cartoon")]
        lit = self.picture(camera="Audience")
        camera = self.scene.cameras["Audience"]
        self.scene.set_camera("Audience", camera, look="Ink")
        self.assertEqual(self.scene.camera_looks["Audience"], "Ink")
        self.assertFalse(self.same(self.picture(camera="Audience"), lit))
        self.assertTrue(self.same(self.picture(camera=camera), lit))  # this one is none of the scene's
        self.assertTrue(self.same(self.picture(camera="Audience", look="lit"), lit))
        self.scene.set_camera("Audience", camera)  # keeps it
        self.assertEqual(self.scene.camera_looks["Audience"], "Ink")
        self.scene.set_camera("Audience", camera, look="")
        self.assertEqual(self.scene.camera_looks["Audience"], "")
        self.scene.set_cameras([("A", camera), ("B", camera)], looks={"B": "Ink"})
        self.assertEqual(self.scene.camera_looks, {"A": "", "B": "Ink"})
        with self.assertRaisesRegex(crowdbrush.Error, 'no look named "Oil".*Ink'):
            self.scene.set_camera("A", camera, look="Oil")
        with self.assertRaisesRegex(crowdbrush.Error, '"C", which is no camera'):
            self.scene.set_cameras([("A", camera)], looks={"C": "Ink"})
        self.assertEqual(self.scene.camera_looks, {"A": "", "B": "Ink"})

    def test_are_in_files(self):
        self.scene.looks = [Look(id=2, name="Groups", style="property", by="group"), Look(id=1, name="Ink")]
        camera = self.scene.cameras["Audience"]
        self.scene.set_camera("Audience", camera, look="Groups")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "looks.crowd")
            self.scene.save(path)
            again = crowdbrush.open(path)
            self.assertEqual(again.looks, self.scene.looks)
            self.assertEqual(again.camera_looks["Audience"], "Groups")

    def test_refuses_what_cannot_be(self):
        for wrong in ({"style": "oil"}, {"light": "moon"}, {"outline_width": -1}, {"outline_width": float("nan")},
                      {"background": "red"}, {"name": ""}):
            with self.assertRaises(crowdbrush.Error, msg=str(wrong)):
                self.scene.looks = [Look(**{"id": 1, "name": "A", **wrong})]
        with self.assertRaisesRegex(crowdbrush.Error, "another look"):
            self.scene.looks = [Look(id=1, name="A"), Look(id=2, name="A")]
        self.assertEqual(self.scene.looks, [])


if __name__ == "__main__":
    unittest.main()
