# SPDX-License-Identifier: MIT
"""Brushes that scripts bring along."""
import dataclasses
import enum
import unittest
from typing import Annotated, ClassVar, Literal

import numpy as np

import crowdbrush
from crowdbrush import Selection

SIZE = (640, 360)
ACROSS = [(60 + 5.2 * i, 180, 1.0, i / 60) for i in range(101)]
EVERYBODY = [(0, 0), (640, 360)]


def theatre():
    return crowdbrush.open("builtin:scenes/theatre.crowd")


class Wave:
    """Turns people by a wave that runs through the rows."""

    selection = Selection.RECTANGLE
    through = True
    amplitude: Annotated[float, crowdbrush.Range(0, 3)] = 0.5

    def apply(self, selection):
        x = selection.column("position")[:, 0]
        selection.change(heading=selection.column("heading") + self.amplitude * np.sin(x))


class Strokes(unittest.TestCase):
    def test_changes_those_under_it_in_one_step(self):
        scene = theatre()
        before = scene.column("heading")
        outcome = scene.stroke(Wave(), EVERYBODY, size=SIZE)
        self.assertTrue(outcome.committed)
        self.assertGreater(outcome.affected, 20)
        self.assertEqual(len(scene.history), 1)
        self.assertIn("Wave", scene.history[0])
        self.assertGreater(np.count_nonzero(scene.column("heading") != before), 20)
        self.assertTrue(scene.undo())
        np.testing.assert_array_equal(scene.column("heading"), before)

    def test_dabs_reach_everybody_once_and_can_build_up(self):
        class Count:
            radius = 30

            def __init__(self):
                self.dabs = []

            def apply(self, selection):
                self.dabs.append(selection.ids)
                selection.change(phase=selection.random.random(len(selection)))

        scene = theatre()
        once = Count()
        outcome = scene.stroke(once, ACROSS, size=SIZE, seed=4)
        all_ids = np.concatenate(once.dabs)
        self.assertGreater(len(once.dabs), 3)
        self.assertEqual(len(all_ids), len(np.unique(all_ids)))
        self.assertEqual(outcome.affected, len(all_ids))
        phases = scene.column("phase").tobytes()
        scene.undo()
        scene.stroke(Count(), ACROSS, size=SIZE, seed=4)
        self.assertEqual(scene.column("phase").tobytes(), phases)
        scene.undo()
        again = Count()
        again.build_up = True
        scene.stroke(again, ACROSS, size=SIZE, seed=4)
        all_ids = np.concatenate(again.dabs)
        self.assertGreater(len(all_ids), len(np.unique(all_ids)))

    def test_may_create_and_remove(self):
        class Clone:
            radius = 200

            def apply(self, selection):
                place = selection.column("position") + np.float32([0, 3, 0])
                selection.scene.create(template=selection.column("template"), position=place)
                selection.remove()

        scene = theatre()
        before = len(scene)
        outcome = scene.stroke(Clone(), [(320, 180)], size=SIZE)
        self.assertGreater(outcome.affected, 1)
        self.assertEqual(len(scene), before)
        self.assertEqual(len(scene.history), 1)

    def test_an_exception_takes_the_stroke_back(self):
        class Broken:
            selection = Selection.RECTANGLE

            def apply(self, selection):
                selection.change(heading=1.0)
                raise KeyError("no more")

        scene = theatre()
        before = scene.column("heading")
        with self.assertRaises(KeyError):
            scene.stroke(Broken(), EVERYBODY, size=SIZE)
        np.testing.assert_array_equal(scene.column("heading"), before)
        self.assertEqual(scene.history, [])
        scene.stroke(Wave(), EVERYBODY, size=SIZE)  # nothing is left open
        self.assertEqual(len(scene.history), 1)

    def test_what_belongs_to_no_stroke_is_refused(self):
        class Undoing:
            selection = Selection.RECTANGLE

            def apply(self, selection):
                for act in (selection.scene.undo, lambda: selection.scene.save("/tmp/never.crowd"),
                            lambda: selection.scene.stroke(Wave(), EVERYBODY),
                            lambda: selection.scene.edit("in it").__enter__()):
                    with_error(act)

        def with_error(act):
            with self.assertRaises(crowdbrush.Error) as caught:
                act()
            self.assertIn("brush", str(caught.exception))

        outcome = theatre().stroke(Undoing(), EVERYBODY, size=SIZE)
        self.assertFalse(outcome.committed)
        self.assertIn("nothing", outcome.message)

    def test_operators_give_a_value_each(self):
        def face_the_aisle(selection):
            return {"heading": np.arctan2(-selection.column("position")[:, 0], 1.0)}

        class Sleepy:
            selection = Selection.RECTANGLE
            speed: float = 0.25

            def values(self, selection):
                return {"speed": self.speed}

        scene = theatre()
        self.assertGreater(scene.stroke(face_the_aisle, [(320, 180)], size=SIZE).affected, 0)
        self.assertIn("Face the aisle", scene.history[0])
        outcome = scene.stroke(Sleepy(), EVERYBODY, size=SIZE)
        self.assertEqual(np.count_nonzero(scene.column("speed") == np.float32(0.25)), outcome.affected)

    def test_refuses_what_is_no_brush(self):
        scene = theatre()
        for wrong in (3, "wave", object()):
            with self.assertRaises(TypeError):
                scene.stroke(wrong, EVERYBODY)
        with self.assertRaises(crowdbrush.Error):
            scene.stroke(crowdbrush.Brush(crowdbrush.BrushKind.SCRIPT), EVERYBODY)

    def test_a_selection_outlives_its_stroke_harmlessly(self):
        kept = []
        scene = theatre()
        scene.stroke(lambda_brush(kept), [(320, 180)], size=SIZE)
        kept[0].progress(0.5)
        kept[0].change(heading=1.0)  # an edit of its own
        self.assertEqual(len(scene.history), 2)


