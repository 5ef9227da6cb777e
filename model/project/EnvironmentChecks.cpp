// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentChecks.h"

#include <algorithm>
#include <set>

#include <glm/common.hpp>

#include "model/base/ShownText.h"

namespace crowd::model {

namespace {

constexpr float kFarthest = 1e6F; ///< metres
constexpr const char* kNoSuchClip = QT_TRANSLATE_NOOP(
    "Messages", "%1 names the clip \"%2\", which no template of the scene has; there are: %3");
constexpr const char* kNoSuchSlot = QT_TRANSLATE_NOOP(
    "Messages", "%1 names the slot \"%2\", which no template of the scene has; there are: %3");
constexpr std::size_t kMostListed = 20; ///< of what there is, in a message

/// Clips and slots that rules may name: of the templates, and those that rules name already, whose
/// template may be gone.
struct RuleNames
{
    std::set<std::string> clips;
    std::set<std::string> slots;
    bool areClipsKnown = false; ///< else nothing can be said of them
    bool areSlotsKnown = true;

    explicit RuleNames(const Scene& scene)
    {
        for (const TemplateEntry& entry : scene.templates) {
            clips.insert(entry.clipNames.begin(), entry.clipNames.end());
            areSlotsKnown = areSlotsKnown && entry.asset != nullptr;
            if (entry.asset) {
                for (const Slot& slot : entry.asset->slots) {
                    slots.insert(slot.name);
                }
            }
        }
        areClipsKnown = !clips.empty();
        areSlotsKnown = areSlotsKnown && !slots.empty();
        for (const Rule& rule : scene.rules) {
            addNames(rule);
        }
    }

private:
    void addNames(const Rule& rule)
    {
        forEachPart(rule, [this](const RuleKind& kind, const void* object) {
            for (const FieldInfo& field : kind.fields) {
                const FieldValue value = field.get(object);
                if (const auto* all = std::get_if<std::vector<ClipWeight>>(&value)) {
                    for (const ClipWeight& each : *all) {
                        clips.insert(each.clip);
                    }
                } else if (field.meta.role == FieldRole::Clip) {
                    clips.insert(std::get<std::string>(value));
                } else if (field.meta.role == FieldRole::Slot) {
                    slots.insert(std::get<std::string>(value));
                }
            }
        });
    }
};

std::string listed(const std::set<std::string>& names)
{
    std::string text;
    std::size_t count = 0;
    for (const std::string& name : names) {
        if (name.empty()) {
            continue;
        }
        if (++count > kMostListed) {
            return text + " and more";
        }
        text += (text.empty() ? "" : ", ") + shortened(name);
    }
    return text;
}

/// A name that is empty stands for none.
void checkName(const std::set<std::string>& known, const std::string& name, const char* id,
               const std::string& where, Message& problem)
{
    if (problem.empty() && !name.empty() && !known.contains(name)) {
        problem = Message(id, where, shortened(name), listed(known));
    }
}

/// Of one part of a rule, whose place is `where`.
template<class Data>
void checkPartNames(const RuleNames& names, const RulePart<Data>& part, const std::string& where,
                    Message& problem)
{
    for (const FieldInfo& field : part.kind().fields) {
        const FieldValue value = field.get(part.object());
        const std::string place = where + "." + field.meta.key;
        if (const auto* clips = std::get_if<std::vector<ClipWeight>>(&value)) {
            for (std::size_t c = 0; c < clips->size() && names.areClipsKnown; ++c) {
                checkName(names.clips, (*clips)[c].clip, kNoSuchClip,
                          place + "[" + std::to_string(c) + "].clip", problem);
            }
        } else if (field.meta.role == FieldRole::Clip && names.areClipsKnown) {
            checkName(names.clips, std::get<std::string>(value), kNoSuchClip, place, problem);
        } else if (field.meta.role == FieldRole::Slot && names.areSlotsKnown) {
            checkName(names.slots, std::get<std::string>(value), kNoSuchSlot, place, problem);
        }
    }
}

void checkRuleNames(const RuleNames& names, const Scene& scene, Message& problem)
{
    for (std::size_t r = 0; r < scene.rules.size(); ++r) {
        const Rule& rule = scene.rules[r];
        const std::string where = "rules[" + std::to_string(r) + "]";
        for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
            checkPartNames(names, rule.conditions[i], where + ".if[" + std::to_string(i) + "]",
                           problem);
        }
        for (std::size_t i = 0; i < rule.actions.size(); ++i) {
            checkPartNames(names, rule.actions[i], where + ".do[" + std::to_string(i) + "]",
                           problem);
        }
    }
}

/// Where nobody could see anything, nor numbers be exact. Files are not that strict.
void checkPlaces(const Scene& scene, Message& problem)
{
    for (const Place& place : scene.places) {
        const glm::vec3 away = glm::abs(place.position);
        if (problem.empty() && std::max({away.x, away.y, away.z}) > kFarthest) {
            problem = Message(QT_TRANSLATE_NOOP("Messages",
                                                "places: \"%1\" (id %2) is too far away: positions "
                                                "lie from -1000000 to 1000000 metres"),
                              shortened(place.name), place.id);
        }
    }
}

} // namespace

void checkEnvironment(const Scene& before, const Scene& wanted, Message& problem)
{
    checkPlaces(wanted, problem);
    checkRuleNames(RuleNames(before), wanted, problem);
}

} // namespace crowd::model
