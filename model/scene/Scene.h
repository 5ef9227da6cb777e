// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "model/base/Message.h"
#include "model/population/Population.h"
#include "model/rules/Rule.h"
#include "model/scene/Feature.h"
#include "model/scene/Group.h"
#include "model/scene/Light.h"
#include "model/scene/Lighting.h"
#include "model/scene/LookPreset.h"
#include "model/scene/Path.h"
#include "model/scene/Relation.h"
#include "model/scene/Stage.h"
#include "model/scene/State.h"
#include "model/scene/Take.h"
#include "model/scene/Timeline.h"
#include "model/template/Template.h"
#include "model/view/View.h"

/// The scene as a plain value: what a project file holds. World frame: right-handed, metres, Y up.
namespace crowd::model {

/// Corrections that the import dialog proposed and the artist accepted; part of the project.
struct ImportSettings
{
    float scale = 1.0F;
    glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F}; ///< up-axis and facing
    float groundOffset = 0.0F;                  ///< metres added to Y after scale and rotation
    bool removeRootMotion = true;
    std::string unknownMembers; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const ImportSettings&, const ImportSettings&) = default;
};

/// A template as the scene refers to it. `asset` is null while the file is missing or loading; the
/// names below are kept from the last time it was there, so that nothing is lost on saving.
struct TemplateEntry
{
    TemplateId id = 0;
    std::string name;
    std::string path; ///< absolute file path, or "builtin:templates/…"
    ImportSettings import;
    std::vector<std::string> clipNames; ///< what the clip column indexes
    std::vector<float> clipSpeeds;      ///< ground speed edited by the artist, NaN: the asset's
    std::vector<std::optional<ClipRole>> clipRoles; ///< chosen by the artist; nothing: the asset's
    TemplatePtr asset;
    Message problem;            ///< why the asset is not there; empty otherwise
    std::string unknownMembers; ///< see Scene::unknownMembers
};

struct StageEntry
{
    std::uint8_t id = 0;
    std::string name;
    std::string path;
    glm::vec3 position{0.0F};
    float headingRadians = 0.0F;
    float scale = 1.0F;
    StagePtr asset;
    Message problem;
    std::string unknownMembers; ///< see Scene::unknownMembers

    [[nodiscard]] glm::mat4 worldFromStage() const;
    static constexpr auto fields(); ///< how it is placed
};

struct NamedCamera
{
    std::string name;
    Camera camera;
    LookId look = 0;              ///< that the view takes on with it; 0, or one that is gone: none
    std::string unknownMembers{}; ///< see Scene::unknownMembers
};

inline constexpr double kMostAway = 1e6; ///< metres, and radians

constexpr auto ImportSettings::fields()
{
    using S = ImportSettings;
    return std::tuple(
        field(&S::scale,
              {.key = "scale", .doc = "of what is in the file", .low = 1e-9, .high = 1e9}),
        field(&S::rotation,
              {.key = "rotation", .doc = "a quaternion: which way is up and in front"}),
        field(&S::groundOffset, {.key = "groundOffset",
                                 .doc = "metres added to Y after scale and rotation",
                                 .low = -1e9,
                                 .high = 1e9}),
        field(&S::removeRootMotion,
              {.key = "removeRootMotion", .doc = "clips that walk away stay where they are"}));
}

constexpr auto StageEntry::fields()
{
    using S = StageEntry;
    return std::tuple(
        field(&S::position, {.key = "position",
                             .label = QT_TRANSLATE_NOOP("Fields", "Position"),
                             .doc = "of the file's origin",
                             .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                             .low = -kMostAway,
                             .high = kMostAway,
                             .sliderLow = -50.0,
                             .sliderHigh = 50.0,
                             .step = 0.1,
                             .decimals = 2,
                             .role = FieldRole::Space}),
        field(&S::headingRadians, {.key = "heading",
                                   .label = QT_TRANSLATE_NOOP("Fields", "Turned by"),
                                   .tip = QT_TRANSLATE_NOOP("Fields", "Around its upright axis"),
                                   .doc = "around its upright axis",
                                   .unit = QT_TRANSLATE_NOOP("Fields", "°"),
                                   .low = -kMostAway,
                                   .high = kMostAway,
                                   .sliderLow = -180.0,
                                   .sliderHigh = 180.0,
                                   .step = 1.0,
                                   .decimals = 1,
                                   .shownScale = 57.29577951308232,
                                   .role = FieldRole::Angle}),
        field(&S::scale, {.key = "scale",
                          .label = QT_TRANSLATE_NOOP("Fields", "Size"),
                          .doc = "of what is in the file",
                          .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                          .low = 1e-4,
                          .high = 1e4,
                          .sliderLow = 10.0,
                          .sliderHigh = 1000.0,
                          .step = 1.0,
                          .decimals = 1,
                          .isLogarithmic = true,
                          .shownScale = 100.0}));
}

