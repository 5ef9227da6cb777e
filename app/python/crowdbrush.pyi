# SPDX-License-Identifier: MIT
# Written by app/python/describe.py from the module as it is built: ./dev describe
"""Everything the editor can do to a crowd, scripted. Metres, seconds, radians; Y is up and characters face +Z at heading 0. Columns are NumPy arrays."""
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


class Error(RuntimeError):
    """What is wrong, as the editor would say it. Nothing has changed."""


class Clip:
    """An animation of a template, for reading."""
    @property
    def name(self) -> str:
        ...
    @property
    def seconds(self) -> float:
        ...
    @property
    def keyframes(self) -> int:
        """Sampled 32 times a second."""
    @property
    def speed(self) -> float:
        """Ground speed at playback speed 1, m/s."""
    @property
    def loop(self) -> bool:
        ...
    @property
    def seat_height(self) -> Optional[float]:
        """Metres; None: it does not sit."""
    @property
    def role(self) -> str:
        """What it is for: "idle", "walk", "run", "fly", "sit" or "other"."""


class Template:
    """A character of a scene, to make copies of. Follows undo: using one whose template is gone
    raises Error."""
    @property
    def id(self) -> int:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def path(self) -> str:
        ...
    @property
    def clips(self) -> List[Clip]:
        ...
    @property
    def clip_names(self) -> List[str]:
        """What the column "clip" counts."""
    @property
    def slots(self) -> List[str]:
        ...
    @property
    def parts(self) -> List[str]:
        """Bit i of the column "parts" shows part i."""
    @property
    def levels(self) -> List[int]:
        """Triangles of each level of detail."""
    @property
    def height_m(self) -> float:
        ...
    @property
    def triangles(self) -> _Array:
        """T×3 uint32: vertex indices of level 0."""
    def keyframe_vertices(self, clip: Union[int, str], k: int) -> _Array:
        """V×3 float32: level 0 of keyframe k, metres, the template's own frame, file order."""
    def keyframe_normals(self, clip: Union[int, str], k: int) -> _Array:
        """V×3 float32: unit normals of the same vertices."""
    def __eq__(self, other: Any) -> bool:
        ...
    def __hash__(self) -> int: ...


class Property:
    """What there is to know of a column."""
    @property
    def name(self) -> str:
        """As Scene.column takes it."""
    @property
    def type(self) -> str:
        """Of a value in NumPy."""
    @property
    def low(self) -> Optional[float]:
        """The lowest legal number; None: any of its type."""
    @property
    def high(self) -> Optional[float]:
        """The highest legal number; None: any of its type."""
    @property
    def default(self) -> Any:
        """Of those who are created without it, where neither template nor seat suggest another:
        a number or a list of them."""
    @property
    def kind(self) -> str:
        """number, angle, colour, choice, set or reference."""
    @property
    def blend(self) -> str:
        """What lies between two values: step, linear, turn, cycle or colour."""
    @property
    def writers(self) -> List[str]:
        """Who may write it: brush, panel, script, rule, session."""
    @property
    def doc(self) -> str:
        """What it is."""


class BrushKind:
    """What a brush does."""
    CREATE: ClassVar[BrushKind]
    DELETE: ClassVar[BrushKind]
    PUSH: ClassVar[BrushKind]
    COLOUR: ClassVar[BrushKind]
    SCALE: ClassVar[BrushKind]
    MATERIAL: ClassVar[BrushKind]
    PARTS: ClassVar[BrushKind]
    TEMPLATE: ClassVar[BrushKind]
    OUTFIT: ClassVar[BrushKind]
    ORIENTATION: ClassVar[BrushKind]
    ANIMATION: ClassVar[BrushKind]
    TIME: ClassVar[BrushKind]
    STYLE: ClassVar[BrushKind]
    WALK: ClassVar[BrushKind]
    FEATURE: ClassVar[BrushKind]
    RELATION: ClassVar[BrushKind]
    TAG: ClassVar[BrushKind]
    UNTAG: ClassVar[BrushKind]
    GROUP: ClassVar[BrushKind]
    CLONE: ClassVar[BrushKind]
    SMOOTH: ClassVar[BrushKind]
    SHUFFLE: ClassVar[BrushKind]
    RESTORE: ClassVar[BrushKind]
    SCRIPT: ClassVar[BrushKind]
    name: str
    value: int


class Selection:
    """Screen area to individuals or points."""
    POINT: ClassVar[Selection]
    SPRAY: ClassVar[Selection]
    ALL_IN_CIRCLE: ClassVar[Selection]
    RECTANGLE: ClassVar[Selection]
    LASSO: ClassVar[Selection]
    name: str
    value: int


class Operator:
    """How values vary over what is selected."""
    UNIFORM: ClassVar[Operator]
    RANDOM: ClassVar[Operator]
    GRADIENT: ClassVar[Operator]
    name: str
    value: int


class Facing:
    """Which way: a direction, or after something."""
    DIRECTION: ClassVar[Facing]
    RANDOM: ClassVar[Facing]
    ALONG_STROKE: ClassVar[Facing]
    TOWARDS_POINT: ClassVar[Facing]
    TOWARDS_VIEWER: ClassVar[Facing]
    name: str
    value: int


class Timing:
    """How the delays of people go over them."""
    RANGE: ClassVar[Timing]
    WAVE: ClassVar[Timing]
    RIPPLE: ClassVar[Timing]
    IN_STEP: ClassVar[Timing]
    name: str
    value: int


class Movement:
    """How people are moved."""
    PUSH: ClassVar[Movement]
    GATHER: ClassVar[Movement]
    SPREAD: ClassVar[Movement]
    COMB: ClassVar[Movement]
    name: str
    value: int


class HeadingSettings:
    """Which way people face. Radians."""
    @property
    def mode(self) -> Facing:
        ...
    @mode.setter
    def mode(self, value: Facing) -> None:
        ...
    @property
    def towards_point(self) -> Sequence[float]:
        """(x, y, z) in metres."""
    @towards_point.setter
    def towards_point(self, value: Sequence[float]) -> None:
        ...
    @property
    def heading(self) -> float:
        """Radians, 0 faces +Z."""
    @heading.setter
    def heading(self, value: float) -> None:
        ...
    @property
    def turn(self) -> float:
        """Radians, added where the heading follows something else."""
    @turn.setter
    def turn(self, value: float) -> None:
        ...
    @property
    def spread(self) -> float:
        """Radians to each side."""
    @spread.setter
    def spread(self, value: float) -> None:
        ...


class SeatGridSettings:
    """Which seats people come onto."""
    @property
    def is_on(self) -> bool:
        """Create on free seats only."""
    @is_on.setter
    def is_on(self, value: bool) -> None:
        ...
    @property
    def ranks(self) -> List[int]:
        """Empty: all. Assign a whole list."""
    @ranks.setter
    def ranks(self, value: List[int]) -> None:
        ...
    @property
    def wedges(self) -> List[int]:
        """Empty: all. Assign a whole list."""
    @wedges.setter
    def wedges(self, value: List[int]) -> None:
        ...


class MaskSettings:
    """On whom a brush may work at all."""
    @property
    def only_selected(self) -> bool:
        """Only those in `selected`, which the editor fills with the selected ones."""
    @only_selected.setter
    def only_selected(self, value: bool) -> None:
        ...
    @property
    def selected(self) -> List[int]:
        """Ids. Assign a whole list."""
    @selected.setter
    def selected(self, value: List[int]) -> None:
        ...
    @property
    def templates(self) -> List[int]:
        """Ids of templates; empty: all. Assign a whole list."""
    @templates.setter
    def templates(self, value: List[int]) -> None:
        ...
    @property
    def groups(self) -> List[int]:
        """Ids of groups, 0: in none; empty: all. Assign a whole list."""
    @groups.setter
    def groups(self, value: List[int]) -> None:
        ...
    @property
    def tags(self) -> List[int]:
        """Bits 0–63, any of which is worn; empty: all. Assign a whole list."""
    @tags.setter
    def tags(self, value: List[int]) -> None:
        ...
    @property
    def features(self) -> List[int]:
        """Ids of values of features, any of which is borne; empty: all. Assign a whole list."""
    @features.setter
    def features(self, value: List[int]) -> None:
        ...
    @property
    def inverted(self) -> bool:
        ...
    @inverted.setter
    def inverted(self, value: bool) -> None:
        ...


