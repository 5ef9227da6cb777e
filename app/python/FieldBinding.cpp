// SPDX-License-Identifier: MIT
#include "app/python/FieldBinding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/python/PythonBrush.h"
#include "model/base/Overloaded.h"
#include "model/describe/FieldChecks.h"

namespace crowd::app {

using namespace model;

namespace {

using Range = std::pair<float, float>;

void define(py::object& type, const char* name, const char* doc, const py::object& get,
            const py::object& set)
{
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    type.attr(name) = property(get, set, py::none(),
                               *doc != '\0' ? py::object(py::str(doc)) : py::object(py::none()));
}

void define(py::object& type, const FieldInfo& field, const py::object& get, const py::object& set)
{
    define(type, attributeOf(field.meta.key).c_str(), field.meta.doc, get, set);
}

bool isFinite(const FieldValue& value)
{
    const auto isNumber = [](auto... numbers) { return (std::isfinite(numbers) && ...); };
    return std::visit(
        Overloaded{[&](float number) { return isNumber(number); },
                   [&](double number) { return isNumber(number); },
                   [&](const ValueRange& range) { return isNumber(range.low, range.high); },
                   [&](const glm::vec3& point) { return isNumber(point.x, point.y, point.z); },
                   [&](const glm::quat& turn) { return isNumber(turn.w, turn.x, turn.y, turn.z); },
                   [](const DistributionCurve& curve) {
                       return std::ranges::all_of(curve.weights,
                                                  [](float each) { return std::isfinite(each); });
                   },
                   [](const auto&) { return true; }},
        value);
}

std::string nameIn(const py::object& type, const FieldInfo& field)
{
    return py::str(type.attr("__name__")).cast<std::string>() + "." + attributeOf(field.meta.key);
}

/// T: the type that scripts see; `toPython` and `fromPython` lead from and to the field's own.
template<class T, class ToPython, class FromPython>
void attribute(py::object& type, const FieldInfo& field, const StructOf& structOf,
               const ToPython& toPython, const FromPython& fromPython)
{
    const FieldInfo* kept = &field;
    const std::string name = nameIn(type, field);
    define(type, field,
           py::cpp_function([kept, structOf, toPython](const py::object& self)
                                -> T { return toPython(kept->get(structOf(self))); },
                            py::is_method(type)),
           py::cpp_function(
               [kept, name, structOf, fromPython](const py::object& self, const T& value) {
                   const FieldValue given = fromPython(value);
                   if (!isFinite(given)) {
                       throw ScriptError(name + " takes finite numbers, not nan or inf.");
                   }
                   kept->set(structOf(self), given);
               },
               py::is_method(type)));
}

/// A value that scripts see as it is.
template<class T>
void plainAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    attribute<T>(
        type, field, structOf, [](const FieldValue& value) { return std::get<T>(value); },
        [](const T& value) { return FieldValue(value); });
}

template<class Enum>
void choiceAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    attribute<Enum>(
        type, field, structOf,
        [](const FieldValue& value) { return static_cast<Enum>(std::get<std::int64_t>(value)); },
        [](Enum value) { return FieldValue(static_cast<std::int64_t>(value)); });
}

std::int64_t choiceNamed(std::span<const FieldChoice> choices, const std::string& key,
                         const std::string& name)
{
    std::string all;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (key == choices[i].key) {
            return static_cast<std::int64_t>(i);
        }
        all += (all.empty() ? "" : ", ") + std::string(choices[i].key);
    }
    throw ScriptError(name + " must be one of: " + all);
}

/// As choiceAttribute; scripts that were written while it had no class name the choice's key.
template<class Enum>
void choiceOrKeyAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const FieldInfo* kept = &field;
    const std::string name = nameIn(type, field);
    const auto get = [kept, structOf](const py::object& self) {
        return static_cast<Enum>(std::get<std::int64_t>(kept->get(structOf(self))));
    };
    const auto set = [kept, name, structOf](const py::object& self,
                                            const std::variant<Enum, std::string>& value) {
        const auto* key = std::get_if<std::string>(&value);
        kept->set(structOf(self), key != nullptr
                                      ? choiceNamed(kept->meta.choices, *key, name)
                                      : static_cast<std::int64_t>(std::get<Enum>(value)));
    };
    define(type, field, py::cpp_function(get, py::is_method(type)),
           py::cpp_function(set, py::is_method(type)));
}

