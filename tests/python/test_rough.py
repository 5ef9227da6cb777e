# SPDX-License-Identifier: MIT
"""What scripts may do that nobody asked them to: each is answered, and the scene is unharmed."""
import gc
import importlib
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import crowdbrush

MAN = "builtin:templates/man.glb"
HAS_PLAIN_PYTHON = "CROWD_PLAIN_PYTHON" in os.environ


def people(count):
    scene = crowdbrush.Scene()
    man = scene.add_template(MAN)
    scene.create(template=man, position=np.zeros((count, 3)), count=count)
    return scene, man


class Rough(unittest.TestCase):
    def test_imported_twice(self):
        first = sys.modules["crowdbrush"]
        scene, _ = people(2)
        del sys.modules["crowdbrush"]
        try:
            again = importlib.import_module("crowdbrush")
            self.assertEqual(len(again.open("builtin:scenes/theatre.crowd").templates[0].slots) > 0, True)
            self.assertEqual(len(scene), 2)
        except ImportError as refused:  # as clear as working
            self.assertIn("crowdbrush", str(refused))
        finally:
            sys.modules["crowdbrush"] = first
        self.assertEqual(len(scene.create(template=1, position=(0, 0, 0))), 1)

    @unittest.skipUnless(HAS_PLAIN_PYTHON, "needs a python3 of its own")
    def test_without_numpy(self):
        code = "import sys; sys.modules['numpy'] = None; import crowdbrush"
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("python3-numpy", done.stderr)

    def test_threads(self):
        scene, man = people(1)
        problems = []

        def work(k):
            try:
                for i in range(20):
                    scene.create(count=100, template=man, position=(k, 0, i))
                    self.assertTrue((scene.column("position")[:, 1] == 0).all())
                    self.assertTrue((np.diff(scene.ids) > 0).all())
            except Exception as problem:  # handed to the main thread
                problems.append(problem)

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(problems, [])
        self.assertEqual(len(scene), 8001)
        self.assertEqual(len(np.unique(scene.ids)), 8001)

    @unittest.skipUnless(HAS_PLAIN_PYTHON, "a fork of the whole editor is not for a script")
    def test_forks(self):
        code = ("import os, sys, crowdbrush\n"
                "s = crowdbrush.Scene(); m = s.add_template('" + MAN + "')\n"
                "child = os.fork()\n"
                "s.create(template=m, position=(0, 0, 0))\n"
                "if child == 0: os._exit(len(s))\n"
                "sys.exit(0 if os.waitpid(child, 0)[1] >> 8 == 1 and len(s) == 1 else 3)")
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True,
                              timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_scene_dropped_while_parts_are_held(self):
        scene, man = people(3)
        heights = scene.column("height")
        block = scene.edit("Never ended")
        block.__enter__()
        scene.change([1], heading=1.0)
        del scene, block
        gc.collect()
        self.assertEqual(man.name, "man")  # it keeps its scene alive
        self.assertEqual(len(heights), 3)
        del man
        gc.collect()

    def test_callbacks_that_raise(self):
        class Odd:
            def __array__(self, *_):
                raise ValueError("not today")

            def __len__(self):
                raise ValueError("no length")

        class Path:
            def __fspath__(self):
                raise ValueError("no path")

        scene, man = people(2)
        steps = len(scene.history)
        for call in (lambda: scene.create(template=man, position=Odd()),
                     lambda: scene.change(Odd(), heading=1.0),
                     lambda: scene.change([1], heading=Odd()),
                     lambda: scene.remove(Odd()),
                     lambda: scene.save(Path()),
                     lambda: scene.stroke(crowdbrush.Brush(crowdbrush.BrushKind.DELETE), Odd())):
            with self.assertRaises(Exception):
                call()
        self.assertEqual(len(scene.history), steps)
        self.assertEqual(len(scene), 2)

    def test_arrays_of_every_stride_and_type(self):
        scene, _ = people(10)
        wide = np.arange(40, dtype=np.float64)
        for given in (wide[::4], wide[30:20:-1], wide.astype(">f4")[::4], wide.astype(np.int16)[::4],
                      np.ma.array(wide[::4]), wide[::4].tolist(), range(0, 40, 4),
                      np.broadcast_to(np.float32(2), 10)):
            scene.change(scene.ids, heading=given)
            np.testing.assert_array_equal(scene.column("heading"), np.asarray(given, np.float32))
        read_only = np.arange(10.0)
        read_only.flags.writeable = False
        scene.change(scene.ids, heading=read_only)
        steps = len(scene.history)
        for wrong in (wide[:9], wide.reshape(10, 4), wide[::4] + 1j, wide[::4].astype(object), b"",
                      np.zeros(10, "datetime64[s]"), [[1, 2], [3]], {}, "up", None,
                      np.full(10, np.inf), np.zeros((10, 1, 1))):
            with self.subTest(given=repr(wrong)), self.assertRaises((crowdbrush.Error, ValueError, TypeError)):
                scene.change(scene.ids, heading=wrong)
        for wrong in ([1.5], ["a"], [-1], [2**40], [[1]], [[[1]]], None, {}, 7.5):
            with self.subTest(ids=repr(wrong)), self.assertRaises((crowdbrush.Error, ValueError, TypeError)):
                scene.change(wrong, heading=0.0)
        self.assertEqual(len(scene.history), steps)

    def test_endless_recursion_in_a_brush(self):
        def around(selection):
            return around(selection)

        scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        with self.assertRaises(RecursionError):
            scene.stroke(around, [(320, 180)], size=(640, 360))
        self.assertEqual(scene.history, [])

    def test_a_full_disk_or_no_folder(self):
        scene, _ = people(1)
        for path in ("/none/of/this.crowd", "/dev/full/x.crowd", "/proc/x.crowd"):
            with self.assertRaises(crowdbrush.Error):
                scene.save(path)
        with tempfile.TemporaryDirectory() as folder:
            scene.save(pathlib.Path(folder) / "fine.crowd")


if __name__ == "__main__":
    unittest.main()
