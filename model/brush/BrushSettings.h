// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <span>
#include <string>

#include "model/brush/Brushes.h"
#include "model/brush/Mask.h"
#include "model/brush/operators/Operators.h"

/// What a brush is set to: plain values, compared and copied freely, kept in preferences and in
/// recorded strokes. Metres, radians, seconds, logical pixels; colours sRGB.
namespace crowd::model {

enum class BrushSelection : std::uint8_t {
    Point,       ///< what is under the cursor
    Spray,       ///< random points of a circle, so many a second
    AllInCircle, ///< everything in a circle
    Rectangle,   ///< everything between press and release
    Lasso        ///< everything that the pointer's way goes round
};

inline constexpr float kMinRadiusPixels = 1.0F;
inline constexpr float kMaxRadiusPixels = 1000.0F;

struct BrushSettings
{
    BrushChange change; ///< which brush it is, and what it alone is set to
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
    MaskSettings mask;

    BrushSettings() = default;
    /// A brush of a kind, set as its settings say.
    explicit BrushSettings(BrushKind kind);
    template<class Settings>
    explicit BrushSettings(
        Settings settings) requires std::is_constructible_v<BrushChange, Settings>
        : change(std::move(settings))
    {
    }

    [[nodiscard]] BrushKind kind() const { return static_cast<BrushKind>(change.index()); }
    /// Another kind of brush with the same area; its own settings are new.
    void setKind(BrushKind kind);
    /// Settings of the kind that it is; any other is the caller's mistake.
    template<class Settings>
    [[nodiscard]] Settings& as()
    {
        assert(std::holds_alternative<Settings>(change));
        return *std::get_if<Settings>(&change);
    }
    template<class Settings>
    [[nodiscard]] const Settings& as() const
    {
        assert(std::holds_alternative<Settings>(change));
        return *std::get_if<Settings>(&change);
    }
    /// Null where it is another kind.
    template<class Settings>
    [[nodiscard]] Settings* find()
    {
        return std::get_if<Settings>(&change);
    }
    template<class Settings>
    [[nodiscard]] const Settings* find() const
    {
        return std::get_if<Settings>(&change);
    }
    /// The heading that it sets; null where it sets none.
    [[nodiscard]] HeadingSettings* heading();
    [[nodiscard]] const HeadingSettings* heading() const;
    /// Where it adds places; null where it paints on people.
    [[nodiscard]] PlaceSettings* place();
    [[nodiscard]] const PlaceSettings* place() const;
    /// The tag that it gives or takes; null where it does neither.
    [[nodiscard]] const TagSettings* tag() const;

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
    [[nodiscard]] bool addsPlaces() const { return place() != nullptr; }
    /// Whether the area is one for the whole stroke, known when the pointer is released.
    [[nodiscard]] bool hasWholeArea() const
    {
        return selection == BrushSelection::Rectangle || selection == BrushSelection::Lasso;
    }
    /// Whether a share of what is inside is meant, not so much a second.
    [[nodiscard]] bool takesShare() const { return selection != BrushSelection::Spray; }
    /// Whether values run along the line from press to current.
    [[nodiscard]] bool followsLine() const;
    /// Whether a stroke is re-evaluated from press to current until release.
    [[nodiscard]] bool isReevaluated() const;

