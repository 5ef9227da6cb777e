# SPDX-License-Identifier: MIT
# Runs inside the module crowdbrush: typed classes for what a scene's environment is made of, one for
# each entry of the schema that the program describes itself with.
import json as _json
import keyword as _keyword
import math as _math
import re as _re
from collections.abc import Mapping as _MappingBase, MutableMapping as _Mapping

import numpy as _np

_schema = _json.loads(_environment_schema())


def _attribute_of(key):
    """speedShare is speed_share; names that Python or dict has already end with _."""
    name = _re.sub(r"(?<=[a-z])(?=[A-Z])", "_", key).lower().replace(" ", "_")
    return name + "_" if _keyword.iskeyword(name) or hasattr(dict, name) else name


class _Field:
    """A member of an entry, as the program describes it."""

    def __init__(self, described):
        self.key = described["key"]
        self.attribute = _attribute_of(self.key)
        self.type = described["type"]
        self.doc = described["doc"]
        self.default = described["default"]
        self.unit = described.get("unit", "")
        self.low = described.get("low")
        self.high = described.get("high")
        self.choices = described.get("choices", [])
        self.refers = described.get("refers", "")
        self.is_needed = described.get("isNeeded", False)

    def begin(self):
        """What it is when nothing is said: lists are new ones."""
        return self.fitted(self.default, "") if isinstance(self.default, (list, dict)) else self.default

    def fitted(self, value, where):
        """The value as files have it. Raises Error where it is none that the field may have."""
        if self.type.startswith("list of "):
            return [_entry(self.type[8:], each, f"{where}[{i}]") for i, each in enumerate(_listed(value, where))]
        if self.type in _bases:
            return _entry(self.type, value, where)
        if self.type.startswith("ids of "):
            return [_whole(_id_of(each), where, 1, 0xFFFFFFFF) for each in _listed(value, where)]
        if self.type == "choice":
            if value not in self.choices:
                raise Error(f"{where} must be one of: {', '.join(self.choices)}; not {_shortly(value)}.")
            return value
        return getattr(self, "_as_" + self.type)(value, where)

    def _as_bool(self, value, where):
        if not isinstance(value, (bool, _np.bool_)):
            raise Error(f"{where} must be True or False, not {_shortly(value)}.")
        return bool(value)

    def _as_int(self, value, where):
        if self.low is None:
            return _whole(_id_of(value), where, 0, 0xFFFFFFFF)
        return _whole(_id_of(value) if self.refers else value, where, self.low, self.high)

    def _as_float(self, value, where):
        number = _number(value, where)
        if not self.low <= number <= self.high:
            raise Error(f"{where} must lie between {self.low:g} and {self.high:g}, not be {number:g}.")
        return number

    def _as_str(self, value, where):
        if not isinstance(value, str):
            raise Error(f"{where} must be a text, not {_shortly(value)}.")
        return value

    def _as_color(self, value, where):
        return _hex(value, 3, where)

    def _as_tint(self, value, where):
        return _hex(value, 4, where)

    def _as_point(self, value, where):
        return _numbers(value, 3, where)

    def _as_points(self, value, where):
        return [_numbers(each, 3, f"{where}[{i}]") for i, each in enumerate(_listed(value, where))]

    def _as_range(self, value, where):
        return _numbers(value, 2, where)

    def _as_curve(self, value, where):
        return _numbers(value, 16, where)

    def _as_colors(self, value, where):
        return [_hex(each, 3, where) for each in _listed(value, where)]

    def _as_ids(self, value, where):
        return sorted(_whole(_id_of(each), where, max(1, int(self.low)), int(self.high)) for each in _listed(value, where))

    def _as_numbers(self, value, where):
        return [_whole(each, where, int(self.low), int(self.high)) for each in _listed(value, where)]

    def _as_clips(self, value, where):
        if isinstance(value, str):
            value = [value]
        if isinstance(value, dict):
            value = [{"clip": clip, "weight": weight} for clip, weight in value.items()]
        clips = []
        for each in _listed(value, where):
            each = dict(each) if isinstance(each, dict) else {"clip": each}
            self._as_str(each.get("clip"), where)
            each["weight"] = _number(each.get("weight", 1.0), where)
            clips.append(each)
        return clips

    def _as_values(self, value, where):
        return [[_whole(who, where, 0, 0xFFFFFFFF), _number(number, where)]
                for who, number in (_listed(each, where) for each in _listed(value, where))]

    def _as_any(self, value, where):
        return value


def _listed(value, where):
    if isinstance(value, (str, bytes, dict)) or not hasattr(value, "__iter__"):
        raise Error(f"{where} must be a list, not {_shortly(value)}.")
    return list(value)


