// SPDX-License-Identifier: MIT
#include "model/project/RulesJson.h"

#include <cmath>
#include <limits>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "model/project/JsonWriting.h"
#include "model/rules/EnvironmentFields.h"
#include "model/rules/Rule.h"
#include "model/rules/RuleSequence.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::array kYields{"further up", "anybody", "nobody", "others further up"};
constexpr std::array kCueReaches{"everybody", "selected", "tagged"};
constexpr std::array<const char*, 3> kMeetings{"interrupt", "queue", "ignore"};
constexpr float kMaxPayload = 1e6F;
constexpr std::size_t kMaxParts = 1000; ///< of one rule

template<std::size_t N, class Enum>
const char* nameOf(const std::array<const char*, N>& names, Enum value)
{
    return names[static_cast<std::size_t>(value)];
}

/// The kind and what it has; `own` are members that all kinds have.
template<class Data>
json partJson(const RulePart<Data>& part, json own = json::object())
{
    own["kind"] = part.kind().text.key;
    addFields(own, part.kind().fields, part.object());
    return withUnknown(part.unknownMembers, own);
}

json toJson(const Rule& rule)
{
    json object = {{"id", rule.id},
                   {"name", rule.name},
                   {"enabled", rule.isEnabled},
                   {"when", partJson(rule.trigger)},
                   {"if", json::array()},
                   {"any", rule.isAnyEnough},
                   {"do", json::array()},
                   {"meeting", nameOf(kMeetings, rule.meeting)},
                   {"yields", nameOf(kYields, rule.yields)},
                   {"cooldown", number(rule.cooldownSeconds)},
                   {"limit", rule.limit}};
    for (const Condition& condition : rule.conditions) {
        object["if"].push_back(partJson(condition, json::object({{"not", condition.isNot}})));
    }
    for (const Action& action : rule.actions) {
        object["do"].push_back(partJson(action, json::object({{"depth", action.depth}})));
    }
    return withUnknown(rule.unknownMembers, object);
}

void readTag(JsonFields& fields, const char* key, std::uint8_t& tag)
{
    fields.read(key, tag);
    if (tag >= kTagCount) {
        fields.complain(key, QT_TRANSLATE_NOOP("Messages", "%1 must be a tag from 0 to 63"));
    }
}

/// A field of one of several kinds.
struct ForeignField
{
    std::size_t kind;
    const FieldInfo* field;
};

/// All fields of all kinds, each key once.
std::vector<ForeignField> allFields(std::span<const RuleKind> kinds)
{
    std::vector<ForeignField> all;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        for (const FieldInfo& field : kinds[kind].fields) {
            const std::string_view key(field.meta.key);
            const bool isKnown = std::ranges::any_of(
                all, [key](const ForeignField& each) { return key == each.field->meta.key; });
            if (field.meta.isStored && !isKnown) {
                all.push_back({kind, &field});
            }
        }
    }
    return all;
}

/// Files from before each kind had fields of its own hold those of all kinds: they must be right
/// and are then forgotten.
template<class Data>
void skipForeignFields(JsonFields& fields, const RulePart<Data>& part)
{
    static const std::vector<ForeignField> kAll = allFields(kindsOf<Data>());
    RulePart<Data> other;
    for (const ForeignField& each : kAll) {
        const std::string_view key(each.field->meta.key);
        const bool isOwn = std::ranges::any_of(
            part.kind().fields, [key](const FieldInfo& own) { return key == own.meta.key; });
        if (!isOwn && fields.find(key) != nullptr) {
            other.begin(each.kind);
            readField(fields, *each.field, other.object());
        }
    }
}

template<class Data>
void readKind(JsonFields& fields, RulePart<Data>& part)
{
    const std::span<const RuleKind> kinds = kindsOf<Data>();
    std::string key = part.kind().text.key;
    fields.read("kind", key);
    const std::size_t index = indexOfKind(kinds, key);
    if (index < kinds.size()) {
        part.begin(index);
        return;
    }
    std::string all;
    for (const RuleKind& kind : kinds) {
        all += (all.empty() ? "" : ", ") + std::string(kind.text.key);
    }
    fields.complain("kind", QT_TRANSLATE_NOOP("Messages", "%1 must be one of: %2"), all);
}

template<class Data>
void readPart(JsonFields& fields, RulePart<Data>& part)
{
    readFields(fields, part.kind().fields, part.object());
    skipForeignFields(fields, part);
    part.unknownMembers = fields.unknown();
}

