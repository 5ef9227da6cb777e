// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "model/project/EnvironmentJson.h"
#include "model/project/JsonWriting.h"
#include "model/scene/RuleSequence.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::array kTriggers{"start",    "event",       "arrived",    "entered",
                               "left",     "path ended",  "clip ended", "every",
                               "tag near", "speed limit", "waited",     "ahead free"};
constexpr std::array kConditions{"tag",     "template", "in place",  "follows",
                                 "seated",  "chance",   "number",    "speed",
                                 "payload", "full",     "people in", "property"};
constexpr std::array kActions{
    "play",          "follow", "go to",        "flee",          "stop",           "go on",
    "wait",          "speed",  "turn",         "tag",           "untag",          "send",
    "leave scene",   "again",  "sit down",     "stand up",      "wait for event", "set number",
    "add to number", "appear", "go to person", "follow person", "look at",        "set property",
    "repeat",        "one of"};
constexpr std::array kComparedProperties{"height", "girth", "playback speed", "walk speed", "clip"};
constexpr std::array kSettableProperties{"tint", "height", "playback speed", "clip", "phase"};
constexpr std::array kComparisons{"less", "equal", "more"};
constexpr std::array kChoices{"given", "nearest", "nearest free", "first free", "ahead"};
constexpr std::array kAims{"sender", "tagged", "place"};
constexpr std::array kYields{"further up", "anybody", "nobody"};
constexpr std::array kCueReaches{"everybody", "selected", "tagged"};
constexpr std::array<const char*, 5> kReaches{"self", "near", "tagged", "group", "everybody"};
constexpr std::array<const char*, 3> kMeetings{"interrupt", "queue", "ignore"};
constexpr std::array<std::string_view, 8> kCueKeys{"F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10"};
constexpr float kMaxSeconds = 86400.0F;
constexpr float kMaxMetres = 10000.0F;
constexpr float kMaxPayload = 1e6F;
constexpr std::size_t kMaxParts = 1000; ///< of one rule

template<std::size_t N, class Enum>
const char* nameOf(const std::array<const char*, N>& names, Enum value)
{
    return names[static_cast<std::size_t>(value)];
}

json toJson(const Trigger& trigger)
{
    return withUnknown(trigger.unknownMembers,
                       {{"kind", nameOf(kTriggers, trigger.kind)},
                        {"event", trigger.event},
                        {"place", trigger.place},
                        {"path", trigger.path},
                        {"seconds", number(trigger.seconds)},
                        {"jitter", number(trigger.jitter)},
                        {"tag", trigger.tag},
                        {"metres", number(trigger.metres)},
                        {"metresPerSecond", number(trigger.metresPerSecond)},
                        {"above", trigger.isAbove}});
}

json toJson(const Condition& condition)
{
    return withUnknown(condition.unknownMembers,
                       {{"kind", nameOf(kConditions, condition.kind)},
                        {"not", condition.isNot},
                        {"tag", condition.tag},
                        {"template", condition.templateId},
                        {"place", condition.place},
                        {"path", condition.path},
                        {"chance", number(condition.chance)},
                        {"number", condition.number},
                        {"compare", nameOf(kComparisons, condition.comparison)},
                        {"value", number(condition.value)},
                        {"property", nameOf(kComparedProperties, condition.property)},
                        {"clip", condition.clip}});
}

json toJson(const Action& action)
{
    json clips = json::array();
    for (const ClipWeight& clip : action.clips) {
        clips.push_back(withUnknown(clip.unknownMembers,
                                    {{"clip", clip.clip}, {"weight", number(clip.weight)}}));
    }
    return withUnknown(
        action.unknownMembers,
        {{"kind", nameOf(kActions, action.kind)},
         {"clips", clips},
         {"loop", action.isLooped},
         {"seconds", number(action.seconds)},
         {"path", action.path},
         {"place", action.place},
         {"value", number(action.value)},
         {"tag", action.tag},
         {"event", action.event},
         {"reach", nameOf(kReaches, action.reach)},
         {"metres", number(action.metres)},
         {"secondsPerMetre", number(action.secondsPerMetre)},
         {"choice", nameOf(kChoices, action.choice)},
         {"number", action.number},
         {"aim", nameOf(kAims, action.aim)},
         {"property", nameOf(kSettableProperties, action.property)},
         {"slot", action.slot},
         {"color", colorText({action.tint.red, action.tint.green, action.tint.blue})},
         {"strength", action.tint.strength},
         {"depth", action.depth},
         {"times", action.times},
         {"weight", number(action.weight)}});
}

