# SPDX-License-Identifier: MIT
"""Describes the module crowdbrush as it is built: its stubs, or its page of the manual.

    describe.py stubs > app/python/crowdbrush.pyi
    describe.py manual > docs/python.md"""
import enum
import inspect
import re
import sys
import textwrap

import crowdbrush

INDENT = "    "
HEAD = '''# SPDX-License-Identifier: MIT
# Written by app/python/describe.py from the module as it is built: ./dev describe
"""{doc}"""
import os
from typing import Any, Callable, ClassVar, Dict, Iterator, List, Literal, Mapping, MutableMapping, Optional, Sequence, Tuple, TypeVar, Union

import numpy
import numpy.typing

_Array = numpy.typing.NDArray[Any]
FilePath = Union[str, "os.PathLike[str]"]
Array = Any
"""Whatever NumPy makes an array of: an array, a list, a number that stands for all."""
Ids = Any
"""Ids as an array or a list, or a mask with a bool for each individual."""
Clips = Union[str, Sequence[str], Mapping[str, float], Sequence[Mapping[str, Any]]]
"""A clip, several, or several with weights."""
_B = TypeVar("_B")

brushes: Dict[str, Any]
"""Brushes that register_brush made known, by name."""
presets: "Presets"
"""Those that the editor keeps."""
NEAREST_PATH: int
"""Instead of a path's id in a walk brush: the path that each is nearest to."""
'''

# What pybind11 writes of types, in words of typing.
TYPES = [
    (r"\bcrowdbrush\.", ""),
    (r"\bos\.PathLike\b", "FilePath"),
    (r"List\[(float|int)\[\d+\]\]", r"Sequence[\1]"),
    (r"\bfunction\b", "Callable[[float], Any]"),
    (r"\bdict\b", "Dict[Any, Any]"),
    (r"\blist\b", "List[Any]"),
    (r"numpy\.ndarray\[[^\]]*\]", "numpy.ndarray"),
    (r"\bnumpy\.ndarray\b", "_Array"),
    (r"\bobject\b", "Any"),
    (r"\bhandle\b", "Any"),
    (r"\*\*kwargs", "**columns: Array"),
]
# What it takes where pybind11 says less than there is.
ARGUMENTS = {
    ("Scene", "remove", "ids"): "Ids",
    ("Scene", "change", "ids"): "Ids",
    ("Scene", "send", "ids"): "Optional[Ids]",
    ("Session", "send", "ids"): "Optional[Ids]",
    ("Scene", "set_environment", "environment"): "Union[str, Dict[str, Any]]",
    ("Scene", "make_movie", "frames"): "Sequence[int]",
    ("Scene", "make_movie", "passes"): "Sequence[str]",
    ("Scene", "render_passes", "passes"): "Sequence[str]",
    ("Scene", "stroke", "points"): "Array",
    ("Scene", "stroke", "brush"): "Union[Brush, Any]",
    ("Scene", "change_template", "template"): "Union[Template, int]",
    ("Scene", "remove_template", "template"): "Union[Template, int]",
    ("Scene", "change_stage", "stage"): "Union[Stage, int]",
    ("Scene", "remove_stage", "stage"): "Union[Stage, int]",
}
ERROR_DOC = "What is wrong, as the editor would say it. Nothing has changed."
RESULTS = {("Scene", "render"): "Picture", ("Session", "render"): "Picture", ("Edit", "__enter__"): "Scene",
           ("Presets", "__iter__"): "Iterator[str]", ("States", "__iter__"): "Iterator[str]", ("Presets", "keys"): "List[str]",
           ("Presets", "values"): "List[Brush]", ("Presets", "items"): "List[Tuple[str, Brush]]"}


def typed(text):
    for pattern, by in TYPES:
        text = re.sub(pattern, by, text)
    return text.strip()


def split_arguments(text):
    """At commas that stand in no bracket."""
    parts, depth, start = [], 0, 0
    for i, letter in enumerate(text):
        depth += (letter in "([{<") - (letter in ")]}>" and text[i - 1:i + 1] != "->")
        if letter == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    return [part for part in parts + [text[start:].strip()] if part]


def of_pybind(doc):
    """(arguments, result, what it says) of a docstring that pybind11 began with a signature."""
    first, _, rest = doc.partition("\n")
    match = re.match(r"\w+\((.*)\) -> (.*)$", first)
    return split_arguments(match[1]), match[2], rest.strip()