void readTrigger(JsonFields fields, Trigger& trigger)
{
    readKind(fields, trigger);
    readPart(fields, trigger);
}

void readCondition(JsonFields fields, Condition& condition)
{
    readKind(fields, condition);
    fields.read("not", condition.isNot);
    readPart(fields, condition);
}

void readAction(JsonFields fields, Action& action)
{
    readKind(fields, action);
    if (auto* turn = action.as<actions::TurnTo>()) {
        // Files from before there were aims turn people to the place that is given.
        fields.read("place", turn->place);
        turn->aim = turn->place != 0 ? ActionAim::Place : ActionAim::Sender;
    }
    fields.read("depth", action.depth);
    readPart(fields, action);
}

Rule ruleFrom(JsonFields fields, const std::string& where, Message& problem)
{
    Rule rule;
    fields.require("id", rule.id);
    fields.read("name", rule.name);
    fields.read("enabled", rule.isEnabled);
    if (const json* trigger = fields.find("when")) {
        readTrigger(fields.part(*trigger, where + ".when"), rule.trigger);
    }
    readObjects(fields, "if", where + ".", problem, [&](JsonFields item, const std::string&) {
        readCondition(std::move(item), rule.conditions.emplace_back());
    });
    fields.read("any", rule.isAnyEnough);
    readObjects(fields, "do", where + ".", problem, [&](JsonFields item, const std::string&) {
        readAction(std::move(item), rule.actions.emplace_back());
    });
    settleDepths(rule.actions);
    readName(fields, "meeting", kMeetings, rule.meeting);
    readName(fields, "yields", kYields, rule.yields);
    readWithin(fields, "cooldown", 0.0F, kMaxSeconds, rule.cooldownSeconds);
    fields.read("limit", rule.limit);
    if (rule.conditions.size() > kMaxParts || rule.actions.size() > kMaxParts) {
        fields.complain("", QT_TRANSLATE_NOOP("Messages", "%1 has more than %2 parts"), kMaxParts);
    }
    rule.unknownMembers = fields.unknown();
    return rule;
}

void checkRules(const Scene& scene, Message& problem)
{
    std::unordered_set<RuleId> ids;
    for (const Rule& rule : scene.rules) {
        if (!ids.insert(rule.id).second || rule.id == 0) {
            problem = !problem.empty() ? problem : idProblem("rules", rule.id);
        }
    }
}

json toJson(const Cue& cue)
{
    json written{{"id", cue.id},       {"name", cue.name},
                 {"event", cue.event}, {"payload", number(cue.payload)},
                 {"key", cue.key},     {"reach", nameOf(kCueReaches, cue.reach)},
                 {"tag", cue.tag}};
    if (cue.state != 0) {
        addFields(written, cueRecallFields(), &cue);
    }
    return withUnknown(cue.unknownMembers, written);
}

json toJson(const TagName& tag)
{
    return withUnknown(tag.unknownMembers,
                       {{"tag", tag.bit}, {"name", tag.name}, {"color", colorText(tag.color)}});
}

json toJson(const NumberName& named)
{
    json object = {{"id", named.id},
                   {"name", named.name},
                   {"low", number(named.low)},
                   {"high", number(named.high)}};
    for (const auto& [id, value] : named.values) {
        object["values"].push_back({id, number(value)});
    }
    return withUnknown(named.unknownMembers, object);
}

void readCue(JsonFields fields, Cue& cue)
{
    fields.require("id", cue.id);
    fields.read("name", cue.name);
    fields.read("event", cue.event);
    readWithin(fields, "payload", -kMaxPayload, kMaxPayload, cue.payload);
    fields.read("key", cue.key);
    if (!cue.key.empty() && std::ranges::find(kCueKeys, cue.key) == kCueKeys.end()) {
        fields.complain("key",
                        QT_TRANSLATE_NOOP("Messages", "%1 must be one of F3 to F10 or empty"));
    }
    readName(fields, "reach", kCueReaches, cue.reach);
    readTag(fields, "tag", cue.tag);
    readFields(fields, cueRecallFields(), &cue);
    cue.unknownMembers = fields.unknown();
}

