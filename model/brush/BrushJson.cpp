// SPDX-License-Identifier: MIT
#include "model/brush/BrushJson.h"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/describe/FieldChecks.h"
#include "model/describe/FieldJson.h"

namespace crowd::model {

namespace {

constexpr const char* kKindKey = "brush";
constexpr const char* kSettingsKey = "settings";

bool isMeant(const FieldInfo& field, BrushFields which)
{
    const bool isNamed = field.is<std::string>() || field.is<std::vector<ClipWeight>>();
    return which == BrushFields::All || field.meta.isRemembered ||
           (which == BrushFields::Portable && isNamed);
}

std::vector<FieldInfo> fieldsMeant(std::span<const FieldInfo> fields, BrushFields which)
{
    std::vector<FieldInfo> meant;
    for (const FieldInfo& field : fields) {
        if (isMeant(field, which)) {
            meant.push_back(field);
        }
    }
    return meant;
}

const BrushType* findBrush(const std::string& id)
{
    for (const BrushType& type : brushTypes()) {
        if (id == type.info.id) {
            return &type;
        }
    }
    return nullptr;
}

std::string allIds()
{
    std::string all;
    for (const BrushType& type : brushTypes()) {
        all += (all.empty() ? "" : ", ") + std::string(type.info.id);
    }
    return all;
}

void readBrush(JsonFields& source, BrushSettings& brush, BrushFields which, WrongValue wrong)
{
    const BrushType& type = brushType(brush.kind());
    readFields(source, fieldsMeant(fieldsOf<BrushSettings>(), which), &brush, wrong);
    const nlohmann::json* settings = source.find(kSettingsKey);
    if (settings == nullptr || (wrong == WrongValue::Keep && !settings->is_object())) {
        return;
    }
    JsonFields inside = source.part(*settings, source.placeOf(kSettingsKey));
    readFields(inside, fieldsMeant(type.fields, which), type.editable(brush), wrong);
    (void)inside.unknown();
}

Result<void> checkBrush(const BrushSettings& brush)
{
    const BrushType& type = brushType(brush.kind());
    if (auto whole = checkFields(fieldsOf<BrushSettings>(), &brush, {}); !whole) {
        return whole;
    }
    return checkFields(type.fields, type.settings(brush), {});
}

} // namespace

nlohmann::json brushJson(const BrushSettings& brush, BrushFields which)
{
    const BrushType& type = brushType(brush.kind());
    nlohmann::json json = {{kKindKey, type.info.id}};
    addFields(json, fieldsMeant(fieldsOf<BrushSettings>(), which), &brush);
    nlohmann::json& settings = json[kSettingsKey] = nlohmann::json::object();
    addFields(settings, fieldsMeant(type.fields, which), type.settings(brush));
    return json;
}

Result<BrushSettings> brushFromJson(const nlohmann::json& json)
{
    Message problem;
    JsonFields source(json, kKindKey, problem);
    std::string id;
    source.require(kKindKey, id);
    const BrushType* type = findBrush(id);
    if (type == nullptr) {
        source.complain(kKindKey, QT_TRANSLATE_NOOP("Messages", "%1 must be one of: %2"), allIds());
        return Error{problem};
    }
    BrushSettings brush = initialBrush(static_cast<BrushKind>(type - brushTypes().data()));
    const JsonFields::Tolerated none;
    JsonFields strict(json, kKindKey, problem, &none);
    (void)strict.find(kKindKey);
    readBrush(strict, brush, BrushFields::All, WrongValue::Complain);
    (void)strict.unknown();
    if (!problem.empty()) {
        return Error{problem};
    }
    if (const auto sound = checkBrush(brush); !sound) {
        return sound.error();
    }
    return brush;
}

BrushSettings withRemembered(BrushSettings brush, const nlohmann::json& json, BrushFields which)
{
    if (!json.is_object()) {
        return brush;
    }
    Message problem;
    JsonFields source(json, {}, problem);
    BrushSettings known = brush;
    readBrush(source, known, which, WrongValue::Keep);
    return checkBrush(known) ? known : brush;
}

} // namespace crowd::model