def argument(owner, function, text):
    name, colon, rest = text.partition(":")
    if not colon:
        return typed(text)
    kind, equals, default = rest.partition(" = ")
    kind = ARGUMENTS.get((owner, function, name), typed(kind))
    if default == "None" and not kind.startswith(("Optional", "Union[None")) and kind != "Any":
        kind = f"Optional[{kind}]"
    return f"{name}: {kind}" + (" = ..." if equals else "")


def plain(annotation, missing="Any"):
    """An annotation of Python's own as text."""
    if annotation is inspect.Signature.empty:
        return missing
    return typed(annotation.__name__ if isinstance(annotation, type) else str(annotation).strip("'\""))


class Function:
    def __init__(self, owner, name, value):
        doc = value.__doc__ or ""
        self.is_of_class = bool(owner) and isinstance(
            inspect.getattr_static(getattr(crowdbrush, owner), name), classmethod)
        self.is_static = isinstance(inspect.getattr_static(getattr(crowdbrush, owner), name), staticmethod) if owner else False
        if re.match(r"\w+\(.*\) -> ", doc.partition("\n")[0]):
            arguments, result, self.doc = of_pybind(doc)
            self.arguments = [argument(owner, name, each) for each in arguments]
            if owner and self.arguments and self.arguments[0].startswith("self"):
                self.arguments[0] = "self"
            elif owner and not self.is_static and self.arguments:
                self.arguments[0] = "self"
            self.result = RESULTS.get((owner, name), typed(result))
        else:
            signature = inspect.signature(value)
            self.arguments = [typed(re.sub(r" = .*", " = ...", str(each).replace("'", "")))
                              for each in signature.parameters.values()]
            self.result = plain(signature.return_annotation, "None")
            self.doc = inspect.getdoc(value) or ""
            if self.doc.startswith("Initialize self."):
                self.doc = ""
            if self.is_of_class:
                self.arguments.insert(0, "cls")
        if name in ("__eq__", "__ne__"):
            self.arguments = ["self", "other: Any"]
            self.result = "bool"

    def line(self, name):
        return f"def {name}({', '.join(self.arguments)}) -> {self.result}:"


def documented(doc, indent):
    if not doc:
        return [f"{indent}..."]
    if len(doc) > 90 and "\n" not in doc:
        doc = "\n".join(textwrap.wrap(doc, 94 - len(indent), break_long_words=False))
    return [f'{indent}"""{doc.replace(chr(10), chr(10) + indent)}"""']


def members(cls):
    skipped = {"__module__", "__dict__", "__weakref__", "__doc__", "__annotations__", "__new__",
               "__match_args__", "__dataclass_fields__", "__dataclass_params__", "__setattr__",
               "__delattr__", "__entries", "__members__"}
    for name, value in vars(cls).items():
        if name == "__init__" and "Initialize self." in (value.__doc__ or "") and not inspect.isfunction(value):
            continue  # nobody makes one
        is_wanted = not name.startswith("_") or name in (
            "__init__", "__len__", "__eq__", "__hash__", "__enter__", "__exit__", "__iter__", "__contains__",
            "__getitem__", "__setitem__", "__delitem__")
        if name not in skipped and is_wanted and not name.startswith("_pybind"):
            yield name, value


def is_enum(cls):
    return hasattr(cls, "__members__")


def of_property(cls, name, value):
    """(type, what it says, whether it can be set)."""
    doc = value.fget.__doc__ or ""
    if "->" in doc.partition("\n")[0]:
        kind = typed(doc.partition("\n")[0].rpartition("->")[2])
        said = value.__doc__ or ""
        return kind, "" if "->" in said.partition("\n")[0] else said.strip(), value.fset is not None
    return plain(inspect.signature(value.fget).return_annotation), inspect.getdoc(value) or "", \
        value.fset is not None


def is_entry(cls):
    """Of those that entries.py makes of the schema."""
    return issubclass(cls, crowdbrush.Entry) and bool(cls._fields)


def is_space(cls):
    """Holds the kinds of a part of rules."""
    return any(isinstance(each, type) and is_entry(each) for each in vars(cls).values())


def kinds_of(space):
    return [each for each in vars(space).values() if isinstance(each, type)]


