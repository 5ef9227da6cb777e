# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md name the files that one more of a kind takes: all that name the
recipe's example, and no others. With --report, how many that are."""

import dataclasses
import fnmatch
import re
import sys

from sources import ROOMS, code, files, text

# By programs, from the source.
GENERATED = ("app/python/crowdbrush.pyi",)


@dataclasses.dataclass(frozen=True)
class Example:
    """`symbol`: what every file has that knows of it. `users`: files that name it as they could
    name any other of its kind (a ready-made rule, a benchmark), with patterns."""

    symbol: str
    users: tuple[str, ...] = ()
    most: int = 9  # numbered files


EXAMPLES = {
    "A brush": Example(r"\bScaleSettings\b|\bBrushKind::Scale\b|\bBRUSH\(Scale\b|"
                       r"\bBrushKind\.SCALE\b|\bbrush\.scale\b", most=4),
    "An operator": Example(r"\bGradientOperator\b|\bBrushOperator::Gradient\b|"
                           r"\bOPERATOR\(Gradient\)", most=3),
    "A selection": Example(r"\bBrushSelection::Lasso\b|\bLasso +///<|\"LASSO\"",
                           users=("app/commands/BenchPaint.cpp", "app/window/SelectActions.cpp"), most=6),
    "A property of individuals": Example(r"\bwalkSpeed\b|\bWalkSpeed\b",
                                         users=("behavior/validation/*",), most=3),
    "A member of the scene": Example(r"\bmembers::Cues\b|\bScene::cues\b|\"cues\"|"
                                     r"std::vector<Cue> cues;", most=3),
    "An action of rules": Example(r"\bSetSpeed\b", most=4,
                                  users=("model/rules/RuleSets.cpp", "model/rules/Rule.h")),
    "A trigger of rules": Example(r"\bArrived\b", most=4, users=("model/rules/RuleSets.cpp",)),
    "A condition of rules": Example(r"\bIsSeated\b", most=4,
                                    users=("model/rules/RuleSets.cpp",)),
    "A field of the light": Example(r"\bskyZenith\b", most=3,
                                     users=("model/scene/ReadyLight.cpp", "model/scene/DayLight.cpp")),
    "A kind of light": Example(r"\bLightKind::Point\b|\bkPointLight\b|\bbeginPoint\b", most=6),
    "A look": Example(r"\bLook::Plain\b|\"plain\"", users=("app/commands/BenchRender.cpp",), most=3),
    "A kind of mark": Example(r"\bMarkKind::Event\b|\"event\", QT", most=5,
                              users=("model/rules/*",)),
    "A format of pictures": Example(r"\"png\"", users=("model/gltf/*",), most=2),
    "A pass of pictures": Example(r"\{\"depth\", QT|\"depth\.Z\"", most=2),
    "A panel": Example(r"\bHistoryDock\b|\bDockId::History\b|^    History,$", most=7),
    "A test": Example(r"\btst_BrushColour\b", most=2),
}


def recipes():
    """Title → (the example's name, numbered files, files under a condition)."""
    found = {}
    for section in re.split(r"^### ", text("CONTRIBUTING.md"), flags=re.MULTILINE)[1:]:
        title = section.splitlines()[0]
        name = re.search(r"^Example: (\w+)\.", section, re.MULTILINE).group(1)
        items = re.findall(r"^(\d\.|-) (.*(?:\n  .*)*)", section, re.MULTILINE)
        paths = {"numbered": [], "others": []}
        for mark, item in items:
            named = [each for each in re.findall(r"`([^`\s]+)`", item)
                     if "/" in each and "(" not in each]
            kind = "others" if mark == "-" else "numbered"
            paths[kind] += named if mark == "-" else named[:1]
        found[title] = (name, paths["numbered"], paths["others"])
    return found


def pattern_of(path, name):
    filled = path.replace("NAME", name).replace("ROOM", "*")
    filled = re.sub(r"\bname\b|(?<=_)name\b", name.lower(), filled)
    return filled + "*" if filled.endswith("/") else filled


def matches(each, patterns):
    return any(fnmatch.fnmatch(each, pattern) for pattern in patterns)


def knowing(symbol, folders):
    found = re.compile(symbol, re.MULTILINE)
    return [each for each in code(*folders) if found.search(text(each)) and each not in GENERATED]


def complaints(title, example, name, numbered, others):
    folders = (*ROOMS, "tests") if title == "A test" else (*ROOMS, "resources/shaders")
    listed = [pattern_of(path, name) for path in numbered + others]
    for each in knowing(example.symbol, folders):
        if not matches(each, listed + list(example.users)):
            yield f"{each} names {name}, but the recipe does not name it"
    everywhere = knowing(example.symbol, (*ROOMS, "tests"))
    for path in numbered:
        pattern = pattern_of(path, name)
        if not any(matches(each, [pattern]) for each in files()):
            yield f"there is no {path} of {name}"
        elif not path.startswith("resources/") and not any(
                matches(each, [pattern]) for each in everywhere):
            yield f"{path} does not name {name}"
    if len(numbered) > example.most:
        yield f"it takes {len(numbered)} files; there were {example.most}"


def main():
    failed = False
    written = recipes()
    for title in sorted(set(EXAMPLES) ^ set(written)):
        failed = True
        print(f"{title}: in CONTRIBUTING.md or in this test alone")
    for title in sorted(set(EXAMPLES) & set(written)):
        name, numbered, others = written[title]
        if "--report" in sys.argv:
            print(f"{title}: {len(numbered)} files, {len(others)} where needed")
        for complaint in complaints(title, EXAMPLES[title], name, numbered, others):
            failed = True
            print(f"{title}: {complaint}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
