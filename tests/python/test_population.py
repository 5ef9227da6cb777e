# SPDX-License-Identifier: MIT
"""People as columns: creating, reading, changing, removing, by script."""
import unittest

import numpy as np

import crowdbrush

MAN = "builtin:templates/man.glb"


def people(n):
    """A scene with n men in a row, one metre apart."""
    scene = crowdbrush.Scene()
    man = scene.add_template(MAN)
    places = np.zeros((n, 3), np.float32)
    places[:, 0] = np.arange(n)
    ids = scene.create(template=man, position=places)
    return scene, man, ids


class Creating(unittest.TestCase):
    def test_ids_count_from_one(self):
        scene, _, ids = people(4)
        self.assertEqual(len(scene), 4)
        np.testing.assert_array_equal(ids, [1, 2, 3, 4])
        np.testing.assert_array_equal(scene.ids, ids)

    def test_columns_come_back_as_given(self):
        scene, man, _ = people(0)
        n = 1000
        random = np.random.default_rng(7)
        given = {
            "position": random.uniform(-9, 9, (n, 3)).astype(np.float32),
            "heading": random.uniform(-3, 3, n).astype(np.float32),
            "phase": random.uniform(0, 1, n).astype(np.float32),
            "height": random.uniform(0.9, 1.1, n).astype(np.float32),
            "clip": random.integers(0, len(man.clip_names), n).astype(np.uint16),
            "tint": random.integers(0, 256, (n, 8, 4)).astype(np.uint8),
            "tags": random.integers(0, 2**63, n).astype(np.uint64),
        }
        scene.create(template=man, **given)
        for name, values in given.items():
            with self.subTest(column=name):
                np.testing.assert_array_equal(scene.column(name), values)

    def test_one_value_stands_for_all(self):
        scene, man, _ = people(0)
        scene.create(template=man, position=np.zeros((3, 3)), heading=0.5, tint=(10, 20, 30))
        np.testing.assert_array_equal(scene.column("heading"), np.float32([0.5] * 3))
        np.testing.assert_array_equal(scene.column("tint3"), [[10, 20, 30, 255]] * 3)

    def test_clips_by_name(self):
        scene, man, _ = people(2)
        scene.create(template=man, position=[0, 0, 0], clip="walk")
        walk = man.clip_names.index("walk")
        self.assertEqual(scene.column("clip")[-1], walk)
        scene.change(scene.ids, clip=["walk", "idle", "run"])
        self.assertEqual([man.clip_names[c] for c in scene.column("clip")], ["walk", "idle", "run"])

    def test_a_seat_brings_its_place_and_a_sitting_clip(self):
        scene = crowdbrush.Scene()
        scene.add_stage("builtin:stages/theatre.glb")
        man = scene.add_template(MAN)
        seats = scene.seats
        scene.create(template=man, seat=seats["id"][[3, 9]])
        np.testing.assert_array_equal(scene.column("position"), seats["position"][[3, 9]])
        np.testing.assert_array_equal(scene.column("heading"), seats["heading"][[3, 9]])
        self.assertTrue(man.clip_names[scene.column("clip")[0]].startswith("sit"))
        self.assertEqual(np.flatnonzero(~scene.seats["free"]).tolist(), [3, 9])


class Changing(unittest.TestCase):
    def test_by_ids_in_any_order(self):
        scene, _, _ = people(5)
        scene.change([4, 2], heading=[0.4, 0.2])
        np.testing.assert_allclose(scene.column("heading"), [0, 0.2, 0, 0.4, 0])

    def test_by_mask(self):
        scene, _, _ = people(5)
        scene.change(scene.column("position")[:, 0] > 2.5, phase=0.5)
        self.assertEqual((scene.column("phase") == 0.5).tolist(), [False] * 3 + [True] * 2)

    def test_reading_gives_copies(self):
        scene, _, _ = people(3)
        scene.column("position")[:] = 99
        self.assertLess(scene.column("position").max(), 99)

    def test_remove(self):
        scene, _, _ = people(6)
        scene.remove(scene.ids[::2])
        np.testing.assert_array_equal(scene.ids, [2, 4, 6])


