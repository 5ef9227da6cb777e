# SPDX-License-Identifier: MIT
"""Brushes that look at others: time, clone, smooth, push, shuffle; templates, parts and restore."""
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Selection

SIZE = (640, 480)


def crowd(count=20):
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    scene.create(template=man, position=np.array([[i - count / 2, 0, 0] for i in range(count)]))
    scene.set_camera("Front", crowdbrush.Camera((0, 6, 22), (0, 0.9, 0)))
    return scene


def whole(kind):
    brush = Brush(kind)
    brush.selection = Selection.RECTANGLE
    brush.through = True
    return brush


def paint(scene, brush):
    return scene.stroke(brush, [(0, 0), (639, 479)], size=SIZE, seed=7)


class Neighbours(unittest.TestCase):
    def test_time(self):
        scene = crowd()
        brush = whole(BrushKind.TIME)
        brush.time.mode = "IN_STEP"
        self.assertEqual(brush.time.mode, crowdbrush.Timing.IN_STEP)
        with self.assertRaisesRegex(crowdbrush.Error, "TimeSettings.mode must be one of: RANGE, WAVE"):
            brush.time.mode = "IN STEP"
        brush.time.mode = crowdbrush.Timing.IN_STEP
        brush.time.delay = (0.5, 0.5)
        paint(scene, brush)
        self.assertEqual(len(set(scene.column("phase").tolist())), 1)
        brush.time.wave_speed = 0.0
        with self.assertRaisesRegex(crowdbrush.Error, "wave_speed"):
            paint(scene, brush)

    def test_clone_and_shuffle(self):
        scene = crowd()
        heights = np.linspace(0.8, 1.2, 20, dtype=np.float32)
        scene.change(scene.ids, height=heights)
        shuffle = whole(BrushKind.SHUFFLE)
        shuffle.shuffle.size = True
        paint(scene, shuffle)
        self.assertEqual(sorted(scene.column("height").tolist()), heights.tolist())
        self.assertNotEqual(scene.column("height").tolist(), heights.tolist())
        clone = whole(BrushKind.CLONE)
        self.assertEqual(paint(scene, clone).affected, 0)
        clone.clone.source = int(scene.ids[3])
        paint(scene, clone)
        self.assertEqual(len(set(scene.column("height").tolist())), 1)

    def test_smooth(self):
        scene = crowd()
        heights = np.ones(20, dtype=np.float32)
        heights[10] = 2
        scene.change(scene.ids, height=heights)
        brush = whole(BrushKind.SMOOTH)
        brush.smooth.distance = 1.1
        paint(scene, brush)
        self.assertEqual(scene.column("height")[10], 1)
        self.assertEqual(scene.column("height")[9], 1.5)

    def test_push(self):
        scene = crowd()
        before = scene.column("position").copy()
        brush = whole(BrushKind.PUSH)
        brush.push.mode = crowdbrush.Movement.SPREAD
        brush.push.distance = 1.5
        self.assertGreater(paint(scene, brush).affected, 0)
        self.assertFalse((scene.column("position") == before).all())
        scene.undo()
        self.assertTrue((scene.column("position") == before).all())

    def test_parts_and_restore(self):
        scene = crowd()
        before = scene.column("parts").copy()
        brush = whole(BrushKind.PARTS)
        brush.parts.part = "backpack"
        self.assertEqual(paint(scene, brush).affected, 20)
        self.assertFalse((scene.column("parts") == before).all())
        paint(scene, whole(BrushKind.RESTORE))
        self.assertTrue((scene.column("parts") == before).all())
        brush.parts.part = "sword"
        self.assertEqual(paint(scene, brush).affected, 0)

    def test_templates(self):
        scene = crowd()
        woman = scene.add_template("builtin:templates/woman.glb")
        brush = whole(BrushKind.TEMPLATE)
        brush.template.templates = [woman.id]
        self.assertEqual(paint(scene, brush).affected, 20)
        self.assertTrue((scene.column("template") == woman.id).all())


if __name__ == "__main__":
    unittest.main()
