# SPDX-License-Identifier: MIT
"""Settings that are copied and that go to another process."""
import copy
import pickle
import unittest

import crowdbrush
from crowdbrush import Brush, BrushKind


def brushes():
    for name, kind in BrushKind.__members__.items():
        brush = Brush(kind)
        brush.radius = 33
        brush.mask.groups = [1, 2]
        yield name, brush


class Pickles(unittest.TestCase):
    def test_brushes(self):
        for name, brush in brushes():
            with self.subTest(name):
                self.assertEqual(pickle.loads(pickle.dumps(brush)), brush)

    def test_copies_are_of_their_own(self):
        brush = Brush(BrushKind.COLOUR)
        brush.colour.slot = "top"
        brush.create.density = 0.7  # of another kind
        for made in (copy.copy(brush), copy.deepcopy(brush), copy.deepcopy([brush])[0]):
            self.assertEqual(made, brush)
            self.assertAlmostEqual(made.create.density, 0.7, 5)
            made.colour.slot = "hair"
            self.assertEqual(brush.colour.slot, "top")

    def test_parts_of_a_brush(self):
        brush = Brush(BrushKind.CREATE)
        for part in (brush.create, brush.mask, brush.orientation.facing, brush.time):
            for made in (copy.copy(part), copy.deepcopy(part)):
                self.assertIs(type(made), type(part))
        made = copy.copy(brush.mask)
        made.groups = [4]
        self.assertEqual(brush.mask.groups, [])

    def test_cameras(self):
        flat = crowdbrush.Camera.exact((1, 2, 3), (1, 0, 0, 0), orthographic=True, height=7)
        for camera in (crowdbrush.Camera((0, 5, 9), (1, 1.5, 0), 33), flat):
            for made in (pickle.loads(pickle.dumps(camera)), copy.copy(camera), copy.deepcopy(camera)):
                self.assertEqual(made, camera)
                self.assertIsNot(made, camera)


if __name__ == "__main__":
    unittest.main()
