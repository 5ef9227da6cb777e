# SPDX-License-Identifier: MIT
"""The stubs and the manual say what the module is."""
import importlib.util
import pathlib
import unittest

import crowdbrush

ROOT = pathlib.Path(__file__).resolve().parents[2]


def describer():
    spec = importlib.util.spec_from_file_location("describe", ROOT / "app/python/describe.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Described(unittest.TestCase):
    maxDiff = 2000

    def test_stubs_are_fresh(self):
        self.assertEqual(describer().stubs(), (ROOT / "app/python/crowdbrush.pyi").read_text(),
                         "run ./dev describe")

    def test_the_manual_is_fresh(self):
        self.assertEqual(describer().manual(), (ROOT / "docs/python.md").read_text(),
                         "run ./dev describe")

    def test_everything_is_explained(self):
        describe = describer()
        classes, functions = describe.public()
        silent = [name for name, value in functions if not describe.Function("", name, value).doc]
        for name, cls in classes:
            if describe.is_enum(cls):
                continue
            for member, value in describe.members(cls):
                is_plain = member.startswith("__") or isinstance(value, property)
                if not is_plain and callable(getattr(cls, member)):
                    if not describe.Function(name, member, getattr(cls, member)).doc:
                        silent.append(f"{name}.{member}")
        self.assertEqual(silent, [])


if __name__ == "__main__":
    unittest.main()
