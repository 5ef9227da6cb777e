// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "model/project/EnvironmentJson.h"
#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::array<const char*, 9> kTriggers{"start",      "event", "arrived",
                                               "entered",    "left",  "path ended",
                                               "clip ended", "every", "tag near"};
constexpr std::array<const char*, 6> kConditions{"tag",     "template", "in place",
                                                 "follows", "seated",   "chance"};
constexpr std::array<const char*, 14> kActions{"play",  "follow", "go to",       "flee", "stop",
                                               "go on", "wait",   "speed",       "turn", "tag",
                                               "untag", "send",   "leave scene", "again"};
constexpr std::array<const char*, 5> kReaches{"self", "near", "tagged", "group", "everybody"};
constexpr std::array<const char*, 3> kMeetings{"interrupt", "queue", "ignore"};
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
    return {{"kind", nameOf(kTriggers, trigger.kind)},
            {"event", trigger.event},
            {"place", trigger.place},
            {"path", trigger.path},
            {"seconds", number(trigger.seconds)},
            {"jitter", number(trigger.jitter)},
            {"tag", trigger.tag},
            {"metres", number(trigger.metres)}};
}

json toJson(const Condition& condition)
{
    return {{"kind", nameOf(kConditions, condition.kind)},
            {"not", condition.isNot},
            {"tag", condition.tag},
            {"template", condition.templateId},
            {"place", condition.place},
            {"path", condition.path},
            {"chance", number(condition.chance)}};
}

json toJson(const Action& action)
{
    json clips = json::array();
    for (const ClipWeight& clip : action.clips) {
        clips.push_back({{"clip", clip.clip}, {"weight", number(clip.weight)}});
    }
    return {{"kind", nameOf(kActions, action.kind)},
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
            {"secondsPerMetre", number(action.secondsPerMetre)}};
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
}

void readAction(JsonFields fields, Action& action, const std::string& where, std::string& problem)
{
    readName(fields, "kind", kActions, action.kind);
    readObjects(fields, "clips", where + ".", problem, [&](JsonFields clip, const std::string&) {
        ClipWeight& read = action.clips.emplace_back();
        clip.require("clip", read.clip);
        readWithin(clip, "weight", 0.0F, kMaxPayload, read.weight);
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
}

Rule ruleFrom(JsonFields fields, const std::string& where, std::string& problem)
{
    Rule rule;
    fields.require("id", rule.id);
    fields.read("name", rule.name);
    fields.read("enabled", rule.isEnabled);
    if (const json* trigger = fields.find("when")) {
        readTrigger(JsonFields(*trigger, where + ".when", problem), rule.trigger);
    }
    readObjects(fields, "if", where + ".", problem, [&](JsonFields item, const std::string&) {
        readCondition(std::move(item), rule.conditions.emplace_back());
    });
    fields.read("any", rule.isAnyEnough);
    readObjects(fields, "do", where + ".", problem, [&](JsonFields item, const std::string& place) {
        readAction(std::move(item), rule.actions.emplace_back(), place, problem);
    });
    readName(fields, "meeting", kMeetings, rule.meeting);
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
    std::vector<RuleId> ids;
    for (const Rule& rule : scene.rules) {
        if (problem.empty() && (rule.id == 0 || std::ranges::find(ids, rule.id) != ids.end())) {
            problem = "rules: the id " + std::to_string(rule.id) +
                      (rule.id == 0 ? " is not allowed" : " is given twice");
        }
        ids.push_back(rule.id);
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
            {{"tag", tag.bit}, {"name", tag.name}, {"color", colorText(tag.color)}});
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
    });
    checkRules(scene, problem);
    checkTags(scene, problem);
}

} // namespace crowd::model
