# SPDX-License-Identifier: MIT
# Runs inside the module crowdbrush: brushes that scripts bring along.
import dataclasses as _dataclasses
import enum as _enum
import inspect as _inspect
import re as _re
import typing as _typing

import numpy as _np

#: What the editor itself asks for: where a brush reaches. Class attributes of these names set it.
_AREA = ("selection", "radius", "rate", "through", "build_up", "pressure_size", "pressure_rate")
_RESERVED = _AREA + ("name",)

#: By name, in the order of their coming.
brushes = {}

_tell_editor = None


class Range:
    """Limits of a setting: speed: Annotated[float, crowdbrush.Range(0, 4, step=0.1)] = 1.0"""

    low: float
    high: float
    step: "Optional[float]"

    def __init__(self, low: float, high: float, step: "Optional[float]" = None) -> None:
        if not low < high:
            raise ValueError(f"A range runs from the lowest to the highest value, not {low} to {high}.")
        self.low, self.high, self.step = low, high, step


class Selected:
    """Whom a dab of a stroke reaches: what apply(selection) of a brush gets.

    scene: the scene; all that is done to it belongs to the stroke. ids: uint32, ascending, alive.
    seed: a number of this dab. start, end: of the way so far, (x, y) in logical pixels; heading: of
    the way on the ground, radians, or None."""

    scene: "Scene"
    ids: "numpy.ndarray"
    seed: int
    start: "Tuple[float, float]"
    end: "Tuple[float, float]"
    heading: "Optional[float]"

    def __init__(self, scene: "Scene", ids: "numpy.ndarray", seed: int,
                 start: "Tuple[float, float]", end: "Tuple[float, float]",
                 heading: "Optional[float]", report: "Callable[[float], None]") -> None:
        self.scene = scene
        self.ids = ids
        self.seed = seed
        self.start = start
        self.end = end
        self.heading = heading
        self._report = report

    def __len__(self) -> int:
        return len(self.ids)

    @property
    def random(self) -> "numpy.random.Generator":
        """A NumPy generator that gives the same numbers for the same stroke, dab by dab."""
        if "_random" not in self.__dict__:
            self._random = _np.random.Generator(_np.random.PCG64(self.seed))
        return self._random

    def column(self, name: str) -> "numpy.ndarray":
        """A copy of a column of these individuals, in the order of ids."""
        return self.scene.column(name)[_np.searchsorted(self.scene.ids, self.ids)]

    def change(self, **columns: "Array") -> None:
        """scene.change for these individuals: columns by keyword, one value for all or one each."""
        self.scene.change(self.ids, **columns)

    def remove(self) -> None:
        """scene.remove for these individuals."""
        self.scene.remove(self.ids)

    def progress(self, done: float) -> None:
        """Says how much of this dab is done, 0 to 1: shown over the picture when it takes long."""
        self._report(min(1.0, max(0.0, float(done))))


def register_brush(brush: "_B", name: "Optional[str]" = None) -> "_B":
    """Makes a brush known: in the editor it appears in the palette. Usable as a decorator.

    brush: a class with apply(selection), an instance of one, or a function. apply changes people;
    what a function, or a method values(selection), returns is a dict of columns with one value for
    all or one each. Public attributes with a type (bool, int, float, str, an Enum, a Literal, a
    colour as tuple[int, int, int]) are settings; selection, radius, rate, through and build_up say
    where it reaches at first. Returns the brush. Raises TypeError when it is none."""
    known = name or _known_name(brush)
    fields = _fields_of(brush)
    _check(brush)
    brushes[known] = brush
    if _tell_editor is not None:
        documentation = _inspect.getdoc(brush if _inspect.isroutine(brush) else _class_of(brush))
        if _dataclasses.is_dataclass(brush) and str(documentation).startswith(_class_of(brush).__name__ + "("):
            documentation = None  # only what dataclass writes of itself
        _tell_editor(known, (documentation or "").partition("\n\n")[0].replace("\n", " "), _area_of(brush), fields)
    return brush


_hints = {}


def _hints_of(cls):
    """Types by name; found when it is made known: later its module may be gone."""
    if cls not in _hints:
        _hints[cls] = _typing.get_type_hints(cls, include_extras=True)
    return _hints[cls]


def _known_name(brush):
    return str(getattr(brush, "name", None) or _name_of(brush))


def _class_of(brush):
    return brush if _inspect.isclass(brush) else type(brush)


def _name_of(brush):
    if _inspect.isroutine(brush):
        return brush.__name__.replace("_", " ").strip().capitalize()
    words = _re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", _class_of(brush).__name__)
    return _re.sub(r" Brush$", "", words).capitalize()


