# SPDX-License-Identifier: MIT
# Runs inside the module crowdbrush: says which argument of a call is wrong.
import re as _re

_PLAIN = {"float": "a number", "int": "a whole number", "bool": "True or False", "str": "a text",
          "os.PathLike": "a path", "dict": "a dict", "list": "a list", "tuple": "a tuple",
          "function": "a function"}
_LONGEST = 60


def _shortly(value):
    """What was given, for a message."""
    try:
        text = ascii(value)
    except Exception:  # an object that cannot even say what it is
        text = f"an object of type {type(value).__name__}"
    return text if len(text) <= _LONGEST else text[:_LONGEST] + "..."


def _split(text):
    """At commas that stand in no bracket."""
    parts, depth, start = [], 0, 0
    for i, letter in enumerate(text):
        depth += (letter in "([{<") - (letter in ")]}" or letter == ">" and text[i - 1] != "-")
        if letter == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    return [part for part in parts + [text[start:].strip()] if part]


def _inner(kind):
    return _split(kind[kind.index("[") + 1:-1])


def _words(kind):
    """A type as pybind11 writes it, in words."""
    if kind in _PLAIN:
        return _PLAIN[kind]
    if kind.startswith("Optional["):
        return _words(_inner(kind)[0]) + " or None"
    if kind.startswith("Union["):
        return " or ".join(dict.fromkeys(_words(each) for each in _inner(kind)))
    several = _re.fullmatch(r"List\[(.+)\[(\d+)\]\]", kind)
    if several:
        return f"{several[2]} of: {_words(several[1])}"
    if kind.startswith("List["):
        return f"a list, each {_words(_inner(kind)[0])}"
    if kind.startswith("Tuple["):
        return "(" + ", ".join(_words(each) for each in _inner(kind)) + ")"
    if kind.startswith("crowdbrush."):
        return f"a {kind}"
    return "an array" if kind.startswith("numpy") else "any object" if kind == "object" else kind


def _is_row(value):
    return not isinstance(value, (str, bytes, dict)) and hasattr(value, "__len__") and hasattr(value, "__getitem__")


def _fits(kind, value):
    """Whether it may be meant; True where nobody knows."""
    if kind == "object":
        return True
    if kind == "None":
        return value is None
    if kind.startswith("Optional["):
        return value is None or _fits(_inner(kind)[0], value)
    if kind.startswith("Union["):
        return any(_fits(each, value) for each in _inner(kind))
    if kind == "float":
        return hasattr(value, "__float__") or hasattr(value, "__index__")
    if kind == "int":
        return not isinstance(value, float) and (hasattr(value, "__index__") or hasattr(value, "__int__"))
    if kind == "bool":
        return isinstance(value, bool) or type(value).__name__ in ("bool_", "bool")
    if kind == "function":
        return callable(value)
    if kind == "str":
        return isinstance(value, (str, bytes)) and _is_unicode(value)
    if kind == "os.PathLike":
        return isinstance(value, (str, bytes)) or hasattr(value, "__fspath__")
    if kind in ("dict", "list", "tuple"):
        return isinstance(value, {"dict": dict, "list": list, "tuple": tuple}[kind])
    several = _re.fullmatch(r"List\[(.+)\[(\d+)\]\]", kind)
    if several:
        return _is_row(value) and len(value) == int(several[2]) and all(_fits(several[1], each) for each in value)
    if kind.startswith("List["):
        return _is_row(value) and all(_fits(_inner(kind)[0], each) for each in value)
    if kind.startswith("Tuple["):
        kinds = _inner(kind)
        return _is_row(value) and len(value) == len(kinds) and all(map(_fits, kinds, value))
    if kind.startswith("crowdbrush."):
        return isinstance(value, globals().get(kind.partition(".")[2], object))
    return True


def _is_unicode(value):
    try:
        value.encode() if isinstance(value, str) else value.decode()
        return True
    except UnicodeError:
        return False


class _Argument:
    def __init__(self, text):
        name, _, rest = text.partition(":")
        self.name = name.strip()
        kind, equals, default = rest.partition(" = ")
        self.kind = kind.strip()
        self.is_needed = not equals
        self.takes_none = default == "None"

    def fits(self, value):
        try:
            return (self.takes_none and value is None) or _fits(self.kind, value)
        except Exception:  # an object that breaks when it is looked at
            return False

    def words(self):
        none = " or None" if self.takes_none and "None" not in _words(self.kind) else ""
        return _words(self.kind) + none


def _explain_call(name, signature, args, kwargs):
    """What is wrong with a call that fitted nothing."""
    parts = _split(signature[signature.index("(") + 1:signature.rindex(") -> ")])
    takes_any = any(part.startswith("**") for part in parts)
    by_position = sum(part != "*" and not part.startswith("*") for part in parts[:parts.index("*") if "*" in parts else None])
    arguments = [_Argument(part) for part in parts if not part.startswith("*")]
    if arguments and (arguments[0].name == "self" or arguments[0].name == "arg0" and "." in name):
        if not args or not arguments[0].fits(args[0]):
            return f"{name} needs {arguments[0].words()} in front of it" + (
                f", not {_shortly(args[0])}." if args else ".")
        arguments, args, by_position = arguments[1:], args[1:], by_position - 1
    names = ", ".join(each.name for each in arguments) or "none"
    if name.endswith(" ="):  # a property that is set
        return f"{name[:-2]} must be {arguments[0].words()}, not {_shortly(args[0])}."
    if len(args) > by_position:
        return (f"{name} takes {by_position} arguments without a name, and {len(args)} were given; its arguments: "
                f"{names}.")
    given = dict(zip((each.name for each in arguments), args))
    for key in kwargs:
        if key in given:
            return f"{name} got its argument {key} twice."
        if not takes_any and key not in {each.name for each in arguments}:
            return f"{name} has no argument \"{key}\"; its arguments: {names}."
    given.update(kwargs)
    for each in arguments:
        if each.name not in given:
            if each.is_needed:
                return f"{name} needs {each.name}: {each.words()}."
        elif not each.fits(given[each.name]):
            return f"{name}: {each.name} must be {each.words()}, not {_shortly(given[each.name])}."
    for each in arguments:  # of numbers the type says too little
        value = given.get(each.name)
        if "int" in each.kind and isinstance(value, int) and not 0 <= value < 256:
            return f"{name}: {each.name} is out of range: {_shortly(value)}."
    told = ", ".join(f"{key}={_shortly(value)}" for key, value in given.items())
    return f"{name} cannot take {told or 'nothing'}; its arguments: " + ", ".join(
        f"{each.name} ({each.words()})" for each in arguments) + "."


def _explain_value(name, args, kwargs):
    """What is wrong with a call that got something that cannot be turned into what it needs."""
    given = [_shortly(each) for each in args[1:]] + [f"{key}={_shortly(value)}" for key, value in kwargs.items()]
    return f"{name} was given a value of a kind that it cannot take: {', '.join(given)}."
