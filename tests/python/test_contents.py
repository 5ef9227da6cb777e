# SPDX-License-Identifier: MIT
"""Templates, stages, cameras and light by script; strokes with the time that was shown."""
import pathlib
import tempfile
import unittest

import numpy as np

import crowdbrush

MAN = "builtin:templates/man.glb"


def saved(scene):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.crowd"
        scene.save(path)
        return path.read_bytes()


class Contents(unittest.TestCase):
    def undone_and_redone(self, scene, change):
        before = saved(scene)
        change()
        after = saved(scene)
        self.assertNotEqual(before, after)
        scene.undo()
        self.assertEqual(saved(scene), before)
        scene.redo()
        self.assertEqual(saved(scene), after)

    def test_templates_come_change_and_go(self):
        scene = crowdbrush.Scene()
        self.undone_and_redone(scene, lambda: scene.add_template(MAN, "tall", scale=1.5, id=7))
        tall = scene.template("tall")
        self.assertEqual(tall.id, 7)
        plain = scene.add_template(MAN)
        self.assertAlmostEqual(tall.height_m, 1.5 * plain.height_m, places=3)
        self.undone_and_redone(scene, lambda: scene.change_template(tall, name="huge", scale=2.0))
        self.assertAlmostEqual(scene.template("huge").height_m, 2 * plain.height_m, places=3)
        speeds = [None] * len(tall.clips)
        speeds[1] = 2.25
        self.undone_and_redone(scene, lambda: scene.change_template(7, clip_speeds=speeds))
        self.assertEqual(tall.clips[1].speed, 2.25)
        scene.create(template=plain, position=[0, 0, 0])
        with self.assertRaisesRegex(crowdbrush.Error, "remove them first"):
            scene.remove_template(plain)
        self.undone_and_redone(scene, lambda: scene.remove_template(tall))
        for call in (lambda: scene.remove_template(99), lambda: scene.change_template(99, name="x"),
                     lambda: scene.add_template(MAN, id=plain.id),
                     lambda: scene.change_template(plain, scale=0),
                     lambda: scene.change_template(plain, path="/none.glb")):
            steps = len(scene.history)
            with self.assertRaises(crowdbrush.Error):
                call()
            self.assertEqual(len(scene.history), steps)

    def test_stages_come_change_and_go(self):
        scene = crowdbrush.Scene()
        self.undone_and_redone(scene, lambda: scene.add_stage("builtin:stages/theatre.glb"))
        stage = scene.stages[0]
        self.undone_and_redone(
            scene, lambda: scene.change_stage(stage, name="Big", position=(1, 0, 2), scale=1.25))
        self.assertEqual((scene.stages[0].name, scene.stages[0].position), ("Big", [1, 0, 2]))
        self.undone_and_redone(scene, lambda: scene.remove_stage(stage))
        with self.assertRaises(crowdbrush.Error):
            scene.remove_stage(stage)

    def test_cameras_and_light(self):
        scene = crowdbrush.Scene()
        one = crowdbrush.Camera((0, 5, 10), (0, 0, 0))
        two = crowdbrush.Camera.exact((1, 2, 3), (1, 0, 0, 0), orthographic=True, height=7.5,
                                      fov_radians=0.5, pivot_distance=3.25)
        self.undone_and_redone(scene, lambda: scene.set_cameras([("b", one), ("a", two)]))
        self.assertEqual(list(scene.cameras), ["b", "a"])
        self.assertEqual(scene.cameras["a"], two)
        again = scene.cameras["b"]
        self.assertEqual(again, crowdbrush.Camera.exact(
            again.position, again.orientation, orthographic=again.orthographic,
            fov_radians=again.fov_radians, height=again.height, pivot_distance=again.pivot_distance))
        self.undone_and_redone(scene, lambda: scene.remove_camera("b"))
        self.undone_and_redone(scene, lambda: scene.set_lighting(
            crowdbrush.Lighting(sun_strength=0.25, sky_zenith=(0.1, 0.2, 0.3), ground_grid=False)))
        self.assertEqual(scene.lighting.sun_strength, 0.25)
        with self.assertRaises(crowdbrush.Error):
            scene.remove_camera("b")
        with self.assertRaises(crowdbrush.Error):
            crowdbrush.Camera.exact((0, 0, 0), (2, 0, 0, 0))
        with self.assertRaises(crowdbrush.Error):
            crowdbrush.Lighting(sun_strength=float("nan"))
        with self.assertRaisesRegex(crowdbrush.Error, "sun_azimuth is 1e.30; it must lie from -1e.06 to 1e.06"):
            crowdbrush.Lighting(sun_azimuth=1e30)

    def test_light_is_what_is_described_of_it(self):
        scene = crowdbrush.Scene()
        light = scene.lighting
        self.assertGreater(light.shadow_strength, 0)  # as new scenes are
        light.sun_strength = 0.5  # a copy
        self.assertNotEqual(scene.lighting.sun_strength, 0.5)
        scene.set_lighting(light)
        self.assertEqual(scene.lighting.sun_strength, 0.5)
        self.assertEqual(crowdbrush.Lighting().shadow_strength, 0)  # as files without it are
        with self.assertRaisesRegex(TypeError, "no argument 'moon'"):
            crowdbrush.Lighting(moon=1)
        light.shadow_strength = 1.5
        with self.assertRaisesRegex(crowdbrush.Error, "shadow_strength is 1.5; it must lie from 0 to 1"):
            scene.set_lighting(light)
        self.assertEqual(scene.lighting.shadow_strength, crowdbrush.Scene().lighting.shadow_strength)
        for key in ("noon", "afternoon", "dusk", "overcast", "night"):
            self.undone_and_redone(scene, lambda: scene.set_lighting(crowdbrush.Lighting.ready(key)))
        with self.assertRaisesRegex(crowdbrush.Error, "noon, afternoon, dusk, overcast, night"):
            crowdbrush.Lighting.ready("dawn")

    def test_light_of_an_hour(self):
        noon, night = crowdbrush.Lighting.of_day(12), crowdbrush.Lighting.of_day(23.5, haze=.5)
        self.assertGreater(noon.sun_strength, 3 * night.sun_strength)
        self.assertGreater(noon.sky_horizon[0], night.sky_horizon[0] + .4)
        self.assertEqual(night.haze, .5)
        self.assertFalse(hasattr(noon, "day_hours"))  # it is where the sun stands
        scene = crowdbrush.Scene()
        self.undone_and_redone(scene, lambda: scene.set_lighting(night))
        for wrong in (dict(hours=float("nan")), dict(hours=12, haze=1), dict(hours=12, haze=-.1),
                      dict(hours=12, haze=float("nan"))):
            with self.assertRaisesRegex(crowdbrush.Error, "hours|haze"):
                crowdbrush.Lighting.of_day(**wrong)

    def test_what_files_refuse_scripts_refuse(self):
        for camera, said in ((dict(fov_radians=0), "fov_radians is 0; it must lie from 0.01 to 3.1"),
                             (dict(fov_radians=float("nan")), "fov_radians"),
                             (dict(height=-1), "height is -1"),
                             (dict(pivot_distance=0), "pivot_distance is 0")):
            with self.assertRaisesRegex(crowdbrush.Error, said):
                crowdbrush.Camera.exact((0, 0, 0), (1, 0, 0, 0), **camera)
        scene = crowdbrush.Scene()
        stage = "builtin:stages/theatre.glb"
        for placed, said in ((dict(scale=0), "scale is 0"), (dict(scale=1e30), "scale is 1e.30"),
                             (dict(heading=1e30), "heading"), (dict(position=(0, 2e6, 0)), "position")):
            with self.assertRaisesRegex(crowdbrush.Error, said):
                scene.add_stage(stage, **placed)
        self.assertEqual(len(scene.stages), 0)
        with self.assertRaisesRegex(crowdbrush.Error, "ground_offset is 1e.30"):
            scene.add_template("builtin:templates/man.glb", ground_offset=1e30)

    def test_places_paths_tags_and_rules(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        scene.create(template=man, position=np.zeros((3, 3)), count=3)
        places = [{"id": i, "name": f"p{i}", "position": [i, 0, 0.1], "radius": 1.5} for i in (1, 2, 3)]
        paths = [{"id": 4, "name": "round", "kind": "cyclic", "places": [1, 2, 3]}]
        self.undone_and_redone(scene, lambda: scene.set_environment({"places": places, "paths": paths}))
        self.assertEqual([p["id"] for p in scene.environment["places"]], [1, 2, 3])
        self.undone_and_redone(scene, lambda: scene.change([2], path=4, walkSpeed=1.25))
        self.undone_and_redone(scene, lambda: scene.set_environment({"paths": []}))
        np.testing.assert_array_equal(scene.column("path"), [0, 0, 0])
        scene.undo()
        same = scene.environment
        steps = len(scene.history)
        scene.set_environment(same)
        self.assertEqual(len(scene.history), steps)
        for wrong in ({"places": 3}, {"people": []}, "[", {"places": [{"id": 1}, {"id": 1}]},
                      {"paths": [{"id": 4, "places": [99]}]}):
            with self.subTest(wrong=wrong), self.assertRaises(crowdbrush.Error):
                scene.set_environment(wrong)
        for column, value in (("path", 77), ("walkSpeed", -1.0), ("walkSpeed", 99.0)):
            with self.assertRaises(crowdbrush.Error):
                scene.change([1], **{column: value})
        self.assertEqual(scene.environment, same)

    def test_numbers_cues_surface_and_the_newer_rules(self):
        scene = crowdbrush.Scene()
        wanted = {
            "numbers": [{"id": 2, "name": "patience", "low": 1, "high": 4}],
            "cues": [{"id": 1, "name": "Go", "event": "go", "key": "F4", "reach": "tagged", "tag": 3}],
            "surface": {"radius": 0.5, "height": 2, "climb": 0.25, "slope": 30},
            "places": [{"id": 1, "position": [0, 0, 0], "capacity": 4, "role": "forbidden"}],
            "rules": [{"id": 1, "name": "sit", "yields": "anybody",
                       "when": {"kind": "speed limit", "metresPerSecond": 2.5, "above": False},
                       "if": [{"kind": "number", "number": 2, "compare": "less", "value": 3}],
                       "do": [{"kind": "sit down"}, {"kind": "wait for event", "event": "up"},
                              {"kind": "go to", "choice": "nearest free", "place": 1}]}]}
        self.undone_and_redone(scene, lambda: scene.set_environment(wanted))
        self.assertEqual(scene.environment["numbers"], wanted["numbers"])
        self.assertEqual(scene.environment["surface"]["climb"], 0.25)
        self.assertEqual(scene.environment["rules"][0]["do"][2]["choice"], "nearest free")
        same = scene.environment
        for wrong in ({"surface": {"slope": 90}}, {"cues": [{"id": 1, "key": "7"}]},
                      {"numbers": [{"id": 0}]}, {"numbers": [{"id": 1, "low": 3, "high": 2}]}):
            with self.subTest(wrong=wrong), self.assertRaises(crowdbrush.Error):
                scene.set_environment(wrong)
        self.assertEqual(scene.environment, same)

    def test_rules_that_repeat_draw_follow_and_change_properties(self):
        scene = crowdbrush.Scene()
        wanted = {
            "stepsPerSecond": 120,
            "numbers": [{"id": 1, "name": "hunger", "low": 0, "high": 1, "values": [[4, 2.5]]}],
            "rules": [{"id": 1, "name": "play", "when": {"kind": "ahead free"},
                       "if": [{"kind": "property", "property": "clip", "clip": "wave"}],
                       "do": [{"kind": "repeat", "times": 0},
                              {"kind": "one of", "depth": 1, "weight": 3},
                              {"kind": "follow person", "depth": 2, "aim": "tagged", "tag": 2},
                              {"kind": "one of", "depth": 1, "weight": 1},
                              {"kind": "set property", "depth": 2, "property": "tint",
                               "slot": "top", "color": "#112233", "strength": 99}]}]}
        self.undone_and_redone(scene, lambda: scene.set_environment(wanted))
        now = scene.environment
        self.assertEqual(now["stepsPerSecond"], 120)
        self.assertEqual(now["numbers"][0]["values"], [[4, 2.5]])
        for key, value in wanted["rules"][0]["do"][4].items():
            self.assertEqual(now["rules"][0]["do"][4][key], value)
        for wrong, place in (({"rules": [{"id": 1, "do": [{"value": float("nan")}]}]},
                              r"environment\.rules\[0\]\.do\[0\]\.value must be a finite"),
                             ({"numbers": [{"id": 1, "high": float("inf")}]}, "high must be a finite"),
                             ({"stepsPerSecond": 0}, "stepsPerSecond must be 30, 60 or 120")):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(crowdbrush.Error, place):
                scene.set_environment(wrong)
        self.assertEqual(scene.environment, now)

    def test_ready_made_rules(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        row = np.stack([np.arange(20.0), np.zeros(20), np.zeros(20)], axis=1)
        scene.create(template=man, position=row)
        ids = scene.add_rules("audience")
        self.assertEqual([rule["id"] for rule in scene.environment["rules"]], ids)
        cue = next(each for each in scene.cues if "clap" in each.event)
        session = crowdbrush.Session(scene)
        session.run(0.5)
        before = session.column("clip").copy()
        session.send(cue.event)
        session.run(2.0)
        self.assertGreater((session.column("clip") != before).sum(), 10)  # most of them
        more = scene.add_rules("pedestrians")
        self.assertFalse(set(more) & set(ids))
        self.assertTrue(scene.undo())
        self.assertTrue(scene.undo())
        self.assertEqual((scene.environment["rules"], scene.environment["cues"]), ([], []))
        with self.assertRaisesRegex(crowdbrush.Error, "there are: audience, "):
            scene.add_rules("Audience")

    def test_the_walking_style_brush(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        clips = man.clip_names
        positions = np.stack([np.linspace(-3, 3, 60), np.zeros(60), np.zeros(60)], axis=1)
        scene.create(template=man, position=positions, count=60)
        style = crowdbrush.Brush(crowdbrush.BrushKind.STYLE)
        style.selection = crowdbrush.Selection.RECTANGLE
        style.through = True
        style.style.clips = {"run": 1.0, "walk_2": 1.0, "clap": 5.0}
        style.style.speed = (2.0, 3.0)
        view = crowdbrush.Camera((0, 6, 12), (0, 0, 0))
        done = scene.stroke(style, [(0, 0), (640, 360)], size=(640, 360), camera=view)
        self.assertGreater(done.affected, 10)
        chosen = {clips[i - 1] for i in scene.column("walkStyle") if i}
        self.assertEqual(chosen, {"run", "walk_2"})  # nobody gets anywhere by clapping
        speeds = scene.column("walkSpeed")
        self.assertTrue(((speeds == 0) | ((speeds >= 2) & (speeds <= 3))).all())
        scene.undo()
        self.assertFalse(scene.column("walkStyle").any())
        with self.assertRaises(crowdbrush.Error):
            scene.change([1], walkStyle=len(clips) + 1)
        scene.change([1], walkStyle=len(clips))

    def test_walk_and_tag_brushes(self):
        scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        scene.set_environment({"places": [{"id": k, "position": [k, 0, 0]} for k in (1, 2)],
                               "paths": [{"id": 1, "places": [1, 2]}]})
        walk = crowdbrush.Brush(crowdbrush.BrushKind.WALK)
        walk.selection = crowdbrush.Selection.RECTANGLE
        walk.walk.path = 1
        walk.walk.speed = (2.0, 2.0)
        self.assertGreater(scene.stroke(walk, [(0, 0), (640, 360)], size=(640, 360)).affected, 10)
        self.assertGreater(np.count_nonzero(scene.column("walkSpeed") == 2), 10)
        scene.set_environment({
            "places": [{"id": k, "position": [x, 0, z]}
                       for k, (x, z) in enumerate(((-30, 0), (0, -30), (0, -31)), 1)],
            "paths": [{"id": 1, "places": [1]}, {"id": 2, "places": [2, 3]}]})
        walk.walk.path = crowdbrush.NEAREST_PATH
        scene.stroke(walk, [(0, 0), (640, 360)], size=(640, 360))
        x, _, z = scene.column("position").T
        follows = scene.column("path")
        is_first = np.hypot(x + 30, z) < np.hypot(x, z + 30)
        self.assertGreater(np.count_nonzero(follows == 2), 10)
        self.assertFalse((follows[is_first] == 2).any())
        self.assertFalse((follows[~is_first] == 1).any())
        tag = crowdbrush.Brush(crowdbrush.BrushKind.TAG)
        tag.selection = crowdbrush.Selection.RECTANGLE
        tag.tag = 5
        done = scene.stroke(tag, [(0, 0), (640, 360)], size=(640, 360))
        self.assertEqual(np.count_nonzero(scene.column("tags") & np.uint64(1 << 5)), done.affected)

    def test_shown_seconds_decide_who_is_under_the_brush(self):
        def painted(points, **more):
            scene = crowdbrush.Scene()
            scene.set_camera("c", crowdbrush.Camera((0, 1, 6), (0, 1, 0)))
            man = scene.add_template(MAN)
            scene.create(template=man, position=[[x, 0, 0] for x in (-1, 0, 1)], clip="walk")
            brush = crowdbrush.Brush(crowdbrush.BrushKind.COLOUR)
            brush.selection = crowdbrush.Selection.POINT
            scene.stroke(brush, points, size=(320, 240), **more)
            return saved(scene)

        way = np.array([(60 + 2 * i, 150, 1, i / 60) for i in range(100)])
        late = np.column_stack([way, np.full(100, 0.4)])
        self.assertEqual(painted(way, time=0.4), painted(late))
        self.assertEqual(painted(late, time=0.9), painted(late))
        with self.assertRaises(crowdbrush.Error):
            painted(np.column_stack([way, np.full(100, np.nan)]))
        with self.assertRaises(crowdbrush.Error):
            painted(np.column_stack([late, way]))

    def test_create_counts_where_no_column_does(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        self.assertEqual(len(scene.create(template=man, position=(0, 0, 0), count=3)), 3)
        with self.assertRaises(crowdbrush.Error):
            scene.create(template=man, position=np.zeros((2, 3)), count=3)


if __name__ == "__main__":
    unittest.main()
