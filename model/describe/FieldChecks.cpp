// SPDX-License-Identifier: MIT
#include "model/describe/FieldChecks.h"

#include <algorithm>
#include <locale>
#include <sstream>

#include "model/base/Overloaded.h"

namespace crowd::model {

namespace {

bool isWithin(const FieldMeta& meta, double value)
{
    // False where it is not a number. Members are floats: so are the limits that they are held to.
    return value >= static_cast<double>(static_cast<float>(meta.low)) &&
           value <= static_cast<double>(static_cast<float>(meta.high));
}

Result<void> refuseNumber(const FieldMeta& meta, double value, const std::string& name)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1 is %2; it must lie from %3 to %4."), name,
                 shortNumber(value), shortNumber(meta.low), shortNumber(meta.high)};
}

Result<void> checkNumber(const FieldMeta& meta, double value, const std::string& name)
{
    return isWithin(meta, value) ? Result<void>() : refuseNumber(meta, value, name);
}

Result<void> checkInteger(const FieldMeta& meta, std::int64_t value, const std::string& name)
{
    if (meta.choices.empty()) {
        return checkNumber(meta, static_cast<double>(value), name);
    }
    if (value < 0 || value >= static_cast<std::int64_t>(meta.choices.size())) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 is none of the choices there are."), name};
    }
    return {};
}

Result<void> checkRange(const FieldMeta& meta, const ValueRange& range, const std::string& name)
{
    for (const float end : {range.low, range.high}) {
        if (!isWithin(meta, end)) {
            return refuseNumber(meta, end, name);
        }
    }
    if (range.low > range.high) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 runs from the lowest to the highest value."),
                     name};
    }
    return {};
}

template<class Numbers>
Result<void> checkEach(const FieldMeta& meta, const Numbers& numbers, const std::string& name)
{
    for (const float each : numbers) {
        if (!isWithin(meta, each)) {
            return refuseNumber(meta, each, name);
        }
    }
    return {};
}

template<class Weighted>
Result<void> checkWeights(const std::vector<Weighted>& all, const std::string& name)
{
    constexpr double kHeaviest = 1e6;
    for (const Weighted& each : all) {
        if (!(each.weight >= 0.0F && static_cast<double>(each.weight) <= kHeaviest)) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1 is %2; it must lie from %3 to %4."),
                         name, shortNumber(static_cast<double>(each.weight)), 0, 1000000};
        }
    }
    return {};
}

} // namespace

std::string attributeOf(std::string_view key)
{
    std::string name;
    for (const char letter : key) {
        const bool isUpper = letter >= 'A' && letter <= 'Z';
        name += isUpper ? "_" : "";
        name += static_cast<char>(isUpper ? letter - 'A' + 'a' : letter);
    }
    return name;
}

std::string shortNumber(double value)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << value;
    return text.str();
}

Result<void> checkField(const FieldInfo& field, const FieldValue& value, const std::string& name)
{
    const FieldMeta& meta = field.meta;
    return std::visit(
        Overloaded{
            [&](std::int64_t number) { return checkInteger(meta, number, name); },
            [&](float number) { return checkNumber(meta, static_cast<double>(number), name); },
            [&](double number) { return checkNumber(meta, number, name); },
            [&](const ValueRange& range) { return checkRange(meta, range, name); },
            [&](const glm::vec3& point) {
                return checkEach(meta, std::array{point.x, point.y, point.z}, name);
            },
            [&](const glm::quat& turn) -> Result<void> {
                const float length = glm::length(turn); // as files may have it
                return length > 0.5F && length < 2.0F
                           ? Result<void>()
                           : Error{QT_TRANSLATE_NOOP("Messages",
                                                     "%1 is a quaternion (w, x, y, z) of length 1; "
                                                     "(1, 0, 0, 0) does not turn. The length of "
                                                     "what was given is %2."),
                                   name, shortNumber(static_cast<double>(length))};
            },
            [&](const std::vector<ClipWeight>& clips) { return checkWeights(clips, name); },
            [&](const std::vector<TemplateWeight>& mix) { return checkWeights(mix, name); },
            [&](const DistributionCurve& curve) { return checkEach(meta, curve.weights, name); },
            [&](const std::vector<int>& numbers) -> Result<void> {
                if (meta.role != FieldRole::Sequence && !std::ranges::is_sorted(numbers)) {
                    return Error{QT_TRANSLATE_NOOP("Messages", "%1 must be in ascending order."),
                                 name};
                }
                for (const int each : numbers) {
                    if (each < meta.low || each > meta.high) {
                        return refuseNumber(meta, each, name);
                    }
                }
                return {};
            },
            [&](const std::vector<PaintColor>& colors) -> Result<void> {
                if (colors.empty() && meta.low > 0.0) {
                    return Error{QT_TRANSLATE_NOOP("Messages", "%1 must hold at least one colour."),
                                 name};
                }
                return {};
            },
            [](const auto&) { return Result<void>(); }},
        value);
}

namespace {

Result<void> checkItems(const FieldInfo& list, void* object, const std::string& name)
{
    for (std::size_t i = 0; i < list.count(object); ++i) {
        const std::string place = name + '[' + std::to_string(i) + "].";
        if (auto valid = checkFields(list.children, list.itemOf(object, i), place); !valid) {
            return valid;
        }
    }
    return {};
}

Result<void> checkAny(const FieldInfo& field, const void* object, const std::string& name)
{
    void* read = const_cast<void*>(object); // only that
    if (field.isList()) {
        return checkItems(field, read, name);
    }
    return field.isGroup() ? checkFields(field.children, field.childOf(read), name + '.')
                           : checkField(field, field.get(object), name);
}

} // namespace

Result<void> checkFields(std::span<const FieldInfo> fields, const void* object,
                         const std::string& prefix)
{
    for (const FieldInfo& field : fields) {
        if (auto valid = checkAny(field, object, prefix + field.meta.key); !valid) {
            return valid;
        }
    }
    return {};
}

} // namespace crowd::model