def entry_type(field, is_argument):
    """Of a member of an entry: what it is, or what it can be made of."""
    def of_entry(name):
        return f"Union[{name}, Dict[str, Any]]" if is_argument else name

    a_list = "Sequence" if is_argument else "List"
    if field.type.startswith("list of "):
        return f"{a_list}[{of_entry(field.type[8:])}]"
    if field.type.startswith("ids of "):
        return f"Sequence[Union[int, {field.type[7:]}]]" if is_argument else "List[int]"
    if field.type == "choice":
        return f"Literal[{', '.join(chr(34) + each + chr(34) for each in field.choices)}]"
    if field.refers and is_argument:
        return f"Union[int, {field.refers}]"
    plain_types = {"color": ("str", "Union[str, Sequence[int]]"), "tint": ("str", "Union[str, Sequence[int]]"),
                   "point": ("List[float]", "Sequence[float]"), "range": ("List[float]", "Sequence[float]"),
                   "curve": ("List[float]", "Sequence[float]"), "ids": ("List[int]", "Sequence[Any]"),
                   "numbers": ("List[int]", "Sequence[int]"),
                   "points": ("List[List[float]]", "Sequence[Sequence[float]]"),
                   "colors": ("List[str]", "Sequence[Union[str, Sequence[int]]]"),
                   "clips": ("List[Dict[str, Any]]", "Clips"), "any": ("Any", "Any"),
                   "values": ("List[List[float]]", "Sequence[Sequence[float]]")}
    if field.type[0].isupper():
        return of_entry(field.type)
    return plain_types.get(field.type, (field.type, field.type))[is_argument]


NOT_CHOSEN = 0xFFFFFFFF


def facts_of(field):
    """What it says, its range and what it begins with."""
    facts = [field.doc]
    if field.low is not None and field.high < NOT_CHOSEN:
        facts.append(f"{field.low:g} to {field.high:g}".replace("e+0", "e") + f" {field.unit}".rstrip())
    elif field.unit:
        facts.append(field.unit)
    if field.is_needed:
        facts.append("must be given")
    elif field.refers and field.default == NOT_CHOSEN:
        facts.append("to be chosen")
    elif not isinstance(field.default, (list, dict)) and field.default not in ("", None):
        facts.append(f"begins as {field.default!r}")
    return "; ".join(each for each in facts if each)


def entry_lines(cls):
    base = cls.__mro__[1].__name__
    lines = ["", "", f"class {cls.__name__}({base}):"] + documented(inspect.getdoc(cls) or "", INDENT)
    arguments = [f"{name}: {entry_type(field, True)}" + ("" if field.is_needed else " = ...")
                 for name, field in cls._fields.items()]
    signature = ", ".join(["self"] + (["*"] + arguments if arguments else []))
    lines += [f"{INDENT}def __init__({signature}) -> None:", f"{2 * INDENT}..."]
    for name, field in cls._fields.items():
        lines += [f"{INDENT}{name}: {entry_type(field, False)}"] + documented(facts_of(field), INDENT)
    return lines


def space_lines(cls):
    lines = ["", "", f"class {cls.__name__}:"] + documented(inspect.getdoc(cls) or "", INDENT)
    for kind in kinds_of(cls):
        lines += [INDENT + line if line else "" for line in entry_lines(kind)[1:]]
    return lines


