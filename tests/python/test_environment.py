# SPDX-License-Identifier: MIT
"""Rules, places and so on as typed classes: what they are, and that the program reads them so."""
import copy
import json
import pathlib
import pickle
import unittest

import numpy as np

import crowdbrush
from crowdbrush import Branch, Cue, Entry, Number, Path, Place, Rule, Tag, actions, conditions, triggers

ROOT = pathlib.Path(__file__).resolve().parents[1]
MAN = "builtin:templates/man.glb"


def kinds(space):
    return [each for each in vars(space).values() if isinstance(each, type)]


def rules_of_every_kind():
    """One rule for each kind of trigger, with all conditions and all actions."""
    return [Rule(id=i + 1, name=trigger._kind, when=trigger(),
                 if_=[kind() for kind in kinds(conditions)],
                 do=[kind() for kind in kinds(actions)])
            for i, trigger in enumerate(kinds(triggers))]


def number_fields():
    """Class, its other members, field: of all members that are numbers with limits."""
    needed = {Place: {"id": 1, "position": (0, 0, 0)}, Path: {"id": 1}, Cue: {"id": 1}, Rule: {"id": 1},
              Number: {"id": 1}, Branch: {"place": 1, "path": 1}}
    for cls in [*needed, Tag, *kinds(triggers), *kinds(conditions), *kinds(actions)]:
        for field in cls._fields.values():
            if field.low is not None:
                yield cls, needed.get(cls, {}), field


def environment_with(entry):
    """One that has an entry somewhere."""
    place = Place(id=1, position=(0, 0, 0))
    if isinstance(entry, crowdbrush.Trigger):
        return {"rules": [{"id": 1, "when": entry}]}
    if isinstance(entry, crowdbrush.Condition):
        return {"rules": [{"id": 1, "if": [entry]}]}
    if isinstance(entry, crowdbrush.Action):
        return {"rules": [{"id": 1, "do": [entry]}]}
    if isinstance(entry, Branch):
        return {"places": [place], "paths": [{"id": 1, "places": [1], "branches": [entry]}]}
    return {{Place: "places", Path: "paths", Cue: "cues", Rule: "rules", Number: "numbers", Tag: "tags"}[type(entry)]:
            [entry]}