def _number(value, where):
    is_number = not isinstance(value, (str, bytes)) and (hasattr(value, "__float__") or hasattr(value, "__index__"))
    if not is_number or not _math.isfinite(float(value)):
        raise Error(f"{where} must be a finite number, not {_shortly(value)}.")
    return float(value)


def _numbers(value, count, where):
    numbers = [_number(each, where) for each in _listed(value, where)]
    if len(numbers) != count:
        raise Error(f"{where} must be {count} numbers, not {_shortly(value)}.")
    return numbers


def _whole(value, where, low, high):
    if isinstance(value, (bool, float)) or not hasattr(value, "__index__"):
        raise Error(f"{where} must be a whole number, not {_shortly(value)}.")
    number = value.__index__()
    if not low <= number <= high:
        raise Error(f"{where} must lie between {low:g} and {high:.10g}, not be {number}.")
    return number


def _hex(value, count, where):
    """A colour as text, from text or numbers from 0 to 255."""
    if not isinstance(value, str):
        value = "#" + "".join(f"{_whole(each, where, 0, 255):02x}" for each in _listed(value, where))
    if not _re.fullmatch(f"#[0-9a-fA-F]{{{2 * count}}}", value):
        raise Error(f"{where} must be a colour: \"#\" and {2 * count} hexadecimal digits, or {count} numbers.")
    return value.lower()


def _id_of(value):
    """An id is a number, or an entry or a template that has one; of a tag it is its number."""
    if isinstance(value, Entry):
        return value.get("id", value.get("tag"))
    return value.id if isinstance(value, Template) else value


class Entry(dict):
    """What a scene's environment is made of: a dict as the project file has it, with typed attributes.

    Made with its members as keywords; those that are not given have the value that they begin with.
    An attribute is the member of the dict of that name. Goes wherever the dict goes."""

    __slots__ = ()
    _name = ""
    _kind = None
    _fields = {}

    def __init__(self, **members: "Any") -> None:
        unknown = [name for name in members if name not in self._fields]
        if unknown:
            raise TypeError(f"{self._name} has no member \"{unknown[0]}\"; its members: {', '.join(self._fields)}.")
        super().__init__({"kind": self._kind} if self._kind else {})
        for attribute, field in self._fields.items():
            if attribute in members:
                self[field.key] = field.fitted(members[attribute], f"{self._name}.{attribute}")
            elif field.is_needed:
                raise TypeError(f"{self._name} needs {attribute}.")
            else:
                self[field.key] = field.begin()

    @classmethod
    def from_dict(cls, members: "Dict[str, Any]") -> "Entry":
        """Of a dict as the project file has it; members that this version does not know stay in it."""
        if cls in _bases.values() and cls not in _leaves:
            cls = _kind_class(cls, members)
        if cls._kind and members.get("kind", cls._kind) != cls._kind:
            raise Error(f"{cls._name}.kind must be {cls._kind}, not {_shortly(members['kind'])}.")
        known = {field.key: attribute for attribute, field in cls._fields.items()}
        made = cls(**{known[key]: value for key, value in members.items() if key in known})
        for key, value in members.items():
            if key not in known and not (key == "kind" and cls._kind):
                made[key] = value
        return made

    def to_dict(self) -> "Dict[str, Any]":
        """A plain dict, with plain ones in it."""
        return _plain(self)

    def __eq__(self, other: "Any") -> bool:
        """To a dict too: what it leaves out is what it begins with. Numbers are as precise as files."""
        if not isinstance(other, dict):
            return NotImplemented
        try:
            return _comparable(self) == _comparable(type(self).from_dict(other))
        except (Error, TypeError):
            return False

    def __ne__(self, other: "Any") -> bool:
        return not self == other

    __hash__ = None

    def __repr__(self):
        said = []
        for attribute, field in self._fields.items():
            value = self.get(field.key, field.default)
            if field.is_needed or _comparable(value) != _comparable(field.begin()):
                said.append(f"{attribute}={value!r}")
        return f"{type(self).__qualname__}({', '.join(said)})"


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    return [_plain(each) for each in value] if isinstance(value, list) else value


def _comparable(value):
    if isinstance(value, dict):
        return {key: _comparable(each) for key, each in value.items()}
    if isinstance(value, list):
        return [_comparable(each) for each in value]
    return float(_np.float32(value)) if isinstance(value, float) else value


class Trigger(Entry):
    """What makes a rule fire: one of crowdbrush.triggers."""

    __slots__ = ()


class Condition(Entry):
    """What must hold for a rule to fire: one of crowdbrush.conditions."""

    __slots__ = ()


class Action(Entry):
    """What a rule does: one of crowdbrush.actions."""

    __slots__ = ()


class triggers:
    """The kinds of triggers."""


class conditions:
    """The kinds of conditions."""


class actions:
    """The kinds of actions."""


