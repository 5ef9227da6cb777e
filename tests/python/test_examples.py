# SPDX-License-Identifier: MIT
"""The examples do what they say."""
import importlib.util
import pathlib
import sys
import tempfile
import unittest

import numpy as np

import crowdbrush

FOLDER = pathlib.Path(__file__).parent / "examples"


def example(name):
    """The module, without writing compiled files beside it."""
    sys.dont_write_bytecode = True
    spec = importlib.util.spec_from_file_location("example_" + name, FOLDER / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.output = str(pathlib.Path(folder.name) / "a.crowd")

    def test_theatre_by_rank(self):
        example("theatre_by_rank").main(self.output)
        scene = crowdbrush.open(self.output)
        seats = scene.seats
        taken = ~seats["free"]
        self.assertEqual(np.count_nonzero(taken), len(scene))
        self.assertTrue(np.all(taken[seats["rank"] < 3]))
        self.assertTrue(0.5 < taken[seats["rank"] >= 8].mean() < 0.85)

    def test_mosaic(self):
        mosaic = example("mosaic")
        pixels = mosaic.sunrise(6, 10)
        scene = crowdbrush.Scene()
        ids = mosaic.stand(scene, pixels)
        np.testing.assert_array_equal(scene.ids, ids)
        np.testing.assert_array_equal(scene.column("tint0")[:, :3], pixels.reshape(-1, 3))
        mosaic.main(self.output)

    def test_procession(self):
        example("procession").main(self.output)
        scene = crowdbrush.open(self.output)
        places = scene.column("position")[: len(scene) // 2, [0, 2]]
        headings = scene.column("heading")[: len(scene) // 2]
        ahead = np.diff(places, axis=0)
        ahead /= np.hypot(*ahead.T)[:, None]
        facing = np.stack([np.sin(headings), np.cos(headings)], axis=1)[:-1]
        self.assertGreater(np.sum(ahead * facing, axis=1).min(), 0.8)

    def test_wave_brush(self):
        wave = example("wave_brush")
        self.assertIn("Wave", crowdbrush.brushes)
        scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        outcome = scene.stroke(wave.WaveBrush(), [(200, 330), (300, 330)], size=(1280, 720))
        self.assertGreater(outcome.affected, 3)
        clips = scene.templates[0].clip_names
        self.assertIn("sit_cheer", [clips[c] for c in scene.column("clip")])
        self.assertEqual(len(scene.history), 1)

    def test_statistics(self):
        scene = crowdbrush.open("builtin:scenes/theatre.crowd")
        lines = list(example("statistics").report(scene))
        self.assertTrue(lines[0].startswith(f"{len(scene)} people"))
        self.assertTrue(any("seats are taken" in line for line in lines))


if __name__ == "__main__":
    unittest.main()
