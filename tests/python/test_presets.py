# SPDX-License-Identifier: MIT
"""Brush presets: those that the editor keeps, folders of others, and single files."""
import json
import os
import pathlib
import tempfile
import unittest
import unittest.mock

import crowdbrush
from crowdbrush import Brush, BrushKind


def wide_scale():
    brush = Brush(BrushKind.SCALE)
    brush.radius = 123
    return brush


class InAFolder(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)
        # Deleted files go into a trash of their own.
        here = unittest.mock.patch.dict(os.environ, XDG_DATA_HOME=str(self.folder / "data"))
        here.start()
        self.addCleanup(here.stop)


class Folders(InAFolder):
    def test_are_mappings(self):
        presets = crowdbrush.Presets(self.folder / "new" / "brushes")
        self.assertEqual((len(presets), list(presets), presets.keys()), (0, [], []))
        presets["Giants #tall"] = wide_scale()
        presets["Angry"] = Brush(BrushKind.COLOUR)
        self.assertEqual(list(presets), ["Angry", "Giants #tall"])
        self.assertEqual(presets["Giants #tall"], wide_scale())
        self.assertEqual([name for name, _ in presets.items()], presets.keys())
        self.assertEqual(presets.values()[1], wide_scale())
        self.assertTrue("Angry" in presets and "Calm" not in presets)
        self.assertIsNone(presets.get("Calm"))
        self.assertEqual(presets.get("Angry").kind, BrushKind.COLOUR)
        presets["Angry"] = wide_scale()  # in its place
        self.assertEqual((len(presets), presets["Angry"]), (2, wide_scale()))
        del presets["Angry"]
        self.assertEqual(presets.keys(), ["Giants #tall"])
        self.assertEqual(len(list((self.folder / "data/Trash/files").iterdir())), 1)
        self.assertEqual(len(list(pathlib.Path(presets.folder).glob("*.brush"))), 1)

    def test_say_which_there_are(self):
        presets = crowdbrush.Presets(self.folder)
        presets["Giants"] = wide_scale()
        for act in (lambda: presets["Dwarfs"], lambda: presets.__delitem__("Dwarfs")):
            with self.assertRaisesRegex(crowdbrush.Error, '"Dwarfs".*Giants'):
                act()
        with self.assertRaisesRegex(crowdbrush.Error, "needs a name"):
            presets["  "] = wide_scale()
        with self.assertRaisesRegex(TypeError, "brush"):
            presets["a"] = {}

    def test_are_no_brushes_themselves(self):
        for given in (crowdbrush.Presets(self.folder), {}):
            with self.assertRaisesRegex(TypeError, "is no brush"):
                crowdbrush.Scene().stroke(given, [(0, 0)])

    def test_name_what_cannot_be_read(self):
        presets = crowdbrush.Presets(self.folder)
        (self.folder / "bad.brush").write_text("{")
        self.assertEqual(len(presets), 0)
        self.assertRegex(presets.problems[0], "bad.brush.*line 1")
        with self.assertRaisesRegex(crowdbrush.Error, "bad.brush"):
            presets["bad"]
        (self.folder / "file").write_text("")
        with self.assertRaisesRegex(crowdbrush.Error, "cannot be made"):
            crowdbrush.Presets(self.folder / "file" / "brushes")["a"] = wide_scale()

    def test_of_the_editor_are_the_users(self):
        self.assertEqual(pathlib.Path(crowdbrush.presets.folder).name, "brushes")
        self.assertIn(str(self.folder), crowdbrush.presets.folder)
        crowdbrush.presets["Giants"] = wide_scale()
        self.assertEqual(crowdbrush.presets["Giants"], wide_scale())
        self.assertEqual(crowdbrush.Presets().keys(), ["Giants"])


class Files(InAFolder):
    def test_come_back(self):
        path = self.folder / "giants.brush"
        wide_scale().save(path)
        self.assertEqual(Brush.load(path), wide_scale())
        self.assertEqual(json.loads(path.read_text())["name"], "giants")
        wide_scale().save(path, name="Giants #tall")
        self.assertEqual(crowdbrush.Presets(self.folder).keys(), ["Giants #tall"])

    def test_hold_nothing_of_one_scene(self):
        brush = Brush(BrushKind.GROUP)
        brush.group.group = 7
        brush.save(self.folder / "a.brush")
        again = Brush.load(self.folder / "a.brush")
        self.assertEqual((again.kind, again.group.group), (BrushKind.GROUP, 0))

    def test_that_could_not_be_read_again_are_not_written(self):
        brush = wide_scale()
        brush.radius = -5
        with self.assertRaisesRegex(crowdbrush.Error, "radius"):
            brush.save(self.folder / "a.brush")
        self.assertFalse((self.folder / "a.brush").exists())

    def test_that_are_bad_name_the_place(self):
        good = {"format": "crowdbrush brush", "version": 1, "name": "a",
                "brush": {"brush": "scale", "settings": {}}}
        bad = {
            "": "line 1",
            '{\n "format": crowd': "line 2",
            "[1]": "no brush preset.*[Cc]hoose",
            json.dumps({**good, "version": 2}): "newer version; update",
            json.dumps({**good, "version": "x"}): "version.*must be 1",
            json.dumps({**good, "name": ""}): "no name.*Write",
            json.dumps({**good, "brush": {"brush": "mop"}}): "brush must be one of: .*scale",
            json.dumps({**good, "brush": {"brush": "scale", "radius": "wide"}}): "radius",
            json.dumps({**good, "brush": {"brush": "scale", "radius": 1e9}}): "radius",
            json.dumps({**good, "brush": {"brush": "scale", "settings": {"hieght": 1}}}): "hieght",
            "[" * 100_000: "line 1",
        }
        path = self.folder / "bad.brush"
        for text, said in bad.items():
            with self.subTest(text[:60]):
                path.write_text(text)
                with self.assertRaisesRegex(crowdbrush.Error, f"bad.brush.*{said}"):
                    Brush.load(path)
        with self.assertRaisesRegex(crowdbrush.Error, "gone.brush cannot be read"):
            Brush.load(self.folder / "gone.brush")
        with self.assertRaisesRegex(crowdbrush.Error, "cannot be written"):
            wide_scale().save(self.folder / "gone" / "a.brush")


if __name__ == "__main__":
    unittest.main()
