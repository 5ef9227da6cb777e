# SPDX-License-Identifier: MIT
"""Runs of the simulation by script: walking, events, rules, poses that are kept, pictures."""
import threading
import unittest

import numpy as np

import crowdbrush

MAN = "builtin:templates/man.glb"
STAR = 3
CLAP = {"id": 1, "name": "clap", "when": {"kind": "event", "event": "show"},
        "do": [{"kind": "tag", "tag": 5}]}
HURRY = {"id": 2, "name": "hurry", "when": {"kind": "event", "event": "hurry"},
         "do": [{"kind": "speed"}]}


def walkers(count=8, rules=(CLAP, HURRY)):
    """People in a row who walk 40 m along X."""
    scene = crowdbrush.Scene()
    man = scene.add_template(MAN)
    scene.set_environment({
        "places": [{"id": 1, "name": "end", "position": [40, 0, 0], "radius": 4}],
        "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}],
        "tags": [{"tag": STAR, "name": "star"}], "rules": list(rules)})
    positions = np.stack([np.zeros(count), np.zeros(count), np.arange(count) - count / 2], axis=1)
    scene.create(template=man, position=positions, path=1, walkSpeed=1.25)
    return scene


def along(session):
    return session.column("position")[:, 0]


class Sessions(unittest.TestCase):
    def test_people_walk_and_the_scene_stays(self):
        scene = walkers()
        before = scene.column("position")
        session = crowdbrush.Session(scene)
        session.run(4)
        self.assertEqual((session.steps, session.seconds, len(session)), (120, 4.0, 8))
        self.assertTrue(np.all((along(session) > 3) & (along(session) < 6)), along(session))
        np.testing.assert_array_equal(session.ids, scene.ids)
        np.testing.assert_array_equal(scene.column("position"), before)
        self.assertEqual(session.problems, [])

    def test_who_has_left_is_said(self):
        scene = walkers(rules=[{"id": 1, "when": {"kind": "event", "event": "home"},
                                "do": [{"kind": "leave scene", "choice": "given"}]}])
        session = crowdbrush.Session(scene)
        self.assertEqual(session.present.tolist(), [True] * 8)
        session.send("home", [2, 3])
        session.run(1)
        np.testing.assert_array_equal(session.ids, scene.ids)
        self.assertEqual(session.ids[~session.present].tolist(), [2, 3])
        self.assertEqual(session.present.dtype, bool)
        self.assertTrue(np.all(session.column("position")[~session.present, 1] < -1000))
        self.assertEqual(session.column("path").tolist(), [1, 0, 0, 1, 1, 1, 1, 1])

    def test_the_path_is_that_of_the_branch_taken(self):
        scene = walkers(count=40)
        scene.set_environment({
            "places": [{"id": 1, "name": "fork", "position": [2, 0, 0], "radius": 4},
                       {"id": 2, "name": "end", "position": [40, 0, 0], "radius": 4},
                       {"id": 3, "name": "side", "position": [0, 0, 40], "radius": 4}],
            "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1, 2],
                       "branches": [{"place": 1, "path": 2, "weight": 1}]},
                      {"id": 2, "name": "aside", "kind": "simple", "places": [3]}]})
        session = crowdbrush.Session(scene)
        self.assertEqual(set(session.column("path").tolist()), {1})
        session.run(25)
        paths = session.column("path")
        self.assertEqual(paths.dtype, scene.column("path").dtype)
        self.assertEqual(set(paths.tolist()), {1, 2})
        self.assertGreater(along(session)[paths == 1].min(), along(session)[paths == 2].max())
        self.assertEqual(set(scene.column("path").tolist()), {1})  # as they began

    def test_the_same_steps_give_the_same_crowd(self):
        crowds = []
        for parts in ((60,), (1, 29, 30)):
            session = crowdbrush.Session(walkers())
            session.send("hurry", [2], number=2.5)
            for count in parts:
                session.step(count)
            crowds.append(session.column("position"))
        np.testing.assert_array_equal(*crowds)

    def test_events_reach_those_who_are_meant(self):
        scene = walkers()
        scene.change([4, 6], tags=1 << STAR)
        session = crowdbrush.Session(scene)
        session.send("hurry", [1, 2], number=3.0)
        session.send_tagged("show", "star")
        session.step()
        self.assertEqual(session.fired, {1: 2, 2: 2})
        self.assertEqual(sorted(session.take_log())[0][1:], (1, 4))
        self.assertEqual(session.take_log(), [])
        session.run(3)
        fast = along(session) > 6
        np.testing.assert_array_equal(session.ids[fast], [1, 2])
        session.send_tagged("show", STAR)
        session.send("show")
        session.step()
        self.assertEqual(session.fired[1], 2 + 2 + 8)

    def test_bad_input_is_said_and_nothing_happens(self):
        session = crowdbrush.Session(walkers())
        for call, said in ((lambda: session.send("show", number=float("nan")), "not finite"),
                           (lambda: session.send("show", [99]), "no individual 99"),
                           (lambda: session.send(""), "needs a name"),
                           (lambda: session.send_tagged("show", "moon"), 'no tag "moon"'),
                           (lambda: session.send_tagged("show", 64), "from 0 to 63"),
                           (lambda: session.step(-1), "0 or more"),
                           (lambda: session.run(float("nan")), "seconds is from"),
                           (lambda: session.column("none"), "none")):
            with self.assertRaisesRegex(crowdbrush.Error, said):
                call()
        session.run(0)
        self.assertEqual((session.steps, session.fired), (0, {}))
        session.step()
        self.assertEqual(session.fired, {})

    def test_edits_reach_a_running_session(self):
        scene = walkers()
        session = crowdbrush.Session(scene)
        session.run(1)
        scene.remove([1])
        ids = scene.create(template=scene.template("man"), position=[5, 0, 20])
        self.assertEqual(len(session), 8)
        self.assertIn(ids[0], session.ids)
        self.assertTrue(along(session)[0] > 0.5)  # who is still there goes on
        scene.change(scene.ids, path=0)
        session.run(1)
        rest = along(session)
        session.run(1)
        np.testing.assert_allclose(along(session), rest, atol=0.01)

    def test_a_pose_is_kept_in_one_step(self):
        scene = walkers()
        session = crowdbrush.Session(scene)
        session.send("show", [3])
        session.run(3)
        shown = session.column("position")
        steps = len(scene.history)
        self.assertEqual(session.keep_pose(), 8)
        np.testing.assert_array_equal(scene.column("position"), shown)
        self.assertEqual(scene.column("tags")[2], 1 << 5)
        self.assertEqual(len(scene.history), steps + 1)
        session.run(1)  # goes on from there
        self.assertTrue(np.all(along(session) > shown[:, 0]))
        scene.undo()
        self.assertTrue(np.all(scene.column("position")[:, 0] == 0))

    def test_pictures_show_what_has_happened(self):
        scene = walkers()
        scene.set_camera("far", crowdbrush.Camera((4, 6, 14), (4, 0, 0)))
        now = scene.render(160, 90)
        later = scene.render(160, 90, time=4.0)
        session = crowdbrush.Session(scene)
        np.testing.assert_array_equal(session.render(160, 90), now)
        session.run(4)
        np.testing.assert_array_equal(session.render(160, 90), later)
        self.assertGreater(np.count_nonzero(np.any(now != later, axis=2)), 100)
        np.testing.assert_array_equal(scene.render(160, 90), now)  # and back

    def test_without_a_window_nobody_plays(self):
        with self.assertRaisesRegex(crowdbrush.Error, r"crowdbrush\.Session\(scene\)"):
            walkers().send("show")

    def test_threads_take_turns(self):
        session = crowdbrush.Session(walkers())
        people = [threading.Thread(target=session.step, args=(30,)) for _ in range(3)]
        people.append(threading.Thread(target=lambda: [session.column("position")
                                                       for _ in range(30)]))
        for each in people:
            each.start()
        for each in people:
            each.join()
        self.assertEqual(session.steps, 90)


if __name__ == "__main__":
    unittest.main()
