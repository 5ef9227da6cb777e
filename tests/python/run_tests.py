# SPDX-License-Identifier: MIT
"""Runs every test beside this file: in plain python3 or through `crowdbrush script`."""
import pathlib
import sys
import unittest

import crowdbrush

# Scenes share the built-in characters and the animations that one of them keeps: nothing is read or
# baked a second time.
kept = crowdbrush.open("builtin:scenes/theatre.crowd")
kept.stroke(crowdbrush.Brush(crowdbrush.BrushKind.COLOUR), [(1, 1)], size=(64, 64))

suite = unittest.defaultTestLoader.discover(str(pathlib.Path(__file__).parent))
result = unittest.TextTestRunner(verbosity=2).run(suite)
sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)
