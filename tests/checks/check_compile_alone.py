# SPDX-License-Identifier: MIT
"""Which files tests/tools/compile_alone.py reads, and how."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools"))

import compile_alone  # noqa: E402

INCLUDES = {
    "model/Crowd.cpp": ["model/Crowd.h"],
    "model/Other.cpp": ["model/Other.h"],
    "tests/model/tst_Crowd.cpp": ["model/Crowd.h", "tests/model/People.h"],
    "tests/model/tst_Other.cpp": ["model/Other.h"],
}


def read_after(*changed):
    return list(compile_alone.files_to_read(set(changed), INCLUDES, INCLUDES.get))


class CompileAlone(unittest.TestCase):
    def test_changed_tests_are_read(self):
        self.assertEqual(read_after("tests/model/tst_Other.cpp"), ["tests/model/tst_Other.cpp"])

    def test_changed_files_of_rooms_are_left_to_clang_tidy(self):
        self.assertEqual(read_after("model/Crowd.cpp"), [])
        self.assertEqual(read_after("model/Crowd.cpp", "model/Crowd.h"),
                         ["tests/model/tst_Crowd.cpp"])

    def test_who_includes_a_changed_header_is_read(self):
        self.assertEqual(read_after("model/Crowd.h"),
                         ["model/Crowd.cpp", "tests/model/tst_Crowd.cpp"])
        self.assertEqual(read_after("tests/model/People.h"), ["tests/model/tst_Crowd.cpp"])

    def test_many_are_read_in_even_steps(self):
        self.assertEqual(compile_alone.some_of(list(range(9)), 3), [0, 3, 6])
        self.assertEqual(compile_alone.some_of([1, 2], 3), [1, 2])

    def test_nothing_is_made(self):
        words = compile_alone.reading(
            "cmake -E env A=1 /usr/bin/ccache /usr/bin/c++ -DA=1 -O2 -o a.o -c a.cpp", "/mocs")
        self.assertEqual(words, ["/usr/bin/c++", "-DA=1", "-O2", "-c", "a.cpp",
                                 "-fsyntax-only", "-I/mocs"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
