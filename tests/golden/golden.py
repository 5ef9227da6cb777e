# SPDX-License-Identifier: MIT
"""Recordings that must stay as they are, byte for byte, while the program is rebuilt.

`crowdbrush script tests/golden/golden.py` compares; with `--write` it writes them anew, which is right
only where a change is wanted and somebody has looked at what it changes.

strokes/   what each brush leaves behind, for every selection and operator: whole scenes, so that a
           difference can be read.
sessions/  where people are, and what they do, second by second: a digest of each column.
window/    sessions with mouse and keys, as they were recorded in the window, and what they made:
           tests/gui/tst_Recording writes new ones where CROWD_KEEP_RECORDINGS names this folder.
files/     project files that open and are saved as the same bytes.
"""
import argparse
import difflib
import pathlib
import runpy
import sys
import tempfile
import unittest.mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import crowdbrush  # noqa: E402

import sessions  # noqa: E402  (beside this file)
import strokes  # noqa: E402

SHOWN_LINES = 12


def differences(name, before, now):
    """The first lines that differ, as text."""
    lines = difflib.unified_diff(before.splitlines(), now.splitlines(), "golden", "now",
                                 lineterm="", n=0)
    return [f"{name} differs:"] + [f"  {line[:160]}" for line, _ in zip(lines, range(SHOWN_LINES))]


def check(path, now, writes):
    """What is wrong with one recording, as lines."""
    if writes:
        path.parent.mkdir(exist_ok=True)
        path.write_text(now, encoding="utf-8", newline="\n")
        return []
    if not path.exists():
        return [f"{path.relative_to(HERE)} is missing: run this with --write"]
    before = path.read_bytes().decode("utf-8")
    return [] if before == now else differences(path.relative_to(HERE), before, now)


def saved(scene):
    """The project file of a scene as text."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.crowd"
        scene.save(path)
        return path.read_bytes().decode("utf-8")


def replayed(script):
    """What a script that was recorded in the window makes, as the text of a project file."""
    with unittest.mock.patch.object(sys, "argv", [str(script)]):  # it saves where an argument says
        return saved(runpy.run_path(str(script))["scene"])


def stale(made):
    """Recordings that no case makes any more."""
    kept = {path for folder in ("strokes", "sessions") for path in (HERE / folder).glob("*.*")}
    return [f"{path.relative_to(HERE)} belongs to no case" for path in sorted(kept - made)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="write them anew")
    parser.add_argument("--only", default="", help="cases whose name contains this")
    options = parser.parse_args()
    passed, wrong, made = 0, [], set()
    cases = [(f"strokes/{name}.crowd", lambda run=run: saved(run())) for name, run in strokes.cases()]
    cases += [(f"sessions/{name}.txt", run) for name, run in sessions.cases()]
    cases += [(f"window/{path.stem}.crowd", lambda path=path: replayed(path))
              for path in sorted((HERE / "window").glob("*.py"))]
    cases += [(f"files/{path.name}", lambda path=path: saved(crowdbrush.open(path)))
              for path in sorted((HERE / "files").glob("*.crowd"))]
    for name, run in cases:
        made.add(HERE / name)
        if options.only in name:
            found = check(HERE / name, run(), options.write)
            wrong += found
            passed += not found
    if not options.only:
        wrong += stale(made)
    print("\n".join(wrong + [f"{passed} recordings as they were"]))
    return 1 if wrong or passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
