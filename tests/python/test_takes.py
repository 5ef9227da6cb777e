# SPDX-License-Identifier: MIT
"""Runs that are kept as takes."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush

CAMERA = crowdbrush.Camera((0, 5, 10), (0, 0, 0))


def walkers():
    """Three people in a row who walk 40 m along X."""
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    scene.set_environment({
        "places": [{"id": 1, "name": "end", "position": [40, 0, 0], "radius": 4}],
        "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}]})
    positions = np.stack([np.zeros(3), np.zeros(3), np.arange(3) - 1.5], axis=1)
    scene.create(template=man, position=positions, path=1, walkSpeed=1.25)
    return scene


class Takes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "walk.crowd")
        self.scene = walkers()
        self.scene.save(self.path)

    def tearDown(self):
        self.folder.cleanup()

    def keep(self, name="First"):
        session = crowdbrush.Session(self.scene, record=True)
        session.run(1.0)
        return session, session.keep_take(name)

    def test_a_session_becomes_a_take(self):
        session, take = self.keep()
        self.assertEqual((take.name, take.people, take.begin, take.shown),
                         ("First", 3, 0.0, False))
        self.assertAlmostEqual(take.end, 1.0, 2)
        self.assertEqual([each.name for each in self.scene.takes], ["First"])
        self.assertEqual(len(os.listdir(os.path.join(self.folder.name, "walk.takes"))), 1)
        self.assertTrue(self.scene.undo())
        self.assertEqual(self.scene.takes, [])

    def test_a_session_goes_on_out_of_it(self):
        first, _ = self.keep()
        self.scene.set_environment({
            "places": [{"id": 1, "name": "end", "position": [-40, 0, 0], "radius": 4}],
            "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}]})
        session = crowdbrush.Session(self.scene, record=True, take="First", time=0.5)
        begun = session.column("position")[:, 0].copy()
        self.assertAlmostEqual(session.seconds, 0.5, 2)
        self.assertTrue((begun > 0.2).all() and (begun < first.column("position")[:, 0]).all())
        session.run(2.0)
        self.assertAlmostEqual(session.seconds, 2.5, 2)
        self.assertTrue((session.column("position")[:, 0] < begun - 0.5).all())  # there is now behind
        take = session.keep_take("Second")
        self.assertEqual(take.begin, 0.0)
        self.assertAlmostEqual(take.end, 2.5, 2)
        for wrong, words in (({"take": "Third"}, "First"), ({"time": 1.0}, "take="),
                             ({"take": "First", "time": float("nan")}, "time")):
            with self.assertRaises(crowdbrush.Error) as said:
                crowdbrush.Session(self.scene, **wrong)
            self.assertIn(words, str(said.exception))

    def test_pictures_show_it(self):
        self.keep()
        plain = self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes()
        self.scene.set_environment({"paths": []})
        still = self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes()
        self.assertNotEqual(still, plain)
        self.scene.show_take("First")
        self.assertTrue(self.scene.takes[0].shown)
        self.assertEqual(self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes(), plain)
        self.scene.show_take(None)
        self.assertEqual(self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes(), still)

    def test_files_keep_it(self):
        self.keep()
        self.scene.show_take("First")
        self.scene.save()
        again = crowdbrush.open(self.path)
        self.assertEqual(again.takes[0].problem, "")
        self.assertTrue(again.takes[0].shown)
        for name in os.listdir(os.path.join(self.folder.name, "walk.takes")):
            with open(os.path.join(self.folder.name, "walk.takes", name), "wb"):
                pass
        # One that is no take draws the scene as it plays, and says so.
        with self.assertRaisesRegex(crowdbrush.Error, "damaged"):
            broken = crowdbrush.open(self.path)
            broken.show_take("First")
            broken.render(64, 36, time=0.5, camera=CAMERA)

    def test_files_come_from_elsewhere(self):
        self.keep()
        folder = os.path.join(self.folder.name, "walk.takes")
        path = os.path.join(folder, os.listdir(folder)[0])
        other = walkers()
        take = other.add_take(path, "Theirs", id=7)
        self.assertEqual((take.name, take.people), ("Theirs", 3))
        other.rename_take("Theirs", "Ours")
        with self.assertRaisesRegex(crowdbrush.Error, "already"):
            other.add_take(path, "Ours")
        with self.assertRaisesRegex(crowdbrush.Error, "id 7"):
            other.add_take(path, "More", id=7)
        with self.assertRaisesRegex(crowdbrush.Error, "ends in .take"):
            other.add_take(self.path, "More")
        with self.assertRaises(crowdbrush.Error):
            other.add_take(path + "n.take", "More")
        other.save(os.path.join(self.folder.name, "other.crowd"))
        self.assertEqual(len(os.listdir(os.path.join(self.folder.name, "other.takes"))), 1)

    def test_people_are_edited_by_hand(self):
        self.keep()
        self.scene.show_take("First")
        plain = self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes()
        edits = [{"kind": "hide", "people": [2], "begin": 0.5},
                 {"kind": "pace", "people": [3, 1, 3], "pace": 0.0, "begin": 0.2, "end": 0.9,
                  "on": False}]
        self.scene.edit_take("First", edits)
        kept = self.scene.takes[0].edits
        self.assertEqual([each["kind"] for each in kept], ["hide", "pace"])
        self.assertEqual((kept[1]["people"], kept[1]["on"]), ([1, 3], False))
        self.assertTrue(self.scene.takes[0].edited)
        hidden = self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes()
        self.assertNotEqual(hidden, plain)
        self.scene.edit_take("First", kept, on=False)
        self.assertFalse(self.scene.takes[0].edited)
        self.assertEqual(self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes(), plain)
        self.scene.edit_take("First", kept)
        self.scene.save()
        again = crowdbrush.open(self.path)
        self.assertEqual(again.takes[0].edits, kept)
        self.assertEqual(again.render(64, 36, time=0.91, camera=CAMERA).tobytes(), hidden)
        for wrong, what in (([{"kind": "fly"}], "kind"), ([{"people": [-3]}], "people"),
                            ([{"pace": -1}], "pace"), ([{"colour": 1}], "colour"), ([7], "object"),
                            ({}, "list"), ("[", "list"), ([{"begin": object()}], "list of dicts"),
                            ([{}] * 201, "201")):
            with self.assertRaisesRegex(crowdbrush.Error, what):
                self.scene.edit_take("First", wrong)
        with self.assertRaisesRegex(crowdbrush.Error, "there are: First"):
            self.scene.edit_take("Nobody", [])
        self.assertEqual(self.scene.takes[0].edits, kept)

    def test_somebody_else_does_what_one_did(self):
        self.keep()
        other = self.scene.add_template("builtin:templates/horse.glb")
        self.scene.show_take("First")
        plain = self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes()
        self.scene.edit_take("First", [{"kind": "swap", "people": [2], "templates": [other.id],
                                        "begin": 0.5}])
        self.assertEqual(self.scene.takes[0].edits[0]["templates"], [other.id])
        self.assertNotEqual(self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes(), plain)
        # What is shown before it begins, and by templates that are not there, is as it was.
        early = self.scene.render(64, 36, time=0.41, camera=CAMERA).tobytes()
        self.scene.edit_take("First", [{"kind": "swap", "people": [2], "templates": [4711]}])
        self.assertEqual(self.scene.render(64, 36, time=0.91, camera=CAMERA).tobytes(), plain)
        self.assertEqual(self.scene.render(64, 36, time=0.41, camera=CAMERA).tobytes(), early)
        with self.assertRaisesRegex(crowdbrush.Error, "templates"):
            self.scene.edit_take("First", [{"kind": "swap", "templates": [-3]}])

    def test_some_do_something_again(self):
        self.keep()
        self.scene.set_environment({
            "places": [{"id": 1, "name": "end", "position": [-40, 0, 0], "radius": 4}],
            "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}]})
        again = self.scene.retake("First", "Second", [2], 0.3, 5.0)
        self.assertEqual((again.name, again.people, again.shown), ("Second", 3, False))
        self.assertAlmostEqual(again.end, 1.0, 2)

        def places(take, time):
            return crowdbrush.Session(self.scene, take=take, time=time).column("position")[:, 0]
        self.assertEqual(places("Second", 0.25).tolist(), places("First", 0.25).tolist())
        moved = places("Second", 1.0) - places("First", 1.0)
        self.assertLess(moved[1], -0.3)
        self.assertEqual((moved[0], moved[2]), (0.0, 0.0))
        shares = []
        self.scene.retake("Second", "Third", np.array([True, False, True]), 0.3, 0.8,
                          different=True, progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertTrue(self.scene.undo())
        self.assertEqual([each.name for each in self.scene.takes], ["First", "Second"])
        for wrong, what in ((("Nobody", "Other", [2], 0.0, 1.0), "there are: First"),
                            (("First", "Second", [2], 0.0, 1.0), "already"),
                            (("First", "Other", [], 0.0, 1.0), "Nobody is chosen"),
                            (("First", "Other", [99], 0.0, 1.0), "99"),
                            (("First", "Other", [2], 5.0, 9.0), "outside"),
                            (("First", "Other", [2], float("nan"), 1.0), "stretch")):
            with self.assertRaisesRegex(crowdbrush.Error, what):
                self.scene.retake(*wrong)
        self.assertEqual([each.name for each in self.scene.takes], ["First", "Second"])

    def test_what_cannot_be(self):
        session, _ = self.keep()
        with self.assertRaisesRegex(crowdbrush.Error, "already"):
            session.keep_take("First")
        with self.assertRaisesRegex(crowdbrush.Error, "needs a name"):
            session.keep_take("  ")
        with self.assertRaisesRegex(crowdbrush.Error, "record=True"):
            crowdbrush.Session(self.scene).keep_take("Other")
        for call in (self.scene.show_take, self.scene.remove_take):
            with self.assertRaisesRegex(crowdbrush.Error, "there are: First"):
                call("Nobody")
        self.scene.remove_take("First")
        self.assertEqual(self.scene.takes, [])


if __name__ == "__main__":
    unittest.main()