    /// What all brushes can be set to: area, reach, operator.
    static constexpr auto fields();
    friend bool operator==(const BrushSettings&, const BrushSettings&) = default;
};

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// What there is to know of a kind of brush, without its type.
struct BrushType
{
    const BrushInfo& info;
    std::span<const FieldInfo> fields; ///< of the settings, which BrushChange holds
    std::type_index settingsType;
    BrushChange (*make)();
    /// Sets it as it is when the editor starts.
    void (*prepare)(BrushSettings&);
    /// Null: it changes no properties by itself (creation, deletion, events, places, scripts).
    ChangeResult (*change)(const ChangeRequest&);
    MainNumber (*mainNumber)(const BrushSettings&);
    void (*setMainNumber)(BrushSettings&, float); ///< of the value as shown, within its limits
    /// Sets it by somebody; says what was taken, for the artist: empty, nothing. Null: takes
    /// nothing.
    std::string (*take)(BrushSettings&, const TakenFrom&);
    bool (*followsLine)(const BrushSettings&);     ///< whether an operator of it does
    const void* (*settings)(const BrushSettings&); ///< what the fields are of
    void* (*editable)(BrushSettings&);
};

/// By BrushKind.
[[nodiscard]] std::span<const BrushType> brushTypes();
[[nodiscard]] const BrushType& brushType(BrushKind kind);
/// All kinds in the order in which they are shown.
[[nodiscard]] std::span<const BrushKind> shownBrushes();
/// How a brush is set when the editor starts.
[[nodiscard]] BrushSettings initialBrush(BrushKind kind);

inline constexpr FieldChoice kSelections[] = {
    {"POINT", QT_TRANSLATE_NOOP("Fields", "Point")},
    {"SPRAY", QT_TRANSLATE_NOOP("Fields", "Spray")},
    {"ALL_IN_CIRCLE", QT_TRANSLATE_NOOP("Fields", "All in the circle")},
    {"RECTANGLE", QT_TRANSLATE_NOOP("Fields", "Rectangle")},
    {"LASSO", QT_TRANSLATE_NOOP("Fields", "Lasso")}};

/// The main number of sprays and of brushes without one of their own.
[[nodiscard]] MainNumber rateOf(const BrushSettings& brush);
/// A range from another lowest speed on, as wide as before where that can be walked; m/s.
[[nodiscard]] ValueRange movedTo(float low, const ValueRange& range);

/// Which of the brush's common fields a form of its kind has.
[[nodiscard]] bool hasReach(const BrushSettings& brush);
[[nodiscard]] bool canBuildUp(const BrushSettings& brush);
[[nodiscard]] bool canFlow(const BrushSettings& brush);

constexpr auto BrushSettings::fields()
{
    using S = BrushSettings;
    using C = FieldContext;
    const auto withCircle = [](const S& s, const C&) { return s.hasCircle(); };
    const auto spraying = [](const S& s, const C&) {
        return s.selection == BrushSelection::Spray && !s.addsPlaces();
    };
    return std::tuple(
        field(&S::selection, {.key = "selection",
                              .label = QT_TRANSLATE_NOOP("Fields", "Area"),
                              .choices = kSelections,
                              .section = QT_TRANSLATE_NOOP("Fields", "Brush")})
            .when([](const S& s, const C&) { return !s.addsPlaces(); }),
        field(&S::op, {.key = "operator",
                       .label = QT_TRANSLATE_NOOP("Fields", "Values"),
                       .choices = kOperatorChoices}),
        field(&S::radiusPixels, {.key = "radius",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Size"),
                                 .doc = "Logical pixels.",
                                 .unit = QT_TRANSLATE_NOOP("Fields", " px"),
                                 .low = kMinRadiusPixels,
                                 .high = kMaxRadiusPixels,
                                 .sliderLow = 1.0,
                                 .sliderHigh = 400.0,
                                 .step = 5.0,
                                 .decimals = 0,
                                 .isLogarithmic = true})
            .when(withCircle),
        field(&S::ratePerSecond, {.key = "rate",
                                  .label = QT_TRANSLATE_NOOP("Fields", "Rate"),
                                  .doc = "Spray: points a second.",
                                  .unit = QT_TRANSLATE_NOOP("Fields", " /s"),
                                  .high = 10'000.0,
                                  .sliderLow = 1.0,
                                  .sliderHigh = 500.0,
                                  .step = 5.0,
                                  .decimals = 0,
                                  .isLogarithmic = true})
            .when(spraying),
        field(&S::through, {.key = "through",
                            .label = QT_TRANSLATE_NOOP("Fields", "Also hidden"),
                            .tip = QT_TRANSLATE_NOOP(
                                "Fields", "Also characters hidden behind others or the stage"),
                            .doc = "Also those hidden behind others."})
            .when([](const S& s, const C& c) {
                return hasReach(s) || createsOnSeats(c) ||
                       (s.find<CreateSettings>() && fillsArea(c));
            }),
        field(&S::buildUp,
              {.key = "build_up",
               .label = QT_TRANSLATE_NOOP("Fields", "Build up"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Each dab changes again whom it touches"),
               .isBeside = true})
            .when([](const S& s, const C&) { return canBuildUp(s); }),
        field(&S::flow, {.key = "flow",
                         .label = QT_TRANSLATE_NOOP("Fields", "Flow"),
                         .unit = " %",
                         .sliderLow = 1.0,
                         .sliderHigh = 100.0,
                         .step = 5.0,
                         .decimals = 0,
                         .shownScale = 100.0})
            .when([](const S& s, const C&) { return s.buildUp && canFlow(s); }),
        field(&S::pressureSize,
              {.key = "pressure_size",
               .label = QT_TRANSLATE_NOOP("Fields", "Pen: size"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The harder the pen presses, the larger")})
            .when(withCircle),
        field(&S::pressureRate,
              {.key = "pressure_rate",
               .label = QT_TRANSLATE_NOOP("Fields", "Pen: rate"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The harder the pen presses, the more"),
               .isBeside = true})
            .when(spraying),
        field(&S::distribution,
              {.key = "distribution",
               .label = QT_TRANSLATE_NOOP("Fields", "Frequency"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "How often low (left) to high values (right) come: draw it; a double "
                             "click makes all equal"),
               .doc = "16 weights over the range, for the random operator.",
               .high = 1e6}),
        field(&S::mask, {.key = "mask"}).when([](const S& s, const C&) { return hasReach(s); }));
}

} // namespace crowd::model
