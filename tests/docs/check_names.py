# SPDX-License-Identifier: MIT
"""Every file, folder, class and function that a document names in backticks is there."""

import collections
import fnmatch
import functools
import pathlib
import re
import sys

from sources import ROOMS, code, files, text, without_fences

DOCUMENTS = ("docs/architecture.md", "CONTRIBUTING.md")


def is_path(name):
    return "/" in name or re.search(r"\.(h|cpp|py|pyi|md|svg|txt|cmake|ts|json|yaml)$", name)


def has_path(name):
    """`NAME` in a path stands for whatever something is called; a bare file name is found
    wherever it is."""
    pattern = re.sub(r"NAME|ROOM|\bname\b|(?<=_)name\b", "*", name)
    if name.endswith("/"):
        return any(fnmatch.fnmatch(each, pattern + "*") for each in files())
    if "/" not in name:
        return any(fnmatch.fnmatch(pathlib.PurePosixPath(each).name, pattern) for each in files())
    return any(fnmatch.fnmatch(each, pattern) for each in files())


@functools.cache
def owners():
    """Names of types and namespaces → the files that define them."""
    found = collections.defaultdict(set)
    for each in code(*ROOMS):
        for name in re.findall(r"\b(?:class|struct|concept|using|namespace)\s+(\w+)", text(each)):
            found[name].add(each)
    return found


@functools.cache
def words(each):
    return set(re.findall(r"\w+", text(each)))


def is_defined(name):
    """A type; or a function, a member or a constant, by its use."""
    if name[0].isupper() and not name.isupper():
        return name in owners()
    return any(name in words(each) for each in code(*ROOMS, "cmake"))


def has_member(owner, member):
    return any(member in words(each) for each in owners().get(owner, ()))


def has_command(words):
    return len(words) < 2 or re.search(rf"^(\w+ \| )*{words[1]}( \| [-\w]+)*\)", text("dev"),
                                       re.MULTILINE)


def is_there(name):
    words = name.split()
    if words[0] == "./dev":
        return has_command(words)
    if len(words) > 1 or not re.match(r"[\w.]", name):
        return True  # a command line, or a sign
    if name.startswith(".") and "/" not in name:
        return any(each.endswith(name) for each in files())
    if is_path(name):
        return name.startswith("build/") or has_path(name)
    owner, _, member = name.rstrip("()").partition("::")
    if member:
        return has_member(owner, member)
    if not owner.isidentifier():
        return any(owner in text(each) for each in files() if each.endswith("CMakeLists.txt"))
    return is_defined(owner)


def main():
    missing = []
    for document in DOCUMENTS:
        for number, line in enumerate(without_fences(document).splitlines(), 1):
            missing += [f"{document}: `{name}`: {line.strip()[:60]}"
                        for name in re.findall(r"`([^`]+)`", line) if not is_there(name)]
    for each in missing:
        print(f"There is no such thing: {each}")
    sys.exit(bool(missing))


if __name__ == "__main__":
    main()
