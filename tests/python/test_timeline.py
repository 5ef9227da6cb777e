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

    def test_the_camera_moves(self):
        self.scene.set_cameras([("front", crowdbrush.Camera((0, 2, 20), (0, 2, 0))),
                                ("top", crowdbrush.Camera((0, 30, 1), (0, 0, 0)))])
        self.assertEqual(self.scene.camera_at(5.0), self.scene.cameras["front"])
        self.scene.timeline = [Mark(id=1, seconds=2.0, kind="camera", camera="top"),
                               Mark(id=2, seconds=4.0, kind="camera", move="around", travel=8.0, gentle=False)]
        self.assertEqual(self.scene.camera_at(1.0), self.scene.cameras["front"])
        self.assertEqual(self.scene.camera_at(3.0), self.scene.cameras["top"])
        self.assertAlmostEqual(self.scene.camera_at(8.0).position[2], -1.0, places=3)
        directed = self.scene.render(64, 36, time=3.0)
        self.assertTrue((directed == self.scene.render(64, 36, camera="top", time=3.0)).all())
        self.assertFalse((directed == self.scene.render(64, 36, camera="front", time=3.0)).all())
        with self.assertRaisesRegex(crowdbrush.Error, "week"):
            self.scene.camera_at(float("inf"))

    def test_movies_are_made(self):
        self.scene.set_cameras([("front", crowdbrush.Camera((0, 2, 20), (0, 2, 0))),
                                ("top", crowdbrush.Camera((0, 30, 1), (0, 0, 0)))])
        self.scene.timeline = [Mark(id=1, seconds=0.5, kind="camera", camera="top")]
        shares = []
        with tempfile.TemporaryDirectory() as folder:
            pattern = os.path.join(folder, "f_##.png")
            written = self.scene.make_movie(pattern, [0, 1, 3], fps=4, width=32, height=18, progress=shares.append)
            self.assertEqual([os.path.basename(path) for path in written], ["f_00.png", "f_01.png", "f_03.png"])
            self.assertEqual(sorted(os.listdir(folder)), ["f_00.png", "f_01.png", "f_03.png"])
            self.assertTrue(shares == sorted(shares) and shares[-1] == 1.0)
            movie = os.path.join(folder, "a.gif")
            self.assertEqual(self.scene.make_movie(movie, range(3), fps=2, width=32, height=18), [movie])
            self.assertGreater(os.path.getsize(movie), 100)
            exr = os.path.join(folder, "p.exr")
            passes = self.scene.make_movie(exr, [2], fps=4, width=32, height=18, passes=["motion"], transparent=True)
            self.assertEqual(passes, [os.path.join(folder, "p_0002.exr")])
            with open(passes[0], "rb") as file:
                self.assertIn(b"backward.u", file.read())
            for wrong, said in (((pattern, []), "names none"), ((pattern, [1, 1]), "must rise"),
                                ((pattern, [-1]), "must rise"), ((movie, [0, 1], {"transparent": True}), "transparent"),
                                ((pattern, [0], {"fps": 0}), "fps"), ((movie, [0], {"passes": ["id"]}), "room"),
                                ((pattern, [0], {"passes": ["smell"]}), "smell"),
                                ((pattern, [10**8], {"fps": 1}), "week")):
                with self.assertRaisesRegex(crowdbrush.Error, said):
                    self.scene.make_movie(*wrong[:2], width=8, height=8, **(wrong[2] if len(wrong) > 2 else {}))

    def test_pictures_are_transparent(self):
        picture = self.scene.render(64, 36, camera=crowdbrush.Camera((0, 20, 60), (0, 25, 0)), transparent=True)
        self.assertTrue((picture[0, :, 3] == 0).all() and picture[:, :, 3].max() == 255)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            picture.save_png(path, transparent=True)
            with open(path, "rb") as file:
                self.assertEqual(file.read()[25], 6)  # colours with alpha

    def test_what_is_wrong_is_said(self):
        for wrong, said in (({"seconds": -1}, "seconds must lie between 0 and"),
                            ({"seconds": float("nan")}, "seconds"),
                            ({"kind": "dance"}, "kind must be one of: marker, cue, state, event, camera"),
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