#: Classes by the name that fields give as their type.
_bases = {"Trigger": Trigger, "Condition": Condition, "Action": Action}
_spaces = {Trigger: triggers, Condition: conditions, Action: actions}
_leaves = set()


def _member(field):
    def get(self):
        return self.get(field.key, field.default)

    def set(self, value):
        self[field.key] = field.fitted(value, f"{self._name}.{field.attribute}")

    return property(get, set, None, field.doc)


def _class(described, base, space=None):
    fields = {field.attribute: field for field in map(_Field, described["fields"])}
    name = f"{space.__name__}.{described['name']}" if space else described["name"]
    members = {"__doc__": described["doc"], "__module__": "crowdbrush", "__qualname__": name,
               "__slots__": (), "_name": name, "_kind": described.get("kind"), "_fields": fields}
    members.update((attribute, _member(field)) for attribute, field in fields.items())
    made = type(described["name"], (base,), members)
    _leaves.add(made)
    return made


def _kind_class(base, members):
    """Of a dict with the key "kind"."""
    kinds = {each._kind: each for each in vars(_spaces[base]).values() if isinstance(each, type)}
    kind = members.get("kind")
    if kind not in kinds:
        raise Error(f"{base.__name__}.kind must be one of: {', '.join(kinds)}; not {_shortly(kind)}.")
    return kinds[kind]


def _entry(name, value, where):
    """One of that class: as it is, or made of a dict."""
    base = _bases[name]
    if isinstance(value, base):
        return value
    if name == "LookLight" and isinstance(value, Lighting):
        return base(**{attribute: getattr(value, attribute) for attribute in base._fields})
    if not isinstance(value, dict):
        raise Error(f"{where} must be a {name} or a dict, not {_shortly(value)}.")
    return base.from_dict(value)


for _base, _space in _spaces.items():
    for _each in _schema[_space.__name__]:
        setattr(_space, _each["name"], _class(_each, _base, _space))
for _each in _schema["entries"]:
    globals()[_each["name"]] = _bases[_each["name"]] = _class(_each, Entry)


class FeatureValues(_Mapping):
    """The values of a feature by their names, in order. What it gives are copies: assigning one puts it in its
    place, or at the end; it keeps the id by which people and rules have it. Each is a step of undo."""

    def __init__(self, scene: "Scene", kind: "str") -> None:
        self._scene = scene
        self._kind = kind

    def _all(self):
        return Features(self._scene)._kind_named(self._kind)["values"]

    def __getitem__(self, name: "str") -> "FeatureValue":
        for each in self._all():
            if each["name"] == name:
                return each
        raise KeyError(f"The feature \"{self._kind}\" has no value \"{name}\".")

    def __setitem__(self, name: "str", value: "Any") -> None:
        value = _value_named(name, value)
        kinds = Features(self._scene)._all()
        values = _named(kinds, self._kind)["values"]
        known = [each["name"] for each in values]
        if name in known:
            value["id"] = values[known.index(name)]["id"]
            values[known.index(name)] = value
        else:
            values.append(value)
        Features(self._scene)._put(kinds)

    def __delitem__(self, name: "str") -> None:
        self[name]
        kinds = Features(self._scene)._all()
        kind = _named(kinds, self._kind)
        kind["values"] = [each for each in kind["values"] if each["name"] != name]
        Features(self._scene)._put(kinds)

    def __iter__(self) -> "Iterator[str]":
        return iter([each["name"] for each in self._all()])

    def __len__(self) -> "int":
        return len(self._all())

    def __repr__(self):
        return f"FeatureValues({self._kind!r}: {', '.join(self)})"


class Features(_Mapping):
    """The features of a scene by their names. Assigning a dict, or a list, of values makes one or replaces it; who
    bears a value that is gone bears none. Each is a step of undo."""

    def __init__(self, scene: "Scene") -> None:
        self._scene = scene

    def _all(self):
        return [FeatureKind.from_dict(each) for each in self._scene.environment["features"]]

    def _kind_named(self, name):
        return _named(self._all(), name)

    def _put(self, kinds):
        free = self._scene._free_feature_id()
        for value in (value for kind in kinds for value in kind["values"] if not value.get("id")):
            if not 0 < free <= 0xFFFF:
                raise Error("The scene has as many values of features as there can be.")
            value["id"] = free
            free += 1
        self._scene.set_environment({"features": kinds})

    def __getitem__(self, name: "str") -> "FeatureValues":
        self._kind_named(name)
        return FeatureValues(self._scene, name)

    def __setitem__(self, name: "str", values: "Any") -> None:
        if isinstance(values, _MappingBase):
            values = [_value_named(each, value) for each, value in values.items()]
        values = [_entry("FeatureValue", each, f"features[\"{name}\"]") for each in _listed(values, "values")]
        kinds = self._all()
        if name in [kind["name"] for kind in kinds]:
            kind = _named(kinds, name)
            ids = {each["name"]: each["id"] for each in kind["values"]}
            for value in values:
                value["id"] = ids.get(value["name"], 0)
            kind["values"] = values
        else:
            id = self._scene._free_kind_id()
            if not id:
                raise Error(f"A scene has at most {len(kinds)} features: remove one first.")
            for value in values:
                value["id"] = 0
            kinds.append(FeatureKind(id=id, name=name, values_=values))
        self._put(kinds)

    def __delitem__(self, name: "str") -> None:
        self._kind_named(name)
        self._put([kind for kind in self._all() if kind["name"] != name])

    def __iter__(self) -> "Iterator[str]":
        return iter([kind["name"] for kind in self._all()])

    def __len__(self) -> "int":
        return len(self._all())

    def __repr__(self):
        return f"Features({', '.join(self)})"


