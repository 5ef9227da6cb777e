# SPDX-License-Identifier: MIT
"""Strokes and pictures without a window, by script."""
import os
import tempfile
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Selection

SIZE = (640, 360)


def theatre():
    return crowdbrush.open("builtin:scenes/theatre.crowd")


def across(y=180, seconds=1.0, n=60):
    """A way from left to right."""
    return [(60 + 520 * i / n, y, 1.0, seconds * i / n) for i in range(n + 1)]


def creation(scene):
    brush = Brush(BrushKind.CREATE)
    brush.create.mix = {template: 1.0 for template in scene.templates}
    brush.radius = 60
    brush.rate = 100
    return brush


class Strokes(unittest.TestCase):
    def test_creates_into_free_seats_in_one_step(self):
        scene = theatre()
        before = len(scene)
        outcome = scene.stroke(creation(scene), across(), size=SIZE, seed=5)
        self.assertTrue(outcome.committed)
        self.assertEqual(len(scene), before + outcome.affected)
        self.assertGreater(outcome.affected, 5)
        self.assertEqual(len(scene.history), 1)
        seats = scene.column("seat")
        self.assertEqual(len(np.unique(seats[seats != 0])), np.count_nonzero(seats))

    def test_is_the_same_for_the_same_seed(self):
        def painted(seed):
            scene = theatre()
            scene.stroke(creation(scene), across(), size=SIZE, seed=seed)
            return [scene.column(name).tobytes() for name in ("position", "tint", "seat", "phase")]

        self.assertEqual(painted(3), painted(3))
        self.assertNotEqual(painted(3), painted(4))

    def test_means_those_it_is_told_of(self):
        scene = theatre()
        ids = scene.ids
        brush = Brush(BrushKind.COLOUR)
        brush.selection = Selection.ALL_IN_CIRCLE
        brush.colour.colors = [(9, 200, 10)]
        brush.colour.strength = 1.0

        def painted(**told):
            outcome = scene.stroke(brush, [(1, 1), (30, 1)], size=SIZE, **told)
            green = (scene.column("tint")[:, :, :3] == (9, 200, 10)).all(axis=2).any(axis=1)
            green = scene.ids[green].tolist()
            if outcome.committed:
                scene.undo()
            return green

        self.assertEqual(painted(), [])
        self.assertEqual(painted(selected={}), [])
        self.assertEqual(painted(selected={0: ids[3:5], 1: [ids[9], ids[9], ids[3]]}),
                         [ids[3], ids[4], ids[9]])
        brush.selection = Selection.RECTANGLE
        self.assertEqual(painted(selected={0: ids[7:8]}), [ids[7]])
        removal = Brush(BrushKind.DELETE)
        removal.selection = Selection.ALL_IN_CIRCLE
        removal.build_up = True
        self.assertEqual(scene.stroke(removal, [(1, 1), (30, 1)], size=SIZE, selected={
            0: ids[:2], 1: ids[1:3]}).affected, 3)
        for told, said in (([ids[3]], "must be a dict"), ({-1: ids[:1]}, "-1 is no number"),
                           ({10**30: ids[:1]}, "is no number"), ({"a": ids[:1]}, "'a' is no"),
                           ({0: [10**9]}, "no individual 1000000000"), ({0: "x"}, "ids"),
                           ({0: None}, "ids")):
            with self.subTest(told=told), self.assertRaisesRegex(crowdbrush.Error, said):
                scene.stroke(brush, [(1, 1)], size=SIZE, selected=told)
        with self.assertRaisesRegex(crowdbrush.Error, "creates"):
            scene.stroke(creation(scene), [(1, 1)], size=SIZE, selected={0: ids[:1]})

    def test_creates_where_people_can_walk_or_anywhere(self):
        def painted(anywhere):
            scene = crowdbrush.Scene()
            scene.add_stage("builtin:stages/city.glb")
            brush = Brush(BrushKind.CREATE)
            brush.create.mix = {scene.add_template("builtin:templates/man.glb"): 1.0}
            brush.create.density = 0.3
            brush.selection = Selection.RECTANGLE
            if anywhere is not None:
                brush.create.anywhere = anywhere
            above = crowdbrush.Camera((0, 90, 0.1), (0, 0, 0))
            outcome = scene.stroke(brush, [(100, 40), (540, 320)], camera=above, size=SIZE)
            self.assertTrue(outcome.committed)
            return scene

        def heights(scene):
            return scene.column("position")[:, 1]

        walkable = painted(False)
        self.assertLess(heights(walkable).max(), 2.0)
        anywhere = painted(True)
        self.assertGreater(heights(anywhere).max(), 2.5)
        np.testing.assert_array_equal(heights(painted(None)), heights(anywhere))
        np.testing.assert_array_equal(heights(painted(False)), heights(walkable))

        people = len(anywhere)
        moved = anywhere.put_on_ground()
        self.assertGreater(moved, 3)
        self.assertLess(heights(anywhere).max(), 2.0)  # the steps of a house are ground
        self.assertEqual(len(anywhere), people)
        self.assertEqual(anywhere.put_on_ground(), 0)
        self.assertTrue(anywhere.undo())
        self.assertGreater(heights(anywhere).max(), 2.5)
        high = anywhere.ids[heights(anywhere) > 2.5]
        self.assertEqual(anywhere.put_on_ground(high[:1]), 1)
        with self.assertRaises(crowdbrush.Error):
            anywhere.put_on_ground([4000000])

    def test_recolours_whom_it_passes(self):
        scene = theatre()
        before = scene.column("tint")
        brush = Brush(BrushKind.COLOUR)
        brush.selection = Selection.RECTANGLE
        brush.colour.slot = "top"
        brush.colour.colors = [(1, 2, 3)]
        outcome = scene.stroke(brush, [(10, 10), (630, 350)], size=SIZE)
        self.assertGreater(outcome.affected, 20)
        changed = np.any(scene.column("tint") != before, axis=(1, 2))
        self.assertEqual(np.count_nonzero(changed), outcome.affected)

    def test_says_why_nothing_happened(self):
        scene = crowdbrush.Scene()
        camera = crowdbrush.Camera((0, 5, 10), (0, 0, 0))
        outcome = scene.stroke(Brush(BrushKind.DELETE), [(5, 5)], camera=camera, size=SIZE)
        self.assertFalse(outcome.committed)
        self.assertNotEqual(outcome.message, "")
        self.assertEqual(scene.history, [])

    def test_bad_brushes_and_points(self):
        scene = theatre()
        good = creation(scene)

        def bad(change):
            brush = good.copy()
            change(brush)
            return brush

        brushes = [
            bad(lambda b: setattr(b, "radius", 1e9)),
            bad(lambda b: setattr(b, "rate", -1)),
            bad(lambda b: setattr(b, "rate", 1e30)),
            bad(lambda b: setattr(b.create, "mix", {99: 1.0})),
            bad(lambda b: setattr(b.create, "height", (2.0, 1.0))),
            bad(lambda b: (setattr(b, "kind", BrushKind.COLOUR), setattr(b.colour, "colors", []))),
        ]
        for brush in brushes:
            with self.assertRaises(crowdbrush.Error):
                scene.stroke(brush, across(), size=SIZE)
        for points in [[], [(1,)], [(1, 2, 3, 4, 5, 6)], [(np.nan, 0)], [(0, 0, 2)],
                       [(0, 0, 1, 1), (0, 0, 1, 0)], "abc", None]:
            with self.subTest(points=str(points)), self.assertRaises(crowdbrush.Error):
                scene.stroke(good, points, size=SIZE)
        with self.assertRaises(crowdbrush.Error):
            scene.stroke(good, across(), size=(0, 10))
        with self.assertRaises(crowdbrush.Error):
            scene.stroke(good, across(), camera="nowhere")
        self.assertEqual(scene.history, [])