class Entries(unittest.TestCase):
    def test_is_the_dict_with_attributes(self):
        place = Place(id=3, name="door", position=(1, 2, 3), speed_share=0.25)
        self.assertEqual(place, {"id": 3, "name": "door", "position": [1, 2, 3], "speedShare": 0.25})
        self.assertEqual((place.radius, place.role, place["speedShare"]), (1.0, "spot", 0.25))
        place.role = "exit"
        place.color = (255, 0, 16)
        self.assertEqual((place["role"], place.color), ("exit", "#ff0010"))
        self.assertIsInstance(place, dict)
        self.assertEqual(json.loads(json.dumps(place)), place.to_dict())
        self.assertIs(type(place.to_dict()), dict)

    def test_places_are_lines_and_areas(self):
        scene = crowdbrush.Scene()
        wall = Place(id=1, position=(0, 0, 0), role="obstacle", shape="line", radius=0.2,
                     corners=[(-3, 0, 0), (3, 0.5, 0), (3, 0.5, 4)])
        with scene.edit("Wall"):
            scene.places = [wall]
        self.assertEqual(scene.places[0].corners, [[-3, 0, 0], [3, 0.5, 0], [3, 0.5, 4]])
        self.assertEqual((scene.places[0].shape, Place(id=1, position=(0, 0, 0)).corners), ("line", []))
        for corners in ([(0, 0, 0)], [(0, 0, 0), (1e9, 0, 0)], []):
            with self.assertRaisesRegex(crowdbrush.Error, "corners must be a list of"):
                scene.places = [Place(id=1, position=(0, 0, 0), shape="line", corners=corners)]
        for corners in ([(0, 0)], "ab", [1, 2], [(0, 0, float("nan"))]):
            with self.assertRaisesRegex(crowdbrush.Error, "corners"):
                Place(id=1, position=(0, 0, 0), shape="line", corners=corners)
        self.assertEqual(len(scene.places[0].corners), 3)

    def test_reads_as_what_makes_it(self):
        rule = Rule(id=1, when=triggers.Event(event="bell"), if_=[conditions.Chance(chance=0.25, not_=True)],
                    do=[actions.Repeat(times=3), actions.Play(clips={"wave": 2, "clap": 1}, depth=1)])
        text = repr(rule)
        self.assertEqual(text, "Rule(id=1, when=triggers.Event(event='bell'), "
                               "if_=[conditions.Chance(chance=0.25, not_=True)], "
                               "do=[actions.Repeat(times=3), actions.Play(clips=[{'clip': 'wave', 'weight': 2.0}, "
                               "{'clip': 'clap', 'weight': 1.0}], depth=1)])")
        self.assertEqual(eval(text, vars(crowdbrush)), rule)
        self.assertEqual(repr(actions.Stop()), "actions.Stop()")

    def test_equals_what_says_the_same(self):
        self.assertEqual(actions.Wait(seconds=1 / 3), actions.Wait(seconds=float(np.float32(1 / 3))))
        self.assertNotEqual(actions.Wait(seconds=1), actions.Wait(seconds=2))
        self.assertNotEqual(actions.Wait(), actions.Stop())
        self.assertNotEqual(Place(id=1, position=(0, 0, 0)), 1)
        self.assertEqual({"kind": "stop"}, actions.Stop())
        for copied in (copy.deepcopy, copy.copy, lambda each: pickle.loads(pickle.dumps(each))):
            rule = rules_of_every_kind()[0]
            self.assertEqual(copied(rule), rule)
            self.assertIs(type(copied(rule)), Rule)

    def test_takes_entries_for_ids(self):
        door, hunger = Place(id=4, position=(0, 0, 0)), Number(id=2)
        self.assertEqual(actions.GoTo(place=door).place, 4)
        self.assertEqual(actions.AddToNumber(number=hunger).number, 2)
        self.assertEqual(actions.Tag(tag=Tag(tag=7)).tag, 7)
        self.assertEqual(Path(id=1, places=[door, 5]).places, [4, 5])
        scene = crowdbrush.Scene()
        self.assertEqual(conditions.Template(template=scene.add_template(MAN)).template, 1)

    def test_refuses_what_is_wrong(self):
        for wrong, kind, said in [
                (lambda: Place(id=1), TypeError, "Place needs position"),
                (lambda: Place(id=1, position=(0, 0, 0), radios=2), TypeError, "radios.*radius"),
                (lambda: Place(id=1, position=(0, 0)), crowdbrush.Error, "Place.position must be 3 numbers"),
                (lambda: Place(id=1.5, position=(0, 0, 0)), crowdbrush.Error, "a whole number"),
                (lambda: Place(id=1, position=(0, 0, 0), role="door"), crowdbrush.Error, "one of: spot, "),
                (lambda: Place(id=1, position=(0, 0, 0), color="red"), crowdbrush.Error, "Place.color"),
                (lambda: actions.Wait(seconds=float("nan")), crowdbrush.Error, "a finite number"),
                (lambda: actions.Wait(seconds="1"), crowdbrush.Error, "a finite number"),
                (lambda: actions.Play(clips=3), crowdbrush.Error, "actions.Play.clips must be a list"),
                (lambda: Rule(id=1, enabled=1), crowdbrush.Error, "True or False"),
                (lambda: Rule(id=1, do=[3]), crowdbrush.Error, r"Rule.do\[0\] must be a Action or a dict"),
                (lambda: Rule(id=1, do=[{"kind": "fly"}]), crowdbrush.Error, "Action.kind must be one of: play, "),
                (lambda: Rule(id=1, when=actions.Stop()), crowdbrush.Error, "Trigger.kind must be one of")]:
            with self.subTest(said=said), self.assertRaisesRegex(kind, said):
                wrong()
        with self.assertRaises(AttributeError):
            Place(id=1, position=(0, 0, 0)).radios = 2

    def test_keeps_what_a_later_version_knows(self):
        given = {"id": 1, "position": [0, 0, 0], "scent": {"of": "pines"}}
        self.assertEqual(Place.from_dict(given)["scent"], {"of": "pines"})
        self.assertEqual(crowdbrush.Action.from_dict({"kind": "stop", "how": 1}).to_dict()["how"], 1)


