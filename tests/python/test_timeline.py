# SPDX-License-Identifier: MIT
"""What happens when in a scene, for scripts."""
import os
import tempfile
import unittest

import crowdbrush
from crowdbrush import Mark


class Timeline(unittest.TestCase):
    def setUp(self):
        self.scene = crowdbrush.open("builtin:scenes/theatre.crowd")

    def test_marks_are_entries_of_the_scene(self):
        self.assertEqual(self.scene.timeline, [])
        self.scene.timeline = [Mark(id=4, name="Curtain", seconds=2.5),
                               Mark(id=2, seconds=0.5, kind="event", event="clap", people=[3, 1])]
        self.assertEqual([each.id for each in self.scene.timeline], [2, 4])
        self.assertEqual((self.scene.timeline[0].people, self.scene.timeline["Curtain"].seconds), ([1, 3], 2.5))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "show.crowd")
            self.scene.save(path)
            self.assertEqual(crowdbrush.open(path).timeline, self.scene.timeline)
        self.scene.undo()
        self.assertEqual(self.scene.timeline, [])

    def test_what_is_sprayed_is_heard_one_after_the_other(self):
        first, second = (int(each) for each in self.scene.ids[:2])
        sprayed = Mark(id=1, seconds=0.5, kind="event", event="clap", people=[first, second], delays=[500, 0])
        self.scene.timeline = [sprayed]
        self.assertEqual(self.scene.timeline[0].delays, [500, 0])
        for wrong in ([-1], [0.5], ["late"], [10 ** 9], 3):
            with self.assertRaisesRegex(crowdbrush.Error, "delays"):
                Mark(id=1, delays=wrong)

    def test_a_part_of_the_time_is_played(self):
        self.scene.set_environment({"playRange": {"begin": 1.0, "end": 2.5, "loop": True}})
        self.assertEqual(self.scene.environment["playRange"], {"begin": 1.0, "end": 2.5, "loop": True})
        with self.assertRaisesRegex(crowdbrush.Error, "playRange.begin"):
            self.scene.set_environment({"playRange": {"begin": -1.0}})
        self.scene.undo()
        self.assertFalse(self.scene.environment.get("playRange", {}).get("loop", False))

    def test_what_is_wrong_is_said(self):
        for wrong, said in (({"seconds": -1}, "seconds must lie between 0 and"),
                            ({"seconds": float("nan")}, "seconds"),
                            ({"kind": "dance"}, "kind must be one of: marker, cue, state, event"),
                            ({"people": [0]}, "people")):
            with self.assertRaisesRegex(crowdbrush.Error, said):
                Mark(id=1, **wrong)
        with self.assertRaisesRegex(crowdbrush.Error, "given twice"):
            self.scene.timeline = [Mark(id=1), Mark(id=1)]
        self.assertEqual(self.scene.timeline, [])

    def test_sessions_do_what_it_says(self):
        ids = self.scene.ids
        self.scene.change(ids, height=1.5)
        self.scene.save_state("tall")
        self.scene.change(ids, height=1.0)
        self.scene.timeline = [Mark(id=1, seconds=1.0, kind="state", state=self.scene.states["tall"].id)]
        session = crowdbrush.Session(self.scene)
        session.run(0.9)
        self.assertTrue((session.column("height") == 1.0).all())
        session.run(0.3)
        self.assertTrue((session.column("height") == 1.5).all())
        self.assertTrue((self.scene.column("height") == 1.0).all())
        self.scene.timeline = [Mark(id=1, seconds=0.5, kind="cue", cue=77)]
        session = crowdbrush.Session(self.scene)
        session.run(1.0)
        self.assertIn("At 0.50 seconds the timeline calls a cue that is not there", session.problems[0])


if __name__ == "__main__":
    unittest.main()
