# SPDX-License-Identifier: MIT
"""States: how people were, kept by name and given back."""
import tempfile
import unittest
from pathlib import Path

import numpy as np

import crowdbrush
from crowdbrush import Error

MAN = "builtin:templates/man.glb"


def crowd(n=20):
    scene = crowdbrush.Scene()
    man = scene.add_template(MAN)
    ids = scene.create(template=man, position=np.column_stack((np.arange(n), np.zeros(n), np.zeros(n))),
                       phase=np.linspace(0, 0.9, n))
    return scene, ids


class States(unittest.TestCase):
    def test_recall_equals_what_was_kept(self):
        scene, ids = crowd()
        before = {name: scene.column(name).tobytes() for name in ("clip", "phase", "tint", "height")}
        scene.save_state("calm")
        scene.change(ids, clip=3, phase=0.5, height=1.2, tint=(1, 2, 3, 255))
        recall = scene.recall_state("calm")
        self.assertEqual((recall.affected, recall.notes), (len(ids), []))
        for name, was in before.items():
            self.assertEqual(scene.column(name).tobytes(), was, name)
        self.assertEqual(scene.history[-1], "Recall a state")
        scene.undo()
        self.assertTrue((scene.column("phase") == 0.5).all())

    def test_columns_and_people_that_are_meant(self):
        scene, ids = crowd()
        scene.save_state("few", columns=["phase", "tint"], ids=ids[2:5])
        few = scene.states["few"]
        self.assertEqual((few.name, len(few), few.ids.tolist()), ("few", 3, ids[2:5].tolist()))
        self.assertEqual(few.columns, [f"tint{i}" for i in range(8)] + ["phase"])
        np.testing.assert_array_equal(few.column("phase"), scene.column("phase")[2:5])
        self.assertEqual(few.column("tint").shape, (3, 8, 4))
        scene.change(ids, phase=0.99, height=1.1)
        scene.recall_state("few", columns=["phase"], ids=[ids[3]])
        self.assertEqual(np.count_nonzero(scene.column("phase") == np.float32(0.99)), len(ids) - 1)
        self.assertTrue((scene.column("height") == np.float32(1.1)).all())
        for name in ("height", "id ", ""):
            with self.assertRaisesRegex(Error, "does not hold"):
                few.column(name)

    def test_they_are_a_mapping(self):
        scene, _ = crowd()
        self.assertEqual((len(scene.states), list(scene.states)), (0, []))
        for name in ("a", "b", "c"):
            scene.save_state(name)
        self.assertEqual(list(scene.states), ["a", "b", "c"])
        self.assertIn("b", scene.states)
        scene.states.rename("b", "wild")
        scene.states.arrange(["c", "a", "wild"])
        del scene.states["a"]
        self.assertEqual(scene.states.keys(), ["c", "wild"])
        with self.assertRaises(KeyError):
            scene.states["a"]
        scene.undo()
        self.assertEqual(list(scene.states), ["c", "a", "wild"])
        scene.save_state("a", columns=["phase"])
        self.assertEqual(list(scene.states), ["c", "a", "wild"])
        self.assertEqual(scene.states["a"].columns, ["phase"])
        text = scene.states.text()
        other, _ = crowd()
        other.states.set_text(text)
        self.assertEqual(other.states.text(), text)

    def test_files_have_them(self):
        scene, ids = crowd()
        scene.save_state("calm")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.crowd"
            scene.save(path)
            again = crowdbrush.open(path)
            self.assertEqual(again.states.text(), scene.states.text())
            again.save(Path(folder) / "again.crowd")
            self.assertEqual((Path(folder) / "again.crowd").read_bytes(), path.read_bytes())

    def test_what_is_wrong_is_said(self):
        scene, ids = crowd()
        scene.save_state("calm")
        steps = len(scene.history)
        for call, said in ((lambda: scene.recall_state("wild"), "no state \"wild\"; there are: calm"),
                           (lambda: scene.save_state(" "), "needs a name"),
                           (lambda: scene.save_state("x", columns=["mood"]), "no column \"mood\""),
                           (lambda: scene.save_state("x", columns=[]), "names none"),
                           (lambda: scene.save_state("x", ids=[99]), "no individual 99|99"),
                           (lambda: scene.recall_state("calm", ids=[99]), "99"),
                           (lambda: scene.states.rename("calm", ""), "needs a name"),
                           (lambda: scene.states.rename("x", "y"), "no state"),
                           (lambda: scene.states.arrange([]), "\"calm\" is not among them"),
                           (lambda: scene.states.arrange(["calm", "calm"]), "no state"),
                           (lambda: scene.states.__delitem__("x"), "no state"),
                           (lambda: scene.states.set_text("{"), "damaged")):
            with self.subTest(said), self.assertRaisesRegex(Error, said):
                call()
        self.assertEqual(len(scene.history), steps)

    def test_people_who_are_gone(self):
        scene, ids = crowd()
        scene.save_state("calm")
        scene.remove(ids[:5])
        scene.change(ids[5:], phase=0.99)
        self.assertEqual(scene.recall_state("calm").affected, len(ids) - 5)
        self.assertEqual(len(scene.states["calm"]), len(ids))

    def test_in_an_edit_of_several_steps(self):
        scene, ids = crowd()
        with scene.edit("both"):
            scene.save_state("calm")
            scene.change(ids, phase=0.99)
            scene.recall_state("calm")
        self.assertEqual(scene.history[-1], "both")
        scene.undo()
        self.assertEqual(len(scene.states), 0)

    def test_they_change_over_in_sessions(self):
        scene, ids = crowd()
        scene.change(ids, height=1.0)
        scene.save_state("small")
        scene.change(ids, height=2.0)
        session = crowdbrush.Session(scene)
        session.step(2)
        recall = scene.recall_state("small", 2.0)
        self.assertEqual((recall.affected, scene.history[-1]), (len(ids), "Recall a state"))
        self.assertTrue((scene.column("height") == 1.0).all())
        self.assertTrue((session.column("height") == 2.0).all())
        session.run(1.0)
        np.testing.assert_allclose(session.column("height"), 1.5, atol=0.01)
        session.run(1.1)
        self.assertTrue((session.column("height") == 1.0).all())

    def test_waves_in_a_session_alone(self):
        scene, ids = crowd()
        scene.save_state("small")
        scene.change(ids, height=2.0)
        scene.save_state("tall", columns=["height"])
        scene.undo()
        scene.undo()
        scene.redo()
        scene.save_state("tall", columns=["height"])
        scene.change(ids, height=1.0)
        session = crowdbrush.Session(scene)
        steps = len(scene.history)
        wave = crowdbrush.Stagger(10.0, point=(0, 0, 0))  # they stand along X, a metre apart
        self.assertEqual(session.recall_state("tall", stagger=wave).affected, len(ids))
        session.run(5.0)
        tall = session.column("height") == 2.0
        self.assertTrue(tall[:9].all() and not tall[11:].any(), tall)
        session.recall_state("tall", ids=ids[-2:])
        self.assertTrue((session.column("height")[-2:] == 2.0).all())
        self.assertEqual(len(scene.history), steps)
        self.assertTrue((scene.column("height") == 1.0).all())
        self.assertEqual(session.keep_pose(), 0)  # nobody is elsewhere, but they are tall
        self.assertTrue((scene.column("height")[:9] == 2.0).all())

    def test_staggers(self):
        stagger = crowdbrush.Stagger(3.0, "heading", heading=1.5)
        self.assertEqual((stagger.seconds, stagger.order, stagger.heading), (3.0, "heading", 1.5))
        stagger.order = "row"
        with self.assertRaises(Error):
            stagger.order = "up"
        for bad in (dict(seconds=-1.0), dict(seconds=float("nan")), dict(seconds=1e9),
                    dict(seconds=1.0, order="upwards"), dict(seconds=1.0, heading=float("inf")),
                    dict(seconds=1.0, point=(0, 1e30, 0))):
            with self.assertRaises(Error, msg=str(bad)):
                crowdbrush.Stagger(**bad)
        scene, ids = crowd(3)
        scene.save_state("a")
        session = crowdbrush.Session(scene)
        for target in (scene, session):
            for wrong in (dict(name="b"), dict(name="a", seconds=-1.0), dict(name="a", seconds=float("nan")),
                          dict(name="a", ids=[99]), dict(name="a", columns=["mood"])):
                with self.assertRaises(Error, msg=str(wrong)):
                    target.recall_state(**wrong)
            with self.assertRaises(TypeError):
                target.recall_state("a", 1.0, "wave")
        self.assertEqual(scene.history[-1], "Keep a state")

    def test_the_restore_brush_gives_them_back(self):
        scene, ids = crowd()
        scene.change(ids, height=1.25)
        scene.save_state("small")
        scene.change(ids, height=2.0, phase=0.9)
        brush = crowdbrush.Brush(crowdbrush.BrushKind.RESTORE)
        brush.selection = crowdbrush.Selection.RECTANGLE
        brush.through = True
        brush.restore.source = "STATE"
        scene.set_camera("Front", crowdbrush.Camera((10, 6, 22), (10, 0.9, 0)))

        def stroke():
            return scene.stroke(brush, [(0, 0), (639, 479)], size=(640, 480), seed=7)
        outcome = stroke()
        self.assertEqual((outcome.affected, outcome.message), (0, "Choose a state in the brush's settings first"))
        brush.restore.state = scene.states["small"].id
        self.assertGreater(stroke().affected, 10)
        self.assertIn(np.float32(1.25), scene.column("height"))
        brush.restore.state = 77
        with self.assertRaisesRegex(Error, "restore.state is 77"):
            stroke()

    def test_rules_and_cues_name_them(self):
        scene, ids = crowd(6)
        scene.save_state("small")
        state = scene.states["small"].id
        scene.change(ids, height=2.0)
        scene.cues = [crowdbrush.Cue(id=1, name="Calm", state=state, seconds=2.0, spread=3.0, order="row")]
        self.assertEqual((scene.cues[0].state, scene.cues[0].order), (state, "row"))
        scene.rules = [crowdbrush.Rule(id=1, name="calm", when=crowdbrush.triggers.Event(event="calm"),
                                       do=[crowdbrush.actions.State(state=state)]),
                       crowdbrush.Rule(id=2, name="heard", when=crowdbrush.triggers.State(state=state),
                                       do=[crowdbrush.actions.Tag(tag=4)])]
        session = crowdbrush.Session(scene)
        session.send("calm", ids[:2])
        session.step(6)
        np.testing.assert_array_equal(session.column("height"), [1, 1, 2, 2, 2, 2])
        np.testing.assert_array_equal(session.column("tags"), [16, 16, 0, 0, 0, 0])
        del scene.states["small"]
        scene.save_state("other")
        self.assertNotEqual(scene.states["other"].id, state)  # rules still mean the one that is gone


if __name__ == "__main__":
    unittest.main()
