// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/base/Values.h"
#include "model/population/Columns.h"
#include "model/scene/Path.h"
#include "model/scene/Rule.h"

/// What a brush is set to: plain values, compared and copied freely, kept in preferences and in
/// recorded strokes. Metres, radians, seconds, logical pixels; colours sRGB.
namespace crowd::model {

enum class BrushKind : std::uint8_t {
    Create,
    Delete,
    Colour,
    Orientation,
    Animation,
    Walk, ///< which path people follow, and how fast
    Tag,
    Untag,
    Event,       ///< speaks to the running session, never to the document
    Path,        ///< adds places to a path; no stroke over people
    Environment, ///< adds places that act by themselves; no stroke over people
    Script,      ///< what it changes, a script says
    Style        ///< with which clip and how fast people walk
};
enum class BrushSelection : std::uint8_t {
    Point,       ///< what is under the cursor
    Spray,       ///< random points of a circle, so many a second
    AllInCircle, ///< everything in a circle
    Rectangle    ///< everything between press and release
};
enum class BrushOperator : std::uint8_t { Uniform, Random, Gradient };

/// Which way the created or the turned ones face. A seat's heading always wins at creation.
enum class HeadingMode : std::uint8_t {
    Direction,    ///< headingRadians
    Random,       ///< headingRadians ± spreadRadians, by the distribution
    AlongStroke,  ///< the way the pointer goes, on the ground
    TowardsPoint, ///< towardsPoint
    TowardsViewer ///< the camera
};

struct HeadingSettings
{
    HeadingMode mode = HeadingMode::Direction;
    float headingRadians = 0.0F;
    float spreadRadians = 3.14159265F; ///< to each side
    glm::vec3 towardsPoint{0.0F};
    /// Added where the heading follows something else (stroke, point, viewer): π faces away.
    float turnRadians = 0.0F;
    friend bool operator==(const HeadingSettings&, const HeadingSettings&) = default;
};

struct SeatGridSettings
{
    bool isOn = true;
    std::vector<int> ranks;  ///< ascending; empty: all
    std::vector<int> wedges; ///< ascending; empty: all
    [[nodiscard]] bool allows(int rank, int wedge) const;
    [[nodiscard]] bool isLimited() const { return !ranks.empty() || !wedges.empty(); }
    friend bool operator==(const SeatGridSettings&, const SeatGridSettings&) = default;
};

struct CreateSettings
{
    std::vector<TemplateWeight> mix;
    float minimalDistance = 0.6F;    ///< metres between foot points, also to those already there
    ValueRange height{0.95F, 1.05F}; ///< scale
    ValueRange girth{0.95F, 1.05F};  ///< scale
    std::vector<PaintColor> palette; ///< tints of clothes; empty: none
    float paletteStrength = 1.0F;    ///< 0..1
    bool variesOutfit = true;        ///< any material of each slot, else the first
    /// Any skin, hair and face; unset: as variesOutfit.
    std::optional<bool> variesFaces;
    bool variesParts = false; ///< each part worn or not, else as the template has them
    ValueRange phase{0.0F, 1.0F};
    std::vector<ClipWeight> clips; ///< empty: the template's default, seated on a seat
    HeadingSettings heading{HeadingMode::Random};
    float density = 1.0F;       ///< persons per m², filling areas without seat grid
    float seatPercent = 100.0F; ///< share of the free seats, filling areas with seat grid
    SeatGridSettings seats;
    /// Also on roofs, crowns of trees and wherever else nobody can walk to. Strokes of before there
    /// was a choice say nothing of it.
    bool anywhere = true;
    friend bool operator==(const CreateSettings&, const CreateSettings&) = default;
};

struct DeleteSettings
{
    float percent = 100.0F; ///< of those in the area, for thinning out; a spray takes whom it hits
    friend bool operator==(const DeleteSettings&, const DeleteSettings&) = default;
};

struct ColourSettings
{
    std::string slot;        ///< by name; empty: all tintable slots
    bool sparesBody = false; ///< of all, not skin, hair and face, where there is anything else
    /// The colour as it was chosen, whatever the material's; else it multiplies that one.
    bool replaces = false;
    /// Uniform takes the first; Random one of them, or between them with `blends`; Gradient runs
    /// through them from first to last. Never empty.
    std::vector<PaintColor> colors{{214, 64, 48}, {48, 96, 214}};
    float strength = 1.0F; ///< 0..1
    bool blends = false;
    bool eachSlotApart = false; ///< Random: another draw for each slot
    friend bool operator==(const ColourSettings&, const ColourSettings&) = default;
};

struct OrientationSettings
{
    HeadingSettings heading{HeadingMode::AlongStroke};
    friend bool operator==(const OrientationSettings&, const OrientationSettings&) = default;
};

struct AnimationSettings
{
    std::vector<ClipWeight> clips; ///< empty: the clip stays
    bool setsPhase = true;
    ValueRange phase{0.0F, 1.0F}; ///< Uniform takes low; Gradient runs from low to high
    bool setsSpeed = false;
    ValueRange speed{1.0F, 1.0F};
    friend bool operator==(const AnimationSettings&, const AnimationSettings&) = default;
};

struct WalkSettings
{
    bool setsPath = true;
    PathId path = 0; ///< 0: follow none; kNearestPath: the one that each is nearest to
    bool setsSpeed = true;
    ValueRange speed{1.1F, 1.5F}; ///< m/s
    friend bool operator==(const WalkSettings&, const WalkSettings&) = default;
};

struct StyleSettings
{
    bool setsStyle = true;
    std::vector<ClipWeight> clips; ///< to walk with; empty: the one that fits the speed
    bool setsSpeed = true;
    ValueRange speed{1.1F, 1.5F}; ///< m/s
    friend bool operator==(const StyleSettings&, const StyleSettings&) = default;
};

struct TagSettings
{
    std::uint8_t tag = 0; ///< bit
    friend bool operator==(const TagSettings&, const TagSettings&) = default;
};

struct EventSettings
{
    std::string name = "cheer";
    float payload = 2.5F;
    friend bool operator==(const EventSettings&, const EventSettings&) = default;
};

/// Of the brushes that add places.
struct PlaceSettings
{
    float radiusMetres = 1.5F;
    PathKind kind = PathKind::Simple;     ///< of new paths
    PlaceRole role = PlaceRole::Obstacle; ///< of the environment brush
    bool anywhere = true;                 ///< also where nobody can walk to
    friend bool operator==(const PlaceSettings&, const PlaceSettings&) = default;
};

/// A setting that a script brush brings along.
struct ScriptValue
{
    std::string name;
    std::variant<bool, std::int64_t, double, std::string, PaintColor> value;
    friend bool operator==(const ScriptValue&, const ScriptValue&) = default;
};

struct ScriptSettings
{
    std::string brush; ///< the name it was registered by
    std::vector<ScriptValue> values;
    friend bool operator==(const ScriptSettings&, const ScriptSettings&) = default;
};

/// The number that + and - change, and what it is.
enum class MainQuantity : std::uint8_t {
    Density,       ///< create in an area without seat grid: persons per m²
    SeatPercent,   ///< create in an area on seats
    Distance,      ///< create at points without seat grid: metres
    Rate,          ///< sprays that create or delete: points a second
    DeletePercent, ///< delete in an area
    Strength,      ///< colour: per cent
    Heading,       ///< orientation: degrees
    Turn,          ///< orientation by something else: degrees from it
    Speed,         ///< animation: playback speed
    WalkSpeed,     ///< walk and style: m/s
    Tag,           ///< tag and untag: which
    Payload,       ///< event: the number that goes with it
    PlaceRadius    ///< path and environment: metres
};

struct MainNumber
{
    MainQuantity quantity;
    double value;
    double low;
    double high;
    double step;
    int decimals;
};

struct BrushSettings
{
    BrushKind kind = BrushKind::Create;
    BrushSelection selection = BrushSelection::Spray;
    BrushOperator op = BrushOperator::Uniform;
    float radiusPixels = 40.0F;
    float ratePerSecond = 20.0F; ///< spray: points a second
    bool through = false;        ///< also those hidden behind others or behind the stage
    bool buildUp = false;        ///< each dab changes again whom it touches
    float flow = 0.25F;          ///< build up: share of the way that each dab goes
    bool pressureSize = false;   ///< pressure scales the radius
    bool pressureRate = false;   ///< pressure scales the spray's rate
    DistributionCurve distribution;

