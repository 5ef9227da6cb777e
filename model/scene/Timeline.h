// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <QtCore/QtGlobal>
#include <glm/vec3.hpp>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/rules/RuleFields.h"
#include "model/rules/RuleNames.h"
#include "model/states/RecallTiming.h"

/// What happens when while a scene plays: marks in time. Plain values, part of the scene.
namespace crowd::model {

/// A stable name within a scene; 0: none.
using MarkId = std::uint32_t;

/// What happens at a mark. Saved by the keys of kMarkKinds.
enum class MarkKind : std::uint8_t {
    Marker, ///< nothing: a name for a moment
    Cue,    ///< what the cue does by then
    State,  ///< people take on a state
    Event,  ///< people hear an event
    Camera  ///< what the timeline is looked at with moves; nobody in the scene notices
};

/// What the camera does from a mark on. Saved by the keys of kCameraMoves.
enum class CameraMove : std::uint8_t {
    To,     ///< goes to a camera of the scene
    Around, ///< turns around what it looks at
    Along   ///< travels along a path
};

/// Whether people do something then.
[[nodiscard]] constexpr bool isForPeople(MarkKind kind)
{
    return kind != MarkKind::Marker && kind != MarkKind::Camera;
}

/// A week.
inline constexpr double kLatestMark = 604'800.0;
inline constexpr std::size_t kMostMarks = 100'000;
/// That a mark names: files hold no longer lists.
inline constexpr std::size_t kMostMarkPeople = 100'000;
inline constexpr int kLatestDelay = 3'600'000;     ///< milliseconds
inline constexpr double kLongestTravel = 36'000.0; ///< seconds

struct Mark
{
    MarkId id = 0;
    std::string name;
    double seconds = 0.0; ///< of the clock; what was played before a run began does not happen
    MarkKind kind = MarkKind::Marker;
    std::uint32_t cue = 0;   ///< CueId, of Cue
    std::uint32_t state = 0; ///< StateId, of State
    float fade = 0.0F;       ///< seconds that each takes to take it on
    float spread = 0.0F;     ///< seconds from the first who begins to the last
    StaggerOrder order = StaggerOrder::Distance;
    glm::vec3 point{0.0F};       ///< of Distance, metres
    float headingRadians = 0.0F; ///< of Heading, also of what a cue recalls
    std::string event;           ///< of Event
    float payload = 0.0F;
    CameraMove move = CameraMove::To; ///< of Camera, as all until people
    /// Of the scene, by its name: what it goes to, or begins the move with. Empty: it goes on from
    /// where it is.
    std::string camera;
    float travel = 0.0F;     ///< seconds that it takes; 0: a cut
    bool isGentle = true;    ///< begins and ends slowly
    float turn = 6.2831853F; ///< radians, of Around; positive: to the right around it
    std::uint32_t path = 0;  ///< PathId, of Along
    float above = 1.7F;      ///< metres over the path, of Along
    bool looksAhead = true;  ///< of Along; else at what it looked at before
    /// Whom it is for, ascending; they may be gone. Empty: whomever the cue reaches, all of the
    /// state, everybody.
    std::vector<int> people;
    /// Of Event: how much later each of people hears it, milliseconds; none where there is no
    /// entry.
    std::vector<int> delays;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    /// From the first that happens to the last, seconds.
    [[nodiscard]] double length() const;
    /// How people take on the state.
    [[nodiscard]] RecallTiming timing() const
    {
        return {fade, {spread, order, point, headingRadians}};
    }
    void setTiming(const RecallTiming& timing);
    static bool isOfCamera(const Mark& mark, const FieldContext&)
    {
        return mark.kind == MarkKind::Camera;
    }
    [[nodiscard]] bool isMoving(CameraMove how) const
    {
        return kind == MarkKind::Camera && move == how;
    }
    [[nodiscard]] bool isSpread() const { return kind == MarkKind::State && spread > 0.0F; }
    friend bool operator==(const Mark&, const Mark&) = default;
};

/// Ascending ids.
using Timeline = std::vector<Mark>;

/// Null: there is none.
[[nodiscard]] const Mark* findMark(const Timeline& timeline, MarkId id);
/// For one more: above all that there are; 0: there is no room.
[[nodiscard]] MarkId freeMarkId(const Timeline& timeline);
/// In the order in which they happen: by time, then by id.
[[nodiscard]] Timeline inOrder(Timeline timeline);
/// Whether people do something at some of them.
[[nodiscard]] bool doesAnything(const Timeline& timeline);
/// What happens at one moment each: an event that people hear one after the other becomes several
/// marks with the same id, each for those who hear it then.
[[nodiscard]] Timeline atOneMomentEach(const Mark& mark);

/// Which part of the time is played, over and over if wanted. Seconds of the clock.
struct PlayRange
{
    double begin = 0.0;
    double end = 0.0; ///< not after the beginning: all time is played
    bool isLoop = false;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    [[nodiscard]] bool isSet() const { return end > begin; }
    friend bool operator==(const PlayRange&, const PlayRange&) = default;
};

inline constexpr std::array kMarkKinds{
    FieldChoice{"marker", QT_TRANSLATE_NOOP("Fields", "nothing: a marker"),
                QT_TRANSLATE_NOOP("Fields", "A name for a moment")},
    FieldChoice{"cue", QT_TRANSLATE_NOOP("Fields", "call a cue"),
                QT_TRANSLATE_NOOP("Fields", "What the cue sends, and the state it recalls")},
    FieldChoice{"state", QT_TRANSLATE_NOOP("Fields", "recall a state"),
                QT_TRANSLATE_NOOP("Fields", "In the run alone: the scene stays as it is")},
    FieldChoice{"event", QT_TRANSLATE_NOOP("Fields", "send an event"),
                QT_TRANSLATE_NOOP("Fields", "Rules answer it")},
    FieldChoice{"camera", QT_TRANSLATE_NOOP("Fields", "move the camera"),
                QT_TRANSLATE_NOOP("Fields", "A cut, or a move that takes its time")}};

inline constexpr std::array kCameraMoves{
    FieldChoice{"to", QT_TRANSLATE_NOOP("Fields", "to a camera"),
                QT_TRANSLATE_NOOP("Fields", "At once, or as a flight")},
    FieldChoice{"around", QT_TRANSLATE_NOOP("Fields", "around"),
                QT_TRANSLATE_NOOP("Fields", "Around what it looks at")},
    FieldChoice{"along", QT_TRANSLATE_NOOP("Fields", "along a path"),
                QT_TRANSLATE_NOOP("Fields", "From its first place to its last")}};

constexpr auto Mark::fields()
{
    using C = FieldContext;
    return std::tuple(
        field(&Mark::id, {.key = "id",
                          .doc = "of no other mark of the scene",
                          .low = 1.0,
                          .high = 4294967295.0}),
        field(&Mark::name, {.key = "name",
                            .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                            .tip = QT_TRANSLATE_NOOP("Fields", "Without one it is called after "
                                                               "what happens"),
                            .doc = "as the editor shows it"}),
        field(&Mark::seconds, {.key = "seconds",
                               .label = QT_TRANSLATE_NOOP("Fields", "At"),
                               .tip = QT_TRANSLATE_NOOP("Fields", "When it happens, by the clock"),
                               .doc = "when it happens, by the clock",
                               .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                               .high = kLatestMark,
                               .sliderHigh = 120.0,
                               .decimals = 2}),
        field(&Mark::kind, {.key = "kind",
                            .label = QT_TRANSLATE_NOOP("Fields", "Then"),
                            .doc = "what happens",
                            .choices = kMarkKinds}),
        field(&Mark::cue, rulefields::reference({.label = QT_TRANSLATE_NOOP("Fields", "Cue"),
                                                 .doc = "id of the cue that is called, of `cue`",
                                                 .zero = QT_TRANSLATE_NOOP("Fields", "None")},
                                                "cue", FieldRole::Cue))
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::Cue; }),
        field(&Mark::state,
              rulefields::reference({.label = QT_TRANSLATE_NOOP("Fields", "State"),
                                     .doc = "id of the state that people take on, of `state`",
                                     .zero = QT_TRANSLATE_NOOP("Fields", "None")},
                                    "state", FieldRole::State))
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::State; }),
        field(&Mark::fade, {.key = "fade",
                            .label = QT_TRANSLATE_NOOP("Fields", "Each takes"),
                            .doc = "that each takes to take it on",
                            .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                            .high = kLongestRecall,
                            .sliderHigh = 10.0})
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::State; }),
        field(&Mark::spread, {.key = "spread",
                              .label = QT_TRANSLATE_NOOP("Fields", "The last begins after"),
                              .tip = QT_TRANSLATE_NOOP("Fields", "0: all begin at the same moment"),
                              .doc = "from the first who begins to the last",
                              .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                              .high = kLongestRecall,
                              .sliderHigh = 20.0})
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::State; }),
        field(&Mark::order, {.key = "order",
                             .label = QT_TRANSLATE_NOOP("Fields", "Order"),
                             .doc = "who begins when",
                             .choices = Stagger::kOrders})
            .when([](const Mark& s, const C&) { return s.isSpread(); }),
        field(&Mark::point, {.key = "point",
                             .label = QT_TRANSLATE_NOOP("Fields", "From"),
                             .doc = "metres, where \"distance\" begins",
                             .low = -1e6,
                             .high = 1e6,
                             .sliderLow = -1000.0,
                             .sliderHigh = 1000.0,
                             .role = FieldRole::Point})
            .when([](const Mark& s, const C&) {
                return s.isSpread() && s.order == StaggerOrder::Distance;
            }),
        field(&Mark::headingRadians,
              {.key = "heading",
               .doc = "radians, in which \"heading\" moves on; also of what a cue recalls",
               .low = -1e6,
               .high = 1e6,
               .role = FieldRole::Angle}),
        field(&Mark::event, {.key = "event",
                             .label = QT_TRANSLATE_NOOP("Fields", "Event"),
                             .doc = "that people hear, of `event`",
                             .role = FieldRole::Event})
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::Event; }),
        field(&Mark::payload, {.key = "payload",
                               .label = QT_TRANSLATE_NOOP("Fields", "Number"),
                               .tip = QT_TRANSLATE_NOOP("Fields", "That comes along: rules ask "
                                                                  "for it"),
                               .doc = "the number that comes along",
                               .low = -kMaxNumber,
                               .high = kMaxNumber,
                               .sliderLow = 0.0,
                               .sliderHigh = 10.0})
            .when([](const Mark& s, const C&) { return s.kind == MarkKind::Event; }),
        field(&Mark::move, {.key = "move",
                            .label = QT_TRANSLATE_NOOP("Fields", "Move"),
                            .doc = "what the camera does, of `camera`",
                            .choices = kCameraMoves})
            .when(&Mark::isOfCamera),
        field(&Mark::camera,
              {.key = "camera",
               .label = QT_TRANSLATE_NOOP("Fields", "Camera"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Where it goes to, or begins with"),
               .doc = "name of the camera that it goes to, or begins the move with; empty: it "
                      "goes on from where it is",
               .role = FieldRole::Camera,
               .zero = QT_TRANSLATE_NOOP("Fields", "From where it is")})
            .when(&Mark::isOfCamera),
        field(&Mark::path,
              rulefields::reference({.label = QT_TRANSLATE_NOOP("Fields", "Path"),
                                     .doc = "id of the path that it travels along, of \"along\"",
                                     .zero = QT_TRANSLATE_NOOP("Fields", "None")},
                                    "path", FieldRole::Path))
            .when([](const Mark& s, const C&) { return s.isMoving(CameraMove::Along); }),
        field(&Mark::turn, {.key = "turn",
                            .label = QT_TRANSLATE_NOOP("Fields", "Turns by"),
                            .tip = QT_TRANSLATE_NOOP("Fields", "360°: once around; less than "
                                                               "nothing: the other way"),
                            .doc = "radians that it turns by, of \"around\"",
                            .unit = QT_TRANSLATE_NOOP("Fields", "°"),
                            .low = -1e3,
                            .high = 1e3,
                            .sliderLow = -720.0,
                            .sliderHigh = 720.0,
                            .step = 15.0,
                            .decimals = 0,
                            .shownScale = 57.29577951308232})
            .when([](const Mark& s, const C&) { return s.isMoving(CameraMove::Around); }),
        field(&Mark::travel, {.key = "travel",
                              .label = QT_TRANSLATE_NOOP("Fields", "Takes"),
                              .tip = QT_TRANSLATE_NOOP("Fields", "0: at once, a cut"),
                              .doc = "seconds that the move takes; 0: a cut",
                              .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                              .high = kLongestTravel,
                              .sliderHigh = 20.0})
            .when(&Mark::isOfCamera),
        field(&Mark::above, {.key = "above",
                             .label = QT_TRANSLATE_NOOP("Fields", "Above it"),
                             .doc = "metres above the path, of \"along\"",
                             .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                             .low = -1e4,
                             .high = 1e4,
                             .sliderLow = 0.0,
                             .sliderHigh = 20.0})
            .when([](const Mark& s, const C&) { return s.isMoving(CameraMove::Along); }),
        field(&Mark::looksAhead,
              {.key = "ahead",
               .label = QT_TRANSLATE_NOOP("Fields", "Looks ahead"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Else at what it looked at before"),
               .doc = "whether it looks where it travels, of \"along\"; else at what it looked "
                      "at before"})
            .when([](const Mark& s, const C&) { return s.isMoving(CameraMove::Along); }),
        field(&Mark::isGentle, {.key = "gentle",
                                .label = QT_TRANSLATE_NOOP("Fields", "Gently"),
                                .tip = QT_TRANSLATE_NOOP("Fields", "It begins and ends slowly"),
                                .doc = "whether the move begins and ends slowly"})
            .when([](const Mark& s, const C& c) { return isOfCamera(s, c) && s.travel > 0.0F; }),
        field(&Mark::people, {.key = "people",
                              .doc = "ids of those whom it is for; empty: whomever the cue "
                                     "reaches, all of the state, everybody",
                              .low = 1.0,
                              .high = 2147483647.0}),
        field(&Mark::delays, {.key = "delays",
                              .doc = "of \"event\": milliseconds after that at which each of "
                                     "people hears it; empty: all at once",
                              .high = kLatestDelay,
                              .role = FieldRole::Sequence}));
}

constexpr auto PlayRange::fields()
{
    return std::tuple(
        field(&PlayRange::begin,
              {.key = "begin", .doc = "seconds of the clock", .high = kLatestMark}),
        field(&PlayRange::end, {.key = "end",
                                .doc = "seconds of the clock; not after the beginning: all time "
                                       "is played",
                                .high = kLatestMark}),
        field(&PlayRange::isLoop,
              {.key = "loop", .doc = "whether it begins again at the end, rather than pauses"}));
}

} // namespace crowd::model
