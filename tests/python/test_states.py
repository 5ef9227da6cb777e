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


if __name__ == "__main__":
    unittest.main()
