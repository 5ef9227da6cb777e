// SPDX-License-Identifier: MIT
#include "model/describe/FieldJson.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr const char* kMustBeTag = QT_TRANSLATE_NOOP("Messages", "%1 must be a tag from 0 to 63");
constexpr const char* kMustLieBetween =
    QT_TRANSLATE_NOOP("Messages", "%1 must lie between %2 and %3");
constexpr std::size_t kMostEntries = 100'000; ///< of a list

/// Bytes as "#" and two digits each.
template<std::size_t N>
std::string hexText(const std::array<std::uint8_t, N>& bytes)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t byte : bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

template<std::size_t N>
bool readHex(const std::string& text, std::array<std::uint8_t, N>& bytes)
{
    if (text.size() != 1 + 2 * N || text[0] != '#') {
        return false;
    }
    for (std::size_t i = 0; i < N; ++i) {
        const char* begin = text.data() + 1 + 2 * i;
        const auto [end, error] = std::from_chars(begin, begin + 2, bytes[i], 16);
        if (error != std::errc() || end != begin + 2) {
            return false;
        }
    }
    return true;
}

json toJson(const FieldMeta&, bool value)
{
    return value;
}
json toJson(const FieldMeta& meta, std::int64_t value)
{
    if (meta.choices.empty()) { // as it is read: only what is negative has a sign
        return value < 0 ? json(value) : json(static_cast<std::uint64_t>(value));
    }
    const auto index = static_cast<std::size_t>(value);
    return index < meta.choices.size() ? json(meta.choices[index].key) : json();
}
json toJson(const FieldMeta&, float value)
{
    return number(value);
}
json toJson(const FieldMeta&, double value)
{
    return value;
}
json toJson(const FieldMeta&, const std::string& value)
{
    return value;
}
json toJson(const FieldMeta&, const PaintColor& value)
{
    return colorText(value);
}
json toJson(const FieldMeta&, const Tint& value)
{
    return hexText<4>({value.red, value.green, value.blue, value.strength});
}
json toJson(const FieldMeta&, const ValueRange& value)
{
    return {number(value.low), number(value.high)};
}
json toJson(const FieldMeta&, const glm::vec3& value)
{
    return numbers(value);
}
json toJson(const FieldMeta&, const glm::quat& value)
{
    return numbers(value);
}
json toJson(const FieldMeta&, const std::optional<bool>& value)
{
    return value ? json(*value) : json();
}
json toJson(const FieldMeta&, const DistributionCurve& value)
{
    json list = json::array();
    for (const float weight : value.weights) {
        list.push_back(number(weight));
    }
    return list;
}
json toJson(const FieldMeta&, const ClipWeight& value)
{
    return withUnknown(value.unknownMembers,
                       {{"clip", value.clip}, {"weight", number(value.weight)}});
}
json toJson(const FieldMeta&, const TemplateWeight& value)
{
    return {{"template", value.id}, {"weight", number(value.weight)}};
}
json toJson(const FieldMeta&, int value)
{
    return value;
}
template<class Entry>
json toJson(const FieldMeta& meta, const std::vector<Entry>& values)
{
    json list = json::array();
    for (const Entry& each : values) {
        list.push_back(toJson(meta, each));
    }
    return list;
}

void readChoice(JsonFields& fields, const FieldMeta& meta, std::int64_t& value)
{
    const auto index = static_cast<std::size_t>(value);
    std::string text = index < meta.choices.size() ? meta.choices[index].key : "";
    fields.read(meta.key, text);
    std::string all;
    for (std::size_t i = 0; i < meta.choices.size(); ++i) {
        if (text == meta.choices[i].key) {
            value = static_cast<std::int64_t>(i);
            return;
        }
        all += (all.empty() ? "" : ", ") + std::string(meta.choices[i].key);
    }
    fields.complain(meta.key, QT_TRANSLATE_NOOP("Messages", "%1 must be one of: %2"), all);
}