def _check(brush):
    has_values = hasattr(brush, "values") and not hasattr(brush, "keys")  # a dict is no brush
    if not (_inspect.isroutine(brush) or hasattr(brush, "apply") or has_values):
        raise TypeError(f"{brush!r} is no brush: it needs a method apply(selection) or "
                        "values(selection), or to be a function.")
    if _inspect.isclass(brush):
        brush()  # raises what is missing: the editor makes one for each stroke


def _area_of(brush):
    area = Brush(BrushKind.SCRIPT)
    area.selection = Selection.ALL_IN_CIRCLE
    for each in _AREA:
        if hasattr(brush, each):
            setattr(area, each, getattr(brush, each))
    return area


def _default_of(brush, name):
    for field in getattr(_class_of(brush), "__dataclass_fields__", {}).values():
        if field.name == name and field.default_factory is not _dataclasses.MISSING:
            if _inspect.isclass(brush):
                return field.default_factory()
    try:
        return getattr(brush, name)
    except AttributeError:
        raise TypeError(f"{_class_of(brush).__name__}.{name} has no value: settings need one to "
                        "begin with.") from None


def _fields_of(brush):
    """Settings as the editor shows them: name, value, low, high, step, decimals, choices."""
    if _inspect.isroutine(brush):
        return []
    fields = []
    for name, kind in _hints_of(_class_of(brush)).items():
        if name.startswith("_") or name in _RESERVED or _typing.get_origin(kind) is _typing.ClassVar:
            continue
        fields.append(_field(f"{_class_of(brush).__name__}.{name}", name, kind,
                             _default_of(brush, name)))
    return fields


def _field(where, name, kind, value):
    limits = None
    if _typing.get_origin(kind) is _typing.Annotated:
        limits = next((each for each in kind.__metadata__ if isinstance(each, Range)), None)
        kind = kind.__origin__
    choices = []
    if _typing.get_origin(kind) is _typing.Literal:
        choices = [str(each) for each in _typing.get_args(kind)]
        value = str(value)
    elif isinstance(kind, type) and issubclass(kind, _enum.Enum):
        choices = [each.name for each in kind]
        value = value.name
    elif kind is bool:
        value = bool(value)
    elif kind is int:
        value = int(value)
    elif kind is float:
        value = float(value)
    elif kind is str:
        value = str(value)
    elif _typing.get_origin(kind) is tuple and _typing.get_args(kind) == (int, int, int):
        value = tuple(int(each) for each in value)
        if len(value) != 3 or min(value) < 0 or max(value) > 255:
            raise TypeError(f"{where}: a colour is (red, green, blue), 0 to 255.")
    else:
        raise TypeError(f"{where}: a setting is bool, int, float, str, an Enum, a Literal or a "
                        "colour, tuple[int, int, int].")
    low, high = _limits_of(value)
    if limits is not None:
        low, high = limits.low, limits.high
    step = limits.step if limits is not None and limits.step else None
    whole = isinstance(value, int)
    if step is None:
        step = max(1, round((high - low) / 100)) if whole else (high - low) / 100
    decimals = 0 if whole else max(0, min(4, 2 - int(_np.floor(_np.log10(max(high - low, 1e-9))))))
    return (name, value, float(low), float(high), float(step), decimals, choices)


def _limits_of(value):
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return 0, 1
    most = max(10 * abs(value), 10 if isinstance(value, int) else 1.0)
    return (-most if value < 0 else 0), most


def _brush_with(brush, values):
    """A brush of its own for a stroke, set as the editor has it."""
    if _inspect.isroutine(brush):
        return brush
    made = brush() if _inspect.isclass(brush) else brush
    kinds = _hints_of(_class_of(brush)) if values else {}
    for name, value in values.items():
        kind = kinds.get(name)
        if _typing.get_origin(kind) is _typing.Annotated:
            kind = kind.__origin__
        if isinstance(kind, type) and issubclass(kind, _enum.Enum):
            value = kind[value]
        elif _typing.get_origin(kind) is _typing.Literal:
            value = next(each for each in _typing.get_args(kind) if str(each) == value)
        setattr(made, name, value)
    return made


def _apply(brush, selection):
    """One dab."""
    if hasattr(brush, "apply"):
        brush.apply(selection)
        return
    columns = brush(selection) if _inspect.isroutine(brush) else brush.values(selection)
    if columns is None:
        return
    if not isinstance(columns, dict) or not all(isinstance(name, str) for name in columns):
        raise TypeError(f"{_name_of(brush)} must return a dict of columns by name, as in "
                        f"{{'heading': 1.0}}, or None, not {_shortly(columns)}.")
    if columns:
        selection.change(**columns)
