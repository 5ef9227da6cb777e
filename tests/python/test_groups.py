# SPDX-License-Identifier: MIT
"""Groups and masks of brushes: found by name, hidden and locked ones untouched, undo."""
import json
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Error, Group, Selection

SIZE = (640, 480)


def crowd(count=6):
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    ids = scene.create(template=man, position=np.array([[i - count / 2, 0, 0] for i in range(count)]))
    scene.set_camera("Front", crowdbrush.Camera((0, 6, 22), (0, 0.9, 0)))
    return scene, ids


def sized(mask=None):
    brush = Brush(BrushKind.SCALE)
    brush.selection = Selection.RECTANGLE
    brush.through = True
    brush.scale.sets_girth = False
    brush.scale.height = (2.0, 2.0)
    for name, value in (mask or {}).items():
        setattr(brush.mask, name, value)
    return brush


def painted(scene, brush):
    scene.stroke(brush, [(0, 0), (639, 479)], size=SIZE)
    tall = [int(i) for i in np.flatnonzero(scene.column("height") == 2.0)]
    scene.undo()
    return tall


class Groups(unittest.TestCase):
    def test_they_are_found_by_name(self):
        scene, ids = crowd()
        scene.groups = [Group(id=1, name="left"), Group(id=2, name="right", color="#102030")]
        self.assertEqual(scene.groups["right"].id, 2)
        self.assertIn("left", scene.groups)
        self.assertNotIn("middle", scene.groups)
        with self.assertRaisesRegex(Error, 'no entry named "middle".*left, right'):
            scene.groups["middle"]
        scene.undo()
        self.assertEqual(scene.groups, [])

    def test_locked_and_hidden_ones_are_not_touched(self):
        scene, ids = crowd()
        scene.groups = [Group(id=1, name="locked", locked=True), Group(id=2, name="hidden", hidden=True)]
        scene.change(ids[:2], group=1)
        scene.change(ids[2:4], group=2)
        self.assertEqual(painted(scene, sized()), [4, 5])

    def test_hidden_ones_are_in_no_picture(self):
        scene, ids = crowd()
        everybody = scene.render(160, 120)
        scene.groups = [Group(id=1, name="all", hidden=True)]
        scene.change(ids, group=1)
        nobody = scene.render(160, 120)
        scene.groups = [Group(id=1, name="all")]
        self.assertTrue((scene.render(160, 120) == everybody).all())
        self.assertGreater((nobody != everybody).sum(), 100)

    def test_the_group_brush_takes_in(self):
        scene, ids = crowd()
        scene.groups = [Group(id=7, name="seven")]
        brush = Brush(BrushKind.GROUP)
        brush.selection = Selection.RECTANGLE
        brush.through = True
        brush.group.group = 7
        self.assertEqual(scene.stroke(brush, [(0, 0), (639, 479)], size=SIZE).affected, 6)
        self.assertEqual(set(scene.column("group").tolist()), {7})

    def test_what_is_wrong_is_named(self):
        scene, ids = crowd()
        with self.assertRaisesRegex(Error, "groups"):
            scene.set_environment({"groups": [{"id": 1}, {"id": 1}]})
        with self.assertRaisesRegex((Error, TypeError), "locked"):
            Group(id=1, locked="yes")

    def test_those_that_are_not_there_are_refused(self):
        scene, ids = crowd()
        man = scene.template("man")
        with self.assertRaisesRegex(Error, r"group\[0\] is 7, and the scene has no such group. It has none"):
            scene.change(ids, group=7)
        scene.groups = [Group(id=3, name="choir"), Group(id=4, name="band")]
        said = r'group\[1\] is 7, and the scene has no such group. Its groups: 3 "choir", 4 "band"; 0: none.'
        with self.assertRaisesRegex(Error, said):
            scene.change(ids[:3], group=[0, 7, 3])
        with self.assertRaisesRegex(Error, said):
            scene.create(template=man, position=np.zeros((2, 3)), group=[4, 7])
        self.assertEqual((len(scene), set(scene.column("group").tolist())), (6, {0}))
        scene.change(ids[:1], group=7, allow_missing=True)
        scene.create(template=man, position=(0, 0, 0), group=7, path=5, allow_missing=True)
        self.assertEqual(scene.column("group").tolist(), [7, 0, 0, 0, 0, 0, 7])
        with self.assertRaisesRegex(Error, "no such path"):
            scene.change(ids, path=5)