void readInteger(JsonFields& fields, const FieldMeta& meta, std::int64_t& value)
{
    const json* found = fields.find(meta.key);
    if (found == nullptr) {
        return;
    }
    const auto most = static_cast<std::int64_t>(meta.high);
    const bool isTag = meta.role == FieldRole::Tag;
    const bool isWhole = meta.low < 0.0 ? found->is_number_integer() : found->is_number_unsigned();
    const bool isTooLarge =
        found->is_number_unsigned() &&
        found->get<std::uint64_t>() > static_cast<std::uint64_t>(std::max<std::int64_t>(most, 0));
    if (!isWhole || (isTooLarge && most >= 0xFFFFFFFF)) {
        fields.complain(
            meta.key,
            isTag ? kMustBeTag
                  : QT_TRANSLATE_NOOP(
                        "Messages",
                        "%1 must be a whole number that is not negative and not too large"));
    } else if (isTooLarge) {
        fields.complain(meta.key,
                        isTag ? kMustBeTag : QT_TRANSLATE_NOOP("Messages", "%1 must be at most %2"),
                        most);
    } else if (found->get<std::int64_t>() < static_cast<std::int64_t>(meta.low)) {
        fields.complain(meta.key, QT_TRANSLATE_NOOP("Messages", "%1 must be at least %2"),
                        static_cast<std::int64_t>(meta.low));
    } else {
        value = found->get<std::int64_t>();
    }
}