class CreateSettings:
    """Who is created, and how."""
    @property
    def mix(self) -> Dict[Any, Any]:
        """Template (or its id) → weight."""
    @mix.setter
    def mix(self, value: Dict[Any, Any]) -> None:
        ...
    @property
    def seats(self) -> SeatGridSettings:
        ...
    @seats.setter
    def seats(self, value: SeatGridSettings) -> None:
        ...
    @property
    def seat_percent(self) -> float:
        """Per cent, rectangles."""
    @seat_percent.setter
    def seat_percent(self, value: float) -> None:
        ...
    @property
    def anywhere(self) -> bool:
        """Also on roofs, trees and wherever else nobody can walk to. False: only where people
        can walk, which takes seconds to find on large stages."""
    @anywhere.setter
    def anywhere(self, value: bool) -> None:
        ...
    @property
    def density(self) -> float:
        """Persons per m², rectangles."""
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def minimal_distance(self) -> float:
        """Metres."""
    @minimal_distance.setter
    def minimal_distance(self, value: float) -> None:
        ...
    @property
    def height(self) -> Tuple[float, float]:
        """Scale, (lowest, highest)."""
    @height.setter
    def height(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def girth(self) -> Tuple[float, float]:
        """Scale, (lowest, highest)."""
    @girth.setter
    def girth(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def phase(self) -> Tuple[float, float]:
        """(lowest, highest), 0–1 of the clip at time 0."""
    @phase.setter
    def phase(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def palette_strength(self) -> float:
        """0–1."""
    @palette_strength.setter
    def palette_strength(self, value: float) -> None:
        ...
    @property
    def varies_outfit(self) -> bool:
        """Any material of each slot, else the first."""
    @varies_outfit.setter
    def varies_outfit(self, value: bool) -> None:
        ...
    @property
    def varies_faces(self) -> Optional[bool]:
        """Any skin, hair and face; None: as varies_outfit."""
    @varies_faces.setter
    def varies_faces(self, value: Optional[bool]) -> None:
        ...
    @property
    def varies_parts(self) -> bool:
        """Each part worn or not, else as the template has them."""
    @varies_parts.setter
    def varies_parts(self, value: bool) -> None:
        ...
    @property
    def palette(self) -> List[Sequence[int]]:
        """List of (red, green, blue), 0–255. Assign a whole list."""
    @palette.setter
    def palette(self, value: List[Sequence[int]]) -> None:
        ...
    @property
    def group(self) -> int:
        """Id of the group that new ones come into; 0: none."""
    @group.setter
    def group(self, value: int) -> None:
        ...
    @property
    def facing(self) -> HeadingSettings:
        ...
    @facing.setter
    def facing(self, value: HeadingSettings) -> None:
        ...
    @property
    def clips(self) -> Dict[Any, Any]:
        """Name → weight; empty: what suits the place."""
    @clips.setter
    def clips(self, value: Dict[Any, Any]) -> None:
        ...


class DeleteSettings:
    """How many are removed."""
    @property
    def percent(self) -> float:
        """Of those in the area."""
    @percent.setter
    def percent(self, value: float) -> None:
        ...


class ColourSettings:
    """Tints of slots."""
    @property
    def slot(self) -> str:
        """By name; empty: all tintable slots."""
    @slot.setter
    def slot(self, value: str) -> None:
        ...
    @property
    def spares_body(self) -> bool:
        """Of all slots, not skin, hair and face, where there is anything else."""
    @spares_body.setter
    def spares_body(self, value: bool) -> None:
        ...
    @property
    def replaces(self) -> bool:
        """The colour itself, whatever the material's; else it multiplies that one."""
    @replaces.setter
    def replaces(self, value: bool) -> None:
        ...
    @property
    def colors(self) -> List[Sequence[int]]:
        """List of (red, green, blue), 0–255. Assign a whole list."""
    @colors.setter
    def colors(self, value: List[Sequence[int]]) -> None:
        ...
    @property
    def strength(self) -> float:
        """0–1."""
    @strength.setter
    def strength(self, value: float) -> None:
        ...
    @property
    def blends(self) -> bool:
        ...
    @blends.setter
    def blends(self, value: bool) -> None:
        ...
    @property
    def each_slot_apart(self) -> bool:
        ...
    @each_slot_apart.setter
    def each_slot_apart(self, value: bool) -> None:
        ...


class OrientationSettings:
    """Which way people are turned."""
    @property
    def facing(self) -> HeadingSettings:
        ...
    @facing.setter
    def facing(self, value: HeadingSettings) -> None:
        ...


class AnimationSettings:
    """What people do."""
    @property
    def clips(self) -> Dict[Any, Any]:
        """Name → weight; empty: unchanged."""
    @clips.setter
    def clips(self, value: Dict[Any, Any]) -> None:
        ...
    @property
    def sets_phase(self) -> bool:
        ...
    @sets_phase.setter
    def sets_phase(self, value: bool) -> None:
        ...
    @property
    def phase(self) -> Tuple[float, float]:
        """(lowest, highest), 0–1 of the clip at time 0."""
    @phase.setter
    def phase(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def sets_speed(self) -> bool:
        ...
    @sets_speed.setter
    def sets_speed(self, value: bool) -> None:
        ...
    @property
    def speed(self) -> Tuple[float, float]:
        """(lowest, highest), 1 as authored."""
    @speed.setter
    def speed(self, value: Tuple[float, float]) -> None:
        ...


class WalkSettings:
    """Which path people follow, and how fast."""
    @property
    def sets_path(self) -> bool:
        ...
    @sets_path.setter
    def sets_path(self, value: bool) -> None:
        ...
    @property
    def path(self) -> int:
        """Id of a path; 0: follow none; NEAREST_PATH: the one that each is nearest to."""
    @path.setter
    def path(self, value: int) -> None:
        ...
    @property
    def sets_speed(self) -> bool:
        ...
    @sets_speed.setter
    def sets_speed(self, value: bool) -> None:
        ...
    @property
    def speed(self) -> Tuple[float, float]:
        """m/s, (lowest, highest)."""
    @speed.setter
    def speed(self, value: Tuple[float, float]) -> None:
        ...


class StyleSettings:
    """How people walk, and how fast."""
    @property
    def sets_style(self) -> bool:
        ...
    @sets_style.setter
    def sets_style(self, value: bool) -> None:
        ...
    @property
    def clips(self) -> Dict[Any, Any]:
        """Name → weight of clips to walk with; empty: what fits the speed."""
    @clips.setter
    def clips(self, value: Dict[Any, Any]) -> None:
        ...
    @property
    def sets_speed(self) -> bool:
        ...
    @sets_speed.setter
    def sets_speed(self, value: bool) -> None:
        ...
    @property
    def speed(self) -> Tuple[float, float]:
        """m/s, (lowest, highest)."""
    @speed.setter
    def speed(self, value: Tuple[float, float]) -> None:
        ...


class ScaleSettings:
    """Height and girth, each with a range and an operator."""
    @property
    def sets_height(self) -> bool:
        ...
    @sets_height.setter
    def sets_height(self, value: bool) -> None:
        ...
    @property
    def height(self) -> Tuple[float, float]:
        """Scale, (lowest, highest)."""
    @height.setter
    def height(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def height_operator(self) -> Operator:
        """How the values vary: lowest for all, drawn, or along the line."""
    @height_operator.setter
    def height_operator(self, value: Operator) -> None:
        ...
    @property
    def sets_girth(self) -> bool:
        ...
    @sets_girth.setter
    def sets_girth(self, value: bool) -> None:
        ...
    @property
    def girth(self) -> Tuple[float, float]:
        """Scale, (lowest, highest)."""
    @girth.setter
    def girth(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def girth_operator(self) -> Operator:
        """How the values vary: lowest for all, drawn, or along the line."""
    @girth_operator.setter
    def girth_operator(self, value: Operator) -> None:
        ...


class MaterialSettings:
    """Which of its materials a slot has."""
    @property
    def slot(self) -> str:
        """By name; empty: all slots."""
    @slot.setter
    def slot(self, value: str) -> None:
        ...
    @property
    def spares_body(self) -> bool:
        """Of all slots, not skin, hair and face, where there is anything else."""
    @spares_body.setter
    def spares_body(self, value: bool) -> None:
        ...
    @property
    def choice(self) -> str:
        """By name; empty: any of the slot's, by the operator."""
    @choice.setter
    def choice(self, value: str) -> None:
        ...
    @property
    def each_slot_apart(self) -> bool:
        ...
    @each_slot_apart.setter
    def each_slot_apart(self, value: bool) -> None:
        ...


class GroupSettings:
    """The group that people come into."""
    @property
    def group(self) -> int:
        """Id of a group; 0: none."""
    @group.setter
    def group(self, value: int) -> None:
        ...


class TemplateSettings:
    """Who people become; what fits the new template stays."""
    @property
    def templates(self) -> List[int]:
        """Ids of templates. Assign a whole list."""
    @templates.setter
    def templates(self, value: List[int]) -> None:
        ...


class ShuffleSettings:
    """What people of the same template exchange."""
    @property
    def colours(self) -> bool:
        ...
    @colours.setter
    def colours(self, value: bool) -> None:
        ...
    @property
    def size(self) -> bool:
        ...
    @size.setter
    def size(self, value: bool) -> None:
        ...
    @property
    def heading(self) -> bool:
        ...
    @heading.setter
    def heading(self, value: bool) -> None:
        ...
    @property
    def timing(self) -> bool:
        ...
    @timing.setter
    def timing(self, value: bool) -> None:
        ...
    @property
    def clips(self) -> bool:
        ...
    @clips.setter
    def clips(self, value: bool) -> None:
        ...


class RestoreSettings:
    """What people get back."""
    @property
    def source(self) -> str:
        """Where it comes from."""
    @source.setter
    def source(self, value: str) -> None:
        ...
    @property
    def state(self) -> int:
        """The id of a state; of STATE."""
    @state.setter
    def state(self, value: int) -> None:
        ...
    @property
    def whole(self) -> bool:
        """All that the state holds, else what is ticked; of STATE."""
    @whole.setter
    def whole(self, value: bool) -> None:
        ...
    @property
    def colours(self) -> bool:
        ...
    @colours.setter
    def colours(self, value: bool) -> None:
        ...
    @property
    def materials(self) -> bool:
        ...
    @materials.setter
    def materials(self, value: bool) -> None:
        ...
    @property
    def parts(self) -> bool:
        ...
    @parts.setter
    def parts(self, value: bool) -> None:
        ...
    @property
    def size(self) -> bool:
        ...
    @size.setter
    def size(self, value: bool) -> None:
        ...
    @property
    def clips(self) -> bool:
        ...
    @clips.setter
    def clips(self, value: bool) -> None:
        ...


class TimeSettings:
    """When people begin their clips."""
    @property
    def mode(self) -> Timing:
        ...
    @mode.setter
    def mode(self, value: Timing) -> None:
        ...
    @property
    def delay(self) -> Tuple[float, float]:
        """Seconds, (shortest, longest)."""
    @delay.setter
    def delay(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def wave_speed(self) -> float:
        """Metres a second."""
    @wave_speed.setter
    def wave_speed(self, value: float) -> None:
        ...


class CloneSettings:
    """What people get of one of them."""
    @property
    def source(self) -> int:
        """Id of an individual; 0: none chosen."""
    @source.setter
    def source(self, value: int) -> None:
        ...
    @property
    def template_too(self) -> bool:
        ...
    @template_too.setter
    def template_too(self, value: bool) -> None:
        ...
    @property
    def looks(self) -> bool:
        ...
    @looks.setter
    def looks(self, value: bool) -> None:
        ...
    @property
    def size(self) -> bool:
        ...
    @size.setter
    def size(self, value: bool) -> None:
        ...
    @property
    def heading(self) -> bool:
        ...
    @heading.setter
    def heading(self, value: bool) -> None:
        ...
    @property
    def clips(self) -> bool:
        ...
    @clips.setter
    def clips(self, value: bool) -> None:
        ...
    @property
    def timing(self) -> bool:
        ...
    @timing.setter
    def timing(self, value: bool) -> None:
        ...
    @property
    def walking(self) -> bool:
        ...
    @walking.setter
    def walking(self, value: bool) -> None:
        ...
    @property
    def tags(self) -> bool:
        ...
    @tags.setter
    def tags(self, value: bool) -> None:
        ...
    @property
    def group(self) -> bool:
        ...
    @group.setter
    def group(self, value: bool) -> None:
        ...


class SmoothSettings:
    """What becomes like the neighbours' values."""
    @property
    def distance(self) -> float:
        """Metres."""
    @distance.setter
    def distance(self, value: float) -> None:
        ...
    @property
    def size(self) -> bool:
        ...
    @size.setter
    def size(self, value: bool) -> None:
        ...
    @property
    def heading(self) -> bool:
        ...
    @heading.setter
    def heading(self, value: bool) -> None:
        ...
    @property
    def timing(self) -> bool:
        ...
    @timing.setter
    def timing(self, value: bool) -> None:
        ...
    @property
    def walk_speed(self) -> bool:
        ...
    @walk_speed.setter
    def walk_speed(self, value: bool) -> None:
        ...
    @property
    def colours(self) -> bool:
        ...
    @colours.setter
    def colours(self, value: bool) -> None:
        ...


class PushSettings:
    """How people are moved on the ground."""
    @property
    def mode(self) -> Movement:
        ...
    @mode.setter
    def mode(self, value: Movement) -> None:
        ...
    @property
    def strength(self) -> float:
        ...
    @strength.setter
    def strength(self, value: float) -> None:
        ...
    @property
    def distance(self) -> float:
        """Metres."""
    @distance.setter
    def distance(self, value: float) -> None:
        ...


class PartsSettings:
    """Which parts people show."""
    @property
    def part(self) -> str:
        """By name; empty: all."""
    @part.setter
    def part(self, value: str) -> None:
        ...
    @property
    def is_shown(self) -> bool:
        ...
    @is_shown.setter
    def is_shown(self, value: bool) -> None:
        ...
    @property
    def percent(self) -> float:
        """Percent of those under the brush."""
    @percent.setter
    def percent(self, value: float) -> None:
        ...


class FeatureSettings:
    """Which value of a kind of feature people bear."""
    @property
    def kind(self) -> str:
        """Name of a kind of feature: "emotion", "outfit"."""
    @kind.setter
    def kind(self, value: str) -> None:
        ...
    @property
    def takes_off(self) -> bool:
        """They bear no value of the kind any more; what it did to them is as their template has it."""
    @takes_off.setter
    def takes_off(self, value: bool) -> None:
        ...
    @property
    def values(self) -> Dict[Any, Any]:
        """Name → weight; empty: all of the kind."""
    @values.setter
    def values(self, value: Dict[Any, Any]) -> None:
        ...


class RelationSettings:
    """Who of those under the brush is related to whom."""
    @property
    def relation(self) -> str:
        """Name of a kind of relation: "friends", "family"."""
    @relation.setter
    def relation(self, value: str) -> None:
        ...
    @property
    def how(self) -> str:
        ...
    @how.setter
    def how(self, value: str) -> None:
        ...
    @property
    def least(self) -> int:
        """Small groups: the fewest members."""
    @least.setter
    def least(self, value: int) -> None:
        ...
    @property
    def most(self) -> int:
        """Small groups: the most members."""
    @most.setter
    def most(self, value: int) -> None:
        ...
    @property
    def count(self) -> int:
        """Some around: how many each is related to."""
    @count.setter
    def count(self, value: int) -> None:
        ...
    @property
    def metres(self) -> float:
        """Small groups, some around: how far they are apart at most."""
    @metres.setter
    def metres(self, value: float) -> None:
        ...
    @property
    def strength(self) -> Tuple[float, float]:
        """Drawn for each relation, 0–1."""
    @strength.setter
    def strength(self, value: Tuple[float, float]) -> None:
        ...
    @property
    def erases(self) -> bool:
        """Takes relations of the kind away that people have."""
    @erases.setter
    def erases(self, value: bool) -> None:
        ...
    @property
    def sources(self) -> List[int]:
        """From A to B by a rectangle or lasso: ids of those from whom."""
    @sources.setter
    def sources(self, value: List[int]) -> None:
        ...


class Brush:
    """A brush with the editor's own settings."""
    def __init__(self, kind: BrushKind) -> None:
        ...
    def copy(self) -> Brush:
        """Another one, set the same."""
    def to_dict(self) -> Dict[Any, Any]:
        """The settings of its kind as a dict that JSON can hold: what presets are kept as."""
    @staticmethod
    def from_dict(settings: Dict[Any, Any]) -> Brush:
        """The brush of such a dict; what is not in it is as the editor begins. Raises Error
        where a member is wrong or unknown."""
    def __eq__(self, other: Any) -> bool:
        ...
    @property
    def kind(self) -> BrushKind:
        ...
    @kind.setter
    def kind(self, value: BrushKind) -> None:
        ...
    @property
    def selection(self) -> Selection:
        ...
    @selection.setter
    def selection(self, value: Selection) -> None:
        ...
    @property
    def operator(self) -> Operator:
        ...
    @operator.setter
    def operator(self, value: Operator) -> None:
        ...
    @property
    def radius(self) -> float:
        """Logical pixels."""
    @radius.setter
    def radius(self, value: float) -> None:
        ...
    @property
    def rate(self) -> float:
        """Spray: points a second."""
    @rate.setter
    def rate(self, value: float) -> None:
        ...
    @property
    def through(self) -> bool:
        """Also those hidden behind others."""
    @through.setter
    def through(self, value: bool) -> None:
        ...
    @property
    def build_up(self) -> bool:
        ...
    @build_up.setter
    def build_up(self, value: bool) -> None:
        ...
    @property
    def flow(self) -> float:
        ...
    @flow.setter
    def flow(self, value: float) -> None:
        ...
    @property
    def pressure_size(self) -> bool:
        ...
    @pressure_size.setter
    def pressure_size(self, value: bool) -> None:
        ...
    @property
    def pressure_rate(self) -> bool:
        ...
    @pressure_rate.setter
    def pressure_rate(self, value: bool) -> None:
        ...
    @property
    def distribution(self) -> Sequence[float]:
        """16 weights over the range, for the random operator."""
    @distribution.setter
    def distribution(self, value: Sequence[float]) -> None:
        ...
    @property
    def mask(self) -> MaskSettings:
        ...
    @mask.setter
    def mask(self, value: MaskSettings) -> None:
        ...
    @property
    def create(self) -> CreateSettings:
        ...
    @create.setter
    def create(self, value: CreateSettings) -> None:
        ...
    @property
    def removal(self) -> DeleteSettings:
        ...
    @removal.setter
    def removal(self, value: DeleteSettings) -> None:
        ...
    @property
    def colour(self) -> ColourSettings:
        ...
    @colour.setter
    def colour(self, value: ColourSettings) -> None:
        ...
    @property
    def orientation(self) -> OrientationSettings:
        ...
    @orientation.setter
    def orientation(self, value: OrientationSettings) -> None:
        ...
    @property
    def animation(self) -> AnimationSettings:
        ...
    @animation.setter
    def animation(self, value: AnimationSettings) -> None:
        ...
    @property
    def walk(self) -> WalkSettings:
        ...
    @walk.setter
    def walk(self, value: WalkSettings) -> None:
        ...
    @property
    def style(self) -> StyleSettings:
        ...
    @style.setter
    def style(self, value: StyleSettings) -> None:
        ...
    @property
    def scale(self) -> ScaleSettings:
        ...
    @scale.setter
    def scale(self, value: ScaleSettings) -> None:
        ...
    @property
    def material(self) -> MaterialSettings:
        ...
    @material.setter
    def material(self, value: MaterialSettings) -> None:
        ...
    @property
    def group(self) -> GroupSettings:
        ...
    @group.setter
    def group(self, value: GroupSettings) -> None:
        ...
    @property
    def template(self) -> TemplateSettings:
        ...
    @template.setter
    def template(self, value: TemplateSettings) -> None:
        ...
    @property
    def shuffle(self) -> ShuffleSettings:
        ...
    @shuffle.setter
    def shuffle(self, value: ShuffleSettings) -> None:
        ...
    @property
    def restore(self) -> RestoreSettings:
        ...
    @restore.setter
    def restore(self, value: RestoreSettings) -> None:
        ...
    @property
    def time(self) -> TimeSettings:
        ...
    @time.setter
    def time(self, value: TimeSettings) -> None:
        ...
    @property
    def clone(self) -> CloneSettings:
        ...
    @clone.setter
    def clone(self, value: CloneSettings) -> None:
        ...
    @property
    def smooth(self) -> SmoothSettings:
        ...
    @smooth.setter
    def smooth(self, value: SmoothSettings) -> None:
        ...
    @property
    def push(self) -> PushSettings:
        ...
    @push.setter
    def push(self, value: PushSettings) -> None:
        ...
    @property
    def parts(self) -> PartsSettings:
        ...
    @parts.setter
    def parts(self, value: PartsSettings) -> None:
        ...
    @property
    def feature(self) -> FeatureSettings:
        ...
    @feature.setter
    def feature(self, value: FeatureSettings) -> None:
        ...
    @property
    def relation(self) -> RelationSettings:
        ...
    @relation.setter
    def relation(self, value: RelationSettings) -> None:
        ...
    @property
    def tag(self) -> int:
        """Of the tag brushes: the bit, 0–63."""
    @tag.setter
    def tag(self, value: int) -> None:
        ...
    @property
    def takes_off(self) -> bool:
        """They bear no value of the kind any more; what it did to them is as their template has it."""
    @takes_off.setter
    def takes_off(self, value: bool) -> None:
        ...
    @property
    def values(self) -> Dict[Any, Any]:
        """Name → weight; empty: all of the kind."""
    @values.setter
    def values(self, value: Dict[Any, Any]) -> None:
        ...
    @staticmethod
    def load(path: FilePath) -> Brush:
        """The brush of a .brush file, as the panel of presets saves them. Raises Error with the
        file, the place in it and what to do."""
    def save(self, path: FilePath, name: Optional[str] = ...) -> None:
        """Writes a .brush file, whole or not at all; name: what the panel calls it, else as the
        file. What means something in one scene alone is not in it: see Presets."""


class Presets:
    """Brushes kept under names, one .brush file each in a folder, as a mapping: presets[name]
    gives a brush, presets[name] = brush keeps one, del presets[name] removes it.
    crowdbrush.presets are the editor's own, and its panel shows at once what is written
    there. Words of a name that begin with # are tags. What means something in one scene
    alone, such as the group that a brush puts people into and the templates that it creates,
    is not kept: see Brush.to_dict."""
    def __init__(self, folder: Optional[FilePath] = ...) -> None:
        """Of a folder, which is made with the first preset; None: where the editor keeps its own."""
    def __len__(self) -> int:
        ...
    def __iter__(self) -> Iterator[str]:
        ...
    def __contains__(self, name: str) -> bool:
        ...
    def __getitem__(self, name: str) -> Brush:
        """Raises Error where there is none."""
    def __setitem__(self, name: str, brush: Brush) -> None:
        """Writes it; takes the place of the one with that name."""
    def __delitem__(self, name: str) -> None:
        """Its file goes into the system's trash. Raises Error where there is none."""
    def get(self, name: str, default: Any = ...) -> Any:
        """The brush, or default where there is none of that name."""
    def keys(self) -> List[str]:
        """Their names, sorted as in the panel."""
    def values(self) -> List[Brush]:
        """Their brushes, in that order."""
    def items(self) -> List[Tuple[str, Brush]]:
        """(name, brush) of each, in that order."""
    @property
    def folder(self) -> str:
        """Where their files are."""
    @property
    def problems(self) -> List[str]:
        """Which files of the folder cannot be used, and why, in sentences."""


class Range:
    """Limits of a setting: speed: Annotated[float, crowdbrush.Range(0, 4, step=0.1)] = 1.0"""
    low: float
    high: float
    step: Optional[float]
    def __init__(self, low: float, high: float, step: Optional[float] = ...) -> None:
        ...


class Selected:
    """Whom a dab of a stroke reaches: what apply(selection) of a brush gets.
    
    scene: the scene; all that is done to it belongs to the stroke. ids: uint32, ascending, alive.
    seed: a number of this dab. start, end: of the way so far, (x, y) in logical pixels; heading: of
    the way on the ground, radians, or None."""
    scene: Scene
    ids: _Array
    seed: int
    start: Tuple[float, float]
    end: Tuple[float, float]
    heading: Optional[float]
    def __init__(self, scene: Scene, ids: _Array, seed: int, start: Tuple[float, float], end: Tuple[float, float], heading: Optional[float], report: Callable[[float], None]) -> None:
        ...
    def __len__(self) -> int:
        ...
    @property
    def random(self) -> numpy.random.Generator:
        """A NumPy generator that gives the same numbers for the same stroke, dab by dab."""
    def column(self, name: str) -> _Array:
        """A copy of a column of these individuals, in the order of ids."""
    def change(self, **columns: Array) -> None:
        """scene.change for these individuals: columns by keyword, one value for all or one each."""
    def remove(self) -> None:
        """scene.remove for these individuals."""
    def progress(self, done: float) -> None:
        """Says how much of this dab is done, 0 to 1: shown over the picture when it takes long."""


class Scene:
    """A document: people, templates, stages, cameras, history."""
    def __init__(self) -> None:
        """An empty scene."""
    def save(self, path: Optional[FilePath] = ...) -> None:
        """Writes a .crowd file, whole or not at all. Without a path: where it was opened or
        saved last. Raises Error where the file cannot be written."""
    @property
    def path(self) -> str:
        """The file that it was opened from or saved to; empty: none."""
    @property
    def modified(self) -> bool:
        """Whether there is something to save."""
    def undo(self) -> bool:
        """Takes the last step back; False when there was nothing to undo. Raises Error inside an
        edit."""
    def redo(self) -> bool:
        """False when there was nothing to redo."""
    @property
    def history(self) -> List[str]:
        """Texts of all steps, oldest first."""
    @property
    def history_index(self) -> int:
        """How many steps are done."""
    def edit(self, name: str) -> Edit:
        """with scene.edit("name"): all changes become one undo step; an exception takes them back."""
    def __len__(self) -> int:
        ...
    @property
    def ids(self) -> _Array:
        """N uint32, ascending."""
    def column(self, name: str) -> _Array:
        """A copy of a column for everybody, rows by ascending id: N numbers, N×3 float32 for
        position, N×8×4 uint8 for tint, N×4 for tint0 … tint7, N×8 for choices. Raises Error
        for an unknown name."""
    def create(self, *, count: Optional[int] = ..., allow_missing: bool = ..., progress: Optional[Callable[[float], Any]] = ..., **columns: Array) -> _Array:
        """create(template=…, position=N×3, …) → ids. Columns by keyword, one value for all or
        one each; a seat brings position, heading and a sitting clip. count: how many, where
        no column says so. Raises Error, and creates nobody, for wrong shapes, values that are
        not finite, unknown templates and clips, seats that are taken, and groups and paths
        that the scene does not have, unless allow_missing. progress: is called with the share
        that is done, 0 to 1, some times a second; what it raises, as Ctrl+C, ends the call,
        which takes back what it did."""
    def remove(self, ids: Ids) -> None:
        """By ids or by a mask over everybody. Raises Error for ids that are dead or named twice."""
    def change(self, ids: Ids, *, allow_missing: bool = ..., **columns: Array) -> None:
        """change(ids_or_mask, heading=…, …): columns by keyword, one value for all or one each,
        in the order of ids. Raises Error, and changes nothing, for dead ids, wrong shapes,
        values that are not finite, and groups and paths that the scene does not have, unless
        allow_missing."""
    def put_on_ground(self, ids: Any = ...) -> int:
        """Those of them, or of all, who stand where nobody can walk (on roofs, in basins, in the
        air) come to the nearest ground: one undo step. How many. Takes seconds where the
        stages are large. Raises Error for dead ids."""
    def send(self, event: str, ids: Optional[Ids] = ..., *, number: float = ...) -> None:
        """An event happens to those who play in the editor's window: to these, or to everybody.
        Raises Error where nobody plays; without a window a Session is what plays."""
    @property
    def seats(self) -> Dict[Any, Any]:
        """Arrays by name: id, position (N×3, metres), heading (radians), rank, wedge, and free
        (bool)."""
    def render(self, width: int, height: int, *, camera: Union[None, str, Camera] = ..., time: float = ..., look: str = ..., by: str = ..., focus: Optional[float] = ..., f_stop: Optional[float] = ..., transparent: bool = ..., allow_missing: bool = ..., progress: Optional[Callable[[float], Any]] = ...) -> Picture:
        """The picture as height × width × 4 uint8. Needs no display. time: seconds, at most a
        week. camera: a name or a Camera; without one, as the timeline has it at that time, or
        the scene's first. look: one of the scene's by its name, or "plain", "lit", "cartoon"
        and the like; without it, as the camera has it, else lit. by: what people are coloured
        by, in the look "property": "template", "group", "tag", "clip", "height", "density", a
        property that is a number, or "feature:KIND". focus (metres from the camera; without
        it, what the camera turns around) and f_stop (the smaller, the less is sharp; 0.5
        without it): depth of field, where either is given. transparent: alpha is 0 where
        neither people nor stages are. Where a stage, or a character of whom there is
        somebody, could not be loaded, it fails and says what is missing, unless
        allow_missing. progress: is called with the share that is done, 0 to 1, some times a
        second; what it raises, as Ctrl+C, ends the call, which takes back what it did."""
    def camera_at(self, time: float) -> Camera:
        """The camera as the timeline's marks have moved it by then: seconds of the clock.
        Without such marks it is the scene's first."""
    def render_passes(self, width: int, height: int, passes: Sequence[str], *, camera: Union[None, str, Camera] = ..., time: float = ..., look: str = ..., by: str = ..., path: Optional[FilePath] = ..., transparent: bool = ..., allow_missing: bool = ..., progress: Optional[Callable[[float], Any]] = ...) -> Dict[Any, Any]:
        """What the picture shows, in numbers for compositing: by the name of each of the passes
        an array, height × width, × the components where there are several, float32 or uint32,
        rows from the top. path: an .exr file that they are written to as well, a layer each,
        or a .png, from which each has one of its own (a.depth.png), as whole numbers. Of each
        pixel it is what lies at its centre; glass of stages is seen through, and of people
        what hides less than half. There are colour (red, green, blue and alpha of the
        finished picture, as linear light beyond 8 bits and white, colours times alpha); depth
        (metres along the view axis; 1e10 where nothing is); normal (unit vectors, world,
        towards the camera's side; 0 where nothing is); position (metres, world, Y up; 0 where
        nothing is); motion (pixels, right and up, to where the same point was a frame
        earlier; 0 where somebody was not there yet); id (the individual's id; 0 where nobody
        is); template (the individual's template; 0 where nobody is); cryptomatte (mattes of
        everybody and of every template with smooth edges, by the Cryptomatte specification;
        24 components; sharp where the colours have depth of field). camera, time, look, by,
        transparent and allow_missing are as of render. progress: is called with the share
        that is done, 0 to 1, some times a second; what it raises, as Ctrl+C, ends the call,
        which takes back what it did."""
    def make_movie(self, path: FilePath, frames: Sequence[int], *, fps: float = ..., width: int = ..., height: int = ..., camera: Union[None, str, Camera] = ..., look: str = ..., by: str = ..., passes: Sequence[str] = ..., transparent: bool = ..., allow_missing: bool = ..., progress: Optional[Callable[[float], Any]] = ...) -> List[Any]:
        """Draws frames of the scene, such as range(300), each at its number / fps seconds: into
        one movie where path ends as one (.mp4, .webm, .gif; made by ffmpeg), else each into a
        picture of its own, with its number for the #### of path. Without a camera, the
        timeline moves it. passes: as of render_passes, into .exr files. Returns what was
        written. camera, look, by and allow_missing are as of render. progress: is called with
        the share that is done, 0 to 1, some times a second; what it raises, as Ctrl+C, ends
        the call, which takes back what it did."""
    @property
    def takes(self) -> List[Take]:
        """list of Take: kept runs. Their motion is in files in a folder beside the project."""
    def show_take(self, name: Optional[str]) -> None:
        """People move as in that take: in the window, in pictures and movies. None: as the scene
        plays. Raises Error where there is none, or its motion is not there."""
    def add_take(self, path: FilePath, name: str, *, id: int = ...) -> Take:
        """A .take file, of this project or another one, becomes a take of this scene; saving
        brings it into the project's folder of takes. It moves those who have the same ids."""
    def rename_take(self, name: str, to: str) -> None:
        """Raises Error where another one has that name."""
    def edit_take(self, name: str, edits: Any, *, on: bool = ...) -> None:
        """What is done to people of the take by hand, instead of what was done so far: a list of
        dicts, or JSON text. kind: "shift" (later: seconds), "pace" (pace: times as fast; 0:
        they stand still), "aside" (aside: metres to the right), "swap" (templates: ids of
        those that they are of meanwhile) or "hide"; people: their ids, ascending; begin and
        end: seconds of the clock, of all but "shift" (an end that is not after the beginning:
        to the end of the take); on: whether it counts. They survive it when people are taken
        again. on=False: none of them counts. Raises Error for what is none, and where there
        is no such take."""
    def retake(self, take: str, name: str, ids: Any, begin: float, end: float, *, different: bool = ..., progress: Optional[Callable[[float], Any]] = ...) -> Take:
        """Some people of a take, by ids or a mask over everybody, are simulated again from begin
        to end, seconds of the clock, by the rules and paths of now; everybody else does what
        he did, and they make way for him. They set out as they are then and come back to
        where they were where more of the take follows. What comes of it is another take, one
        undo step; returns it. different: dice fall otherwise than in the run. Raises Error
        where there is no such take, the name is another's, nobody is chosen or the stretch
        lies outside. progress: is called with the share that is done, 0 to 1, some times a
        second; what it raises, as Ctrl+C, ends the call, which takes back what it did."""
    def remove_take(self, name: str) -> None:
        """The file with its motion stays."""
    @property
    def templates(self) -> List[Template]:
        """Characters to make copies of."""
    def template(self, name: str) -> Template:
        """The first one of that name."""
    def add_template(self, path: FilePath, name: str = ..., *, id: int = ..., scale: Optional[float] = ..., rotation: Optional[Sequence[float]] = ..., ground_offset: Optional[float] = ..., remove_root_motion: Optional[bool] = ..., clip_speeds: Optional[List[Optional[float]]] = ..., clip_roles: Optional[List[Optional[str]]] = ...) -> Template:
        """A .glb or .gltf file, or a built-in one such as builtin:templates/man.glb. The rest is
        what the import dialog asks for: a scale, a rotation (w, x, y, z), metres added to Y,
        and clip by clip ground speeds in m/s (None: the file's) and roles, which say what
        people stand, walk and sit with: "idle", "walk", "run", "fly", "sit" or "other" (None:
        the proposed one)."""
    def change_template(self, template: Union[Template, int], *, path: Optional[FilePath] = ..., name: Optional[str] = ..., scale: Optional[float] = ..., rotation: Optional[Sequence[float]] = ..., ground_offset: Optional[float] = ..., remove_root_motion: Optional[bool] = ..., clip_speeds: Optional[List[Optional[float]]] = ..., clip_roles: Optional[List[Optional[str]]] = ...) -> None:
        """By handle or id; what is not given stays. See add_template."""
    def remove_template(self, template: Union[Template, int]) -> None:
        """By handle or id; refused as long as somebody is of it."""
    @property
    def stages(self) -> List[Stage]:
        """Geometry that people stand on, as it is placed."""
    def add_stage(self, path: FilePath, name: str = ..., position: Sequence[float] = ..., heading: float = ..., scale: float = ..., *, id: int = ...) -> Stage:
        """A .glb or .gltf file, or a built-in one such as builtin:stages/theatre.glb. Metres,
        radians."""
    def change_stage(self, stage: Union[Stage, int], *, path: Optional[FilePath] = ..., name: Optional[str] = ..., position: Optional[Sequence[float]] = ..., heading: Optional[float] = ..., scale: Optional[float] = ...) -> None:
        """By stage or id; what is not given stays."""
    def remove_stage(self, stage: Union[Stage, int]) -> None:
        """By stage or id."""
    @property
    def cameras(self) -> Dict[Any, Any]:
        """Name → Camera."""
    def set_camera(self, name: str, camera: Camera, look: Optional[str] = ...) -> None:
        """Moves the one of that name, or adds it. look: the name of one of the scene's, which
        the view takes on with this camera; "": none; None: as it was."""
    def remove_camera(self, name: str) -> None:
        """Raises Error where there is none of that name."""
    def set_cameras(self, cameras: List[Tuple[str, Camera]], looks: Dict[str, str] = ...) -> None:
        """All of them, as pairs of name and Camera, in this order. looks: name of the camera →
        name of its look, of those that have one."""
    @property
    def camera_looks(self) -> Dict[Any, Any]:
        """Name of the camera → name of its look, empty where it has none."""
    @property
    def lighting(self) -> Lighting:
        """A copy of how it is now; changed with set_lighting."""
    def set_lighting(self, lighting: Lighting) -> None:
        """Sun, sky and ground as given."""
    @property
    def environment(self) -> Any:
        """A dict of lists as the project file has them: places, paths, groups, tags, rules,
        numbers, cues, the surface to walk on, stepsPerSecond, and playRange (begin, end in
        seconds, and loop: what the editor plays). scene.rules and so on give the lists as
        typed classes."""
    def set_environment(self, environment: Union[str, Dict[str, Any]], *, strict: bool = ...) -> None:
        """Lists of places, paths, groups, tags, rules and so on as in environment, or the same
        as JSON text; what is not in it stays. What stands in them are dicts, or Rule, Place
        and so on. Raises Error where a member is wrong, or misspelt, or a rule names a clip
        or slot that no template has. strict=False takes what a project file may hold: members
        of a later version, clips of templates that are gone."""
    def add_rules(self, key: str) -> List[int]:
        """Ready-made rules with their cues, as the editor's panel adds them: made for the clips
        and places that the scene has. Their ids. There are: audience, stadium wave,
        pedestrians, panic, flock, queue."""
    def stroke(self, brush: Union[Brush, Any], points: Array, *, camera: Union[None, str, Camera] = ..., size: Tuple[float, float] = ..., seed: int = ..., time: float = ..., allow_missing: bool = ..., selected: Any = ..., progress: Optional[Callable[[float], Any]] = ...) -> StrokeOutcome:
        """Paints as the mouse does: points in logical pixels of a view of this size, rows of x,
        y[, pressure[, time[, shown]]]; one undo step. shown: the transport's time of what was
        on screen, for all of them with time=. Raises Error where the brush names a group,
        template, path or clip that the scene does not have, unless allow_missing: it paints
        all the same then, as the editor does. selected: whom each dab means, by its number,
        instead of those under it; recordings of strokes on people who were elsewhere while it
        played have it. progress: is called with the share that is done, 0 to 1, some times a
        second; what it raises, as Ctrl+C, ends the call, which takes back what it did."""
    @property
    def states(self) -> States:
        """Kept states by name."""
    def save_state(self, name: str, columns: Optional[List[str]] = ..., ids: Any = ...) -> None:
        """Keeps how these people are now, or all of them: one undo step. columns: names;
        without, everything but who and where they are (template, position, heading, seat,
        group, seed). A state of that name is replaced. Raises Error for unknown columns and
        dead ids."""
    def recall_state(self, name: str, seconds: float = ..., stagger: Optional[Stagger] = ..., ids: Any = ..., *, columns: Optional[List[str]] = ...) -> StateRecall:
        """Gives them back what they had: one undo step. columns, ids: these alone. Clips, slots
        and parts go by name; who is gone is skipped. seconds, stagger: the scene changes at
        once, but in its sessions, and where the editor plays, each takes so long, one after
        the other. Raises Error where there is no such state, and for dead ids."""
    def set_feature(self, ids: Any, kind: str, value: Any) -> int:
        """Lets these people bear a value of a feature, with all that it does to them: one undo
        step. value: its name; a dict of names and weights, or a list of names, one of which
        is drawn for each; None: they bear none any more, what it did to them stays. What a
        value names by clips, slots and parts that somebody has not is left as it is. How many
        changed. Raises Error for unknown names and dead ids."""
    def feature(self, kind: str) -> Any:
        """Names of the values of a feature that people bear, in the order of ids; "" for none.
        Raises Error where there is no such feature."""
    def relate(self, from_ids: Any, to_ids: Any, name: str, strength: Any = ...) -> int:
        """Relates people by a kind of relation: the first of from_ids to the first of to_ids and
        so on; one stands for all. One undo step. strength: 0 to 1, a number or one for each.
        Who is related so already gets the new strength. How many relations are another way.
        Raises Error for unknown names, dead ids, and lists that do not fit."""
    def unrelate(self, from_ids: Any, to_ids: Any = ..., name: Optional[str] = ...) -> int:
        """Takes relations away from from_ids to to_ids, one for one; without to_ids all that
        from_ids have, whichever way they go. name: of that kind alone. One undo step. How
        many there were."""
    def related(self, ids: Any, name: Optional[str] = ...) -> _Array:
        """Ids of those to whom one of these is related, ascending; of a kind that is not mutual
        those that it goes to. name: by that kind alone."""
    def duplicate(self, ids: Any, offset: Sequence[float] = ...) -> _Array:
        """Copies of these people, offset metres away, related among each other as these are: one
        undo step. Of those who sit on the free seats nearest to there; where none is near
        they stand. Their ids, in the order of these."""
    @property
    def relations(self) -> Dict[Any, Any]:
        """All relations as a dict of arrays, "from", "to", "name" and "strength", in the order
        of the ids. Copies: relate() and unrelate() change them."""
    @property
    def features(self) -> Features:
        """Features by their names, and their values by theirs."""
    @property
    def relation_kinds(self) -> RelationKinds:
        """Kinds of relations by their names."""
    @property
    def places(self) -> List[Place]:
        """A new list of Place, as the environment has them, by name too; setting it is a step of
        undo."""
    @places.setter
    def places(self, value: List[Place]) -> None:
        ...
    @property
    def paths(self) -> List[Path]:
        """A new list of Path, as the environment has them, by name too; setting it is a step of
        undo."""
    @paths.setter
    def paths(self, value: List[Path]) -> None:
        ...
    @property
    def groups(self) -> List[Group]:
        """A new list of Group, as the environment has them, by name too; setting it is a step of
        undo."""
    @groups.setter
    def groups(self, value: List[Group]) -> None:
        ...
    @property
    def tags(self) -> List[Tag]:
        """A new list of Tag, as the environment has them, by name too; setting it is a step of undo."""
    @tags.setter
    def tags(self, value: List[Tag]) -> None:
        ...
    @property
    def numbers(self) -> List[Number]:
        """A new list of Number, as the environment has them, by name too; setting it is a step
        of undo."""
    @numbers.setter
    def numbers(self, value: List[Number]) -> None:
        ...
    @property
    def cues(self) -> List[Cue]:
        """A new list of Cue, as the environment has them, by name too; setting it is a step of undo."""
    @cues.setter
    def cues(self, value: List[Cue]) -> None:
        ...
    @property
    def lights(self) -> List[Light]:
        """A new list of Light, as the environment has them, by name too; setting it is a step of
        undo."""
    @lights.setter
    def lights(self, value: List[Light]) -> None:
        ...
    @property
    def looks(self) -> List[Look]:
        """A new list of Look, as the environment has them, by name too; setting it is a step of
        undo."""
    @looks.setter
    def looks(self, value: List[Look]) -> None:
        ...
    @property
    def timeline(self) -> List[Mark]:
        """A new list of Mark, as the environment has them, by name too; setting it is a step of
        undo."""
    @timeline.setter
    def timeline(self, value: List[Mark]) -> None:
        ...
    @property
    def rules(self) -> List[Rule]:
        """A new list of Rule, as the environment has them, by name too; setting it is a step of
        undo."""
    @rules.setter
    def rules(self, value: List[Rule]) -> None:
        ...


class Edit:
    """What scene.edit(name) gives: for `with`."""
    def __enter__(self) -> Scene:
        ...
    def __exit__(self, arg0: Any, arg1: Any, arg2: Any) -> None:
        ...


class Camera:
    """Where a picture is taken from. World frame, metres."""
    def __init__(self, position: Sequence[float], target: Sequence[float], fov: float = ...) -> None:
        """Looks from position to target, metres. fov: vertical, degrees."""
    @staticmethod
    def exact(position: Sequence[float], orientation: Sequence[float], *, orthographic: bool = ..., fov_radians: float = ..., height: float = ..., pivot_distance: float = ...) -> Camera:
        """Just as the editor holds it: orientation is a quaternion (w, x, y, z) of a view along
        -Z with Y up; height: metres from bottom to top, orthographic; pivot_distance: to the
        point that orbiting turns around."""
    @property
    def position(self) -> Sequence[float]:
        ...
    @property
    def target(self) -> Sequence[float]:
        ...
    @property
    def orientation(self) -> Sequence[float]:
        """Quaternion (w, x, y, z)."""
    @property
    def orthographic(self) -> bool:
        ...
    @property
    def fov_radians(self) -> float:
        """Vertical."""
    @property
    def height(self) -> float:
        """Metres, orthographic."""
    @property
    def pivot_distance(self) -> float:
        """Metres."""
    def __eq__(self, other: Any) -> bool:
        ...


class Picture(numpy.ndarray[Any, Any]):
    """A picture: height × width × 4 uint8, red, green, blue, alpha, sRGB, rows from the top."""
    def save_png(self, path: FilePath, transparent: bool = ...) -> None:
        """Writes the picture to a file, whole or not at all; with its alpha where transparent."""


class Take:
    """A run that was kept, to be shown again whatever becomes of paths and rules; as it was when
    it was asked for."""
    @property
    def name(self) -> str:
        ...
    @property
    def begin(self) -> float:
        """Seconds of the clock of its first step."""
    @property
    def end(self) -> float:
        """Seconds of the clock of its last step."""
    @property
    def people(self) -> int:
        """How many it moves."""
    @property
    def shown(self) -> bool:
        """Whether it is seen instead of a run."""
    @property
    def problem(self) -> str:
        """Why its motion is not there; empty: it is."""
    @property
    def edits(self) -> Any:
        """list of dict: what is done to people of it by hand, see Scene.edit_take."""
    @property
    def edited(self) -> bool:
        """Whether its edits count."""


class Lighting:
    """Sun, sky and ground. Angles in radians, colours sRGB 0–1."""
    def __init__(self, *, sun_azimuth: float = ..., sun_elevation: float = ..., sun_color: Sequence[float] = ..., sun_strength: float = ..., shadow_strength: float = ..., shadow_softness: float = ..., highlights: float = ..., ambient_color: Sequence[float] = ..., ambient_strength: float = ..., occlusion: float = ..., sky_zenith: Sequence[float] = ..., sky_horizon: Sequence[float] = ..., ground: Sequence[float] = ..., ground_grid: bool = ..., haze: float = ..., haze_height: float = ..., exposure: float = ..., white: float = ..., tone: Any = ...) -> None:
        ...
    @property
    def sun_azimuth(self) -> float:
        """where the sun stands, from +Z towards +X"""
    @sun_azimuth.setter
    def sun_azimuth(self, value: float) -> None:
        ...
    @property
    def sun_elevation(self) -> float:
        """how high it stands over the horizon"""
    @sun_elevation.setter
    def sun_elevation(self, value: float) -> None:
        ...
    @property
    def sun_color(self) -> Sequence[float]:
        """of the sun"""
    @sun_color.setter
    def sun_color(self, value: Sequence[float]) -> None:
        ...
    @property
    def sun_strength(self) -> float:
        """of the sun; 1: as on a clear day"""
    @sun_strength.setter
    def sun_strength(self, value: float) -> None:
        ...
    @property
    def shadow_strength(self) -> float:
        """how dark the shadows are that people and stages cast; 0: none are cast"""
    @shadow_strength.setter
    def shadow_strength(self, value: float) -> None:
        ...
    @property
    def shadow_softness(self) -> float:
        """the angle that the sun takes in the sky: the larger, the softer its shadows"""
    @shadow_softness.setter
    def shadow_softness(self, value: float) -> None:
        ...
    @property
    def highlights(self) -> float:
        """how strongly smooth surfaces mirror the sun, the lamps and the sky; 0: not"""
    @highlights.setter
    def highlights(self, value: float) -> None:
        ...
    @property
    def ambient_color(self) -> Sequence[float]:
        """of the light that comes from all of the sky"""
    @ambient_color.setter
    def ambient_color(self, value: Sequence[float]) -> None:
        ...
    @property
    def ambient_strength(self) -> float:
        """of the sky's light"""
    @ambient_strength.setter
    def ambient_strength(self, value: float) -> None:
        ...
    @property
    def occlusion(self) -> float:
        """how dark it is in corners and where bodies meet ground and seats; 0: not"""
    @occlusion.setter
    def occlusion(self, value: float) -> None:
        ...
    @property
    def sky_zenith(self) -> Sequence[float]:
        """the sky overhead"""
    @sky_zenith.setter
    def sky_zenith(self, value: Sequence[float]) -> None:
        ...
    @property
    def sky_horizon(self) -> Sequence[float]:
        """the sky at the horizon, and the ground far away"""
    @sky_horizon.setter
    def sky_horizon(self, value: Sequence[float]) -> None:
        ...
    @property
    def ground(self) -> Sequence[float]:
        """of the ground"""
    @ground.setter
    def ground(self, value: Sequence[float]) -> None:
        ...
    @property
    def ground_grid(self) -> bool:
        """lines a metre apart"""
    @ground_grid.setter
    def ground_grid(self, value: bool) -> None:
        ...
    @property
    def haze(self) -> float:
        """share of what is a hundred metres away that the air hides"""
    @haze.setter
    def haze(self, value: float) -> None:
        ...
    @property
    def haze_height(self) -> float:
        """metres above 0 where a third of it is left, as of mist; 0: it is everywhere alike"""
    @haze_height.setter
    def haze_height(self, value: float) -> None:
        ...
    @property
    def exposure(self) -> float:
        """stops: each doubles the brightness"""
    @exposure.setter
    def exposure(self, value: float) -> None:
        ...
    @property
    def white(self) -> float:
        """the light that looks white, kelvin: lower makes the picture bluer"""
    @white.setter
    def white(self, value: float) -> None:
        ...
    @property
    def tone(self) -> str:
        """what brightness beyond white becomes: white, or it rolls off as on film"""
    @tone.setter
    def tone(self, value: str) -> None:
        ...
    @staticmethod
    def ready(key: str) -> Lighting:
        """A ready-made one: "noon", "afternoon", "dusk", "overcast", "night" or "studio"."""
    @staticmethod
    def of_day(hours: float, haze: float = ...) -> Lighting:
        """Sun or moon and sky as they are at an hour of 0–24, paler and softer the more haze
        there is."""


class Stage:
    """A stage as it is placed in a scene, for reading."""
    @property
    def id(self) -> int:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def path(self) -> str:
        ...
    @property
    def position(self) -> Sequence[float]:
        """World frame, metres."""
    @property
    def heading(self) -> float:
        """Radians."""
    @property
    def scale(self) -> float:
        ...


class StrokeOutcome:
    """What a stroke did."""
    @property
    def committed(self) -> bool:
        """Whether it made an undo step."""
    @property
    def affected(self) -> int:
        """Created, removed or changed."""
    @property
    def message(self) -> str:
        """Why nothing happened; empty otherwise."""


class Stagger:
    """People take on a state one after the other."""
    def __init__(self, seconds: float, order: str = ..., point: Sequence[float] = ..., heading: float = ...) -> None:
        """The last begins so many seconds after the first. order: distance (from point), heading
        (in which it moves on, radians), row or wedge (of the seats), random."""
    @property
    def seconds(self) -> float:
        """from the first who begins to the last; 0: all together"""
    @seconds.setter
    def seconds(self, value: float) -> None:
        ...
    @property
    def order(self) -> str:
        """who begins when"""
    @order.setter
    def order(self, value: str) -> None:
        ...
    @property
    def point(self) -> Sequence[float]:
        """metres; of `distance`"""
    @point.setter
    def point(self, value: Sequence[float]) -> None:
        ...
    @property
    def heading(self) -> float:
        """radians; of `heading`, in which it moves on"""
    @heading.setter
    def heading(self, value: float) -> None:
        ...


class State:
    """How some people were in some of their properties, as it was when it was asked for."""
    @property
    def name(self) -> str:
        ...
    @property
    def id(self) -> int:
        """Its name within the scene, which stays: as rules, cues and the restore brush have it."""
    @property
    def columns(self) -> List[str]:
        """Names of the columns that it gives back."""
    @property
    def ids(self) -> _Array:
        """Whose they are, ascending; some may be gone."""
    def __len__(self) -> int:
        """How many people it is of."""
    def column(self, name: str) -> _Array:
        """What it holds, as Scene.column has it, in the order of ids. Raises Error for what it
        does not hold."""


class StateRecall:
    """What came of giving a state back."""
    @property
    def affected(self) -> int:
        """How many people changed."""
    @property
    def notes(self) -> List[str]:
        """What did not fit any more."""


class States:
    """The states of a scene by their names, in the order of the panel."""
    def __getitem__(self, name: str) -> State:
        ...
    def __delitem__(self, name: str) -> None:
        """One undo step."""
    def __contains__(self, arg0: str) -> bool:
        ...
    def __len__(self) -> int:
        ...
    def __iter__(self) -> Iterator[str]:
        ...
    def keys(self) -> List[str]:
        """The names, in their order."""
    def rename(self, name: str, to: str) -> None:
        """One undo step."""
    def arrange(self, names: List[str]) -> None:
        """All names in another order: one undo step."""
    def text(self) -> str:
        """All of them as the text of a project file with nothing else."""
    def set_text(self, text: str) -> None:
        """What text() gave, in place of what there is: one undo step."""


class Entry(Dict[str, Any]):
    """What a scene's environment is made of: a dict as the project file has it, with typed attributes.
    
    Made with its members as keywords; those that are not given have the value that they begin with.
    An attribute is the member of the dict of that name. Goes wherever the dict goes."""
    def __init__(self, **members: Any) -> None:
        ...
    @classmethod
    def from_dict(cls, members: Dict[str, Any]) -> Entry:
        """Of a dict as the project file has it; members that this version does not know stay in it."""
    def to_dict(self) -> Dict[str, Any]:
        """A plain dict, with plain ones in it."""
    def __eq__(self, other: Any) -> bool:
        """To a dict too: what it leaves out is what it begins with. Numbers are as precise as files."""


class Trigger(Entry):
    """What makes a rule fire: one of crowdbrush.triggers."""


class Condition(Entry):
    """What must hold for a rule to fire: one of crowdbrush.conditions."""


class Action(Entry):
    """What a rule does: one of crowdbrush.actions."""


class triggers:
    """The kinds of triggers."""

    class Start(Trigger):
        """The session begins."""
        def __init__(self) -> None:
            ...

    class Event(Trigger):
        """An event of that name reaches somebody."""
        def __init__(self, *, event: str = ...) -> None:
            ...
        event: str
        """its name"""

    class Arrived(Trigger):
        """Somebody reaches the place that he was going to."""
        def __init__(self, *, place: Union[int, Place] = ...) -> None:
            ...
        place: int
        """0: any; begins as 0"""

    class Entered(Trigger):
        """Somebody comes into a place's circle."""
        def __init__(self, *, place: Union[int, Place] = ...) -> None:
            ...
        place: int
        """0: any; begins as 0"""

    class Left(Trigger):
        """Somebody comes out of a place's circle."""
        def __init__(self, *, place: Union[int, Place] = ...) -> None:
            ...
        place: int
        """0: any; begins as 0"""

    class PathEnded(Trigger):
        """Somebody reaches the end of a simple path."""
        def __init__(self, *, path: Union[int, Path] = ...) -> None:
            ...
        path: int
        """0: any; begins as 0"""

    class ClipEnded(Trigger):
        """A clip that a rule let somebody play is over."""
        def __init__(self) -> None:
            ...

    class State(Trigger):
        """Somebody begins to take on a state, whoever recalled it."""
        def __init__(self, *, state: int = ...) -> None:
            ...
        state: int
        """its id; 0: any; begins as 0"""

    class Feature(Trigger):
        """Somebody bears another value of a feature than before, whoever gave it."""
        def __init__(self, *, feature: Union[int, FeatureValue] = ...) -> None:
            ...
        feature: int
        """the id of the one that he bears now; 0: any; begins as 0"""

    class RelatedDid(Trigger):
        """One to whom he is related, whichever way, arrives at a place, leaves it or hears an event.
    It comes from that one."""
        def __init__(self, *, relation: Union[int, RelationKind] = ..., deed: Literal["arrives", "leaves", "hears"] = ..., place: Union[int, Place] = ..., event: str = ...) -> None:
            ...
        relation: int
        """by which; 0: any; begins as 0"""
        deed: Literal["arrives", "leaves", "hears"]
        """what that one does; begins as 'arrives'"""
        place: int
        """where; 0: any; begins as 0"""
        event: str
        """its name, of hears"""

    class Every(Trigger):
        """Again and again, for each at other times."""
        def __init__(self, *, seconds: float = ..., jitter: float = ...) -> None:
            ...
        seconds: float
        """between two times; 0 to 86400 s; begins as 5.0"""
        jitter: float
        """how much earlier or later it may be, as a share of the time; 0 to 1; begins as 0.2"""

    class TagNear(Trigger):
        """Somebody with a tag comes near."""
        def __init__(self, *, tag: Union[int, Tag] = ..., metres: float = ...) -> None:
            ...
        tag: int
        """of who comes near; 0 to 63; begins as 0"""
        metres: float
        """how near; 0 to 10000 m; begins as 3.0"""

    class SpeedLimit(Trigger):
        """Somebody gets faster or slower than a speed."""
        def __init__(self, *, above: bool = ..., metres_per_second: float = ...) -> None:
            ...
        above: bool
        """whether he gets faster than it, else slower; begins as True"""
        metres_per_second: float
        """the speed, m/s; 0 to 100 m/s; begins as 2.0"""

    class Waited(Trigger):
        """Somebody has stood still for so long."""
        def __init__(self, *, seconds: float = ...) -> None:
            ...
        seconds: float
        """how long; 0 to 86400 s; begins as 5.0"""

    class AheadFree(Trigger):
        """The place before somebody's in a path's order gets free."""
        def __init__(self, *, path: Union[int, Path] = ...) -> None:
            ...
        path: int
        """0: any; begins as 0"""


class conditions:
    """The kinds of conditions."""

    class Tag(Condition):
        """Has a tag."""
        def __init__(self, *, tag: Union[int, Tag] = ..., not_: bool = ...) -> None:
            ...
        tag: int
        """the tag; 0 to 63; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Feature(Condition):
        """Bears a value of a feature."""
        def __init__(self, *, feature: Union[int, FeatureValue] = ..., not_: bool = ...) -> None:
            ...
        feature: int
        """its id; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Template(Condition):
        """Is made from a template."""
        def __init__(self, *, template: Union[int, Template] = ..., not_: bool = ...) -> None:
            ...
        template: int
        """its id; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class InPlace(Condition):
        """Is in a place's circle."""
        def __init__(self, *, place: Union[int, Place] = ..., not_: bool = ...) -> None:
            ...
        place: int
        """its id; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Follows(Condition):
        """Walks along a path."""
        def __init__(self, *, path: Union[int, Path] = ..., not_: bool = ...) -> None:
            ...
        path: int
        """0: any; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Seated(Condition):
        """Sits on a seat."""
        def __init__(self, *, not_: bool = ...) -> None:
            ...
        not_: bool
        """whether it must not hold; begins as False"""

    class Chance(Condition):
        """Holds in a share of cases, drawn anew each time."""
        def __init__(self, *, chance: float = ..., not_: bool = ...) -> None:
            ...
        chance: float
        """the share; 0 to 1; begins as 0.5"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Number(Condition):
        """An artist's number of his, compared."""
        def __init__(self, *, number: Union[int, Number] = ..., compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        number: int
        """its id; begins as 0"""
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Speed(Condition):
        """How fast he goes over the ground, m/s, compared."""
        def __init__(self, *, compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6 m/s; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Payload(Condition):
        """The number that the event carries, compared."""
        def __init__(self, *, compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Full(Condition):
        """A place has no room left."""
        def __init__(self, *, place: Union[int, Place] = ..., not_: bool = ...) -> None:
            ...
        place: int
        """its id; begins as 0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class PeopleIn(Condition):
        """How many are in a place, compared."""
        def __init__(self, *, place: Union[int, Place] = ..., compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        place: int
        """its id; begins as 0"""
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Related(Condition):
        """How many are related to him, whichever way, and have not left, compared."""
        def __init__(self, *, relation: Union[int, RelationKind] = ..., compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        relation: int
        """by which; 0: any; begins as 0"""
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""

    class Property(Condition):
        """A property of his, compared."""
        def __init__(self, *, property: Literal["height", "girth", "playback speed", "walk speed", "clip"] = ..., clip: str = ..., compare: Literal["less", "equal", "more"] = ..., value: float = ..., not_: bool = ...) -> None:
            ...
        property: Literal["height", "girth", "playback speed", "walk speed", "clip"]
        """which; begins as 'height'"""
        clip: str
        """of the property clip: its name"""
        compare: Literal["less", "equal", "more"]
        """how it is compared with the value; begins as 'more'"""
        value: float
        """that it is compared with; -1e6 to 1e6 ×; begins as 0.0"""
        not_: bool
        """whether it must not hold; begins as False"""


class actions:
    """The kinds of actions."""

    class Play(Action):
        """Plays one of the clips, drawn by weight."""
        def __init__(self, *, clips: Clips = ..., loop: bool = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        clips: List[Dict[str, Any]]
        """with their weights; whoever has none of them goes on at once"""
        loop: bool
        """for so many seconds, else once; begins as False"""
        seconds: float
        """how long a loop goes on; 0: until another rule comes; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Turn(Action):
        """Turns to somebody or something."""
        def __init__(self, *, aim: Literal["sender", "tagged", "place", "related"] = ..., tag: Union[int, Tag] = ..., place: Union[int, Place] = ..., relation: Union[int, RelationKind] = ..., depth: int = ...) -> None:
            ...
        aim: Literal["sender", "tagged", "place", "related"]
        """whom or what it is about; begins as 'sender'"""
        tag: int
        """of whom is meant; 0 to 63; begins as 0"""
        place: int
        """that is meant; begins as 0"""
        relation: int
        """by which those are related who are meant; 0: any; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class LookAt(Action):
        """Keeps facing somebody or something."""
        def __init__(self, *, aim: Literal["sender", "tagged", "place", "related"] = ..., tag: Union[int, Tag] = ..., place: Union[int, Place] = ..., relation: Union[int, RelationKind] = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        aim: Literal["sender", "tagged", "place", "related"]
        """whom or what it is about; begins as 'sender'"""
        tag: int
        """of whom is meant; 0 to 63; begins as 0"""
        place: int
        """that is meant; begins as 0"""
        relation: int
        """by which those are related who are meant; 0: any; begins as 0"""
        seconds: float
        """how long; 0: until another rule comes; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class SitDown(Action):
        """Goes to the nearest free seat and sits down."""
        def __init__(self, *, metres: float = ..., depth: int = ...) -> None:
            ...
        metres: float
        """how far the seat may be; 0: however far; 0 to 10000 m; begins as 2.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class StandUp(Action):
        """Gets up from his seat."""
        def __init__(self, *, depth: int = ...) -> None:
            ...
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Follow(Action):
        """Walks along a path."""
        def __init__(self, *, path: Union[int, Path] = ..., depth: int = ...) -> None:
            ...
        path: int
        """its id; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class GoTo(Action):
        """Goes to a place, and on when he is there."""
        def __init__(self, *, choice: Literal["given", "nearest", "nearest free", "first free", "ahead"] = ..., path: Union[int, Path] = ..., place: Union[int, Place] = ..., depth: int = ...) -> None:
            ...
        choice: Literal["given", "nearest", "nearest free", "first free", "ahead"]
        """which place; begins as 'given'"""
        path: int
        """whose places are meant, of all choices but given; 0: any; begins as 0"""
        place: int
        """the one that is given, or one whose name those have that are meant; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class GoToPerson(Action):
        """Goes to somebody, who may walk himself."""
        def __init__(self, *, aim: Literal["sender", "tagged", "place", "related"] = ..., tag: Union[int, Tag] = ..., place: Union[int, Place] = ..., relation: Union[int, RelationKind] = ..., metres: float = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        aim: Literal["sender", "tagged", "place", "related"]
        """whom or what it is about; begins as 'sender'"""
        tag: int
        """of whom is meant; 0 to 63; begins as 0"""
        place: int
        """that is meant; begins as 0"""
        relation: int
        """by which those are related who are meant; 0: any; begins as 0"""
        metres: float
        """how near he comes; 0 to 10000 m; begins as 2.0"""
        seconds: float
        """gives up after so long; 0: never; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class FollowPerson(Action):
        """Stays near somebody who walks."""
        def __init__(self, *, aim: Literal["sender", "tagged", "place", "related"] = ..., tag: Union[int, Tag] = ..., place: Union[int, Place] = ..., relation: Union[int, RelationKind] = ..., metres: float = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        aim: Literal["sender", "tagged", "place", "related"]
        """whom or what it is about; begins as 'sender'"""
        tag: int
        """of whom is meant; 0 to 63; begins as 0"""
        place: int
        """that is meant; begins as 0"""
        relation: int
        """by which those are related who are meant; 0: any; begins as 0"""
        metres: float
        """how near he comes; 0 to 10000 m; begins as 2.0"""
        seconds: float
        """how long; 0: until another rule comes; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Flee(Action):
        """Goes away from somebody or something."""
        def __init__(self, *, aim: Literal["sender", "tagged", "place", "related"] = ..., tag: Union[int, Tag] = ..., place: Union[int, Place] = ..., relation: Union[int, RelationKind] = ..., metres: float = ..., depth: int = ...) -> None:
            ...
        aim: Literal["sender", "tagged", "place", "related"]
        """whom or what it is about; begins as 'sender'"""
        tag: int
        """of whom is meant; 0 to 63; begins as 0"""
        place: int
        """that is meant; begins as 0"""
        relation: int
        """by which those are related who are meant; 0: any; begins as 0"""
        metres: float
        """how far; 0 to 10000 m; begins as 2.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Stop(Action):
        """Stands still."""
        def __init__(self, *, depth: int = ...) -> None:
            ...
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class GoOn(Action):
        """Walks on along what he walked before he stopped."""
        def __init__(self, *, depth: int = ...) -> None:
            ...
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Speed(Action):
        """Walks so fast from now on."""
        def __init__(self, *, value: float = ..., depth: int = ...) -> None:
            ...
        value: float
        """m/s; 0: the number of the event; -1e6 to 1e6 m/s; begins as 0.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Wait(Action):
        """Waits so long, half of that more or less."""
        def __init__(self, *, seconds: float = ..., depth: int = ...) -> None:
            ...
        seconds: float
        """about how long; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class WaitForEvent(Action):
        """Waits until an event reaches him."""
        def __init__(self, *, event: str = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        event: str
        """its name"""
        seconds: float
        """at most; 0: for ever; 0 to 86400 s; begins as 3.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Repeat(Action):
        """Does the deeper actions below it so many times."""
        def __init__(self, *, times: int = ..., depth: int = ...) -> None:
            ...
        times: int
        """how often; 0: for ever; 0 to 1000 ×; begins as 2"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class OneOf(Action):
        """One alternative of a choice, drawn by weight: several of them, each with the deeper
    actions below it, make the choice."""
        def __init__(self, *, weight: float = ..., depth: int = ...) -> None:
            ...
        weight: float
        """how often it comes, against the others; 0 to 1e6 ×; begins as 1.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Again(Action):
        """Begins with the first action again."""
        def __init__(self, *, depth: int = ...) -> None:
            ...
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Send(Action):
        """Sends an event, which arrives in the next step or later."""
        def __init__(self, *, event: str = ..., reach: Literal["self", "near", "tagged", "group", "everybody", "related"] = ..., metres: float = ..., tag: Union[int, Tag] = ..., relation: Union[int, RelationKind] = ..., seconds_per_metre: float = ..., value: float = ..., depth: int = ...) -> None:
            ...
        event: str
        """its name"""
        reach: Literal["self", "near", "tagged", "group", "everybody", "related"]
        """whom it reaches; begins as 'near'"""
        metres: float
        """how near those are who are near; 0 to 10000 m; begins as 2.0"""
        tag: int
        """of those tagged; 0 to 63; begins as 0"""
        relation: int
        """of those related; 0: any; begins as 0"""
        seconds_per_metre: float
        """how long it takes to get there, s/m; 0 to 86400 s/m; begins as 0.0"""
        value: float
        """the number that it carries; -1e6 to 1e6; begins as 0.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Tag(Action):
        """Gets a tag."""
        def __init__(self, *, tag: Union[int, Tag] = ..., depth: int = ...) -> None:
            ...
        tag: int
        """the tag; 0 to 63; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Untag(Action):
        """Loses a tag."""
        def __init__(self, *, tag: Union[int, Tag] = ..., depth: int = ...) -> None:
            ...
        tag: int
        """the tag; 0 to 63; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class SetProperty(Action):
        """Sets a property for the rest of the session; Keep Pose puts it into the scene."""
        def __init__(self, *, property: Literal["tint", "height", "playback speed", "clip", "phase"] = ..., slot: str = ..., color: Union[str, Sequence[int]] = ..., strength: int = ..., value: float = ..., clips: Clips = ..., depth: int = ...) -> None:
            ...
        property: Literal["tint", "height", "playback speed", "clip", "phase"]
        """which; begins as 'tint'"""
        slot: str
        """of tint: its name; empty: all that can be tinted"""
        color: str
        """of tint, sRGB; begins as '#c83c3c'"""
        strength: int
        """of tint: how much of the colour, 0 to 255; 0 to 255; begins as 255"""
        value: float
        """of height, playback speed and phase; -1e6 to 1e6 ×; begins as 0.0"""
        clips: List[Dict[str, Any]]
        """of clip: those drawn from, with their weights"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Feature(Action):
        """Bears a value of a feature from now on, with all that it does, in this run alone. Its
    clips play at once."""
        def __init__(self, *, feature: Union[int, FeatureValue] = ..., depth: int = ...) -> None:
            ...
        feature: int
        """its id; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class State(Action):
        """Gets back what a kept state has of him, in this run alone."""
        def __init__(self, *, state: int = ..., seconds: float = ..., within: float = ..., depth: int = ...) -> None:
            ...
        state: int
        """its id; begins as 0"""
        seconds: float
        """that it takes; 0: at once; 0 to 86400 s; begins as 0.0"""
        within: float
        """each begins at a moment of his own; 0: now; 0 to 86400 s; begins as 0.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Light(Action):
        """A light that stands in the scene goes on or off, flashes or sweeps, in this run alone.
    Once is enough, whoever says it."""
        def __init__(self, *, light: int = ..., deed: Literal["on", "off", "flash", "sweep"] = ..., seconds: float = ..., depth: int = ...) -> None:
            ...
        light: int
        """its id; begins as 0"""
        deed: Literal["on", "off", "flash", "sweep"]
        """what it does; begins as 'on'"""
        seconds: float
        """that it takes; 0: at once; 0 to 86400 s; begins as 1.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class SetNumber(Action):
        """Sets an artist's number of his."""
        def __init__(self, *, number: Union[int, Number] = ..., value: float = ..., depth: int = ...) -> None:
            ...
        number: int
        """its id; begins as 0"""
        value: float
        """what it becomes; -1e6 to 1e6; begins as 0.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class AddToNumber(Action):
        """Adds to an artist's number of his."""
        def __init__(self, *, number: Union[int, Number] = ..., value: float = ..., depth: int = ...) -> None:
            ...
        number: int
        """its id; begins as 0"""
        value: float
        """what is added; -1e6 to 1e6; begins as 0.0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class Appear(Action):
        """Is at a place from now on, also after leaving the scene."""
        def __init__(self, *, place: Union[int, Place] = ..., depth: int = ...) -> None:
            ...
        place: int
        """its id; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""

    class LeaveScene(Action):
        """Leaves the scene."""
        def __init__(self, *, choice: Literal["given", "nearest", "nearest free", "first free", "ahead"] = ..., path: Union[int, Path] = ..., place: Union[int, Place] = ..., depth: int = ...) -> None:
            ...
        choice: Literal["given", "nearest", "nearest free", "first free", "ahead"]
        """at which place; given and place 0: where he is; begins as 'given'"""
        path: int
        """whose places are meant, of all choices but given; 0: all exits; begins as 0"""
        place: int
        """the one that is given, or one whose name those have that are meant; begins as 0"""
        depth: int
        """deeper ones belong to the repeat or the one of above them; 0 to 255; begins as 0"""


class FeatureClip(Entry):
    """A clip that a value of a feature lets its bearers play."""
    def __init__(self, *, clip: str = ..., role: Literal["any", "idle", "walk", "run", "fly", "sit"] = ..., weight: float = ...) -> None:
        ...
    clip: str
    """the words of its name: "cheer" is also "sit_cheer"; empty: any of the role"""
    role: Literal["any", "idle", "walk", "run", "fly", "sit"]
    """what it is for; any: whatever it is; begins as 'any'"""
    weight: float
    """how often, against the others; 0 to 1e6; begins as 1.0"""


class FeatureMaterial(Entry):
    """One of the materials of a slot."""
    def __init__(self, *, name: str = ..., weight: float = ...) -> None:
        ...
    name: str
    """of the slot's materials"""
    weight: float
    """how often, against the others; 0 to 1e6; begins as 1.0"""


class FeatureSlot(Entry):
    """How a value of a feature lets a slot look."""
    def __init__(self, *, slot: str = ..., colors: Sequence[Union[str, Sequence[int]]] = ..., strength: float = ..., replaces: bool = ..., materials: Sequence[Union[FeatureMaterial, Dict[str, Any]]] = ...) -> None:
        ...
    slot: str
    """the words of its name; empty: what is worn and no other names"""
    colors: List[str]
    """of which one is drawn for each; none: as it is"""
    strength: float
    """of the tint; 0 to 1; begins as 1.0"""
    replaces: bool
    """the colour itself; else it multiplies the material's; begins as True"""
    materials: List[FeatureMaterial]
    """one of which is drawn"""


class FeaturePart(Entry):
    """A part that a value of a feature shows or hides."""
    def __init__(self, *, part: str = ..., shown: bool = ...) -> None:
        ...
    part: str
    """the words of its name; empty: all"""
    shown: bool
    """whether it is seen; begins as True"""


class FeatureValue(Entry):
    """What people can be like: what it names changes with its bearers, the rest stays."""
    def __init__(self, *, id: int = ..., name: str = ..., color: Union[str, Sequence[int]] = ..., templates: Union[int, Template] = ..., clips: Sequence[Union[FeatureClip, Dict[str, Any]]] = ..., sets_phase: bool = ..., phase: Sequence[float] = ..., phase_curve: Sequence[float] = ..., sets_speed: bool = ..., speed: Sequence[float] = ..., speed_curve: Sequence[float] = ..., sets_walk_speed: bool = ..., walk_speed: Sequence[float] = ..., walk_speed_curve: Sequence[float] = ..., sets_height: bool = ..., height: Sequence[float] = ..., height_curve: Sequence[float] = ..., sets_girth: bool = ..., girth: Sequence[float] = ..., girth_curve: Sequence[float] = ..., slots: Sequence[Union[FeatureSlot, Dict[str, Any]]] = ..., parts: Sequence[Union[FeaturePart, Dict[str, Any]]] = ...) -> None:
        ...
    id: int
    """what columns and rules have: of no other value of the scene; 0 to 65535; begins as 0"""
    name: str
    """as scripts and brushes call it"""
    color: str
    """in which the editor shows it; begins as '#969696'"""
    templates: List[int]
    """ids of those it is limited to; none: all; 0 to 65535"""
    clips: List[FeatureClip]
    """of which one is drawn for each"""
    sets_phase: bool
    """whether it sets the phase; begins as False"""
    phase: List[float]
    """0–1 of the clip at time 0"""
    phase_curve: List[float]
    """how often phases come"""
    sets_speed: bool
    """whether it sets the speed; begins as False"""
    speed: List[float]
    """of playback, 1 as authored"""
    speed_curve: List[float]
    """how often speeds come"""
    sets_walk_speed: bool
    """whether it sets the walking speed; begins as False"""
    walk_speed: List[float]
    """at height 1; m/s"""
    walk_speed_curve: List[float]
    """how often walking speeds come"""
    sets_height: bool
    """whether it sets the height; begins as False"""
    height: List[float]
    """a scale"""
    height_curve: List[float]
    """how often heights come"""
    sets_girth: bool
    """whether it sets the girth; begins as False"""
    girth: List[float]
    """a scale"""
    girth_curve: List[float]
    """how often girths come"""
    slots: List[FeatureSlot]
    """how slots look"""
    parts: List[FeaturePart]
    """which parts are seen"""


class FeatureKind(Entry):
    """A feature: a kind with its values."""
    def __init__(self, *, id: int = ..., name: str = ..., values_: Sequence[Union[FeatureValue, Dict[str, Any]]] = ...) -> None:
        ...
    id: int
    """the number of the column that says who bears which of its values; 0 to 8; begins as 0"""
    name: str
    """as scripts and brushes call it"""
    values_: List[FeatureValue]
    """in order, from one end of a gradient to the other"""


class RelationKind(Entry):
    """How people can be related to each other."""
    def __init__(self, *, id: int = ..., name: str = ..., color: Union[str, Sequence[int]] = ..., mutual: bool = ..., walk: Literal["own", "together", "behind", "apart"] = ..., walk_metres: float = ..., faces: bool = ..., face_metres: float = ..., passes_events: bool = ..., pass_seconds: Sequence[float] = ..., shares_features: bool = ..., shares_colors: bool = ...) -> None:
        ...
    id: int
    """what relations and rules have: of no other kind of the scene; 0 to 64; begins as 0"""
    name: str
    """as scripts and brushes call it"""
    color: str
    """of its arcs in the picture; begins as '#969696'"""
    mutual: bool
    """it goes both ways; else from one to the other alone; begins as True"""
    walk: Literal["own", "together", "behind", "apart"]
    """how those who are related walk; begins as 'own'"""
    walk_metres: float
    """behind: how near they come; apart: how far they keep; 0.5 to 100 m; begins as 2.0"""
    faces: bool
    """who stand near each other turn to each other; begins as False"""
    face_metres: float
    """how near that is; 0.5 to 50 m; begins as 2.5"""
    passes_events: bool
    """an event that one hears those related to him hear later; begins as False"""
    pass_seconds: List[float]
    """how much later, drawn each time; s"""
    shares_features: bool
    """what is painted of features on one, those related to him get too; begins as False"""
    shares_colors: bool
    """what is painted of colours on one, those related to him get too; begins as False"""


class Place(Entry):
    """A spot with a size on the ground."""
    def __init__(self, *, id: int, name: str = ..., position: Sequence[float], radius: float = ..., color: Union[str, Sequence[int]] = ..., role: Literal["spot", "obstacle", "attractor", "repeller", "exit", "slow", "forbidden", "preferred"] = ..., capacity: int = ..., speed_share: float = ..., shape: Literal["round", "line", "area"] = ..., corners: Sequence[Sequence[float]] = ...) -> None:
        ...
    id: int
    """by which others name it, never 0; must be given"""
    name: str
    """as the editor shows it"""
    position: List[float]
    """of its middle; m; must be given"""
    radius: float
    """its size on the ground; 0.05 to 200 m; begins as 1.0"""
    color: str
    """in which the editor shows it; begins as '#f09628'"""
    role: Literal["spot", "obstacle", "attractor", "repeller", "exit", "slow", "forbidden", "preferred"]
    """what it does to those who walk; begins as 'spot'"""
    capacity: int
    """how many have room; 0: as many as can stand in it; 0 to 100000; begins as 0"""
    speed_share: float
    """of a slow place: share of the speed that people would walk with; 0.05 to 1; begins as 0.5"""
    shape: Literal["round", "line", "area"]
    """what all of it lies around, no farther off than its radius: its position, a line along its
    corners, or what they enclose; begins as 'round'"""
    corners: List[List[float]]
    """of a line or an area, in order: metres from the position"""


class Branch(Entry):
    """Where some leave a path for the beginning of another one."""
    def __init__(self, *, place: Union[int, Place], path: Union[int, Path], weight: float = ...) -> None:
        ...
    place: int
    """of the path, where some leave it; must be given"""
    path: int
    """to whose beginning they go; must be given"""
    weight: float
    """how many leave, against 1 who go on; 0 to 1000; begins as 1.0"""


class Path(Entry):
    """Places to walk along, in order."""
    def __init__(self, *, id: int, name: str = ..., kind: Literal["simple", "cyclic", "teleport"] = ..., color: Union[str, Sequence[int]] = ..., places: Sequence[Union[int, Place]] = ..., branches: Sequence[Union[Branch, Dict[str, Any]]] = ...) -> None:
        ...
    id: int
    """by which others name it, never 0; must be given"""
    name: str
    """as the editor shows it"""
    kind: Literal["simple", "cyclic", "teleport"]
    """at the last place: stop, go on to the first, jump to the first; begins as 'simple'"""
    color: str
    """in which the editor shows it; begins as '#f09628'"""
    places: List[int]
    """in the order in which they are walked to"""
    branches: List[Branch]
    """where some leave it"""


class Group(Entry):
    """A layer of the crowd: a name for those in it."""
    def __init__(self, *, id: int, name: str = ..., color: Union[str, Sequence[int]] = ..., hidden: bool = ..., locked: bool = ..., party: bool = ...) -> None:
        ...
    id: int
    """what the column "group" has; must be given"""
    name: str
    ...
    color: str
    """begins as '#5a96dc'"""
    hidden: bool
    """neither drawn nor touched; begins as False"""
    locked: bool
    """no stroke touches them; begins as False"""
    party: bool
    """all take the same branch of a path; begins as False"""


class Tag(Entry):
    """A tag that characters can have, 0 to 63."""
    def __init__(self, *, tag: int = ..., name: str = ..., color: Union[str, Sequence[int]] = ...) -> None:
        ...
    tag: int
    """which one it names; 0 to 63; begins as 0"""
    name: str
    """as the editor shows it"""
    color: str
    """in which the editor shows it; begins as '#c850c8'"""


class Number(Entry):
    """A number that everybody has, for rules."""
    def __init__(self, *, id: int, name: str = ..., low: float = ..., high: float = ..., values_: Sequence[Sequence[float]] = ...) -> None:
        ...
    id: int
    """by which others name it, never 0; must be given"""
    name: str
    """as the editor shows it"""
    low: float
    """the least that anybody begins with; -1e6 to 1e6; begins as 0.0"""
    high: float
    """the most that anybody begins with, not below low; -1e6 to 1e6; begins as 0.0"""
    values_: List[List[float]]
    """[id, number] of each individual that begins with another one"""


class Cue(Entry):
    """A button that sends an event."""
    def __init__(self, *, id: int, name: str = ..., event: str = ..., payload: float = ..., key: str = ..., reach: Literal["everybody", "selected", "tagged"] = ..., tag: Union[int, Tag] = ..., state: int = ..., seconds: float = ..., spread: float = ..., order: Literal["distance", "heading", "row", "wedge", "random"] = ..., point: Sequence[float] = ...) -> None:
        ...
    id: int
    """by which others name it, never 0; must be given"""
    name: str
    """as the editor shows it"""
    event: str
    """what it sends"""
    payload: float
    """the number that comes along; -1e6 to 1e6; begins as 0.0"""
    key: str
    """that sends it, "F3" to "F10"; empty: none"""
    reach: Literal["everybody", "selected", "tagged"]
    """whom it reaches; begins as 'everybody'"""
    tag: int
    """of those whom "tagged" reaches; 0 to 63; begins as 0"""
    state: int
    """that they take on; 0: none; begins as 0"""
    seconds: float
    """that each takes to take it on; 0 to 600 s; begins as 0.0"""
    spread: float
    """from the first who begins to the last; 0 to 600 s; begins as 0.0"""
    order: Literal["distance", "heading", "row", "wedge", "random"]
    """who begins when; begins as 'distance'"""
    point: List[float]
    """metres, where "distance" begins"""


class Light(Entry):
    """A light that stands in the scene, beside sun and sky."""
    def __init__(self, *, id: int, name: str = ..., on: bool = ..., kind: Literal["spot", "point"] = ..., strength: float = ..., color: Union[str, Sequence[int]] = ..., size: float = ..., after_dark: bool = ..., shadows: bool = ..., cone: float = ..., softness: float = ..., beam: float = ..., aim: Literal["place", "person", "group"] = ..., target: Sequence[float] = ..., person: int = ..., group: Union[int, Group] = ..., position: Sequence[float] = ...) -> None:
        ...
    id: int
    """of no other light of the scene; must be given"""
    name: str
    """what it is called"""
    on: bool
    """it shines; begins as True"""
    kind: Literal["spot", "point"]
    """a cone, or light to all sides; begins as 'spot'"""
    strength: float
    """1: as bright as the sun at ten metres; it falls off with the square of the distance; 0 to
    1000; begins as 1.0"""
    color: str
    """of its light; begins as '#fff4e0'"""
    size: float
    """of the lamp: what is nearer to it than that gets no brighter; 0.01 to 1000 m; begins as
    0.5"""
    after_dark: bool
    """it shines only while sun and sky are dark, as street lamps; begins as False"""
    shadows: bool
    """people and stages cast shadows in its light; of those that are to, the four strongest do;
    begins as False"""
    cone: float
    """how wide it opens, from edge to edge; 0.01 to 3 rad; begins as 0.44"""
    softness: float
    """share of the cone in which it fades out; 0: a sharp edge; 0 to 1; begins as 0.3"""
    beam: float
    """how much of it is seen in the air, as in smoke; 0 to 1; begins as 0.15"""
    aim: Literal["place", "person", "group"]
    """what it turns to; begins as 'place'"""
    target: List[float]
    """the middle of what it lights, of "place"; m"""
    person: int
    """whom it goes with, of "person": an id; 0: nobody; begins as 0"""
    group: int
    """of "group"; 0: none; begins as 0"""
    position: List[float]
    """where the lamp is; m"""


class LookLight(Entry):
    """Sun and sky of a look, where they are its own."""
    def __init__(self, *, sun_azimuth: float = ..., sun_elevation: float = ..., sun_color: Sequence[float] = ..., sun_strength: float = ..., shadow_strength: float = ..., shadow_softness: float = ..., highlights: float = ..., ambient_color: Sequence[float] = ..., ambient_strength: float = ..., occlusion: float = ..., sky_zenith: Sequence[float] = ..., sky_horizon: Sequence[float] = ..., ground: Sequence[float] = ..., ground_grid: bool = ..., haze: float = ..., haze_height: float = ..., exposure: float = ..., white: float = ..., tone: Literal["none", "filmic"] = ...) -> None:
        ...
    sun_azimuth: float
    """where the sun stands, from +Z towards +X; -1e6 to 1e6 rad; begins as 0.6"""
    sun_elevation: float
    """how high it stands over the horizon; -1e6 to 1e6 rad; begins as 0.9"""
    sun_color: List[float]
    """of the sun"""
    sun_strength: float
    """of the sun; 1: as on a clear day; 0 to 1000; begins as 1.0"""
    shadow_strength: float
    """how dark the shadows are that people and stages cast; 0: none are cast; 0 to 1; begins as
    0.0"""
    shadow_softness: float
    """the angle that the sun takes in the sky: the larger, the softer its shadows; 0 to 0.5;
    begins as 0.02"""
    highlights: float
    """how strongly smooth surfaces mirror the sun, the lamps and the sky; 0: not; 0 to 4; begins
    as 0.0"""
    ambient_color: List[float]
    """of the light that comes from all of the sky"""
    ambient_strength: float
    """of the sky's light; 0 to 1000; begins as 0.6"""
    occlusion: float
    """how dark it is in corners and where bodies meet ground and seats; 0: not; 0 to 1; begins
    as 0.0"""
    sky_zenith: List[float]
    """the sky overhead"""
    sky_horizon: List[float]
    """the sky at the horizon, and the ground far away"""
    ground: List[float]
    """of the ground"""
    ground_grid: bool
    """lines a metre apart; begins as True"""
    haze: float
    """share of what is a hundred metres away that the air hides; 0 to 0.999; begins as 0.0"""
    haze_height: float
    """metres above 0 where a third of it is left, as of mist; 0: it is everywhere alike; 0 to
    10000 m; begins as 0.0"""
    exposure: float
    """stops: each doubles the brightness; -10 to 10; begins as 0.0"""
    white: float
    """the light that looks white, kelvin: lower makes the picture bluer; 1500 to 20000 K; begins
    as 6500.0"""
    tone: Literal["none", "filmic"]
    """what brightness beyond white becomes: white, or it rolls off as on film; begins as 'none'"""


class Look(Entry):
    """A way of drawing that belongs to the scene."""
    def __init__(self, *, id: int, name: str = ..., style: Literal["plain", "lit", "cartoon", "clay", "silhouettes", "blueprint", "wireframe", "property"] = ..., by: str = ..., two_tones: bool = ..., light: Literal["scene", "noon", "afternoon", "dusk", "overcast", "night", "studio", "own"] = ..., lamps: bool = ..., shadows: bool = ..., own_background: bool = ..., background: Union[str, Sequence[int]] = ..., ground: bool = ..., own_outline: bool = ..., outline_width: float = ..., outline: Union[str, Sequence[int]] = ..., own_light: Union[LookLight, Dict[str, Any]] = ...) -> None:
        ...
    id: int
    """of no other look of the scene; must be given"""
    name: str
    """what it is called"""
    style: Literal["plain", "lit", "cartoon", "clay", "silhouettes", "blueprint", "wireframe", "property"]
    """how surfaces are drawn; begins as 'lit'"""
    by: str
    """what people are coloured by, of "property"; begins as 'template'"""
    two_tones: bool
    """of "cartoon": light and shade alone, without a step between; begins as False"""
    light: Literal["scene", "noon", "afternoon", "dusk", "overcast", "night", "studio", "own"]
    """sun and sky: those of the scene, ready-made ones, or its own; begins as 'scene'"""
    lamps: bool
    """the lights that stand in the scene shine; begins as True"""
    shadows: bool
    """shadows are drawn, of any kind; begins as True"""
    own_background: bool
    """one colour instead of the sky; begins as False"""
    background: str
    """instead of the sky; begins as '#eceef0'"""
    ground: bool
    """the ground around stages is drawn; begins as True"""
    own_outline: bool
    """outlines are as the next two say, not as the style has them; begins as False"""
    outline_width: float
    """of outlines; 0: none; 0 to 20 px; begins as 2.0"""
    outline: str
    """of outlines; begins as '#141218'"""
    own_light: LookLight
    """of "own": sun and sky"""


class Mark(Entry):
    """A moment of the timeline, and what happens then."""
    def __init__(self, *, id: int, name: str = ..., seconds: float = ..., kind: Literal["marker", "cue", "state", "event", "camera"] = ..., cue: Union[int, Cue] = ..., state: int = ..., fade: float = ..., spread: float = ..., order: Literal["distance", "heading", "row", "wedge", "random"] = ..., point: Sequence[float] = ..., heading: float = ..., event: str = ..., payload: float = ..., move: Literal["to", "around", "along"] = ..., camera: str = ..., path: Union[int, Path] = ..., turn: float = ..., travel: float = ..., above: float = ..., ahead: bool = ..., gentle: bool = ..., people: Sequence[Any] = ..., delays: Sequence[int] = ...) -> None:
        ...
    id: int
    """of no other mark of the scene; must be given"""
    name: str
    """as the editor shows it"""
    seconds: float
    """when it happens, by the clock; 0 to 604800 s; begins as 0.0"""
    kind: Literal["marker", "cue", "state", "event", "camera"]
    """what happens; begins as 'marker'"""
    cue: int
    """id of the cue that is called, of `cue`; begins as 0"""
    state: int
    """id of the state that people take on, of `state`; begins as 0"""
    fade: float
    """that each takes to take it on; 0 to 600 s; begins as 0.0"""
    spread: float
    """from the first who begins to the last; 0 to 600 s; begins as 0.0"""
    order: Literal["distance", "heading", "row", "wedge", "random"]
    """who begins when; begins as 'distance'"""
    point: List[float]
    """metres, where "distance" begins"""
    heading: float
    """radians, in which "heading" moves on; also of what a cue recalls; -1e6 to 1e6 rad; begins
    as 0.0"""
    event: str
    """that people hear, of `event`"""
    payload: float
    """the number that comes along; -1e6 to 1e6; begins as 0.0"""
    move: Literal["to", "around", "along"]
    """what the camera does, of `camera`; begins as 'to'"""
    camera: str
    """name of the camera that it goes to, or begins the move with; empty: it goes on from where
    it is"""
    path: int
    """id of the path that it travels along, of "along"; begins as 0"""
    turn: float
    """radians that it turns by, of "around"; -1000 to 1000; begins as 6.2831855"""
    travel: float
    """seconds that the move takes; 0: a cut; 0 to 36000 s; begins as 0.0"""
    above: float
    """metres above the path, of "along"; -10000 to 10000 m; begins as 1.7"""
    ahead: bool
    """whether it looks where it travels, of "along"; else at what it looked at before; begins as
    True"""
    gentle: bool
    """whether the move begins and ends slowly; begins as True"""
    people: List[int]
    """ids of those whom it is for; empty: whomever the cue reaches, all of the state, everybody;
    1 to 2.14748e9"""
    delays: List[int]
    """of "event": milliseconds after that at which each of people hears it; empty: all at once;
    0 to 3.6e6"""


class Rule(Entry):
    """When this happens, and the conditions hold, do this."""
    def __init__(self, *, id: int, name: str = ..., enabled: bool = ..., any: bool = ..., meeting: Literal["interrupt", "queue", "ignore"] = ..., yields: Literal["further up", "anybody", "nobody", "others further up"] = ..., cooldown: float = ..., limit: int = ..., when: Union[Trigger, Dict[str, Any]] = ..., if_: Sequence[Union[Condition, Dict[str, Any]]] = ..., do: Sequence[Union[Action, Dict[str, Any]]] = ...) -> None:
        ...
    id: int
    """by which others name it, never 0; must be given"""
    name: str
    """as the editor shows it"""
    enabled: bool
    """whether it runs; begins as True"""
    any: bool
    """whether one of the conditions is enough, else all; begins as False"""
    meeting: Literal["interrupt", "queue", "ignore"]
    """what happens to somebody who is busy with another rule; begins as 'interrupt'"""
    yields: Literal["further up", "anybody", "nobody", "others further up"]
    """which rules may break it off; begins as 'further up'"""
    cooldown: float
    """between two times for the same individual; 0 to 86400 s; begins as 0.0"""
    limit: int
    """how often for the same individual; 0: as often as it comes; begins as 0"""
    when: Trigger
    """what makes it fire"""
    if_: List[Condition]
    """what must hold"""
    do: List[Action]
    """what is done, in order"""


class FeatureValues(MutableMapping[str, FeatureValue]):
    """The values of a feature by their names, in order. What it gives are copies: assigning one puts it in its
    place, or at the end; it keeps the id by which people and rules have it. Each is a step of undo."""
    def __init__(self, scene: Scene, kind: str) -> None:
        ...
    def __getitem__(self, name: str) -> FeatureValue:
        ...
    def __setitem__(self, name: str, value: Any) -> None:
        ...
    def __delitem__(self, name: str) -> None:
        ...
    def __iter__(self) -> Iterator[str]:
        ...
    def __len__(self) -> int:
        ...


class Features(MutableMapping[str, FeatureValues]):
    """The features of a scene by their names. Assigning a dict, or a list, of values makes one or replaces it; who
    bears a value that is gone bears none. Each is a step of undo."""
    def __init__(self, scene: Scene) -> None:
        ...
    def __getitem__(self, name: str) -> FeatureValues:
        ...
    def __setitem__(self, name: str, values: Any) -> None:
        ...
    def __delitem__(self, name: str) -> None:
        ...
    def __iter__(self) -> Iterator[str]:
        ...
    def __len__(self) -> int:
        ...


class RelationKinds(MutableMapping[str, RelationKind]):
    """The kinds of relations of a scene by their names. What it gives are copies: assigning one puts it in its place
    or adds it; relations of a kind that is taken away go with it. Each is a step of undo."""
    def __init__(self, scene: Scene) -> None:
        ...
    def __getitem__(self, name: str) -> RelationKind:
        ...
    def __setitem__(self, name: str, kind: Any) -> None:
        ...
    def __delitem__(self, name: str) -> None:
        ...
    def __iter__(self) -> Iterator[str]:
        ...
    def __len__(self) -> int:
        ...


class Session:
    """A run of the simulation: people walk, rules fire. Never changes the scene by itself; edits
    of the scene reach it at its next step. The same scene, edits, events and steps give the
    same crowd."""
    def __init__(self, scene: Scene, *, record: bool = ..., take: Optional[str] = ..., time: float = ...) -> None:
        """Begins where the scene is now, or with people as they are in a kept take of that name
        at that time: with the rules and paths of now, which begin anew. Where there are
        stages and somebody walks, what can be walked on is found first, which takes seconds.
        record: its steps are kept, for keep_take, after those of the take until then."""
    @property
    def scene(self) -> Scene:
        """That it runs."""
    def step(self, count: int = ...) -> None:
        """So many steps on, each as long as the scene says (1/30 s where it says nothing)."""
    def run(self, seconds: float) -> None:
        """So long on, in whole steps."""
    @property
    def seconds(self) -> float:
        """That it has run, after the time of the take that it began in."""
    @property
    def steps(self) -> int:
        """That it has made."""
    def send(self, event: str, ids: Optional[Ids] = ..., *, number: float = ...) -> None:
        """An event happens at the next step: to these, or to everybody. Raises Error for ids
        that are dead, an empty name and a number that is not finite."""
    def send_tagged(self, event: str, tag: Union[int, str], *, number: float = ...) -> None:
        """To those who have a tag at that time; tag: its name, or its number from 0 to 63."""
    def recall_state(self, name: str, seconds: float = ..., stagger: Optional[Stagger] = ..., ids: Any = ..., *, columns: Optional[List[str]] = ...) -> StateRecall:
        """As Scene.recall_state, but in this session alone: the scene stays as it is. What an
        edit of the scene sets later counts again."""
    @property
    def fired(self) -> Dict[int, int]:
        """How often each rule has fired, by its id; those that have not are left out."""
    def take_log(self) -> List[Any]:
        """(seconds, rule's id, individual's id) of what fired since the last call, at most some
        thousand."""
    @property
    def problems(self) -> List[str]:
        """What could not be followed or came to grief, in sentences."""
    def __len__(self) -> int:
        ...
    @property
    def ids(self) -> _Array:
        """N uint32, ascending: everybody, also who has left."""
    @property
    def present(self) -> _Array:
        """N bool, in the order of ids: whether each is still there. Who has left, at an exit or
        by a rule, stays in ids and columns, 100 000 m below the ground."""
    def column(self, name: str) -> _Array:
        """As Scene.column, but as everybody is after the last step; path: the one that each
        follows now, which is another after a branch or a rule's action, and 0 for those who
        have left."""
    def keep_pose(self) -> int:
        """Where everybody is now becomes where the scene has them: one undo step. How many
        people stand or sit another way than before."""
    def render(self, width: int, height: int, *, camera: Union[None, str, Camera] = ..., look: str = ..., by: str = ..., focus: Optional[float] = ..., f_stop: Optional[float] = ..., transparent: bool = ...) -> Picture:
        """As Scene.render, but as everybody is after the last step."""
    def render_passes(self, width: int, height: int, passes: List[str], *, camera: Union[None, str, Camera] = ..., look: str = ..., by: str = ..., path: Optional[FilePath] = ..., transparent: bool = ...) -> Dict[Any, Any]:
        """As Scene.render_passes, but as everybody is after the last step; motion is that of the
        last step, of a session with record=True."""
    def keep_take(self, name: str, *, progress: Optional[Callable[[float], Any]] = ...) -> Take:
        """What the session has done so far becomes a take of its scene: one undo step. It needs
        to record (Session(scene, record=True)). Returns the Take. progress: is called with
        the share that is done, 0 to 1, some times a second; what it raises, as Ctrl+C, ends
        the call, which takes back what it did."""


def properties() -> List[Property]:
    """All properties that individuals have, in the order of their columns."""


def register_brush(brush: _B, name: Optional[str] = ...) -> _B:
    """Makes a brush known: in the editor it appears in the palette. Usable as a decorator.
    
    brush: a class with apply(selection), an instance of one, or a function. apply changes people;
    what a function, or a method values(selection), returns is a dict of columns with one value for
    all or one each. Public attributes with a type (bool, int, float, str, an Enum, a Literal, a
    colour as tuple[int, int, int]) are settings; selection, radius, rate, through and build_up say
    where it reaches at first. Returns the brush. Raises TypeError when it is none."""


def open(path: FilePath) -> Scene:
    """Opens a .crowd file, or a ready-made scene such as builtin:scenes/theatre.crowd. Raises
    Error with the reason why it cannot be read; warns (UserWarning) of stages and templates
    that could not be loaded, and of what in the file was odd."""
