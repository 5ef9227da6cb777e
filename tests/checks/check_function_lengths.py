# SPDX-License-Identifier: MIT
"""Which functions tests/tools/function_lengths.py finds, and how long it says they are."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "tools" / "function_lengths.py"
LONG_BODY = "    one();\n" * 60


class FunctionLengths(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def found_in(self, source, *options):
        (self.folder / "one.cpp").write_text(source, encoding="utf-8")
        return subprocess.run([sys.executable, "-B", SCRIPT, *options, self.folder], text=True,
                              capture_output=True, check=False)

    def assert_found(self, source, what):
        done = self.found_in(source)
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stdout.strip().endswith(what), done.stdout)

    def assert_nothing(self, source):
        done = self.found_in(source)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_long_function_is_named(self):
        self.assert_found("void Dock::fill()\n{\n" + LONG_BODY + "}\n",
                          "one.cpp:1: Dock::fill: 63 lines")

    def test_fifty_lines_are_enough(self):
        self.assert_nothing("void fill()\n{\n" + "    one();\n" * 47 + "}\n")

    def test_heads_of_several_lines_count(self):
        self.assert_found("/// Fills.\ntemplate<class T>\nvoid fill(int a,\n          int b)\n{\n" +
                          LONG_BODY + "}\n", "one.cpp:2: fill: 65 lines")

    def test_functions_in_classes_are_found(self):
        inside = "".join("    " + line + "\n" for line in
                         ("void fill()\n{\n" + LONG_BODY + "}").splitlines())
        self.assert_found("class Dock\n{\npublic:\n" + inside + "};\n",
                          "one.cpp:4: fill: 63 lines")

    def test_classes_and_tables_are_no_functions(self):
        self.assert_nothing("struct Dock : Base<int (*)(int)>\n{\n" + "    int a;\n" * 80 + "};\n")
        self.assert_nothing("constexpr auto Dock::fields()\n{\n" + LONG_BODY + "}\n")

    def test_the_longest_are_listed(self):
        done = self.found_in("void fill()\n{\n    one();\n}\n", "--longest", "3")
        self.assertEqual(done.returncode, 0)
        self.assertIn("fill: 4 lines", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