class Undoing(unittest.TestCase):
    def test_steps_go_back_and_forth(self):
        scene, _, _ = people(3)
        before = scene.column("position")
        scene.change([1], position=[7, 0, 7])
        self.assertTrue(scene.undo())
        np.testing.assert_array_equal(scene.column("position"), before)
        self.assertTrue(scene.redo())
        self.assertEqual(scene.column("position")[0, 2], 7)
        self.assertEqual(scene.history_index, 3)
        while scene.undo():
            pass
        self.assertEqual(len(scene), 0)
        self.assertFalse(scene.undo())

    def test_an_edit_is_one_step(self):
        scene, man, _ = people(2)
        with scene.edit("Two at once"):
            scene.create(template=man, position=[0, 0, 5])
            scene.change([1], heading=1.0)
        self.assertEqual(scene.history[-1], "Two at once")
        scene.undo()
        self.assertEqual(len(scene), 2)
        self.assertEqual(scene.column("heading")[0], 0)

    def test_an_exception_takes_an_edit_back(self):
        scene, man, _ = people(2)
        steps = len(scene.history)
        with self.assertRaises(ZeroDivisionError):
            with scene.edit("Never"):
                scene.create(template=man, position=[0, 0, 5])
                scene.remove([1])
                1 / 0
        np.testing.assert_array_equal(scene.ids, [1, 2])
        self.assertEqual(len(scene.history), steps)


class Refusing(unittest.TestCase):
    def refused(self, part, call, *args, **kwargs):
        with self.assertRaises(crowdbrush.Error) as caught:
            call(*args, **kwargs)
        self.assertIn(part, str(caught.exception))

    def test_nothing_changes(self):
        scene, man, _ = people(3)
        steps = len(scene.history)
        tint = np.zeros((3, 7, 4), int)
        cases = [
            ("finite", scene.create, dict(template=man, position=[0, np.nan, 0])),
            ("finite", scene.create, dict(template=man, position=[0, 0, 0], heading=np.inf)),
            ("shape", scene.create, dict(template=man, position=np.zeros((2, 2)))),
            ("shape", scene.create, dict(template=man, position=np.zeros((2, 3)), heading=[1, 2, 3])),
            ("template", scene.create, dict(position=[0, 0, 0])),
            ("position", scene.create, dict(template=man)),
            ("no such template", scene.create, dict(template=77, position=[0, 0, 0])),
            ("no column", scene.create, dict(template=man, position=[0, 0, 0], mood=3)),
            ("no clip", scene.create, dict(template=man, position=[0, 0, 0], clip="swim")),
            ("clips, counted", scene.create, dict(template=man, position=[0, 0, 0], clip=900)),
            ("from 0.01 to 100", scene.create, dict(template=man, position=[0, 0, 0], height=0)),
            ("such a seat", scene.create, dict(template=man, seat=12345)),
            ("whole numbers", scene.create, dict(template=man, position=[0, 0, 0], clip=0.5)),
            ("0 to 255", scene.create, dict(template=man, position=[0, 0, 0], tint=(300, 0, 0))),
            ("numbers", scene.create, dict(template=man, position=[["a", "b", "c"]])),
        ]
        for part, call, arguments in cases:
            with self.subTest(message=part, arguments=str(arguments)):
                self.refused(part, call, **arguments)
        self.refused("no individual 9", scene.change, [9], heading=0.0)
        self.refused("twice", scene.change, [2, 2], heading=0.0)
        self.refused("mask", scene.change, [True, False], heading=0.0)
        self.refused("shape", scene.change, scene.ids, tint=tint)
        self.refused("no individual", scene.remove, [1, 50])
        self.refused("no column", scene.column, "mood")
        self.assertEqual(len(scene), 3)
        self.assertEqual(len(scene.history), steps)

    def test_a_taken_seat(self):
        scene = crowdbrush.Scene()
        scene.add_stage("builtin:stages/theatre.glb")
        man = scene.add_template(MAN)
        seat = int(scene.seats["id"][0])
        scene.create(template=man, seat=seat)
        self.refused("taken", scene.create, template=man, seat=seat)
        self.refused("taken", scene.create, template=man, seat=scene.seats["id"][[4, 4]])

    def test_odd_strides_and_types_are_read_rightly(self):
        scene, man, _ = people(0)
        wide = np.arange(60, dtype=">f8").reshape(10, 6)
        scene.create(template=man, position=wide[::2, ::2])
        np.testing.assert_array_equal(scene.column("position"), wide[::2, ::2].astype(np.float32))

    def test_a_template_that_is_gone(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        scene.undo()
        self.refused("no longer", lambda: man.name)
        self.refused("no such template", scene.create, template=man, position=[0, 0, 0])

    def test_inside_an_edit(self):
        scene, _, _ = people(1)
        with scene.edit("Outer"):
            self.refused("inside", scene.undo)
            self.refused("inside", scene.save, "/tmp/never.crowd")
            with self.assertRaises(crowdbrush.Error):
                with scene.edit("Inner"):
                    pass


if __name__ == "__main__":
    unittest.main()