json toJson(const Rule& rule)
{
    json object = {{"id", rule.id},
                   {"name", rule.name},
                   {"enabled", rule.isEnabled},
                   {"when", toJson(rule.trigger)},
                   {"if", json::array()},
                   {"any", rule.isAnyEnough},
                   {"do", json::array()},
                   {"meeting", nameOf(kMeetings, rule.meeting)},
                   {"yields", nameOf(kYields, rule.yields)},
                   {"cooldown", number(rule.cooldownSeconds)},
                   {"limit", rule.limit}};
    for (const Condition& condition : rule.conditions) {
        object["if"].push_back(toJson(condition));
    }
    for (const Action& action : rule.actions) {
        object["do"].push_back(toJson(action));
    }
    return withUnknown(rule.unknownMembers, object);
}

void readTag(JsonFields& fields, const char* key, std::uint8_t& tag)
{
    fields.read(key, tag);
    if (tag >= kTagCount) {
        fields.complain(key, "must be a tag from 0 to 63");
    }
}

void readTrigger(JsonFields fields, Trigger& trigger)
{
    readName(fields, "kind", kTriggers, trigger.kind);
    fields.read("event", trigger.event);
    fields.read("place", trigger.place);
    fields.read("path", trigger.path);
    readWithin(fields, "seconds", 0.0F, kMaxSeconds, trigger.seconds);
    readWithin(fields, "jitter", 0.0F, 1.0F, trigger.jitter);
    readTag(fields, "tag", trigger.tag);
    readWithin(fields, "metres", 0.0F, kMaxMetres, trigger.metres);
    readWithin(fields, "metresPerSecond", 0.0F, kMaxWalkingSpeed * 10.0F, trigger.metresPerSecond);
    fields.read("above", trigger.isAbove);
    trigger.unknownMembers = fields.unknown();
}

void readCondition(JsonFields fields, Condition& condition)
{
    readName(fields, "kind", kConditions, condition.kind);
    fields.read("not", condition.isNot);
    readTag(fields, "tag", condition.tag);
    fields.read("template", condition.templateId);
    fields.read("place", condition.place);
    fields.read("path", condition.path);
    readWithin(fields, "chance", 0.0F, 1.0F, condition.chance);
    fields.read("number", condition.number);
    readName(fields, "compare", kComparisons, condition.comparison);
    readWithin(fields, "value", -kMaxNumber, kMaxNumber, condition.value);
    readName(fields, "property", kComparedProperties, condition.property);
    fields.read("clip", condition.clip);
    condition.unknownMembers = fields.unknown();
}

void readAction(JsonFields fields, Action& action, const std::string& where, std::string& problem)
{
    readName(fields, "kind", kActions, action.kind);
    readObjects(fields, "clips", where + ".", problem, [&](JsonFields clip, const std::string&) {
        ClipWeight& read = action.clips.emplace_back();
        clip.require("clip", read.clip);
        readWithin(clip, "weight", 0.0F, kMaxPayload, read.weight);
        read.unknownMembers = clip.unknown();
    });
    fields.read("loop", action.isLooped);
    readWithin(fields, "seconds", 0.0F, kMaxSeconds, action.seconds);
    fields.read("path", action.path);
    fields.read("place", action.place);
    readWithin(fields, "value", -kMaxPayload, kMaxPayload, action.value);
    readTag(fields, "tag", action.tag);
    fields.read("event", action.event);
    readName(fields, "reach", kReaches, action.reach);
    readWithin(fields, "metres", 0.0F, kMaxMetres, action.metres);
    readWithin(fields, "secondsPerMetre", 0.0F, kMaxSeconds, action.secondsPerMetre);
    readName(fields, "choice", kChoices, action.choice);
    fields.read("number", action.number);
    // Files from before there were aims turn people to the place that is given.
    const bool isToPlace = action.kind == ActionKind::TurnTo && action.place != 0;
    action.aim = isToPlace ? ActionAim::Place : ActionAim::Sender;
    readName(fields, "aim", kAims, action.aim);
    readName(fields, "property", kSettableProperties, action.property);
    fields.read("slot", action.slot);
    std::array<std::uint8_t, 3> color{action.tint.red, action.tint.green, action.tint.blue};
    readColor(fields, "color", color);
    action.tint = {color[0], color[1], color[2], action.tint.strength};
    fields.read("strength", action.tint.strength);
    fields.read("depth", action.depth);
    fields.read("times", action.times);
    if (action.times > kMaxTimes) {
        fields.complain("times", "must be at most " + std::to_string(kMaxTimes));
    }
    readWithin(fields, "weight", 0.0F, kMaxPayload, action.weight);
    action.unknownMembers = fields.unknown();
}