class Environment(unittest.TestCase):
    def test_every_kind_is_read_back_as_it_was(self):
        scene = crowdbrush.Scene()
        wanted = rules_of_every_kind()
        scene.rules = wanted
        self.assertEqual(scene.rules, wanted)
        for rule, given in zip(scene.rules, scene.environment["rules"]):
            self.assertEqual(rule.to_dict(), given)  # no member more, and none less
            self.assertEqual(list(map(type, rule.do)), kinds(actions))

    def test_other_entries_are_read_back_as_they_were(self):
        scene = crowdbrush.Scene()
        door, hall = Place(id=1, name="door", position=(0, 0, 1)), Place(id=2, position=(4, 0, 1), role="slow", capacity=3)
        scene.places = [door, hall]
        scene.paths = [Path(id=1, places=[door, hall], kind="cyclic"),
                       Path(id=2, places=[hall], branches=[Branch(place=hall, path=1, weight=0.5)])]
        scene.tags = [Tag(tag=3, name="star")]
        scene.numbers = [Number(id=1, name="hunger", high=4, values_=[(7, 2.5)])]
        scene.cues = [Cue(id=1, name="Go", event="go", key="F4", reach="tagged", tag=3)]
        self.assertEqual(scene.places, [door, hall])
        self.assertEqual([path.places for path in scene.paths], [[1, 2], [2]])
        self.assertEqual(scene.paths[1].branches[0].weight, 0.5)
        self.assertEqual((scene.tags[0].name, scene.numbers[0].values_, scene.cues[0].key), ("star", [[7, 2.5]], "F4"))
        same = scene.environment
        scene.set_environment(same)
        scene.places = scene.places
        self.assertEqual(scene.environment, same)
        self.assertEqual(len(scene.history), 5)
        scene.undo()
        self.assertEqual(scene.cues, [])

    def test_limits_are_those_of_files(self):
        for cls, needed, field in number_fields():
            scene = crowdbrush.Scene()
            with self.subTest(field=f"{cls.__qualname__}.{field.attribute}"):
                for value in {field.low, min(field.high, 1e6 if field.type == "int" else field.high)}:
                    fitting = {field.attribute: int(value) if field.type == "int" else value}
                    if cls is Number:
                        fitting = {"low": value, "high": value}
                    if field.key == "depth":
                        continue  # it settles below the line before
                    scene.set_environment(environment_with(cls(**{**needed, **fitting})))
                for value in (field.low - 1, field.high * 2 + 1):
                    if field.type == "int" and value > 0xFFFFFFFF:
                        continue
                    with self.assertRaises(crowdbrush.Error):
                        cls(**{**needed, field.attribute: int(value) if field.type == "int" else value})
                    wrong = cls(**needed)
                    wrong[field.key] = int(value) if field.type == "int" else value
                    with self.assertRaises(crowdbrush.Error):
                        scene.set_environment(environment_with(wrong))

    def test_rules_of_classes_run(self):
        scene = crowdbrush.Scene()
        man = scene.add_template(MAN)
        scene.create(template=man, position=np.zeros((4, 3)) + np.arange(4)[:, None] * (1.0, 0.0, 0.0))
        door = Place(id=1, name="door", position=(1.5, 0, 6), radius=3)
        star = Tag(tag=5, name="star")
        scene.places, scene.tags = [door], [star]
        scene.rules = [
            Rule(id=1, name="to the door", when=triggers.Event(event="bell"),
                 do=[actions.GoTo(place=door), actions.Tag(tag=star)]),
            Rule(id=2, name="never", when=triggers.Event(event="bell"), if_=[conditions.Tag(tag=star)],
                 do=[actions.LeaveScene()])]
        session = crowdbrush.Session(scene)
        session.send("bell")
        session.run(12)
        self.assertTrue((session.column("position")[:, 2] > 2).all())
        np.testing.assert_array_equal(session.column("tags") >> star.tag & 1, [1] * 4)
        self.assertEqual([each.name for each in scene.rules], ["to the door", "never"])

    def test_a_file_with_all_fields_of_rules_reads_as_the_same_rules(self):
        """Files from before each kind had fields of its own stored those of all kinds."""
        old = crowdbrush.open(str(ROOT / "data/project/every_field_of_rules.crowd"))
        new = crowdbrush.open(str(ROOT / "golden/files/every_kind_of_rule.crowd"))
        self.assertGreater(len(new.rules), 10)
        self.assertEqual(old.environment, new.environment)
        self.assertEqual(old.rules, new.rules)


if __name__ == "__main__":
    unittest.main()
