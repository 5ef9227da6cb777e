// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/base/Color.h"
#include "model/base/Values.h"
#include "model/population/Columns.h"
#include "model/scene/Path.h"

/// Rules as data: "when this happens, and these conditions hold, do this sequence". What they mean
/// is behavior's affair. Metres, seconds.
namespace crowd::model {

using RuleId = std::uint32_t;

/// A place or a path that is still to be chosen, where 0 means any.
inline constexpr std::uint32_t kNotChosen = 0xFFFFFFFFU;

inline constexpr int kTagCount = 64; ///< bits of the tags column

/// Stable name of an artist's number within a scene; 0 is none.
using NumberId = std::uint32_t;
using CueId = std::uint32_t;

/// A tag as the artist knows it.
struct TagName
{
    std::uint8_t bit = 0; ///< 0..63
    std::string name;
    std::array<std::uint8_t, 3> color{200, 80, 200}; ///< sRGB
    std::string unknownMembers{};                    ///< see Scene::unknownMembers
    friend bool operator==(const TagName&, const TagName&) = default;
};

/// A number that everybody has, as the artist knows it; rules ask for it and change it while a
/// session runs. Everybody begins with one of his own between low and high.
struct NumberName
{
    NumberId id = 0;
    std::string name;
    float low = 0.0F;
    float high = 0.0F;
    /// Who begins with another one: what a session had made of it when the pose was kept. Ascending
    /// ids; they may name who is gone.
    std::vector<std::pair<IndividualId, float>> values{};
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const NumberName&, const NumberName&) = default;
};
inline constexpr float kMaxNumber = 1e6F;
inline constexpr std::uint32_t kMaxTimes = 1000; ///< that an action repeats
/// Numbers, and cues, that a scene may have.
inline constexpr std::size_t kMaxNamed = 256;

/// Whom a cue speaks to.
enum class CueReach : std::uint8_t { Everybody, Selected, Tagged };

/// A button, and a key where one is given, that send an event to a running session.
struct Cue
{
    CueId id = 0;
    std::string name;
    std::string event;
    float payload = 0.0F;
    std::string key; ///< "F3" to "F10"; empty: none
    CueReach reach = CueReach::Everybody;
    std::uint8_t tag = 0;         ///< Tagged
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const Cue&, const Cue&) = default;
};

enum class TriggerKind : std::uint8_t {
    Start,      ///< the session begins
    Event,      ///< an event by name
    Arrived,    ///< reached the place it was going to
    Entered,    ///< came into a place's circle
    Left,       ///< came out of it
    PathEnded,  ///< reached the end of a simple path
    ClipEnded,  ///< a clip that was played once is over
    Every,      ///< again and again
    TagNear,    ///< somebody with a tag came near
    SpeedLimit, ///< became faster or slower than so many metres a second
    Waited,     ///< has stood still for so many seconds
    AheadFree   ///< the place before his in the path's order is free now
};

struct Trigger
{
    TriggerKind kind = TriggerKind::Event;
    std::string event;            ///< Event
    PlaceId place = 0;            ///< Arrived, Entered, Left; 0: any; kNotChosen
    PathId path = 0;              ///< PathEnded; 0: any. AheadFree. kNotChosen
    float seconds = 5.0F;         ///< Every, Waited
    float jitter = 0.2F;          ///< Every: share of the time, 0..1
    std::uint8_t tag = 0;         ///< TagNear
    float metres = 3.0F;          ///< TagNear
    float metresPerSecond = 2.0F; ///< SpeedLimit
    bool isAbove = true;          ///< SpeedLimit: faster than it, else slower
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const Trigger&, const Trigger&) = default;
};

enum class ConditionKind : std::uint8_t {
    HasTag,
    OfTemplate,
    InPlace,
    FollowsPath, ///< path 0: any
    IsSeated,
    Chance,
    Number,   ///< an artist's number, compared
    Speed,    ///< on the ground, m/s, compared
    Payload,  ///< the number of the event, compared
    IsFull,   ///< the place has no room left
    PeopleIn, ///< how many are in the place, compared
    Property  ///< a property of theirs, compared
};

/// What a condition can compare.
enum class ComparedProperty : std::uint8_t {
    Height,        ///< scale
    Girth,         ///< scale
    PlaybackSpeed, ///< of the clip that they have while they stand or sit
    WalkSpeed,     ///< that they would like to walk with, m/s
    Clip           ///< the one that is seen is the one named
};

enum class Comparison : std::uint8_t { Less, Equal, More };

struct Condition
{
    ConditionKind kind = ConditionKind::HasTag;
    bool isNot = false;
    std::uint8_t tag = 0;
    TemplateId templateId = 0;
    PlaceId place = 0;
    PathId path = 0;
    float chance = 0.5F; ///< 0..1
    NumberId number = 0;
    Comparison comparison = Comparison::More;
    float value = 0.0F;
    ComparedProperty property = ComparedProperty::Height;
    std::string clip{};           ///< Property, Clip
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const Condition&, const Condition&) = default;
};