def class_lines(name, cls):
    if is_entry(cls):
        return entry_lines(cls)
    if is_space(cls):
        return space_lines(cls)
    bases = {"Picture": "numpy.ndarray[Any, Any]", "Error": "RuntimeError", "Entry": "Dict[str, Any]",
             "Features": "MutableMapping[str, FeatureValues]",
             "RelationKinds": "MutableMapping[str, RelationKind]", "FeatureValues": "MutableMapping[str, FeatureValue]"}
    base = bases.get(name, "Entry" if issubclass(cls, crowdbrush.Entry) else "")
    lines = ["", "", f"class {name}({base}):" if base else f"class {name}:"]
    doc = ERROR_DOC if name == "Error" else inspect.getdoc(cls) or ""
    if is_enum(cls):
        doc = doc.partition("\n\nMembers:")[0].strip()
        doc = "" if doc.startswith("Members:") else doc
    lines += documented(doc, INDENT) if doc else []
    if name == "Error":
        return lines
    if is_enum(cls):
        lines += [f"{INDENT}{each}: ClassVar[{name}]" for each in cls.__members__]
        lines += [f"{INDENT}name: str", f"{INDENT}value: int"]
        return lines
    for field, kind in getattr(cls, "__annotations__", {}).items():
        lines.append(f"{INDENT}{field}: {plain(kind)}")
    for member, value in members(cls):
        if value is None:
            continue
        if isinstance(value, property):
            kind, said, can_set = of_property(cls, member, value)
            lines += [f"{INDENT}@property", f"{INDENT}def {member}(self) -> {kind}:"]
            lines += documented(said, 2 * INDENT)
            if can_set:
                lines += [f"{INDENT}@{member}.setter", f"{INDENT}def {member}(self, value: {kind}) -> None:",
                          f"{2 * INDENT}..."]
        elif member == "__hash__":
            lines.append(f"{INDENT}def __hash__(self) -> int: ...")
        elif callable(getattr(cls, member)) and member in getattr(cls, "__annotations__", {}):
            continue
        elif callable(getattr(cls, member)):
            function = Function(name, member, getattr(cls, member))
            if function.is_static:
                lines.append(f"{INDENT}@staticmethod")
            if function.is_of_class:
                lines.append(f"{INDENT}@classmethod")
            lines.append(INDENT + function.line(member))
            lines += documented(function.doc, 2 * INDENT)
    return lines


def public():
    """Classes first, in the order of their making."""
    everything = [(name, value) for name, value in vars(crowdbrush).items() if not name.startswith("_")]
    classes = [each for each in everything if inspect.isclass(each[1])]
    functions = [each for each in everything if callable(each[1]) and not inspect.isclass(each[1])]
    return classes, functions


def stubs():
    classes, functions = public()
    lines = [HEAD.format(doc=crowdbrush.__doc__).rstrip()]
    for name, cls in classes:
        lines += class_lines(name, cls)
    for name, value in functions:
        function = Function("", name, value)
        lines += ["", "", function.line(name)] + documented(function.doc, INDENT)
    return "\n".join(lines) + "\n"


INTRODUCTION = """# Crowdbrush in Python

{doc}

Written by `app/python/describe.py` from the module itself; `./dev describe` writes it again.

`import crowdbrush` works in the editor's console (**F12**, with the open document as `scene`), in
`crowdbrush script FILE.py`, and in a plain `/usr/bin/python3` with `build/release/python` on its
path. Neither of the last two needs a display. `tests/python/examples/` holds scripts to learn from.

What is wrong raises `crowdbrush.Error` with the message that the editor would show, before anything
changes. `with scene.edit("name"):` makes one undo step of what is in it, or none at all when an
exception leaves it. `Array` stands for whatever NumPy makes an array of; a single value stands for
all individuals.

`crowdbrush.Session(scene)` runs the crowd without a clock: `session.run(5)` lets people walk for five
seconds, `session.send("clap", ids)` sends them an event. In the console `scene.send("clap")` goes to
those who play in the window.

*Script > Record Script* in the editor writes down as Python what is done by hand.

## Columns

`scene.column(name)` gives a copy, rows by ascending id; `scene.create` and `scene.change` take the
same names as keywords.

| column | an individual | range | |
|---|---|---|---|
{columns}
"""


# Columns that are made of others, and before which of them they stand.
MADE_COLUMNS = {
    "template": "| `id` | uint32 | | never used again while the scene lives; for reading |",
    "tint0": "| `tint` | 8 × 4 × uint8 | | of all slots; one colour for all of them where it is written |",
}


def column_names(names):
    if len(names) > 2:
        return f"`{names[0]}` … `{names[-1]}`"
    return ", ".join(f"`{name}`" for name in names)


def columns():
    """A row for each property; neighbours that differ in nothing but their names share one."""
    rows = []
    for each in crowdbrush.properties():
        if each.name in MADE_COLUMNS:
            rows.append(([], MADE_COLUMNS[each.name]))
        span = "" if each.low is None else f" {each.low:g} to {each.high:g}".replace("e+0", "e")
        facts = f" | {each.type} |{span} | {each.doc} |"
        if rows and rows[-1][0] and rows[-1][1] == facts:
            rows[-1][0].append(each.name)
        else:
            rows.append(([each.name], facts))
    return "\n".join(f"| {column_names(names)}{facts}" if names else facts for names, facts in rows)


