# SPDX-License-Identifier: MIT
"""Calls that take long: how far they are, and that they are taken back where something stops them."""
import time
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Selection
from interrupting import Interrupting

MAN = "builtin:templates/man.glb"
ABOVE = crowdbrush.Camera((0, 60, 120), (0, 0, 0))
SOON = 2.0  # seconds
MANY = 200  # points


class Stop(Exception):
    pass


def crowd(rows):
    scene = crowdbrush.Scene()
    man = scene.add_template(MAN)
    if rows:
        x, z = np.meshgrid(np.arange(rows) * 0.6, np.arange(rows) * 0.6)
        spots = np.column_stack([x.ravel(), np.zeros(rows * rows), z.ravel()]) - (0.3 * rows, 0, 0.3 * rows)
        scene.create(template=man, position=spots)
    return scene, man


def colour(radius):
    brush = Brush(BrushKind.COLOUR)
    brush.selection = Selection.ALL_IN_CIRCLE
    brush.radius = radius
    brush.build_up = True
    brush.colour.slot = "top"
    brush.colour.colors = [(1, 2, 3)]
    return brush


def way(n):
    return [(100 + 1080 * i / n, 360 + 100 * (i % 2)) for i in range(n)]


class Turner:
    selection = Selection.ALL_IN_CIRCLE
    radius = 100

    def apply(self, selected):
        selected.change(heading=selected.column("heading") + 0.1)


class Stopping(unittest.TestCase, Interrupting):
    def unchanged(self, scene):
        """A check that the scene is as now."""
        names = ("position", "tint", "heading")
        before = [scene.column(name).tobytes() for name in names], scene.ids.tolist(), scene.history

        def check():
            self.assertEqual(([scene.column(name).tobytes() for name in names], scene.ids.tolist(), scene.history),
                             before)

        return check

    def test_an_interrupted_stroke_is_taken_back(self):
        scene, _ = crowd(200)
        check = self.unchanged(scene)
        self.assertLess(self.interrupted(lambda: scene.stroke(colour(300), way(MANY), camera=ABOVE)), SOON)
        check()
        self.assertTrue(scene.stroke(colour(20), way(2), camera=ABOVE).committed)  # still paints

    def test_a_long_move_is_interrupted_between_its_dabs(self):
        scene, _ = crowd(200)
        check = self.unchanged(scene)
        brush = colour(300)
        brush.selection = Selection.SPRAY
        brush.rate = 10_000
        spray = [(640, 360, 1.0, 0.0), (640, 361, 1.0, 3000.0)]
        self.assertLess(self.interrupted(lambda: scene.stroke(brush, spray, camera=ABOVE)), SOON)
        check()

    def test_an_interrupted_creation_is_taken_back(self):
        scene, man = crowd(0)
        check = self.unchanged(scene)
        spots = np.zeros((3_000_000, 3), np.float32)
        self.assertLess(self.interrupted(lambda: scene.create(template=man, position=spots), 0.1), SOON)
        check()
        self.assertEqual(scene.create(template=man, position=(0, 0, 0)).tolist(), [1])

    def test_an_interrupted_picture_with_depth_of_field_ends_soon(self):
        scene, _ = crowd(20)
        check = self.unchanged(scene)
        self.assertLess(self.interrupted(
            lambda: scene.render(1600, 900, camera=ABOVE, f_stop=0.1)), SOON)
        check()

    def test_progress_rises_to_one(self):
        scene, man = crowd(60)
        for call in (lambda told: scene.stroke(colour(300), way(30), camera=ABOVE, progress=told),
                     lambda told: scene.stroke(Turner(), way(30), camera=ABOVE, progress=told),
                     lambda told: scene.create(template=man, position=(0, 0, 0), progress=told),
                     lambda told: scene.render(16, 16, camera=ABOVE, time=1.0, progress=told),
                     lambda told: scene.render(16, 16, camera=ABOVE, f_stop=0.5, progress=told)):
            shares, times = [], []

            def told(share):
                shares.append(share)
                times.append(time.monotonic())

            call(told)
            self.assertEqual(shares[-1], 1.0)
            self.assertEqual(shares, sorted(shares))
            self.assertTrue(all(0.0 <= each <= 1.0 for each in shares))
            self.assertTrue(all(b - a > 0.2 for a, b in zip(times[:-2], times[1:-1])))

    def test_what_progress_raises_takes_the_call_back(self):
        def stop(_):
            raise Stop("enough")

        scene, man = crowd(30)
        check = self.unchanged(scene)
        for call in (lambda: scene.stroke(colour(300), way(5), camera=ABOVE, progress=stop),
                     lambda: scene.stroke(Turner(), way(5), camera=ABOVE, progress=stop),
                     lambda: scene.create(template=man, position=(0, 0, 0), progress=stop),
                     lambda: scene.render(16, 16, camera=ABOVE, progress=stop)):
            with self.assertRaisesRegex(Stop, "enough"):
                call()
            check()

    def test_a_stopped_creation_leaves_the_rest_of_an_edit(self):
        def stop(_):
            raise Stop

        scene, man = crowd(0)
        with scene.edit("two"):
            scene.create(template=man, position=(0, 0, 0))
            with self.assertRaises(Stop):
                scene.create(template=man, position=(1, 0, 0), progress=stop)
        self.assertEqual(len(scene), 1)
        self.assertEqual(scene.history[1:], ["two"])

    def test_progress_cannot_edit(self):
        scene, man = crowd(10)
        said = []

        def edit(_):
            for call in (lambda: scene.create(template=man, position=(0, 0, 0)), scene.undo,
                         lambda: scene.stroke(colour(20), way(2), camera=ABOVE),
                         lambda: scene.change(scene.ids, heading=1.0), lambda: scene.edit("x").__enter__()):
                with self.assertRaisesRegex(crowdbrush.Error, "longer call"):
                    call()
                said.append(len(scene))

        scene.stroke(colour(300), way(2), camera=ABOVE, progress=edit)
        scene.create(template=man, position=(0, 0, 0), progress=edit)
        self.assertGreaterEqual(len(said), 10)
        self.assertEqual(len(scene), 101)
        self.assertEqual(len(scene.history), 4)

    def test_progress_is_a_function(self):
        scene, man = crowd(1)
        for call in (lambda: scene.create(template=man, position=(0, 0, 0), progress=3),
                     lambda: scene.stroke(colour(9), way(2), camera=ABOVE, progress="x")):
            with self.assertRaisesRegex(TypeError, "progress must be"):
                call()


if __name__ == "__main__":
    unittest.main()