def lambda_brush(kept):
    def keep(selection):
        kept.append(selection)
        return {"phase": 0.5}

    keep.radius = 120
    return keep


class Mood(enum.Enum):
    CALM = 1
    WILD = 2


class Registering(unittest.TestCase):
    def setUp(self):
        self.told = []
        crowdbrush._tell_editor = lambda *said: self.told.append(said)

    def tearDown(self):
        crowdbrush._tell_editor = None

    def test_settings_come_from_typed_attributes(self):
        @crowdbrush.register_brush
        @dataclasses.dataclass
        class PartyBrush:
            """Makes a party.

            Not shown."""

            radius = 77
            shared: ClassVar[int] = 3
            loud: bool = True
            guests: int = 5
            tempo: Annotated[float, crowdbrush.Range(0.5, 2, step=0.5)] = 1.0
            mood: Mood = Mood.WILD
            style: Literal["disco", "waltz"] = "waltz"
            colour: "tuple[int, int, int]" = (255, 0, 9)
            motto: str = "hey"
            _secret: int = 1

            def apply(self, selection):
                pass

        name, tip, area, fields = self.told[0]
        self.assertEqual((name, tip, area.radius), ("Party", "Makes a party.", 77))
        self.assertIs(crowdbrush.brushes["Party"], PartyBrush)
        self.assertEqual([f[0] for f in fields],
                         ["loud", "guests", "tempo", "mood", "style", "colour", "motto"])
        self.assertEqual([f[1] for f in fields],
                         [True, 5, 1.0, "WILD", "waltz", (255, 0, 9), "hey"])
        self.assertEqual(fields[2][2:6], (0.5, 2.0, 0.5, 2))
        self.assertEqual(fields[3][6], ["CALM", "WILD"])
        made = crowdbrush._brush_with(PartyBrush, {"mood": "CALM", "style": "disco", "guests": 8})
        self.assertEqual((made.mood, made.style, made.guests), (Mood.CALM, "disco", 8))

    def test_refuses_what_cannot_be_set(self):
        class NoValue:
            speed: float

            def apply(self, selection):
                pass

        class Odd:
            speed: complex = 1j

            def apply(self, selection):
                pass

        for wrong in (NoValue, Odd, type("Empty", (), {}), 3):
            with self.subTest(brush=wrong), self.assertRaises(TypeError):
                crowdbrush.register_brush(wrong)
        self.assertEqual(self.told, [])


if __name__ == "__main__":
    unittest.main()