def manual_class(name, cls):
    lines = ["", f"### {name}", ""]
    doc = ERROR_DOC if name == "Error" else inspect.getdoc(cls) or ""
    if is_enum(cls):
        said = doc.partition("\n\nMembers:")[0].strip()
        lines += [said, ""] if said and not said.startswith("Members:") else []
        lines += ["`" + "`, `".join(cls.__members__) + "`"]
        return lines
    lines += [doc.replace("\n", " ")] if doc else []
    for member, value in members(cls):
        if isinstance(value, property):
            kind, said, can_set = of_property(cls, member, value)
            lines += ["", f"- `{member}: {kind}`" + ("" if can_set else " (for reading)") +
                      (f" – {said}" if said else "")]
        elif member.startswith("__") and member not in ("__init__", "__len__"):
            continue
        elif callable(getattr(cls, member)):
            function = Function(name, member, getattr(cls, member))
            arguments = ", ".join(a for a in function.arguments if a != "self")
            shown = {"__init__": name, "__len__": "len"}.get(member, member)
            said = function.doc.replace("\n", " ")
            lines += ["", f"- `{shown}({arguments})`" +
                      (f" → `{function.result}`" if function.result != "None" else "") +
                      (f" – {said}" if said else "")]
    return [line for i, line in enumerate(lines) if line or i == 0 or lines[i - 1]]


ENVIRONMENT = """## The environment

Places, paths, tags, numbers, cues and rules, as `scene.environment` and project files have them.
Each is a dict with a typed attribute for each member: `Place(id=1, position=(0, 0, 4), radius=2)` is
the dict `{"id": 1, "position": [0.0, 0.0, 4.0], "radius": 2.0, …}` and goes wherever the dict goes.
`scene.rules`, `scene.places` and so on give lists of them and take them back. A member is the
attribute's name, but for names that Python has already, which end with `_` (`rule.if_` is the member
`if`), and for capitals (`place.speed_share` is `speedShare`). Colours are `"#rrggbb"`, or numbers
from 0 to 255 where they are given; an id is a number or what has one. All conditions have
`not_: bool` too: whether it must not hold; and all actions `depth: int`: deeper ones belong to the
`actions.Repeat` or `actions.OneOf` above them.

```python
door = crowdbrush.Place(id=1, name="door", position=(4, 0, 2))
scene.places += [door]
scene.rules += [crowdbrush.Rule(
    id=1, name="to the door",
    when=crowdbrush.triggers.Event(event="bell"),
    if_=[crowdbrush.conditions.Chance(chance=0.5)],
    do=[crowdbrush.actions.GoTo(place=door), crowdbrush.actions.Stop()])]
```
"""


# What all conditions and all actions have is said once.
COMMON = {crowdbrush.Condition: ("not",), crowdbrush.Action: ("depth",)}


def manual_entry(cls):
    kind = f" (`{cls._kind}`)" if cls._kind else ""
    lines = ["", f"**{cls.__qualname__}**{kind} – {inspect.getdoc(cls)}"]
    fields = [(name, field) for name, field in cls._fields.items() if field.key not in COMMON.get(cls.__mro__[1], ())]
    if fields:
        lines.append("")
    for name, field in fields:
        lines.append(f"- `{name}: {entry_type(field, False)}`" +
                     (f" (`{field.key}`)" if name != field.key else "") + f" – {facts_of(field)}")
    return lines


def environment_lines(classes):
    lines = ENVIRONMENT.rstrip().split("\n")
    for title, kinds in [("Entries", [cls for _, cls in classes if is_entry(cls)])] + [
            (name.capitalize(), kinds_of(cls)) for name, cls in classes if is_space(cls)]:
        lines += ["", f"### {title}"]
        for cls in kinds:
            lines += manual_entry(cls)
    return lines


def manual():
    classes, functions = public()
    lines = [INTRODUCTION.format(doc=crowdbrush.__doc__, columns=columns()).rstrip(), "", "## Functions", ""]
    for name, value in functions:
        function = Function("", name, value)
        lines.append(f"- `{name}({', '.join(function.arguments)})` → `{function.result}` – " +
                     function.doc.replace("\n", " "))
    lines += [""] + environment_lines(classes)
    lines += ["", "## Classes"]
    for name, cls in classes:
        if not is_entry(cls) and not is_space(cls):
            lines += manual_class(name, cls)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write({"stubs": stubs, "manual": manual}[sys.argv[1]]())