class Masks(unittest.TestCase):
    def test_only_those_who_fulfil_all(self):
        scene, ids = crowd()
        scene.groups = [Group(id=3, name="three")]
        scene.change(ids[1:4], group=3)
        scene.change(ids[3:], tags=1 << 5)
        self.assertEqual(painted(scene, sized({"groups": [3]})), [1, 2, 3])
        self.assertEqual(painted(scene, sized({"groups": [0]})), [0, 4, 5])
        self.assertEqual(painted(scene, sized({"tags": [5]})), [3, 4, 5])
        self.assertEqual(painted(scene, sized({"tags": [5], "groups": [3]})), [3])
        self.assertEqual(painted(scene, sized({"tags": [5], "groups": [3], "inverted": True})), [0, 1, 2, 4, 5])
        chosen = [int(ids[5]), int(ids[0])]  # in any order
        self.assertEqual(painted(scene, sized({"only_selected": True, "selected": chosen})), [0, 5])

    def test_templates_are_handles_or_ids(self):
        scene, ids = crowd()
        man = scene.template("man")
        woman = scene.add_template("builtin:templates/woman.glb")
        brush = sized({"templates": [man]})
        self.assertEqual(brush.mask.templates, [man.id])
        self.assertEqual(painted(scene, brush), [0, 1, 2, 3, 4, 5])
        self.assertEqual(painted(scene, sized({"templates": [woman]})), [])
        brush.kind = BrushKind.TEMPLATE
        brush.template.templates = (woman,)
        self.assertEqual(brush.template.templates, [woman.id])
        with self.assertRaisesRegex(Error, "TemplateSettings.templates must be in ascending order"):
            brush.template.templates = [woman, man]
        with self.assertRaisesRegex(Error, "A template is one of scene.templates or its id"):
            brush.mask.templates = ["man"]

    def test_what_the_scene_does_not_have_is_named(self):
        scene, ids = crowd()
        with self.assertRaisesRegex(Error, "brush.mask.groups names group 3"):
            painted(scene, sized({"groups": [0, 3]}))
        with self.assertRaisesRegex(Error, "brush.mask.templates names template 77"):
            painted(scene, sized({"templates": [77]}))
        brush = sized()
        brush.kind = BrushKind.GROUP
        brush.group.group = 9
        with self.assertRaisesRegex(Error, "brush.group.group names group 9.*scene.groups"):
            painted(scene, brush)
        brush = sized()
        brush.kind = BrushKind.TEMPLATE
        brush.template.templates = [scene.template("man").id, 77]
        with self.assertRaisesRegex(Error, "brush.template.templates names template 77"):
            painted(scene, brush)
        brush = sized()
        brush.kind = BrushKind.GROUP
        brush.group.group = 9
        scene.groups = [Group(id=3, name="choir")]
        with self.assertRaisesRegex(Error, 'brush.group.group names group 9.*3 "choir"'):
            painted(scene, brush)

    def test_missing_ones_may_be_allowed(self):
        scene, ids = crowd()
        across = [(0, 0), (639, 479)]
        brush = sized({"groups": [0, 3], "templates": [scene.template("man").id, 77]})
        self.assertEqual(scene.stroke(brush, across, size=SIZE, allow_missing=True).affected, 6)
        brush = sized()
        brush.kind = BrushKind.GROUP
        brush.group.group = 9
        self.assertEqual(scene.stroke(brush, across, size=SIZE, allow_missing=True).affected, 6)
        self.assertEqual(set(scene.column("group").tolist()), {9})

    def test_what_cannot_be_is_refused(self):
        scene, ids = crowd()
        with self.assertRaisesRegex(Error, "brush.mask.tags"):
            painted(scene, sized({"tags": [64]}))
        with self.assertRaisesRegex(Error, "brush.mask.groups"):
            painted(scene, sized({"groups": [-1]}))


class Lasso(unittest.TestCase):
    def test_it_paints_on_whom_it_goes_round(self):
        scene, ids = crowd()
        brush = sized()
        brush.selection = Selection.LASSO
        scene.stroke(brush, [(0, 0), (300, 0), (300, 479), (0, 479)], size=SIZE)
        self.assertEqual(np.flatnonzero(scene.column("height") == 2.0).tolist(), [0, 1, 2])


class Dicts(unittest.TestCase):
    def test_every_brush_comes_back(self):
        for kind in BrushKind.__members__.values():
            with self.subTest(kind):
                brush = Brush(kind)
                brush.radius = 77
                brush.mask.tags = [3, 1]
                brush.distribution = [float(i % 5) for i in range(16)]
                again = Brush.from_dict(json.loads(json.dumps(brush.to_dict())))
                self.assertEqual(again.to_dict(), brush.to_dict())
                self.assertEqual((again.kind, again.radius, again.mask.tags), (kind, 77, [1, 3]))
                self.assertEqual(again, brush)

    def test_what_is_wrong_is_named(self):
        for settings, said in (({}, "brush.brush is missing"), ({"brush": "mop"}, "brush.brush must be one of"),
                               ({"brush": "scale", "radius": -1}, "brush.radius must lie between"),
                               ({"brush": "scale", "radus": 1}, 'brush has no "radus"'),
                               ({"brush": "scale", "radius": float("nan")}, "JSON"),
                               ({"brush": object()}, "JSON"), ({"brush": "m" * 5000}, "must be one of")):
            with self.subTest(said):
                with self.assertRaisesRegex(Error, said):
                    Brush.from_dict(settings)


if __name__ == "__main__":
    unittest.main()
