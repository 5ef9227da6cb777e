// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentSchema.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <typeindex>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/describe/FieldJson.h"
#include "model/rules/EnvironmentFields.h"
#include "model/rules/Rule.h"
#include "model/scene/Feature.h"
#include "model/scene/Group.h"
#include "model/scene/Light.h"
#include "model/scene/Lighting.h"
#include "model/scene/LookPreset.h"
#include "model/scene/Relation.h"
#include "model/scene/Timeline.h"

namespace crowd::model {

namespace {

using nlohmann::json;

/// The class of a struct, or of what a list holds.
const char* structName(const FieldInfo& field)
{
    const std::array<std::pair<std::type_index, const char*>, 6> names{{
        {typeid(FeatureValue), "FeatureValue"},
        {typeid(FeatureClip), "FeatureClip"},
        {typeid(FeatureSlot), "FeatureSlot"},
        {typeid(FeatureMaterial), "FeatureMaterial"},
        {typeid(FeaturePart), "FeaturePart"},
        {typeid(Lighting), "LookLight"},
    }};
    const auto* found =
        std::ranges::find(names, field.structType, &decltype(names)::value_type::first);
    return found->second;
}

std::string typeOf(const FieldInfo& field)
{
    if (field.isList()) {
        return std::string("list of ") + structName(field);
    }
    if (field.isGroup()) {
        return structName(field);
    }
    if (field.is<double>()) {
        return "float";
    }
    if (field.meta.role == FieldRole::Sequence) {
        return "numbers";
    }
    if (field.is<std::int64_t>()) {
        return field.meta.choices.empty() ? "int" : "choice";
    }
    const std::array<std::pair<bool, const char*>, 11> types{{
        {field.is<bool>(), "bool"},
        {field.is<float>(), "float"},
        {field.is<std::string>(), "str"},
        {field.is<PaintColor>(), "color"},
        {field.is<Tint>(), "tint"},
        {field.is<glm::vec3>(), "point"},
        {field.is<std::vector<ClipWeight>>(), "clips"},
        {field.is<ValueRange>(), "range"},
        {field.is<DistributionCurve>(), "curve"},
        {field.is<std::vector<PaintColor>>(), "colors"},
        {field.is<std::vector<int>>(), "ids"},
    }};
    for (const auto& [isIt, name] : types) {
        if (isIt) {
            return name;
        }
    }
    return "any";
}

/// Of which entry or handle it is the id; empty: of none.
const char* referredBy(FieldRole role)
{
    switch (role) {
    case FieldRole::Place:
        return "Place";
    case FieldRole::Path:
        return "Path";
    case FieldRole::Tag:
        return "Tag";
    case FieldRole::Feature:
        return "FeatureValue";
    case FieldRole::Relation:
        return "RelationKind";
    case FieldRole::Group:
        return "Group";
    case FieldRole::ArtistNumber:
        return "Number";
    case FieldRole::Template:
        return "Template";
    case FieldRole::Cue:
        return "Cue";
    default:
        return "";
    }
}

std::string unitOf(const FieldMeta& meta)
{
    const bool isAngle = meta.role == FieldRole::Angle || meta.role == FieldRole::Opening;
    const std::string unit(isAngle ? "rad" : meta.shownScale == 1.0 ? meta.unit : "");
    const std::size_t first = unit.find_first_not_of(' ');
    return first == std::string::npos ? "" : unit.substr(first);
}

json fieldJson(const FieldInfo& field, const json& defaults)
{
    const FieldMeta& meta = field.meta;
    json described = {{"key", meta.key},
                      {"type", typeOf(field)},
                      {"doc", meta.doc},
                      {"default", defaults.value(meta.key, json::object())}};
    const std::string refers = referredBy(meta.role);
    if (!refers.empty()) {
        described["refers"] = refers;
    }
    const bool isNumber = described["type"] == "int" || described["type"] == "float";
    const bool isOfOwnRange = isNumber && (refers.empty() || meta.role == FieldRole::Tag);
    if (isOfOwnRange || described["type"] == "ids" || described["type"] == "numbers") {
        described["low"] = meta.low;
        described["high"] = meta.high;
    }
    if (const std::string unit = unitOf(meta); !unit.empty()) {
        described["unit"] = unit;
    }
    if (described["type"] == "choice") {
        for (const FieldChoice& choice : meta.choices) {
            described["choices"].push_back(choice.key);
        }
    }
    return described;
}

/// `object` has the values that the fields begin with.
json fieldsJson(std::span<const FieldInfo> fields, const void* object)
{
    json defaults = json::object();
    addFields(defaults, fields, object);
    json list = json::array();
    for (const FieldInfo& field : fields) {
        const auto isSame = [&field](const json& known) { return known["key"] == field.meta.key; };
        if (field.meta.isStored && std::ranges::none_of(list, isSame)) {
            list.push_back(fieldJson(field, defaults));
        }
    }
    return list;
}

/// "go to person" is GoToPerson.
std::string upperCamel(std::string_view key)
{
    std::string name;
    bool isFirst = true;
    for (const char letter : key) {
        const bool isLower = letter >= 'a' && letter <= 'z';
        if (letter != ' ') {
            name += isFirst && isLower ? static_cast<char>(letter - 'a' + 'A') : letter;
        }
        isFirst = letter == ' ';
    }
    return name;
}

/// All kinds of triggers, conditions or actions; `common` is what all of them have beside.
template<class Part>
json kindsJson(std::span<const FieldInfo> common)
{
    json list = json::array();
    Part part;
    for (std::size_t i = 0; i < kindsOf<decltype(part.data)>().size(); ++i) {
        part.begin(i);
        json fields = fieldsJson(part.kind().fields, part.object());
        for (json& field : fieldsJson(common, &part)) {
            fields.push_back(std::move(field));
        }
        const KindText& text = part.kind().text;
        list.push_back({{"name", upperCamel(text.key)},
                        {"kind", text.key},
                        {"doc", text.doc},
                        {"fields", std::move(fields)}});
    }
    return list;
}

/// A member that is a list of others, or another one.
json partField(const char* key, const char* type, const char* doc, json begin = json::array())
{
    return {{"key", key}, {"type", type}, {"doc", doc}, {"default", std::move(begin)}};
}

json entryJson(const char* name, const char* list, const char* doc, json fields,
               std::initializer_list<json> parts = {})
{
    for (const json& part : parts) {
        fields.push_back(part);
    }
    const std::string_view owner(name);
    for (json& field : fields) {
        const auto key = field["key"].get<std::string>();
        const bool getsId = owner == "FeatureKind" || owner == "FeatureValue" ||
                            owner == "RelationKind"; // from its mapping
        if (key == "id" && getsId) {
            field["low"] = 0;
        }
        field["isNeeded"] = (key == "id" && !getsId) || (owner == "Place" && key == "position") ||
                            (owner == "Branch" && (key == "place" || key == "path"));
    }
    return {{"name", name}, {"list", list}, {"doc", doc}, {"fields", std::move(fields)}};
}

json featureEntriesJson()
{
    const FeatureKind kind;
    const FeatureValue value;
    const FeatureClip clip;
    const FeatureSlot slot;
    const FeatureMaterial material;
    const FeaturePart featurePart;
    const RelationKind relation;
    return {entryJson("FeatureClip", "", "A clip that a value of a feature lets its bearers play.",
                      fieldsJson(fieldsOf<FeatureClip>(), &clip)),
            entryJson("FeatureMaterial", "", "One of the materials of a slot.",
                      fieldsJson(fieldsOf<FeatureMaterial>(), &material)),
            entryJson("FeatureSlot", "", "How a value of a feature lets a slot look.",
                      fieldsJson(fieldsOf<FeatureSlot>(), &slot)),
            entryJson("FeaturePart", "", "A part that a value of a feature shows or hides.",
                      fieldsJson(fieldsOf<FeaturePart>(), &featurePart)),
            entryJson(
                "FeatureValue", "",
                "What people can be like: what it names changes with its bearers, the rest stays.",
                fieldsJson(fieldsOf<FeatureValue>(), &value)),
            entryJson("FeatureKind", "", "A feature: a kind with its values.",
                      fieldsJson(fieldsOf<FeatureKind>(), &kind)),
            entryJson("RelationKind", "", "How people can be related to each other.",
                      fieldsJson(fieldsOf<RelationKind>(), &relation))};
}

json entriesJson()
{
    const Place place;
    const Path path;
    const PathBranch branch;
    const Group group;
    const TagName tag;
    const NumberName number;
    const Cue cue;
    const Light light;
    const LookPreset look;
    const Lighting lighting;
    const Mark mark;
    const Rule rule;
    const json first = {{"kind", rule.trigger.kind().text.key}};
    return {
        entryJson("Place", "places", "A spot with a size on the ground.",
                  fieldsJson(placeFields(), &place),
                  {partField("corners", "points",
                             "of a line or an area, in order: metres from the position")}),
        entryJson("Branch", "", "Where some leave a path for the beginning of another one.",
                  fieldsJson(branchFields(), &branch)),
        entryJson("Path", "paths", "Places to walk along, in order.",
                  fieldsJson(pathFields(), &path),
                  {partField("places", "ids of Place", "in the order in which they are walked to"),
                   partField("branches", "list of Branch", "where some leave it")}),
        entryJson("Group", "groups", "A layer of the crowd: a name for those in it.",
                  fieldsJson(fieldsOf<Group>(), &group)),
        entryJson("Tag", "tags", "A tag that characters can have, 0 to 63.",
                  fieldsJson(tagFields(), &tag)),
        entryJson("Number", "numbers", "A number that everybody has, for rules.",
                  fieldsJson(numberFields(), &number),
                  {partField("values", "values",
                             "[id, number] of each individual that begins with another one")}),
        entryJson("Cue", "cues", "A button that sends an event.", fieldsJson(cueFields(), &cue)),
        entryJson("Light", "lights", "A light that stands in the scene, beside sun and sky.",
                  fieldsJson(fieldsOf<Light>(), &light)),
        entryJson("LookLight", "", "Sun and sky of a look, where they are its own.",
                  fieldsJson(fieldsOf<Lighting>(), &lighting)),
        entryJson("Look", "looks", "A way of drawing that belongs to the scene.",
                  fieldsJson(fieldsOf<LookPreset>(), &look)),
        entryJson("Mark", "timeline", "A moment of the timeline, and what happens then.",
                  fieldsJson(fieldsOf<Mark>(), &mark)),
        entryJson("Rule", "rules", "When this happens, and the conditions hold, do this.",
                  fieldsJson(ruleFields(), &rule),
                  {partField("when", "Trigger", "what makes it fire", first),
                   partField("if", "list of Condition", "what must hold"),
                   partField("do", "list of Action", "what is done, in order")}),
    };
}

} // namespace

std::string environmentSchema()
{
    json entries = featureEntriesJson();
    for (json& entry : entriesJson()) {
        entries.push_back(std::move(entry));
    }
    return json{{"entries", std::move(entries)},
                {"triggers", kindsJson<Trigger>({})},
                {"conditions", kindsJson<Condition>(conditionFields())},
                {"actions", kindsJson<Action>(actionFields())}}
        .dump();
}

} // namespace crowd::model