enum class ActionKind : std::uint8_t {
    PlayClip,   ///< one of the clips, by weight
    FollowPath, ///< path
    GoToPlace,  ///< place
    Flee,       ///< away from the aim, for so many metres
    Stop,
    GoOn,     ///< what was being walked before it stopped
    Wait,     ///< seconds ± half of that
    SetSpeed, ///< value: m/s; 0: the payload of the event
    TurnTo,   ///< the aim
    AddTag,
    RemoveTag,
    SendEvent,
    LeaveScene, ///< at the place that `choice` says; Given and 0: where he is
    Again,      ///< from the first action on
    SitDown,    ///< on the nearest free seat within so many metres; 0: however far
    StandUp,
    WaitForEvent, ///< the event, or so many seconds; 0: for ever
    SetNumber,    ///< number becomes value
    AddToNumber,  ///< value is added
    Appear,       ///< at the place, also after leaving the scene
    GoToPerson,   ///< as near to the aim as so many metres; gives up after `seconds`; 0: never
    Follow,       ///< stays so near to the aim for `seconds`; 0: until another rule comes
    LookAt,       ///< keeps facing the aim for `seconds`; 0: until another rule comes
    SetProperty,  ///< for the rest of the session; Keep Pose puts it into the scene
    Repeat,       ///< what belongs to it, so many times; see RuleSequence.h
    OneOf         ///< what belongs to one of several alternatives, drawn by weight
};

/// What an action can set of somebody while a session runs.
enum class SettableProperty : std::uint8_t {
    Tint,          ///< of a slot
    Height,        ///< value: scale
    PlaybackSpeed, ///< value: of the clip that they have while they stand or sit
    Clip,          ///< that they have while they stand or sit: one of the clips, by weight
    Phase          ///< value: where they are in that clip now, 0..1
};

/// Whom or what an action is about.
enum class ActionAim : std::uint8_t {
    Sender, ///< who sent the event or came near; where it came from when nobody did
    Tagged, ///< the nearest one with the tag
    Place
};

/// Which place to go to, or to leave at. Candidates of all but Given: the path's places where one
/// is given, else all that are called as the given place, else all spots; all exits to leave at.
/// Who waits for a free one gets it in his turn: first come, first served.
enum class PlaceChoice : std::uint8_t {
    Given,
    Nearest,
    NearestFree,
    FirstFree, ///< in the path's order; behind the last who has one where people move up
    Ahead      ///< the one before his in the path's order, once it is free: queues move up
};

/// Whom a sent event reaches.
enum class EventReach : std::uint8_t { Self, Near, Tagged, Group, Everybody };

struct Action
{
    ActionKind kind = ActionKind::PlayClip;
    std::vector<ClipWeight> clips;
    bool isLooped = false; ///< PlayClip: for `seconds`, else once
    float seconds = 3.0F;
    PathId path = 0;
    PlaceId place = 0;
    float value = 0.0F; ///< SetSpeed m/s; SendEvent: payload
    std::uint8_t tag = 0;
    std::string event;
    EventReach reach = EventReach::Near;
    float metres = 2.0F;
    float secondsPerMetre = 0.0F;            ///< SendEvent: so that a wave runs
    PlaceChoice choice = PlaceChoice::Given; ///< GoToPlace, LeaveScene
    NumberId number = 0;                     ///< SetNumber, AddToNumber
    /// Flee, TurnTo, GoToPerson, Follow, LookAt; GoToPerson and Follow know no places.
    ActionAim aim = ActionAim::Sender;
    SettableProperty property = SettableProperty::Tint;
    std::string slot; ///< Tint: by name; empty: all tintable slots
    Tint tint{200, 60, 60, 255};
    std::uint8_t depth = 0;       ///< deeper ones belong to a Repeat or OneOf above
    std::uint32_t times = 2;      ///< Repeat; 0: for ever
    float weight = 1.0F;          ///< OneOf: against the other alternatives
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const Action&, const Action&) = default;
};

/// What happens to somebody who is busy with another rule.
enum class RuleMeeting : std::uint8_t { Interrupt, Queue, Ignore };

/// Which rules may break off what a rule lets somebody do.
enum class RuleYield : std::uint8_t {
    FurtherUp, ///< rules above it in the list, and itself
    Anybody,
    Nobody
};

struct Rule
{
    RuleId id = 0;
    std::string name;
    bool isEnabled = true;
    Trigger trigger;
    std::vector<Condition> conditions;
    bool isAnyEnough = false; ///< one of the conditions, else all
    std::vector<Action> actions;
    RuleMeeting meeting = RuleMeeting::Interrupt;
    RuleYield yields = RuleYield::FurtherUp;
    float cooldownSeconds = 0.0F; ///< for the same individual
    std::uint32_t limit = 0;      ///< so often for the same individual; 0: as often as it comes
    std::string unknownMembers;   ///< see Scene::unknownMembers
    friend bool operator==(const Rule&, const Rule&) = default;
};

} // namespace crowd::model