/// Pairs of an individual and its value.
void readNumberValues(JsonFields& fields, NumberName& named)
{
    const json* list = fields.find("values");
    if (list == nullptr) {
        return;
    }
    const auto isPair = [](const json& pair) {
        return pair.is_array() && pair.size() == 2 && pair[0].is_number_unsigned() &&
               pair[0].get<std::uint64_t>() <= std::numeric_limits<IndividualId>::max() &&
               pair[1].is_number() && std::fabs(pair[1].get<double>()) <= double{kMaxNumber};
    };
    if (!list->is_array() || !std::ranges::all_of(*list, isPair)) {
        fields.complain("values",
                        QT_TRANSLATE_NOOP("Messages",
                                          "%1 must be a list of pairs: an individual's id and a "
                                          "number from -1000000 to 1000000"));
        return;
    }
    for (const json& pair : *list) {
        named.values.emplace_back(pair[0].get<IndividualId>(), pair[1].get<float>());
    }
    std::ranges::sort(named.values);
    const auto twice = std::ranges::adjacent_find(
        named.values, [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != named.values.end()) {
        fields.complain("values", QT_TRANSLATE_NOOP("Messages", "%1 names the individual %2 twice"),
                        twice->first);
    }
}

void readNumber(JsonFields fields, NumberName& named)
{
    fields.require("id", named.id);
    fields.read("name", named.name);
    readWithin(fields, "low", -kMaxNumber, kMaxNumber, named.low);
    readWithin(fields, "high", named.low, kMaxNumber, named.high);
    readNumberValues(fields, named);
    named.unknownMembers = fields.unknown();
}

/// Not too many, each with an id of its own.
template<class Entry>
void checkEntryIds(const std::vector<Entry>& entries, const char* key, Message& problem)
{
    std::vector<std::uint32_t> ids;
    ids.reserve(entries.size());
    for (const Entry& entry : entries) {
        ids.push_back(entry.id);
    }
    std::ranges::sort(ids);
    const auto twice = std::ranges::adjacent_find(ids);
    if (!problem.empty()) {
        return;
    }
    if (ids.size() > kMaxNamed) {
        problem =
            Message(QT_TRANSLATE_NOOP("Messages", "%1: there are more than %2"), key, kMaxNamed);
    } else if (!ids.empty() && ids.front() == 0) {
        problem = idProblem(key, 0);
    } else if (twice != ids.end()) {
        problem = idProblem(key, *twice);
    }
}

void checkTags(Scene& scene, Message& problem)
{
    std::ranges::sort(scene.tags, {}, &TagName::bit);
    const auto twice = std::ranges::adjacent_find(scene.tags, {}, &TagName::bit);
    if (problem.empty() && twice != scene.tags.end()) {
        problem =
            Message(QT_TRANSLATE_NOOP("Messages", "tags: the tag %1 is given twice"), twice->bit);
    }
}

} // namespace

json memberJson(members::Rules, const Scene& scene)
{
    json list = json::array();
    for (const Rule& rule : scene.rules) {
        list.push_back(toJson(rule));
    }
    return list;
}

void readMember(members::Rules, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "rules", "", problem, [&](JsonFields fields, const std::string& where) {
        scene.rules.push_back(ruleFrom(std::move(fields), where, problem));
    });
    checkRules(scene, problem);
}

json memberJson(members::Tags, const Scene& scene)
{
    json list = json::array();
    for (const TagName& tag : scene.tags) {
        list.push_back(toJson(tag));
    }
    return list;
}

void readMember(members::Tags, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "tags", "", problem, [&scene](JsonFields fields, const std::string&) {
        TagName& tag = scene.tags.emplace_back();
        readTag(fields, "tag", tag.bit);
        fields.read("name", tag.name);
        readColor(fields, "color", tag.color);
        tag.unknownMembers = fields.unknown();
    });
    checkTags(scene, problem);
}

json memberJson(members::Numbers, const Scene& scene)
{
    json list = json::array();
    for (const NumberName& named : scene.numbers) {
        list.push_back(toJson(named));
    }
    return list;
}

void readMember(members::Numbers, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "numbers", "", problem, [&scene](JsonFields fields, const std::string&) {
        readNumber(std::move(fields), scene.numbers.emplace_back());
    });
    checkEntryIds(scene.numbers, "numbers", problem);
    std::ranges::sort(scene.numbers, {}, &NumberName::id);
}

json memberJson(members::Cues, const Scene& scene)
{
    json list = json::array();
    for (const Cue& cue : scene.cues) {
        list.push_back(toJson(cue));
    }
    return list;
}

void readMember(members::Cues, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "cues", "", problem, [&scene](JsonFields fields, const std::string&) {
        readCue(std::move(fields), scene.cues.emplace_back());
    });
    checkEntryIds(scene.cues, "cues", problem);
}

} // namespace crowd::model