def _named(kinds, name):
    for kind in kinds:
        if kind["name"] == name:
            return kind
    raise KeyError(f"There is no feature \"{name}\".")


def _value_named(name, value):
    value = FeatureValue.from_dict(dict(_entry("FeatureValue", value, f"features[...][\"{name}\"]")))
    value["name"] = name
    value["id"] = 0
    return value


def _features_of(self) -> "Features":
    if not isinstance(self, Scene):
        raise TypeError(f"features belong to a crowdbrush.Scene, not to {_shortly(self)}.")
    return Features(self)


Scene.features = property(_features_of, None, None, "Features by their names, and their values by theirs.")


class RelationKinds(_Mapping):
    """The kinds of relations of a scene by their names. What it gives are copies: assigning one puts it in its place
    or adds it; relations of a kind that is taken away go with it. Each is a step of undo."""

    def __init__(self, scene: "Scene") -> None:
        self._scene = scene

    def _all(self):
        return [RelationKind.from_dict(each) for each in self._scene.environment["relationKinds"]]

    def __getitem__(self, name: "str") -> "RelationKind":
        for kind in self._all():
            if kind["name"] == name:
                return kind
        raise KeyError(f"There is no relation \"{name}\".")

    def __setitem__(self, name: "str", kind: "Any") -> None:
        kind = RelationKind.from_dict(dict(_entry("RelationKind", kind, f"relation_kinds[\"{name}\"]")))
        kinds = self._all()
        known = {each["name"]: each["id"] for each in kinds}
        kind["name"] = name
        kind["id"] = known.get(name) or self._scene._free_relation_id()
        if not kind["id"]:
            raise Error(f"A scene has at most {len(kinds)} kinds of relations: remove one first.")
        kinds = [each for each in kinds if each["name"] != name] + [kind]
        self._scene.set_environment({"relationKinds": sorted(kinds, key=lambda each: each["id"])})

    def __delitem__(self, name: "str") -> None:
        self[name]
        self._scene.set_environment({"relationKinds": [each for each in self._all() if each["name"] != name]})

    def __iter__(self) -> "Iterator[str]":
        return iter([kind["name"] for kind in self._all()])

    def __len__(self) -> "int":
        return len(self._all())

    def __repr__(self):
        return f"RelationKinds({', '.join(self)})"


def _relation_kinds_of(self) -> "RelationKinds":
    if not isinstance(self, Scene):
        raise TypeError(f"relation_kinds belong to a crowdbrush.Scene, not to {_shortly(self)}.")
    return RelationKinds(self)


Scene.relation_kinds = property(_relation_kinds_of, None, None, "Kinds of relations by their names.")


class _Entries(list):
    """Entries in order, found by name too: scene.groups["left stand"]."""

    def __getitem__(self, which):
        if not isinstance(which, str):
            return list.__getitem__(self, which)
        for each in self:
            if each.get("name") == which:
                return each
        names = ", ".join(str(each.get("name")) for each in self) or "none"
        raise Error(f"There is no entry named \"{which}\"; there are: {names}.")

    def __contains__(self, which):
        if isinstance(which, str):
            return any(each.get("name") == which for each in self)
        return list.__contains__(self, which)


def _list_property(key, name):
    def get(self):
        return _Entries(_bases[name].from_dict(each) for each in Scene.environment.fget(self).get(key, []))

    def set(self, entries):
        listed = [_entry(name, each, f"{key}[{i}]") for i, each in enumerate(_listed(entries, key))]
        Scene.set_environment(self, {key: listed})

    get.__annotations__["return"] = f"List[{name}]"
    return property(get, set, None, f"A new list of {name}, as the environment has them, by name too; "
                    "setting it is a step of undo.")


for _each in _schema["entries"]:
    if _each["list"]:
        setattr(Scene, _each["list"], _list_property(_each["list"], _each["name"]))
del _base, _space, _each
