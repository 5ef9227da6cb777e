// SPDX-License-Identifier: MIT
#include "model/rules/EnvironmentFields.h"

#include <array>
#include <vector>

#include "model/rules/RuleFields.h"
#include "model/rules/RuleSequence.h"
#include "model/scene/Path.h"

namespace crowd::model {

namespace {

constexpr double kMostIds = 0xFFFFFFFFU;
constexpr double kMostBranchWeight = 1000.0;

constexpr std::array kRoles{FieldChoice{"spot", ""},      FieldChoice{"obstacle", ""},
                            FieldChoice{"attractor", ""}, FieldChoice{"repeller", ""},
                            FieldChoice{"exit", ""},      FieldChoice{"slow", ""},
                            FieldChoice{"forbidden", ""}, FieldChoice{"preferred", ""}};
constexpr std::array kShapes{FieldChoice{"round", ""}, FieldChoice{"line", ""},
                             FieldChoice{"area", ""}};
constexpr std::array kPathKinds{FieldChoice{"simple", ""}, FieldChoice{"cyclic", ""},
                                FieldChoice{"teleport", ""}};
constexpr std::array kReaches{FieldChoice{"everybody", ""}, FieldChoice{"selected", ""},
                              FieldChoice{"tagged", ""}};
constexpr std::array kMeetings{FieldChoice{"interrupt", ""}, FieldChoice{"queue", ""},
                               FieldChoice{"ignore", ""}};
constexpr std::array kYields{FieldChoice{"further up", ""}, FieldChoice{"anybody", ""},
                             FieldChoice{"nobody", ""}, FieldChoice{"others further up", ""}};

template<class Owner, class... Fields>
std::vector<FieldInfo> described(const Fields&... fields)
{
    return {detail::erased<Owner>(fields)...};
}

template<class S>
Field<S, std::uint32_t> idField(std::uint32_t S::*member)
{
    return field(
        member,
        {.key = "id", .doc = "by which others name it, never 0", .low = 1.0, .high = kMostIds});
}

template<class S>
Field<S, std::string> nameField(std::string S::*member)
{
    return field(member, {.key = "name", .doc = "as the editor shows it"});
}

template<class S>
Field<S, PaintColor> colorField(PaintColor S::*member)
{
    return field(member, {.key = "color", .doc = "in which the editor shows it"});
}

} // namespace

std::span<const FieldInfo> placeFields()
{
    static const std::vector<FieldInfo> kFields = described<Place>(
        idField(&Place::id), nameField(&Place::name),
        field(&Place::position,
              {.key = "position", .doc = "of its middle", .unit = " m", .role = FieldRole::Point}),
        field(&Place::radius, {.key = "radius",
                               .doc = "its size on the ground",
                               .unit = " m",
                               .low = kMinPlaceRadius,
                               .high = kMaxPlaceRadius}),
        colorField(&Place::color),
        field(&Place::role,
              {.key = "role", .doc = "what it does to those who walk", .choices = kRoles}),
        field(&Place::capacity, {.key = "capacity",
                                 .doc = "how many have room; 0: as many as can stand in it",
                                 .high = kMaxPlaceCapacity}),
        field(&Place::speedShare,
              {.key = "speedShare",
               .doc = "of a slow place: share of the speed that people would walk with",
               .low = kMinSpeedShare,
               .high = 1.0}),
        field(&Place::shape, {.key = "shape",
                              .doc = "what all of it lies around, no farther off than its radius: "
                                     "its position, a line along its corners, or what they enclose",
                              .choices = kShapes}));
    return kFields;
}

std::span<const FieldInfo> pathFields()
{
    static const std::vector<FieldInfo> kFields = described<Path>(
        idField(&Path::id), nameField(&Path::name),
        field(&Path::kind, {.key = "kind",
                            .doc = "at the last place: stop, go on to the first, jump to the first",
                            .choices = kPathKinds}),
        colorField(&Path::color));
    return kFields;
}

std::span<const FieldInfo> branchFields()
{
    static const std::vector<FieldInfo> kFields = described<PathBranch>(
        field(&PathBranch::place, rulefields::place({.doc = "of the path, where some leave it"})),
        field(&PathBranch::path, rulefields::path({.doc = "to whose beginning they go"})),
        field(&PathBranch::weight, {.key = "weight",
                                    .doc = "how many leave, against 1 who go on",
                                    .high = kMostBranchWeight}));
    return kFields;
}

std::span<const FieldInfo> tagFields()
{
    static const std::vector<FieldInfo> kFields = described<TagName>(
        field(&TagName::bit, {.key = "tag", .doc = "which one it names", .high = kTagCount - 1}),
        nameField(&TagName::name), colorField(&TagName::color));
    return kFields;
}

std::span<const FieldInfo> numberFields()
{
    static const std::vector<FieldInfo> kFields = described<NumberName>(
        idField(&NumberName::id), nameField(&NumberName::name),
        field(&NumberName::low, {.key = "low",
                                 .doc = "the least that anybody begins with",
                                 .low = -kMaxNumber,
                                 .high = kMaxNumber}),
        field(&NumberName::high, {.key = "high",
                                  .doc = "the most that anybody begins with, not below low",
                                  .low = -kMaxNumber,
                                  .high = kMaxNumber}));
    return kFields;
}

std::span<const FieldInfo> cueFields()
{
    static const std::vector<FieldInfo> kFields = described<Cue>(
        idField(&Cue::id), nameField(&Cue::name),
        field(&Cue::event, rulefields::event({.doc = "what it sends"})),
        field(&Cue::payload, {.key = "payload",
                              .doc = "the number that comes along",
                              .low = -kMaxNumber,
                              .high = kMaxNumber}),
        field(&Cue::key, {.key = "key", .doc = "that sends it, \"F3\" to \"F10\"; empty: none"}),
        field(&Cue::reach, {.key = "reach", .doc = "whom it reaches", .choices = kReaches}),
        field(&Cue::tag, rulefields::tag({.doc = "of those whom \"tagged\" reaches"})),
        field(&Cue::state, rulefields::state({.doc = "that they take on; 0: none"})),
        field(&Cue::seconds, {.key = "seconds",
                              .doc = "that each takes to take it on",
                              .unit = " s",
                              .high = kLongestRecall}),
        field(&Cue::spread, {.key = "spread",
                             .doc = "from the first who begins to the last",
                             .unit = " s",
                             .high = kLongestRecall}),
        field(&Cue::order, {.key = "order", .doc = "who begins when", .choices = Stagger::kOrders}),
        field(&Cue::point, {.key = "point",
                            .doc = "metres, where \"distance\" begins",
                            .low = -1e6,
                            .high = 1e6,
                            .role = FieldRole::Point}));
    return kFields;
}

std::span<const FieldInfo> cueRecallFields()
{
    constexpr std::size_t kRecalls = 5;
    return cueFields().last(kRecalls);
}

std::span<const FieldInfo> ruleFields()
{
    static const std::vector<FieldInfo> kFields = described<Rule>(
        idField(&Rule::id), nameField(&Rule::name),
        field(&Rule::isEnabled, {.key = "enabled", .doc = "whether it runs"}),
        field(&Rule::isAnyEnough,
              {.key = "any", .doc = "whether one of the conditions is enough, else all"}),
        field(&Rule::meeting, {.key = "meeting",
                               .doc = "what happens to somebody who is busy with another rule",
                               .choices = kMeetings}),
        field(&Rule::yields,
              {.key = "yields", .doc = "which rules may break it off", .choices = kYields}),
        field(&Rule::cooldownSeconds, {.key = "cooldown",
                                       .doc = "between two times for the same individual",
                                       .unit = " s",
                                       .high = kMaxSeconds}),
        field(&Rule::limit, {.key = "limit",
                             .doc = "how often for the same individual; 0: as often as it comes",
                             .high = kMostIds}));
    return kFields;
}

std::span<const FieldInfo> conditionFields()
{
    static const std::vector<FieldInfo> kFields = described<Condition>(
        field(&Condition::isNot, {.key = "not", .doc = "whether it must not hold"}));
    return kFields;
}

std::span<const FieldInfo> actionFields()
{
    static const std::vector<FieldInfo> kFields = described<Action>(
        field(&Action::depth, {.key = "depth",
                               .doc = "deeper ones belong to the repeat or the one of above them",
                               .high = 255.0}));
    return kFields;
}

} // namespace crowd::model
