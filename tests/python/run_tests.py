# SPDX-License-Identifier: MIT
"""Runs every test beside this file, in plain python3 or through `crowdbrush script`; with --smoke
those that find most of what differs between the two, and of what sanitizers look for."""
import pathlib
import sys
import unittest

import crowdbrush

# Scenes share the built-in characters and the animations that one of them keeps: nothing is read or
# baked a second time.
kept = crowdbrush.open("builtin:scenes/theatre.crowd")
kept.stroke(crowdbrush.Brush(crowdbrush.BrushKind.COLOUR), [(1, 1)], size=(64, 64))

SMOKE = ("test_[hs]*.py", "test_painting.py", "test_presets.py")  # hostile, session, stopping, …

folder = pathlib.Path(__file__).parent
patterns = SMOKE if "--smoke" in sys.argv[1:] else ("test_*.py",)
suite = unittest.TestSuite(
    unittest.defaultTestLoader.discover(str(folder), pattern=pattern) for pattern in patterns)
result = unittest.TextTestRunner(verbosity=2).run(suite)
sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)