Rule ruleFrom(JsonFields fields, const std::string& where, std::string& problem)
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
    readObjects(fields, "do", where + ".", problem, [&](JsonFields item, const std::string& place) {
        readAction(std::move(item), rule.actions.emplace_back(), place, problem);
    });
    settleDepths(rule.actions);
    readName(fields, "meeting", kMeetings, rule.meeting);
    readName(fields, "yields", kYields, rule.yields);
    readWithin(fields, "cooldown", 0.0F, kMaxSeconds, rule.cooldownSeconds);
    fields.read("limit", rule.limit);
    if (rule.conditions.size() > kMaxParts || rule.actions.size() > kMaxParts) {
        fields.complain("", "has more than " + std::to_string(kMaxParts) + " parts");
    }
    rule.unknownMembers = fields.unknown();
    return rule;
}

void checkRules(const Scene& scene, std::string& problem)
{
    std::unordered_set<RuleId> ids;
    for (const Rule& rule : scene.rules) {
        if (!ids.insert(rule.id).second || rule.id == 0) {
            problem = !problem.empty() ? problem
                                       : "rules: the id " + std::to_string(rule.id) +
                                             (rule.id == 0 ? " is not allowed" : " is given twice");
        }
    }
}

json toJson(const Cue& cue)
{
    return withUnknown(cue.unknownMembers, {{"id", cue.id},
                                            {"name", cue.name},
                                            {"event", cue.event},
                                            {"payload", number(cue.payload)},
                                            {"key", cue.key},
                                            {"reach", nameOf(kCueReaches, cue.reach)},
                                            {"tag", cue.tag}});
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
        fields.complain("key", "must be one of F3 to F10 or empty");
    }
    readName(fields, "reach", kCueReaches, cue.reach);
    readTag(fields, "tag", cue.tag);
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
        fields.complain("values", "must be a list of pairs: an individual's id and a number from "
                                  "-1000000 to 1000000");
        return;
    }
    for (const json& pair : *list) {
        named.values.emplace_back(pair[0].get<IndividualId>(), pair[1].get<float>());
    }
    std::ranges::sort(named.values);
    const auto twice = std::ranges::adjacent_find(
        named.values, [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != named.values.end()) {
        fields.complain("values",
                        "names the individual " + std::to_string(twice->first) + " twice");
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
void checkEntryIds(const std::vector<Entry>& entries, const char* key, std::string& problem)
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
        problem = std::string(key) + ": there are more than " + std::to_string(kMaxNamed);
    } else if (!ids.empty() && ids.front() == 0) {
        problem = std::string(key) + ": the id 0 is not allowed";
    } else if (twice != ids.end()) {
        problem = std::string(key) + ": the id " + std::to_string(*twice) + " is given twice";
    }
}

void checkTags(Scene& scene, std::string& problem)
{
    std::ranges::sort(scene.tags, {}, &TagName::bit);
    const auto twice = std::ranges::adjacent_find(scene.tags, {}, &TagName::bit);
    if (problem.empty() && twice != scene.tags.end()) {
        problem = "tags: the tag " + std::to_string(twice->bit) + " is given twice";
    }
}

} // namespace

void writeRules(const Scene& scene, json& top)
{
    for (const Rule& rule : scene.rules) {
        top["rules"].push_back(toJson(rule));
    }
    for (const TagName& tag : scene.tags) {
        top["tags"].push_back(
            withUnknown(tag.unknownMembers,
                        {{"tag", tag.bit}, {"name", tag.name}, {"color", colorText(tag.color)}}));
    }
    for (const NumberName& named : scene.numbers) {
        top["numbers"].push_back(toJson(named));
    }
    for (const Cue& cue : scene.cues) {
        top["cues"].push_back(toJson(cue));
    }
}

void readRules(JsonFields& top, Scene& scene, std::string& problem)
{
    readObjects(top, "rules", "", problem, [&](JsonFields fields, const std::string& where) {
        scene.rules.push_back(ruleFrom(std::move(fields), where, problem));
    });
    readObjects(top, "tags", "", problem, [&](JsonFields fields, const std::string&) {
        TagName& tag = scene.tags.emplace_back();
        readTag(fields, "tag", tag.bit);
        fields.read("name", tag.name);
        readColor(fields, "color", tag.color);
        tag.unknownMembers = fields.unknown();
    });
    readObjects(top, "numbers", "", problem, [&](JsonFields fields, const std::string&) {
        readNumber(std::move(fields), scene.numbers.emplace_back());
    });
    readObjects(top, "cues", "", problem, [&](JsonFields fields, const std::string&) {
        readCue(std::move(fields), scene.cues.emplace_back());
    });
    checkRules(scene, problem);
    checkTags(scene, problem);
    checkEntryIds(scene.numbers, "numbers", problem);
    checkEntryIds(scene.cues, "cues", problem);
    std::ranges::sort(scene.numbers, {}, &NumberName::id);
}

} // namespace crowd::model
