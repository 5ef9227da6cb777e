# SPDX-License-Identifier: MIT
"""The scale and the material brush: strokes with every operator, undo, what they refuse."""
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Operator, Selection

SIZE = (640, 480)
LINE = [(20, 240), (620, 240)]


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


class Scale(unittest.TestCase):
    def test_each_measure_has_a_range_and_an_operator_of_its_own(self):
        scene = crowd()
        brush = whole(BrushKind.SCALE)
        brush.scale.height = (1.5, 2.0)
        brush.scale.height_operator = Operator.UNIFORM
        brush.scale.girth = (0.5, 1.5)
        brush.scale.girth_operator = Operator.RANDOM
        self.assertEqual(paint(scene, brush).affected, 20)
        self.assertTrue((scene.column("height") == 1.5).all())
        girth = scene.column("girth")
        self.assertTrue(((girth >= 0.5) & (girth <= 1.5)).all())
        self.assertGreater(len(set(girth.tolist())), 10)
        scene.undo()
        self.assertTrue((scene.column("girth") == 1).all())
        scene.redo()
        self.assertEqual(scene.column("girth").tolist(), girth.tolist())

    def test_a_gradient_runs_along_the_line(self):
        scene = crowd()
        brush = whole(BrushKind.SCALE)
        brush.scale.sets_girth = False
        brush.scale.height = (0.5, 1.5)
        brush.scale.height_operator = Operator.GRADIENT
        scene.stroke(brush, [(0, 0), (639, 479)], size=SIZE)
        heights = scene.column("height")
        self.assertTrue((np.diff(heights) > 0).all())
        self.assertTrue((scene.column("girth") == 1).all())

    def test_building_up_goes_a_share_of_the_way(self):
        scene = crowd()
        brush = Brush(BrushKind.SCALE)
        brush.selection = Selection.ALL_IN_CIRCLE
        brush.radius = 400
        brush.through = brush.build_up = True
        brush.flow = 0.5
        brush.scale.height = (2.0, 2.0)
        brush.scale.sets_girth = False
        scene.stroke(brush, [(320, 240)], size=SIZE)
        reached = scene.column("height")
        self.assertIn(1.5, reached.tolist())
        scene.stroke(brush, [(320, 240)], size=SIZE)
        self.assertIn(1.75, scene.column("height").tolist())

    def test_what_makes_no_sense_is_refused(self):
        scene = crowd(2)
        brush = whole(BrushKind.SCALE)
        with self.assertRaisesRegex(crowdbrush.Error, "ScaleSettings.height takes finite numbers"):
            brush.scale.height = (float("nan"), 1.0)
        for bad in ((0.0, 1.0), (1.0, 1000.0), (2.0, 1.0)):
            brush.scale.height = bad
            with self.assertRaisesRegex(crowdbrush.Error, "brush.scale.height"):
                paint(scene, brush)
        self.assertTrue((scene.column("height") == 1).all())

    def test_nothing_to_do_says_why(self):
        scene = crowd(2)
        brush = whole(BrushKind.SCALE)
        brush.scale.height = brush.scale.girth = (1.0, 1.0)
        outcome = paint(scene, brush)
        self.assertFalse(outcome.committed)
        self.assertIn("already have this size", outcome.message)
        brush.scale.sets_height = brush.scale.sets_girth = False
        self.assertIn("change nothing", paint(scene, brush).message)


class Material(unittest.TestCase):
    def test_any_material_of_a_slot(self):
        scene = crowd()
        brush = whole(BrushKind.MATERIAL)
        brush.operator = Operator.RANDOM
        brush.material.slot = "top"
        self.assertGreater(paint(scene, brush).affected, 5)
        choices = scene.column("choices")
        changed = [i for i in range(8) if len(set(choices[:, i].tolist())) > 1]
        self.assertEqual(len(changed), 1)

    def test_the_body_is_spared(self):
        scene = crowd()
        brush = whole(BrushKind.MATERIAL)
        brush.operator = Operator.RANDOM
        paint(scene, brush)
        spared = scene.column("choices")
        brush.material.spares_body = False
        paint(scene, brush)
        more = scene.column("choices")
        self.assertGreater(sum(len(set(more[:, i].tolist())) > 1 for i in range(8)),
                           sum(len(set(spared[:, i].tolist())) > 1 for i in range(8)))

    def test_unknown_names_say_why(self):
        scene = crowd(2)
        brush = whole(BrushKind.MATERIAL)
        brush.material.choice = "no such material"
        outcome = paint(scene, brush)
        self.assertFalse(outcome.committed)
        self.assertIn("chosen material", outcome.message)
        brush.material.slot = "no such slot"
        self.assertIn("chosen slot", paint(scene, brush).message)


if __name__ == "__main__":
    unittest.main()
