# SPDX-License-Identifier: MIT
"""The project's own files, for tests of what the documents say about them."""

import functools
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("app", "behavior", "model", "render", "widgets")
FOLDERS = (*ROOMS, ".ci", ".githooks", "cmake", "docs", "resources", "tests", "translations")
CODE = (".h", ".cpp", ".in", ".py", ".txt", ".cmake", ".glsl", ".vert", ".frag")


@functools.cache
def files():
    """All of them, relative to the root, as posix paths."""
    found = [path for path in ROOT.iterdir() if path.is_file()]
    for folder in FOLDERS:
        found += [path for path in (ROOT / folder).rglob("*") if path.is_file()]
    return sorted(path.relative_to(ROOT).as_posix() for path in found
                  if "__pycache__" not in path.parts)


@functools.cache
def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def code(*folders):
    """Files of code in these folders."""
    return [name for name in files()
            if name.startswith(tuple(folder + "/" for folder in folders)) and name.endswith(CODE)]


def without_fences(document):
    """A document's prose: blocks of code are commands and examples."""
    return re.sub(r"^```.*?^```", "", text(document), flags=re.DOTALL | re.MULTILINE)
