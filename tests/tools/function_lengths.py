# SPDX-License-Identifier: MIT
"""C++ functions longer than the house's limit, by the layout that clang-format gives them: the
brace of a body stands alone, as far in as the function's head. Prints nothing where there is none.
Functions called fields() are tables of data: they are as long as there are fields.

    function_lengths.py [--longest N] [FOLDER...]
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("app", "behavior", "model", "render", "widgets")
MOST = 50  # lines, from the head to the closing brace


# What else has a brace on a line of its own.
NO_FUNCTION = re.compile(r"\s*(?:template<[^(]*>\s*)*(?:class|struct|union|enum|namespace|extern|do)\b")
NAME = re.compile(r"([~\w:<>,& ]*?(?:operator[^\s(]+|operator\(\)|[~\w]+))\s*\(")


def head_of(lines, brace):
    """The first line of what ends before the brace: back to a line that ends something else."""
    first = brace
    while first > 0:
        before = lines[first - 1].strip()
        if not before or before[-1] in ";}{" or before.startswith(("#", "//", "///")) or \
                re.fullmatch(r"(?:public|private|protected|Q_SIGNALS)(?: Q_SLOTS)?:", before):
            break
        first -= 1
    return first


def functions(lines):
    """(number of the first line, lines, name) of each function with a body of several lines."""
    for brace, line in enumerate(lines):
        if line.strip() != "{" or len(line) - 1 not in (0, 4, 8):
            continue
        indent = line[:-1]
        first = head_of(lines, brace)
        head = " ".join(each.strip() for each in lines[first:brace])
        if "(" not in head or NO_FUNCTION.match(head):
            continue
        end = next((i for i in range(brace + 1, len(lines))
                    if lines[i].startswith(indent + "}")), None)
        if end is not None:
            found = NAME.search(head)
            name = found.group(1).split()[-1] if found and found.group(1).split() else head[:60]
            yield first + 1, end - first + 1, name


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--longest", type=int, metavar="N", help="list the longest instead")
    parser.add_argument("folders", nargs="*", default=[ROOT / room for room in ROOMS])
    options = parser.parse_args()

    found = []
    for folder in map(pathlib.Path, options.folders):
        for path in sorted((*folder.rglob("*.h"), *folder.rglob("*.cpp"))):
            lines = path.read_text(encoding="utf-8").splitlines()
            shown = str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)
            found += [(count, shown, first, name) for first, count, name in functions(lines)
                      if name.split("::")[-1] != "fields"]
    found.sort(key=lambda each: (-each[0], each[1:]))
    listed = found[:options.longest] if options.longest else \
        [each for each in found if each[0] > MOST]
    for count, file, first, name in listed:
        print(f"{file}:{first}: {name}: {count} lines")
    sys.exit(bool(listed) and not options.longest)


if __name__ == "__main__":
    main()