    CreateSettings create;
    DeleteSettings removal;
    ColourSettings colour;
    OrientationSettings orientation;
    AnimationSettings animation;
    WalkSettings walk;
    TagSettings tag;
    EventSettings event;
    PlaceSettings place;
    ScriptSettings script;
    StyleSettings style;

    [[nodiscard]] MainNumber mainNumber() const;
    /// The same brush with another main number, kept within its limits.
    [[nodiscard]] BrushSettings withMainNumber(double value) const;
    /// Larger or smaller by so many pixels, 1..1000.
    [[nodiscard]] BrushSettings resized(float deltaPixels) const;
    /// Whether the area has a circle of radiusPixels.
    [[nodiscard]] bool hasCircle() const
    {
        return !addsPlaces() &&
               (selection == BrushSelection::Spray || selection == BrushSelection::AllInCircle);
    }
    /// Whether it sets places on the ground instead of painting on people.
    [[nodiscard]] bool addsPlaces() const
    {
        return kind == BrushKind::Path || kind == BrushKind::Environment;
    }
    /// Whether a share of what is inside is meant, not so much a second.
    [[nodiscard]] bool takesShare() const { return selection != BrushSelection::Spray; }
    /// Whether a stroke is re-evaluated from press to current until release.
    [[nodiscard]] bool isReevaluated() const
    {
        return selection == BrushSelection::Rectangle ||
               (op == BrushOperator::Gradient && kind != BrushKind::Create &&
                kind != BrushKind::Delete && kind != BrushKind::Event);
    }
    friend bool operator==(const BrushSettings&, const BrushSettings&) = default;
};

inline constexpr float kMinRadiusPixels = 1.0F;
inline constexpr float kMaxRadiusPixels = 1000.0F;

} // namespace crowd::model