/// A member of an enumeration that has no class in Python: its choice's key.
void keyAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const auto choices = field.meta.choices;
    const std::string name = nameIn(type, field);
    attribute<std::string>(
        type, field, structOf,
        [choices](const FieldValue& value) -> std::string {
            return choices[static_cast<std::size_t>(std::get<std::int64_t>(value))].key;
        },
        [choices, name](const std::string& key) {
            return FieldValue(choiceNamed(choices, key, name));
        });
}

/// Whole numbers are refused at once where they do not fit: the member may be narrower.
void numberAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const FieldInfo* kept = &field;
    const std::string name = nameIn(type, field);
    attribute<std::int64_t>(
        type, field, structOf,
        [](const FieldValue& value) { return std::get<std::int64_t>(value); },
        [kept, name](std::int64_t value) {
            valueOrRaise(checkField(*kept, value, name));
            return FieldValue(value);
        });
}

void integerAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const FieldChoice* choices = field.meta.choices.data();
    if (choices == kHeadingModes) {
        choiceAttribute<HeadingMode>(type, field, structOf);
    } else if (choices == kSelections) {
        choiceAttribute<BrushSelection>(type, field, structOf);
    } else if (choices == kOperatorChoices) {
        choiceAttribute<BrushOperator>(type, field, structOf);
    } else if (choices == kTimeModes) {
        choiceOrKeyAttribute<TimeMode>(type, field, structOf);
    } else if (choices == kPushModes) {
        choiceOrKeyAttribute<PushMode>(type, field, structOf);
    } else if (choices != nullptr) {
        keyAttribute(type, field, structOf);
    } else {
        numberAttribute(type, field, structOf);
    }
}

/// Numbers of which each is meant, in whatever order they are given.
void numbersAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    using Numbers = std::vector<int>;
    attribute<Numbers>(
        type, field, structOf, [](const FieldValue& value) { return std::get<Numbers>(value); },
        [](Numbers numbers) {
            std::ranges::sort(numbers);
            return FieldValue(std::move(numbers));
        });
}

/// Templates as handles or ids. A gradient runs over them as they stand there.
void templatesAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    using Numbers = std::vector<int>;
    const FieldInfo* kept = &field;
    const std::string name = nameIn(type, field);
    const auto idsOf = [kept, structOf](const py::object& self) {
        return std::get<Numbers>(kept->get(structOf(self)));
    };
    const auto setIds = [kept, name, structOf](const py::object& self,
                                               const std::vector<py::object>& templates) {
        Numbers ids;
        for (const py::object& each : templates) {
            const bool isHandle = py::isinstance<TemplateHandle>(each);
            const ScenePtr owner = isHandle ? each.cast<const TemplateHandle&>().owner : nullptr;
            ids.push_back(templateIdOf(owner, each));
        }
        if (!std::ranges::is_sorted(ids)) {
            throw ScriptError(name + " must be in ascending order of their ids: sort them.");
        }
        kept->set(structOf(self), ids);
    };
    define(type, field, py::cpp_function(idsOf, py::is_method(type)),
           py::cpp_function(setIds, py::is_method(type)));
}

void listAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    if (field.is<std::vector<int>>() && field.meta.role == FieldRole::Template) {
        templatesAttribute(type, field, structOf);
    } else if (field.is<std::vector<int>>()) {
        numbersAttribute(type, field, structOf);
    } else if (field.is<std::vector<PaintColor>>()) {
        plainAttribute<std::vector<PaintColor>>(type, field, structOf);
    } else if (field.is<std::vector<ClipWeight>>()) {
        attribute<py::dict>(
            type, field, structOf,
            [](const FieldValue& value) {
                return clipsAsDict(std::get<std::vector<ClipWeight>>(value));
            },
            [](const py::dict& clips) { return FieldValue(clipsFromDict(clips)); });
    } else if (field.is<DistributionCurve>()) {
        using Weights = decltype(DistributionCurve::weights);
        attribute<Weights>(
            type, field, structOf,
            [](const FieldValue& value) { return std::get<DistributionCurve>(value).weights; },
            [](const Weights& weights) { return FieldValue(DistributionCurve{weights}); });
    }
}

void rangeAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    attribute<Range>(
        type, field, structOf,
        [](const FieldValue& value) {
            const auto range = std::get<ValueRange>(value);
            return Range(range.low, range.high);
        },
        [](const Range& range) {
            return FieldValue(ValueRange{range.first, range.second});
        });
}

void pointAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    attribute<Point3>(
        type, field, structOf,
        [](const FieldValue& value) {
            const auto point = std::get<glm::vec3>(value);
            return Point3{point.x, point.y, point.z};
        },
        [](const Point3& point) { return FieldValue(glm::vec3(point[0], point[1], point[2])); });
}

/// A quaternion (w, x, y, z).
void turnAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    attribute<std::array<float, 4>>(
        type, field, structOf,
        [](const FieldValue& value) {
            const auto turn = std::get<glm::quat>(value);
            return std::array{turn.w, turn.x, turn.y, turn.z};
        },
        [](const std::array<float, 4>& turn) {
            return FieldValue(glm::quat(turn[0], turn[1], turn[2], turn[3]));
        });
}

/// Templates by number. Settings of creation remember whose they were.
void mixAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const FieldInfo* kept = &field;
    const auto mixOf = [kept, structOf](const py::object& self) {
        py::dict mix;
        const FieldValue value = kept->get(structOf(self));
        for (const TemplateWeight& each : std::get<std::vector<TemplateWeight>>(value)) {
            mix[py::int_(each.id)] = each.weight;
        }
        return mix;
    };
    const auto setMix = [kept, structOf](const py::object& self, const py::dict& mix) {
        std::vector<TemplateWeight> weights;
        std::vector<std::weak_ptr<ScriptScene>> owners;
        for (const auto& [key, weight] : mix) {
            ScenePtr owner;
            if (py::isinstance<TemplateHandle>(key)) {
                owner = key.cast<const TemplateHandle&>().owner;
                owners.push_back(owner);
            }
            weights.push_back({templateIdOf(owner, key), weightFrom(weight)});
        }
        kept->set(structOf(self), std::move(weights));
        if (py::isinstance<PythonCreateSettings>(self)) {
            self.cast<PythonCreateSettings&>().owners = std::move(owners);
        }
    };
    define(type, field, py::cpp_function(mixOf, py::is_method(type)),
           py::cpp_function(setMix, py::is_method(type)));
}

/// Colours with their strength: (red, green, blue, strength), bytes.
void tintAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    using Bytes = std::array<std::uint8_t, 4>;
    attribute<Bytes>(
        type, field, structOf,
        [](const FieldValue& value) {
            const auto tint = std::get<Tint>(value);
            return Bytes{tint.red, tint.green, tint.blue, tint.strength};
        },
        [](const Bytes& bytes) {
            return FieldValue(Tint{bytes[0], bytes[1], bytes[2], bytes[3]});
        });
}

/// Takes over each field from another struct of the same kind.
void assignFields(std::span<const FieldInfo> fields, void* to, const void* from)
{
    for (const FieldInfo& field : fields) {
        if (field.isGroup()) {
            assignFields(field.children, field.childOf(to), field.childOf(const_cast<void*>(from)));
        } else if (field.meta.isStored) {
            field.set(to, field.get(from));
        }
    }
}

void groupAttribute(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    const FieldInfo* kept = &field;
    bindPart(type,
             {field.meta.key, field.meta.doc, field.structType,
              [kept, structOf](const py::handle& self) { return kept->childOf(structOf(self)); },
              [kept](void* to, const void* from) { assignFields(kept->children, to, from); }});
}

} // namespace

void bindPart(py::object& type, const PartInfo& part)
{
    using Caster = py::detail::type_caster_generic;
    const py::detail::type_info* info = py::detail::get_type_info(part.type);
    if (info == nullptr) {
        throw std::logic_error(std::string("The class of the attribute ") + part.name +
                               " must be bound before it.");
    }
    const py::handle inner(reinterpret_cast<PyObject*>(info->type));
    const auto textOf = [](const py::handle& each) {
        return py::str(each.attr("__module__")).cast<std::string>() + "." +
               py::str(each.attr("__qualname__")).cast<std::string>();
    };
    const auto get = [info, partOf = part.partOf](const py::object& self) {
        return py::reinterpret_steal<py::object>(
            Caster::cast(partOf(self), py::return_value_policy::reference_internal, self, info,
                         nullptr, nullptr));
    };
    const std::string owner = py::str(type.attr("__name__")).cast<std::string>();
    const std::string wanted =
        owner + "." + part.name + " takes a " + py::str(inner.attr("__name__")).cast<std::string>();
    const auto set = [info, wanted, partOf = part.partOf,
                      assign = part.assign](const py::object& self, const py::object& value) {
        Caster given(info);
        if (value.is_none() || !given.load(value, false)) {
            throw py::type_error(wanted + ", not " + shortly(value) + ".");
        }
        assign(partOf(self), given.value);
    };
    // Whoever reads it sees what it refers to, though one function serves all types.
    const std::string signature = "(self: " + textOf(type) + ") -> " + textOf(inner);
    py::options options;
    options.disable_function_signatures();
    define(type, part.name, part.doc, py::cpp_function(get, py::is_method(type), signature.c_str()),
           py::cpp_function(set, py::is_method(type)));
}