class Pictures(unittest.TestCase):
    def test_shows_the_scene(self):
        scene = theatre()
        picture = scene.render(160, 90)
        self.assertEqual(picture.shape, (90, 160, 4))
        self.assertEqual(picture.dtype, np.uint8)
        self.assertGreater(len(np.unique(picture[..., :3].reshape(-1, 3), axis=0)), 500)
        np.testing.assert_array_equal(picture, scene.render(160, 90))

    def test_people_are_seen_where_they_stand(self):
        scene = crowdbrush.Scene()
        man = scene.add_template("builtin:templates/man.glb")
        camera = crowdbrush.Camera((0, 1, 5), (0, 1, 0))
        empty = scene.render(120, 120, camera=camera)
        scene.create(template=man, position=[0, 0, 0], tint=(255, 0, 0))
        full = scene.render(120, 120, camera=camera)
        rows, columns = np.nonzero(np.any(full != empty, axis=2))
        self.assertTrue(50 < columns.mean() < 70)
        self.assertGreater(np.ptp(rows), 30)

    def test_saves_a_png(self):
        scene = theatre()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            scene.render(64, 36).save_png(path)
            with open(path, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
            with self.assertRaises(crowdbrush.Error):
                scene.render(64, 36).save_png(os.path.join(folder, "no", "a.png"))

    def test_colours_by_property(self):
        scene = theatre()
        ids = scene.ids
        scene.change(ids[:len(ids) // 2], tags=1)
        lit = scene.render(160, 90)
        by_tag = scene.render(160, 90, by="tag")
        self.assertFalse(np.array_equal(by_tag, lit))
        self.assertTrue(np.array_equal(by_tag, scene.render(160, 90, look="property", by="tag")))
        self.assertFalse(np.array_equal(by_tag, scene.render(160, 90, look="property")))
        self.assertFalse(np.array_equal(by_tag, scene.render(160, 90, by="feature:emotion")))

    def test_depth_of_field(self):
        scene = theatre()
        sharp = scene.render(160, 90).astype(int)
        soft = scene.render(160, 90, focus=0.5, f_stop=0.05).astype(int)

        def contrast(picture):
            return np.abs(np.diff(picture[..., :3], axis=1)).mean()

        self.assertLess(contrast(soft), 0.6 * contrast(sharp))
        self.assertGreater(contrast(scene.render(160, 90, focus=20.0, f_stop=20.0).astype(int)),
                           0.6 * contrast(sharp))
        self.assertFalse(np.array_equal(scene.render(160, 90, f_stop=0.05), sharp))

    def test_bad_requests(self):
        scene = theatre()
        for arguments in [dict(width=0), dict(width=100_000), dict(camera="nowhere"),
                          dict(time=float("nan")), dict(time=1e18), dict(time=-float("inf")),
                          dict(look="sepia"), dict(by="shoe size"), dict(by="tag", look="clay"),
                          dict(focus=0.0), dict(focus=float("nan")), dict(f_stop=-1.0), dict(f_stop=1e30)]:
            with self.subTest(arguments=arguments), self.assertRaises(crowdbrush.Error):
                scene.render(**{"width": 10, "height": 10, **arguments})
        with self.assertRaisesRegex(crowdbrush.Error, "no camera"):
            crowdbrush.Scene().render(10, 10)


if __name__ == "__main__":
    unittest.main()