/// A seat in the world, with the name individuals know it by.
struct WorldSeat
{
    SeatId id = kNoSeat;
    Seat seat; ///< position and heading in the world frame, metres
};

/// How finely time can be divided while a session runs, steps a second; the first is the usual one.
inline constexpr std::array<std::uint32_t, 3> kStepRates{30, 60, 120};

/// See Scene::parties().
inline constexpr GroupId kRelatedParty = 0x80000000U;

struct Scene
{
    std::string name;
    Population population;
    IndividualId nextId = 1;              ///< restored by undo
    std::vector<TemplateEntry> templates; ///< ascending ids
    std::vector<StageEntry> stages;       ///< ascending ids
    std::vector<NamedCamera> cameras;
    Lighting lighting = newLighting();
    Lights lights;                   ///< ascending ids
    Looks looks;                     ///< in the order in which they are shown
    std::vector<Place> places;       ///< ascending ids
    std::vector<Path> paths;         ///< ascending ids; their places are there
    std::vector<Group> groups;       ///< ascending ids
    std::vector<Rule> rules;         ///< the first ones matter most; may name what is gone
    std::vector<TagName> tags;       ///< ascending bits; those that have a name
    std::vector<NumberName> numbers; ///< ascending ids
    std::vector<Cue> cues;           ///< in the order in which they are shown
    std::vector<State> states;       ///< in the order in which they are shown
    std::vector<FeatureKind> features = readyFeatures();        ///< ascending ids
    std::vector<RelationKind> relationKinds = readyRelations(); ///< ascending ids
    RelationTable relations; ///< of people and kinds that are there
    Timeline timeline;       ///< ascending ids
    PlayRange playRange;
    Takes takes; ///< ascending ids
    SurfaceSettings surface;
    std::uint32_t seed = 1;
    std::uint32_t stepsPerSecond = kStepRates.front(); ///< of a session
    /// JSON text of an object with those top-level members of the project file that this version
    /// does not know, empty for none; written back unchanged. Entries keep theirs in the same way.
    std::string unknownMembers;
    std::string unknownTableMembers; ///< of "individuals"
    std::vector<UnknownColumn> unknownColumns;
    /// What was odd in the file that the scene was read from, for the artist; not saved.
    std::vector<Message> readWarnings;

    [[nodiscard]] const TemplateEntry* findTemplate(TemplateId id) const; ///< null: no such entry
    [[nodiscard]] TemplateEntry* findTemplate(TemplateId id);
    [[nodiscard]] const StageEntry* findStage(std::uint8_t id) const;
    [[nodiscard]] const Place* findPlace(PlaceId id) const;
    [[nodiscard]] const Path* findPath(PathId id) const;
    [[nodiscard]] const Group* findGroup(GroupId id) const;
    /// For one more: above all that there are and that cameras ask for; 0: there is no room.
    [[nodiscard]] LookId freeLookId() const;
    /// Whether strokes, moves and selections may touch a row: not where its group is hidden or
    /// locked.
    [[nodiscard]] bool isTouchable(std::size_t row) const;
    /// By row, with whom somebody walks as one party: the group's number; from kRelatedParty on,
    /// those who are related so; 0: nobody.
    [[nodiscard]] std::vector<GroupId> parties() const;
    /// Whether play has more to do than to run clips: somebody follows a path, there are rules, the
    /// timeline does something, or people who are related do something by themselves.
    [[nodiscard]] bool hasBehaviour() const;
    /// All seats of the loaded stages, ascending by id.
    [[nodiscard]] std::vector<WorldSeat> worldSeats() const;
    /// Bounds of stages and people; a 20 m square on the ground when there is nothing.
    [[nodiscard]] Bounds worldBounds() const;
};

/// World matrix of an individual: translate, turn by heading (+Z towards +X), scale (girth, height,
/// girth).
[[nodiscard]] glm::mat4 individualMatrix(const glm::vec3& position, float headingRadians,
                                         float height, float girth);

} // namespace crowd::model