py::dict clipsAsDict(const std::vector<ClipWeight>& weights)
{
    py::dict clips;
    for (const ClipWeight& each : weights) {
        clips[py::str(each.clip)] = each.weight;
    }
    return clips;
}

float weightFrom(const py::handle& given)
{
    const double weight = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred() != nullptr || !std::isfinite(weight) || weight < 0.0) {
        PyErr_Clear();
        throw ScriptError("A weight is a number from 0 on, not " + shortly(given) + ".");
    }
    return static_cast<float>(weight);
}

std::vector<ClipWeight> clipsFromDict(const py::dict& clips)
{
    std::vector<ClipWeight> weights;
    for (const auto& [name, weight] : clips) {
        if (!py::isinstance<py::str>(name)) {
            throw ScriptError("Clips are given by name, not by " + shortly(name) + ".");
        }
        weights.push_back({name.cast<std::string>(), weightFrom(weight)});
    }
    return weights;
}

void bindFields(py::object& type, std::span<const FieldInfo> fields, const StructOf& structOf)
{
    for (const FieldInfo& field : fields) {
        if (field.meta.isStored) {
            bindField(type, field, structOf);
        }
    }
}

void bindField(py::object& type, const FieldInfo& field, const StructOf& structOf)
{
    if (field.isGroup()) {
        groupAttribute(type, field, structOf);
    } else if (field.is<bool>()) {
        plainAttribute<bool>(type, field, structOf);
    } else if (field.is<float>()) {
        plainAttribute<float>(type, field, structOf);
    } else if (field.is<double>()) {
        plainAttribute<double>(type, field, structOf);
    } else if (field.is<std::int64_t>()) {
        integerAttribute(type, field, structOf);
    } else if (field.is<std::string>()) {
        plainAttribute<std::string>(type, field, structOf);
    } else if (field.is<PaintColor>()) {
        plainAttribute<PaintColor>(type, field, structOf);
    } else if (field.is<std::optional<bool>>()) {
        plainAttribute<std::optional<bool>>(type, field, structOf);
    } else if (field.is<ValueRange>()) {
        rangeAttribute(type, field, structOf);
    } else if (field.is<glm::vec3>()) {
        pointAttribute(type, field, structOf);
    } else if (field.is<glm::quat>()) {
        turnAttribute(type, field, structOf);
    } else if (field.is<std::vector<TemplateWeight>>()) {
        mixAttribute(type, field, structOf);
    } else if (field.is<Tint>()) {
        tintAttribute(type, field, structOf);
    } else {
        listAttribute(type, field, structOf);
    }
}

std::string signatureOf(const char* type, std::span<const FieldInfo> fields)
{
    std::string text = "__init__(self: crowdbrush." + std::string(type) + ", *";
    for (const FieldInfo& field : fields) {
        if (!field.meta.isStored) {
            continue;
        }
        const char* name = field.is<bool>()        ? "bool"
                           : field.is<glm::vec3>() ? "Sequence[float]"
                           : field.is<float>()     ? "float"
                                                   : "Any";
        text += ", " + attributeOf(field.meta.key) + ": " + name + " = ...";
    }
    return text + ") -> None";
}

void needLegal(std::span<const FieldInfo> fields, const void* object)
{
    for (const FieldInfo& field : fields) {
        if (field.meta.isStored) {
            valueOrRaise(checkField(field, field.get(object), attributeOf(field.meta.key)));
        }
    }
}

void setFields(const py::object& self, const py::kwargs& given, std::span<const FieldInfo> fields)
{
    for (const auto& [key, value] : given) {
        const std::string name = py::str(key).cast<std::string>();
        const bool isThere = std::ranges::any_of(fields, [&name](const FieldInfo& field) {
            return field.meta.isStored && attributeOf(field.meta.key) == name;
        });
        if (!isThere) {
            throw py::type_error(py::str(self.get_type().attr("__name__")).cast<std::string>() +
                                 "() has no argument '" + name + "'");
        }
        py::setattr(self, name.c_str(), value);
    }
}

} // namespace crowd::app