void readValue(JsonFields& fields, const FieldMeta& meta, bool& value)
{
    fields.read(meta.key, value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, std::int64_t& value)
{
    meta.choices.empty() ? readInteger(fields, meta, value) : readChoice(fields, meta, value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, float& value)
{
    readWithin(fields, meta.key, static_cast<float>(meta.low), static_cast<float>(meta.high),
               value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, double& value)
{
    const json* found = fields.find(meta.key);
    if (found != nullptr && !JsonFields::isFinite(*found)) {
        fields.complain(meta.key, QT_TRANSLATE_NOOP("Messages", "%1 must be a finite number"));
        return;
    }
    value = found != nullptr ? found->get<double>() : value;
    if (!(value >= meta.low && value <= meta.high)) {
        fields.complain(meta.key, kMustLieBetween, meta.low, meta.high);
    }
}
void readValue(JsonFields& fields, const FieldMeta& meta, std::string& value)
{
    fields.read(meta.key, value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, PaintColor& value)
{
    readColor(fields, meta.key, value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, Tint& value)
{
    std::array<std::uint8_t, 4> bytes{value.red, value.green, value.blue, value.strength};
    std::string text = hexText(bytes);
    fields.read(meta.key, text);
    if (!readHex(text, bytes)) {
        fields.complain(
            meta.key, QT_TRANSLATE_NOOP("Messages",
                                        "%1 must be a colour and its strength, as \"#f0962cff\""));
        return;
    }
    value = {bytes[0], bytes[1], bytes[2], bytes[3]};
}
void readValue(JsonFields& fields, const FieldMeta& meta, glm::vec3& value)
{
    fields.read(meta.key, value);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(static_cast<double>(value[axis]) >= meta.low &&
              static_cast<double>(value[axis]) <= meta.high)) {
            fields.complain(meta.key, kMustLieBetween, meta.low, meta.high);
        }
    }
}
void readValue(JsonFields& fields, const FieldMeta& meta, glm::quat& value)
{
    fields.read(meta.key, value);
}
void readValue(JsonFields& fields, const FieldMeta& meta, std::optional<bool>& value)
{
    const json* found = fields.find(meta.key);
    if (found != nullptr && found->is_null()) {
        value.reset();
    } else if (found != nullptr && found->is_boolean()) {
        value = found->get<bool>();
    } else if (found != nullptr) {
        fields.complain(meta.key, QT_TRANSLATE_NOOP("Messages", "%1 must be true, false or null"));
    }
}

/// A list of numbers within the field's limits; null where there is none.
const json* numberList(JsonFields& fields, const FieldMeta& meta, std::size_t count)
{
    const json* list = fields.find(meta.key);
    const auto isWithin = [&meta](const json& each) {
        return JsonFields::isFinite(each) && each.get<double>() >= meta.low &&
               each.get<double>() <= meta.high;
    };
    if (list == nullptr ||
        (list->is_array() && list->size() == count && std::ranges::all_of(*list, isWithin))) {
        return list;
    }
    fields.complain(meta.key,
                    QT_TRANSLATE_NOOP("Messages", "%1 must be a list of %2 numbers from %3 to %4"),
                    count, meta.low, meta.high);
    return nullptr;
}

void readValue(JsonFields& fields, const FieldMeta& meta, ValueRange& value)
{
    const json* list = numberList(fields, meta, 2);
    if (list == nullptr) {
        return;
    }
    if ((*list)[0].get<float>() > (*list)[1].get<float>()) {
        fields.complain(
            meta.key,
            QT_TRANSLATE_NOOP("Messages", "%1 must run from the lowest to the highest value"));
        return;
    }
    value = {(*list)[0].get<float>(), (*list)[1].get<float>()};
}
void readValue(JsonFields& fields, const FieldMeta& meta, DistributionCurve& value)
{
    if (const json* list = numberList(fields, meta, value.weights.size())) {
        for (std::size_t i = 0; i < value.weights.size(); ++i) {
            value.weights[i] = (*list)[i].get<float>();
        }
    }
}

/// Null: there is none, or it is none.
const json* entriesOf(JsonFields& fields, const FieldMeta& meta)
{
    const json* list = fields.find(meta.key);
    if (list != nullptr && (!list->is_array() || list->size() > kMostEntries)) {
        fields.complain(meta.key, list->is_array()
                                      ? QT_TRANSLATE_NOOP("Messages", "%1 has too many entries")
                                      : QT_TRANSLATE_NOOP("Messages", "%1 must be a list"));
        return nullptr;
    }
    return list;
}

void readValue(JsonFields& fields, const FieldMeta& meta, std::vector<int>& values)
{
    const json* list = entriesOf(fields, meta);
    const auto isInt = [](const json& each) {
        return each.is_number_integer() && each.get<std::int64_t>() >= INT32_MIN &&
               each.get<std::int64_t>() <= INT32_MAX;
    };
    if (list == nullptr) {
        return;
    }
    if (!std::ranges::all_of(*list, isInt)) {
        fields.complain(meta.key,
                        QT_TRANSLATE_NOOP("Messages", "%1 must be a list of whole numbers"));
        return;
    }
    auto read = list->get<std::vector<int>>();
    const auto isWithin = [&meta](int each) { return each >= meta.low && each <= meta.high; };
    if (!std::ranges::all_of(read, isWithin)) {
        fields.complain(meta.key, kMustLieBetween, meta.low, meta.high);
        return;
    }
    values = std::move(read);
}
void readValue(JsonFields& fields, const FieldMeta& meta, std::vector<PaintColor>& values)
{
    const json* list = entriesOf(fields, meta);
    if (list == nullptr) {
        return;
    }
    std::vector<PaintColor> read(list->size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!(*list)[i].is_string() || !readHex((*list)[i].get<std::string>(), read[i])) {
            fields.complain(
                meta.key,
                QT_TRANSLATE_NOOP("Messages", "%1 must be a list of colours, as \"#f0962c\""));
            return;
        }
    }
    values = std::move(read);
}

void readEntry(JsonFields& fields, float most, ClipWeight& value)
{
    fields.require("clip", value.clip);
    readWithin(fields, "weight", 0.0F, most, value.weight);
    value.unknownMembers = fields.unknown();
}
void readEntry(JsonFields& fields, float most, TemplateWeight& value)
{
    fields.require("template", value.id);
    readWithin(fields, "weight", 0.0F, most, value.weight);
    (void)fields.unknown();
}
/// `high` of the field is that of the weights.
template<class Weighted>
void readValue(JsonFields& fields, const FieldMeta& meta, std::vector<Weighted>& values)
{
    const json* list = entriesOf(fields, meta);
    if (list == nullptr) {
        return;
    }
    values.clear();
    for (std::size_t i = 0; i < list->size() && fields.isSound(); ++i) {
        JsonFields entry = fields.item((*list)[i], meta.key, i);
        readEntry(entry, static_cast<float>(meta.high), values.emplace_back());
    }
}

void readInto(JsonFields& source, const FieldInfo& field, void* data)
{
    FieldValue value = field.get(data);
    std::visit([&](auto& each) { readValue(source, field.meta, each); }, value);
    if (source.isSound()) {
        field.set(data, value);
    }
}

json itemJson(const FieldInfo& list, void* item)
{
    json begins = json::object();
    json object = json::object();
    addFields(begins, list.children, list.newItem);
    addFields(object, list.children, item);
    for (const auto& [key, value] : begins.items()) {
        if (object[key] == value) {
            object.erase(key);
        }
    }
    return withUnknown(*list.unknownOf(item), object);
}

json itemsJson(const FieldInfo& list, void* data)
{
    json items = json::array();
    for (std::size_t i = 0; i < list.count(data); ++i) {
        items.push_back(itemJson(list, list.itemOf(data, i)));
    }
    return items;
}

json groupJson(const FieldInfo& group, void* inside)
{
    json object = json::object();
    addFields(object, group.children, inside);
    return group.unknownOf ? withUnknown(*group.unknownOf(inside), object) : object;
}

void readGroup(JsonFields& source, const FieldInfo& group, void* data, WrongValue wrong)
{
    const json* inside = source.find(group.meta.key);
    if (inside == nullptr) {
        return;
    }
    Message ignored;
    const bool isKept = wrong == WrongValue::Keep;
    JsonFields members =
        (isKept ? source.apart(ignored) : source).part(*inside, source.placeOf(group.meta.key));
    void* child = group.childOf(data);
    readFields(members, group.children, child, wrong);
    if (group.unknownOf) {
        *group.unknownOf(child) = members.unknown();
    } else if (!isKept) {
        (void)members.unknown(); // complains where there may be none
    }
}

/// As many as there are; of one that is wrong nothing is read any more.
void readItems(JsonFields& source, const FieldInfo& list, void* data)
{
    const json* items = entriesOf(source, list.meta);
    if (items == nullptr) {
        return;
    }
    list.resize(data, 0);
    list.resize(data, items->size());
    for (std::size_t i = 0; i < items->size() && source.isSound(); ++i) {
        JsonFields members = source.item((*items)[i], list.meta.key, i);
        void* item = list.itemOf(data, i);
        readFields(members, list.children, item);
        *list.unknownOf(item) = members.unknown();
    }
}

} // namespace

void addFields(json& object, std::span<const FieldInfo> fields, const void* data)
{
    for (const FieldInfo& field : fields) {
        if (!field.meta.isStored) {
            continue;
        }
        if (field.isList()) {
            object[field.meta.key] = itemsJson(field, const_cast<void*>(data)); // only read
        } else if (field.isGroup()) {
            json inside = groupJson(field, field.childOf(const_cast<void*>(data)));
            if (!field.meta.isBrief ||
                inside != groupJson(field, const_cast<void*>(field.newItem))) {
                object[field.meta.key] = std::move(inside);
            }
        } else {
            object[field.meta.key] = std::visit(
                [&](const auto& each) { return toJson(field.meta, each); }, field.get(data));
        }
    }
}

void readFields(JsonFields& source, std::span<const FieldInfo> fields, void* data, WrongValue wrong)
{
    for (const FieldInfo& field : fields) {
        if (!field.meta.isStored) {
            continue;
        }
        if (field.isList()) {
            readItems(source, field, data);
        } else if (field.isGroup()) {
            readGroup(source, field, data, wrong);
        } else {
            readField(source, field, data, wrong);
        }
    }
}

void readField(JsonFields& source, const FieldInfo& field, void* data, WrongValue wrong)
{
    if (wrong == WrongValue::Keep) {
        Message ignored;
        (void)source.find(field.meta.key);
        JsonFields apart = source.apart(ignored);
        readInto(apart, field, data);
    } else {
        readInto(source, field, data);
    }
}

void readWithin(JsonFields& fields, const char* key, float low, float high, float& value)
{
    fields.read(key, value);
    if (!(value >= low && value <= high)) {
        fields.complain(key, kMustLieBetween, low, high);
    }
}

std::string colorText(const PaintColor& color)
{
    return hexText(color);
}

void readColor(JsonFields& fields, const char* key, PaintColor& color)
{
    std::string text = colorText(color);
    fields.read(key, text);
    if (!readHex(text, color)) {
        fields.complain(key, QT_TRANSLATE_NOOP("Messages", "%1 must be a colour, as \"#f0962c\""));
    }
}

} // namespace crowd::model
