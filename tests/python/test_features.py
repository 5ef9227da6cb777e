# SPDX-License-Identifier: MIT
"""Features: what people are like, in names, and what that does to them."""
import json
import random
import tempfile
import unittest
from pathlib import Path

import numpy as np

import crowdbrush
from crowdbrush import Brush, BrushKind, Error, FeatureClip, FeatureSlot, FeatureValue, Operator

CAST = ("man", "woman", "boy")


def crowd(n=30):
    scene = crowdbrush.Scene()
    templates = [scene.add_template(f"builtin:templates/{name}.glb") for name in CAST]
    ids = [scene.create(template=template, position=np.column_stack((np.arange(n), np.full(n, i), np.zeros(n))))
           for i, template in enumerate(templates)]
    return scene, np.concatenate(ids)


def clips_of(scene):
    names = {template.id: template.clip_names for template in scene.templates}
    return [names[template][clip] for template, clip in zip(scene.column("template"), scene.column("clip"))]


class Features(unittest.TestCase):
    def test_a_new_scene_has_emotions_and_outfits(self):
        scene = crowdbrush.Scene()
        self.assertEqual(list(scene.features), ["emotion", "outfit"])
        self.assertEqual(list(scene.features["emotion"]),
                         ["neutral", "sad", "bored", "attentive", "happy", "excited", "angry"])
        self.assertEqual(list(scene.features["outfit"]),
                         ["everyday", "evening", "work", "sport", "rain", "team red", "team blue", "antique rich",
                          "antique poor"])
        happy = scene.features["emotion"]["happy"]
        self.assertIsInstance(happy, FeatureValue)
        self.assertTrue(happy.sets_phase)
        self.assertIn("clap", [clip.clip for clip in happy.clips])

    def test_setting_one_is_a_step(self):
        scene, ids = crowd()
        before = {name: scene.column(name).tobytes() for name in ("clip", "phase", "speed", "feature1")}
        self.assertEqual(scene.set_feature(ids, "emotion", "excited"), len(ids))
        self.assertEqual(scene.history[-1], "Set a feature")
        self.assertEqual(set(scene.feature("emotion")), {"excited"})
        self.assertEqual(set(scene.feature("outfit")), {""})
        self.assertLessEqual(set(clips_of(scene)), {"cheer", "wave", "dance", "dance_2"})
        self.assertGreater(len(set(scene.column("phase").tolist())), len(ids) // 2)
        scene.undo()
        for name, was in before.items():
            self.assertEqual(scene.column(name).tobytes(), was, name)

    def test_a_mix_and_none(self):
        scene, ids = crowd()
        before = clips_of(scene)
        scene.set_feature(ids, "emotion", {"happy": 3, "sad": 1})
        names = scene.feature("emotion")
        self.assertEqual(set(names), {"happy", "sad"})
        self.assertGreater(np.count_nonzero(names == "happy"), np.count_nonzero(names == "sad"))
        scene.set_feature(ids[:4], "emotion", ["bored", "angry"])
        self.assertLessEqual(set(scene.feature("emotion")[:4]), {"bored", "angry"})
        clips = clips_of(scene)
        self.assertNotEqual(clips[:4], before[:4])
        scene.set_feature(ids[:4], "emotion", None)
        self.assertEqual(set(scene.feature("emotion")[:4]), {""})
        self.assertEqual(clips_of(scene), before[:4] + clips[4:])  # what it did is undone

    def test_outfits_dress(self):
        scene, ids = crowd(4)
        scene.set_feature(ids, "outfit", "team red")
        man = scene.template("man")
        top = man.slots.index("top")
        rows = scene.column("template") == man.id
        np.testing.assert_array_equal(scene.column("tint")[rows][:, top],
                                      np.tile([200, 34, 40, 255], (np.count_nonzero(rows), 1)))
        skin = man.slots.index("skin")
        self.assertFalse(scene.column("tint")[rows][:, skin, 3].any())

    def test_values_are_made_changed_and_removed(self):
        scene, ids = crowd(4)
        scene.features["team"] = {
            "home": FeatureValue(slots=[FeatureSlot(slot="top", colors=[(255, 255, 0)])], color=(255, 255, 0)),
            "guest": {"slots": [{"slot": "top", "colors": ["#00ff00"]}]}}
        self.assertEqual(list(scene.features), ["emotion", "outfit", "team"])
        self.assertEqual(list(scene.features["team"]), ["home", "guest"])
        scene.set_feature(ids, "team", "home")
        home = scene.features["team"]["home"]
        home.clips = [FeatureClip(clip="wave", weight=2.0)]
        scene.features["team"]["home"] = home
        self.assertEqual(set(scene.feature("team")), {"home"})
        self.assertNotIn("wave", clips_of(scene))
        scene.set_feature(ids, "team", "home")
        self.assertEqual(set(clips_of(scene)), {"wave"})
        scene.features["team"]["mascot"] = FeatureValue(sets_height=True, height=(1.5, 1.5))
        self.assertEqual(len({value.id for value in scene.features["team"].values()}), 3)
        del scene.features["team"]["home"]
        self.assertEqual(set(scene.feature("team")), {""})
        self.assertEqual(list(scene.features["team"]), ["guest", "mascot"])
        del scene.features["team"]
        self.assertNotIn("team", scene.features)
        with self.assertRaises(KeyError):
            scene.features["team"]
        with self.assertRaises(KeyError):
            scene.features["emotion"]["brave"]
        for _ in range(4):
            scene.undo()
        self.assertEqual(list(scene.features["team"]), ["home", "guest"])

    def test_files_have_them(self):
        scene, ids = crowd(3)
        scene.features["team"] = {"home": FeatureValue(sets_speed=True, speed=(1, 2), templates=[1])}
        scene.set_feature(ids, "team", "home")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.crowd"
            scene.save(str(path))
            again = crowdbrush.open(str(path))
            self.assertEqual(again.features["team"]["home"], scene.features["team"]["home"])
            self.assertEqual(again.feature("team").tolist(), scene.feature("team").tolist())
            self.assertEqual(set(again.feature("team")), {"home", ""})  # limited to one template
            again.save(str(path.with_name("again.crowd")))
            self.assertEqual(path.read_bytes(), path.with_name("again.crowd").read_bytes())

    def test_the_brush(self):
        scene, ids = crowd()
        camera = crowdbrush.Camera((45, 30, 60), (15, 0, 0))
        brush = Brush(BrushKind.FEATURE)
        brush.operator, brush.selection, brush.through = Operator.GRADIENT, crowdbrush.Selection.RECTANGLE, True
        self.assertEqual(brush.feature.kind, "emotion")
        stroke = scene.stroke(brush, [(0, 0), (1279, 767)], camera=camera, size=(1280, 768))
        self.assertEqual(stroke.affected, len(ids))
        self.assertGreater(len(set(scene.feature("emotion"))), 2)
        brush.feature.kind = "outfit"
        brush.feature.values = {"rain": 1.0}
        scene.stroke(brush, [(0, 0), (1279, 767)], camera=camera, size=(1280, 768))
        self.assertEqual(set(scene.feature("outfit")), {"rain"})
        for kind, values in (("courage", {}), ("emotion", {"rain": 1.0})):
            brush.feature.kind, brush.feature.values = kind, values
            with self.assertRaisesRegex(Error, "there are"):
                scene.stroke(brush, [(0, 0), (1279, 767)], camera=camera, size=(1280, 768))

    def test_random_mixes_with_states_are_undone_and_redone(self):
        scene, ids = crowd(8)
        chance = random.Random(11)

        def text():
            columns = b"".join(scene.column(each.name).tobytes() for each in crowdbrush.properties()
                               if not each.name.startswith("tint") or each.name == "tintReplaces")
            return columns, scene.column("tint").tobytes(), json.dumps(scene.environment), scene.states.text()

        def step():
            some = sorted(chance.sample(ids.tolist(), chance.randint(1, len(ids))))
            kind = chance.choice(list(scene.features))
            what = chance.randrange(7)
            if what < 3 and len(scene.features[kind]):
                scene.set_feature(some, kind, chance.choice([*scene.features[kind], None]))
            elif what == 3:
                scene.save_state(chance.choice("abc"), ids=some)
            elif what == 4 and len(scene.states):
                scene.recall_state(chance.choice(list(scene.states)))
            elif what == 5:
                scene.features[kind][f"new {chance.randrange(3)}"] = FeatureValue(
                    sets_girth=True, girth=(chance.uniform(0.5, 1), 1.5))
            elif what == 6 and len(scene.features[kind]) > 2:
                del scene.features[kind][chance.choice(list(scene.features[kind]))]

        seen = {scene.history_index: text()}
        first = scene.history_index
        for _ in range(120):
            step()
            seen[scene.history_index] = text()
        last = scene.history_index
        self.assertGreater(last - first, 60)
        for index in range(last - 1, first - 1, -1):
            scene.undo()
            self.assertEqual(text(), seen[index], index)
        for index in range(first + 1, last + 1):
            scene.redo()
            self.assertEqual(text(), seen[index], index)
        with tempfile.TemporaryDirectory() as folder:
            one, other = (str(Path(folder) / name) for name in ("one.crowd", "other.crowd"))
            scene.save(one)
            crowdbrush.open(one).save(other)
            self.assertEqual(Path(one).read_bytes(), Path(other).read_bytes())

    def test_what_is_wrong_is_said(self):
        scene, ids = crowd(2)
        before = scene.history
        for kind, value, said in (("courage", "brave", "no feature \"courage\"; there are: emotion, outfit"),
                                  ("emotion", "brave", "no value \"brave\"; there are: neutral"),
                                  ("emotion", {"sad": -1}, "weight"), ("emotion", {"sad": float("nan")}, "weight"),
                                  ("emotion", {"sad": 0}, "more than 0"), ("emotion", [], "names nothing"),
                                  ("emotion", 7, "must be a name"), ("emotion", {"sad": "much"}, "must be a number"),
                                  ("emotion", [7], "goes by its name")):
            with self.assertRaisesRegex(Error, said, msg=str(value)):
                scene.set_feature(ids, kind, value)
        with self.assertRaisesRegex(Error, "12345"):
            scene.set_feature([12345], "emotion", "sad")
        with self.assertRaises(Error):
            scene.feature("courage")
        sad, rain = scene.features["emotion"]["sad"].id, scene.features["outfit"]["rain"].id
        for column, value in (("feature1", rain), ("feature2", sad), ("feature1", 999), ("feature3", 1)):
            with self.assertRaisesRegex(Error, "no feature of that number", msg=column):
                scene.change(ids, **{column: value})
        for wrong in ({"clips": [{"role": "fall"}]}, {"speed": (2, 1)}, {"slots": [{"colors": ["red"]}]},
                      {"speed_curve": [1, 2]}, {"sped": (1, 2)}):
            with self.assertRaises(Error, msg=str(wrong)):
                scene.features["emotion"]["new"] = wrong
        with self.assertRaises((Error, TypeError)):
            scene.features["emotion"]["new"] = 7
        for i in range(6):
            scene.features[f"more {i}"] = {}
        with self.assertRaisesRegex(Error, "at most 8"):
            scene.features["one too many"] = {}
        self.assertEqual(len(scene.history), len(before) + 6)

    def test_rules_give_and_ask_for_them(self):
        scene, ids = crowd(3)
        emotion = {name: value.id for name, value in scene.features["emotion"].items()}
        scene.set_feature(ids, "emotion", "bored")
        scene.rules = [
            crowdbrush.Rule(id=1, name="cheer up", when=crowdbrush.triggers.Event(event="cheer"),
                            if_=[crowdbrush.conditions.Feature(feature=emotion["bored"])],
                            do=[crowdbrush.actions.Feature(feature=emotion["excited"])]),
            crowdbrush.Rule(id=2, name="tell", when=crowdbrush.triggers.Feature(feature=emotion["excited"]),
                            do=[crowdbrush.actions.Tag(tag=3)])]
        scene.set_feature(ids[:1], "emotion", "sad")
        session = crowdbrush.Session(scene)
        session.send("cheer")
        session.step(10)
        self.assertEqual((session.column("tags") & 8 != 0).tolist(), [False] + [True] * (len(ids) - 1))
        names = {template.id: template.clip_names for template in scene.templates}
        shown = [names[t][c] for t, c in zip(session.column("template"), session.column("clip"))]
        self.assertLessEqual(set(shown[1:]), {"cheer", "wave", "dance", "dance_2"})
        self.assertEqual(set(scene.feature("emotion")), {"sad", "bored"})  # in the run alone


if __name__ == "__main__":
    unittest.main()
