# SPDX-License-Identifier: MIT
"""Every property that individuals have, as the table of properties describes it."""
import pathlib
import tempfile
import unittest

import numpy as np

import crowdbrush

MAN = "builtin:templates/man.glb"


def two_people():
    scene = crowdbrush.Scene()
    scene.add_stage("builtin:stages/theatre.glb")
    man = scene.add_template(MAN)
    scene.add_template(MAN)
    scene.set_environment({"places": [{"id": 1, "position": [0, 0, 0]}, {"id": 2, "position": [5, 0, 0]}],
                           "paths": [{"id": 1, "places": [1, 2]}], "groups": [{"id": 1}],
                           "features": [{"id": kind, "name": f"kind {kind}", "values": [{"id": kind, "name": "a"}]}
                                        for kind in range(1, 9)]})
    scene.create(template=man, position=np.zeros((2, 3)))
    return scene


def other_value(scene, each):
    """A legal value that is not the default."""
    if each.name == "template":
        return scene.templates[1].id
    if each.name == "seat":
        return int(scene.seats["id"][3])
    if each.name.startswith("feature"):
        return int(each.name[-1])
    if each.low is None:
        return 1 if np.ndim(each.default) == 0 else [1] * len(each.default)
    number = 0.75 * each.low + 0.25 * each.high
    return number if np.ndim(each.default) == 0 else [number] * len(each.default)


class Properties(unittest.TestCase):
    def test_every_property_is_described(self):
        for each in crowdbrush.properties():
            with self.subTest(column=each.name):
                self.assertTrue(each.doc and each.type and each.kind and each.blend)
                self.assertIn("script", each.writers)

    def test_every_property_is_written_undone_and_saved(self):
        for each in crowdbrush.properties():
            with self.subTest(column=each.name), tempfile.TemporaryDirectory() as folder:
                scene = two_people()
                before = scene.column(each.name)
                value = other_value(scene, each)
                scene.change(scene.ids[1:], **{each.name: value})
                after = scene.column(each.name)
                np.testing.assert_array_equal(after[0], before[0])
                np.testing.assert_array_equal(after[1], np.asarray(value, after.dtype))
                self.assertFalse(np.array_equal(after, before))
                scene.undo()
                np.testing.assert_array_equal(scene.column(each.name), before)
                scene.redo()
                path = pathlib.Path(folder) / "scene.crowd"
                scene.save(path)
                np.testing.assert_array_equal(crowdbrush.open(path).column(each.name), after)

    def test_numbers_outside_their_range_are_refused(self):
        scene = two_people()
        for each in crowdbrush.properties():
            if each.low is None:
                continue
            for wrong in (each.low - abs(each.low) - 1, each.high + abs(each.high), float("nan")):
                value = wrong if np.ndim(each.default) == 0 else [0, wrong, 0]
                steps = len(scene.history)
                with self.subTest(column=each.name, value=wrong):
                    with self.assertRaisesRegex(crowdbrush.Error, each.name):
                        scene.change(scene.ids, **{each.name: value})
                    self.assertEqual(len(scene.history), steps)


if __name__ == "__main__":
    unittest.main()
