# SPDX-License-Identifier: MIT
"""Reads .cpp files one by one with the compiler, so that an include that one of them forgot is
missed: the presets compile the files of a folder together, and each has the others' includes.

Of what has changed since the commit BASE: tests, and whatever includes a changed header itself.
(Changed files of the rooms are read alone by clang-tidy.) Says what the compiler says. A file takes
up to seven seconds; where very much includes what has changed, only some are read, and that is said.

    compile_alone.py BUILD BASE     BUILD is configured without unity build and precompiled headers
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("app", "behavior", "model", "render", "widgets")
MOC = "/usr/lib/qt6/libexec/moc"
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
MOST = 40  # files in a run: some four minutes
COMPILER = re.compile(r"(?:^|/)(?:c|g|clang)\+\+(?:-\d+)?$")


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, text=True, capture_output=True,
                          check=True).stdout.split()


def files_to_read(changed, sources, includes_of):
    """Those of `sources` that are changed tests, or that include a changed header themselves."""
    headers = {name for name in changed if name.endswith(".h")}
    for source in sources:
        is_changed = source in changed
        if is_changed and source.startswith("tests/"):
            yield source
        elif not is_changed and headers.intersection(includes_of(source)):
            yield source


def some_of(sources, most=MOST):
    """At most so many, in even steps."""
    step = max(1.0, len(sources) / most)
    return [sources[int(i * step)] for i in range(min(most, len(sources)))]


def includes_of(source):
    return INCLUDE.findall((ROOT / source).read_text(encoding="utf-8"))


def reading(command, mocs):
    """The command of a compilation that makes nothing, without what is put before the compiler."""
    words = shlex.split(command)
    first = next(i for i, word in enumerate(words) if COMPILER.search(word))
    words = words[first:]
    at = words.index("-o")
    return [*words[:at], *words[at + 2:], "-fsyntax-only", f"-I{mocs}"]


def read(command, folder, mocs):
    source = pathlib.Path(command["file"])
    if f"{source.stem}.moc" in includes_of(source):
        subprocess.run([MOC, f"-I{ROOT}", source, "-o", f"{mocs}/{source.stem}.moc"], check=True)
    return subprocess.run(reading(command["command"], mocs), cwd=folder, text=True,
                          capture_output=True, check=False)


def main():
    build, base = sys.argv[1:]
    changed = set(git("diff", "--name-only", "--diff-filter=d", base, "--", *ROOMS, "tests"))
    sources = git("ls-files", "--", *(f"{room}/*.cpp" for room in (*ROOMS, "tests")))
    all_of_them = list(files_to_read(changed, sources, includes_of))
    wanted = {str(ROOT / name) for name in some_of(all_of_them)}
    commands = json.loads(pathlib.Path(build, "compile_commands.json").read_text("utf-8"))
    commands = list({each["file"]: each for each in commands if each["file"] in wanted}.values())
    print(f"Reading {len(commands)} of {len(all_of_them)} files alone", file=sys.stderr)
    failed = 0
    with tempfile.TemporaryDirectory() as mocs, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        for done in workers.map(lambda each: read(each, build, mocs), commands):
            if done.returncode != 0:
                failed += 1
                print(done.stderr, end="")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
