# SPDX-License-Identifier: MIT
"""Relations between people in scripts."""
import os
import random
import tempfile
import unittest

import numpy

import crowdbrush
from crowdbrush import BrushKind, Error, RelationKind, Selection


def street(count=12):
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    places = [(1.0 * (i % 4), 0.0, 1.0 * (i // 4)) for i in range(count)]
    return scene, scene.create(template=man, position=places)


class Relations(unittest.TestCase):
    def test_relate_asks_and_takes_away(self):
        scene, ids = street()
        self.assertEqual(scene.relate(ids[:3], ids[3:6], "friends", strength=[0.25, 0.5, 1.0]), 3)
        self.assertEqual(scene.relate(ids[0], ids[6:9], "leader"), 3)
        self.assertEqual(scene.relate(ids[3], ids[0], "friends", strength=0.25), 0)  # it is mutual
        self.assertEqual(scene.related(ids[0]).tolist(), [ids[3], *ids[6:9]])
        self.assertEqual(scene.related([ids[3], ids[4]], "friends").tolist(), [ids[0], ids[1]])
        self.assertEqual(scene.related(ids[6]).tolist(), [])  # he leads nobody
        arrays = scene.relations
        self.assertEqual(arrays["from"].dtype, numpy.uint32)
        self.assertEqual(sorted(set(arrays["name"])), ["friends", "leader"])
        self.assertEqual(arrays["strength"][arrays["name"] == "friends"].tolist(), [0.25, 0.5, 1.0])
        self.assertEqual(scene.unrelate(ids[3], ids[0]), 1)
        self.assertEqual(scene.unrelate(ids[0], name="leader"), 3)
        self.assertEqual(len(scene.relations["from"]), 2)
        scene.undo()
        self.assertEqual(len(scene.relations["from"]), 5)
        scene.relate(ids[6], ids[0], "leader")  # each leads the other
        self.assertEqual(scene.unrelate(ids[6], ids[0], "leader"), 1)
        self.assertEqual(scene.related(ids[0], "leader").tolist(), ids[6:9].tolist())
        scene.undo(), scene.undo()
        scene.undo(), scene.undo(), scene.undo()
        self.assertEqual(len(scene.relations["from"]), 0)

    def test_what_does_not_fit_is_refused(self):
        scene, ids = street()
        before = scene.relations
        for arguments, said in (((ids[0], ids[1], "enemies"), "enemies"),
                                ((ids[0], 9999, "friends"), "9999"),
                                ((ids[0], ids[0], "friends"), "itself"),
                                ((ids[:2], ids[2:5], "friends"), "as long as"),
                                ((ids[0], ids[1], "friends", 1.5), "strength"),
                                ((ids[0], ids[1], "friends", float("nan")), "strength"),
                                ((ids[0], ids[1], "friends", 1e30), "strength"),
                                ((ids[0], ids[1], "friends", "much"), "strength")):
            with self.assertRaisesRegex(Error, said):
                scene.relate(*arguments)
        with self.assertRaisesRegex(Error, "enemies"):
            scene.related(ids[0], "enemies")
        with self.assertRaisesRegex(Error, "9999"):
            scene.unrelate(9999)
        self.assertEqual(len(scene.relations["from"]), len(before["from"]))
        self.assertEqual(scene.relate([], [], "friends"), 0)

    def test_kinds_are_a_mapping(self):
        scene, ids = street()
        self.assertEqual(list(scene.relation_kinds), ["family", "friends", "couple", "leader", "rivals"])
        scene.relation_kinds["neighbours"] = RelationKind(color="#102030", shares_colors=True)
        self.assertTrue(scene.relation_kinds["neighbours"].mutual)
        scene.relate(ids[0], ids[1], "neighbours")
        del scene.relation_kinds["neighbours"]
        self.assertEqual(len(scene.relations["from"]), 0)
        scene.undo()
        self.assertEqual(scene.relations["name"].tolist(), ["neighbours"])
        with self.assertRaises(KeyError):
            scene.relation_kinds["enemies"]

    def test_they_do_something_while_it_plays(self):
        scene, ids = street(4)
        scene.change(ids, heading=0.0)
        scene.relate(ids[0], ids[1], "friends")  # a metre apart
        session = crowdbrush.Session(scene)
        session.step(90)
        headings = session.column("heading")
        self.assertGreater(abs(headings[0]), 1.4)
        self.assertLess(abs(headings[2]), 0.1)
        kind = scene.relation_kinds["friends"]
        kind.faces = False
        kind.walk = "apart"
        scene.relation_kinds["friends"] = kind
        self.assertEqual(scene.relation_kinds["friends"].walk, "apart")
        with self.assertRaisesRegex(Error, "walk"):
            kind.walk = "backwards"

    def test_rules_speak_of_them(self):
        scene, ids = street(4)
        scene.relate(ids[0], ids[1], "family")
        family = scene.relation_kinds["family"]
        scene.rules += [crowdbrush.Rule(id=1, when=crowdbrush.triggers.Event(event="go"), do=[
            crowdbrush.actions.Send(event="psst", reach="related", relation=family)]),
            crowdbrush.Rule(id=2, when=crowdbrush.triggers.Event(event="psst"),
                            do=[crowdbrush.actions.Tag(tag=3)])]
        session = crowdbrush.Session(scene)
        session.send("go", ids=ids[:1])
        session.step(6)
        self.assertEqual((session.column("tags") >> 3 & 1).tolist(), [0, 1, 0, 0])

    def test_copies_of_a_family_are_one(self):
        scene, ids = street()
        scene.relate(ids[0], ids[1:3], "family")
        copies = scene.duplicate(ids[:3], offset=(0, 0, 9))
        self.assertEqual(scene.related(copies[0], "family").tolist(), copies[1:].tolist())
        self.assertEqual(scene.related(ids[0], "family").tolist(), ids[1:3].tolist())
        scene.remove(copies)
        self.assertEqual(len(scene.relations["from"]), 2)

    def test_the_brush_relates(self):
        scene, ids = street()
        brush = crowdbrush.Brush(BrushKind.RELATION)
        brush.selection = Selection.RECTANGLE
        brush.through = True
        brush.relation.relation = "family"
        brush.relation.how = "family"
        brush.relation.metres = 5.0
        camera = crowdbrush.Camera((2, 12, 12), (1.5, 0, 1))
        done = scene.stroke(brush, [(0, 0), (1279, 719)], camera=camera)
        self.assertTrue(done)
        self.assertEqual(set(scene.relations["name"]), {"family"})
        brush.relation.relation = "enemies"
        with self.assertRaisesRegex(Error, "enemies"):
            scene.stroke(brush, [(0, 0), (1279, 719)], camera=camera)

    def test_random_steps_come_back(self):
        scene, ids = street(40)
        draw = random.Random(5)
        texts = []

        def text():
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "a.crowd")
                scene.save(path)
                with open(path, encoding="utf-8") as file:
                    written = file.read()
                self.assertEqual(len(crowdbrush.open(path).relations["from"]), len(scene.relations["from"]))
                return written

        texts.append(text())
        for _ in range(25):
            people = scene.column("id")
            some = numpy.array(draw.sample(list(people), 6), dtype=numpy.uint32)
            kind = draw.choice(list(scene.relation_kinds))
            step = draw.choice(("relate", "relate", "unrelate", "remove", "duplicate", "feature"))
            if step == "relate":
                scene.relate(some[:3], some[3:], kind, strength=[draw.random() for _ in range(3)])
            elif step == "unrelate":
                scene.unrelate(some)
            elif step == "remove":
                scene.remove(some[:1])
            elif step == "duplicate":
                scene.duplicate(some)
            else:
                scene.set_feature(some, "emotion", draw.choice(list(scene.features["emotion"])))
            if text() != texts[-1]:
                texts.append(text())
        for expected in reversed(texts[:-1]):
            scene.undo()
            self.assertEqual(text(), expected)
        for expected in texts[1:]:
            scene.redo()
            self.assertEqual(text(), expected)


if __name__ == "__main__":
    unittest.main()
