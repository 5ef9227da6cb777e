// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"
#include "model/scene/Path.h"

namespace crowd::model {

/// Of the brushes that add places.
struct PlaceSettings
{
    float radiusMetres = 1.5F;
    bool anywhere = true; ///< also where nobody can walk to

    static void prepare(BrushSettings& brush);
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    friend bool operator==(const PlaceSettings&, const PlaceSettings&) = default;
};

/// Adds places to a path.
struct PathSettings : PlaceSettings
{
    PathKind kind = PathKind::Simple; ///< of new paths

    static const BrushInfo kInfo;
    static constexpr auto fields();
    friend bool operator==(const PathSettings&, const PathSettings&) = default;
};

/// Adds places that act by themselves.
struct EnvironmentSettings : PlaceSettings
{
    PlaceRole role = PlaceRole::Obstacle;
    PlaceShape shape = PlaceShape::Round;
    float widthMetres = 0.3F; ///< of lines

    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);

    static const BrushInfo kInfo;
    static constexpr auto fields();
    friend bool operator==(const EnvironmentSettings&, const EnvironmentSettings&) = default;
};

inline constexpr BrushInfo PathSettings::kInfo{
    .id = "path",
    .name = QT_TRANSLATE_NOOP("Tools", "Path Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Path"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Paint places on the ground that make a path"),
    .shortcut = "P",
    .order = 80,
    .section = BrushSection::Way,
    .family = StrokeFamily::Places,
    .note = QT_TRANSLATE_NOOP("Fields",
                              "Each click adds a place; Enter, Escape or a double click ends "
                              "the path, a click on its first place closes it. The next click "
                              "begins another one.")};

inline constexpr BrushInfo EnvironmentSettings::kInfo{
    .id = "environment",
    .name = QT_TRANSLATE_NOOP("Tools", "Environment Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "En&vironment"),
    .tip = QT_TRANSLATE_NOOP(
        "Actions", "Paint obstacles, attractors, exits, slow, forbidden and liked ground"),
    .shortcut = "I",
    .order = 110,
    .section = BrushSection::Way,
    .family = StrokeFamily::Places,
    .note = QT_TRANSLATE_NOOP("Fields", "Each click puts one there."),
    .cornersNote = QT_TRANSLATE_NOOP(
        "Fields", "Each click adds a corner, a drag draws freely; Enter or a double click ends "
                  "it, a click on the first corner closes it.")};

inline constexpr FieldChoice kPathKinds[] = {
    {"simple", QT_TRANSLATE_NOOP("Fields", "Stop")},
    {"cyclic", QT_TRANSLATE_NOOP("Fields", "On to the first place")},
    {"teleport", QT_TRANSLATE_NOOP("Fields", "Jump to the first place")}};

inline constexpr FieldChoice kPlaceRoles[] = {
    {"spot", QT_TRANSLATE_NOOP("Fields", "Place"),
     QT_TRANSLATE_NOOP("Fields", "Somewhere to go to; does nothing by itself")},
    {"obstacle", QT_TRANSLATE_NOOP("Fields", "Obstacle"),
     QT_TRANSLATE_NOOP("Fields", "Nobody walks into it")},
    {"attractor", QT_TRANSLATE_NOOP("Fields", "Attractor"),
     QT_TRANSLATE_NOOP("Fields", "Draws those who walk near it")},
    {"repeller", QT_TRANSLATE_NOOP("Fields", "Repeller"),
     QT_TRANSLATE_NOOP("Fields", "Those who walk near it keep away")},
    {"exit", QT_TRANSLATE_NOOP("Fields", "Exit"),
     QT_TRANSLATE_NOOP("Fields", "Who reaches it leaves the scene")},
    {"slow", QT_TRANSLATE_NOOP("Fields", "Slow ground"),
     QT_TRANSLATE_NOOP("Fields", "Characters walk slower there")},
    {"forbidden", QT_TRANSLATE_NOOP("Fields", "Forbidden ground"),
     QT_TRANSLATE_NOOP("Fields", "Nobody walks there; ways lead around it")},
    {"preferred", QT_TRANSLATE_NOOP("Fields", "Liked ground"),
     QT_TRANSLATE_NOOP("Fields", "Ways lead over it where that is not much longer")}};

inline constexpr FieldChoice kPlaceShapes[] = {
    {"round", QT_TRANSLATE_NOOP("Fields", "Round"), QT_TRANSLATE_NOOP("Fields", "A disc")},
    {"line", QT_TRANSLATE_NOOP("Fields", "Line"),
     QT_TRANSLATE_NOOP("Fields", "A wall, a fence, a kerb: from corner to corner")},
    {"area", QT_TRANSLATE_NOOP("Fields", "Area"),
     QT_TRANSLATE_NOOP("Fields", "All that its corners enclose")}};

namespace detail {

template<class S>
constexpr auto placeRadiusField()
{
    return field<S, float>(&S::radiusMetres, {.key = "radius",
                                              .label = QT_TRANSLATE_NOOP("Fields", "Radius"),
                                              .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                              .low = kMinPlaceRadius,
                                              .high = kMaxPlaceRadius,
                                              .sliderLow = 0.1,
                                              .sliderHigh = 50.0,
                                              .step = 0.25,
                                              .isLogarithmic = true});
}

template<class S>
constexpr auto placeAnywhereField()
{
    return field<S, bool>(
        &S::anywhere, {.key = "anywhere",
                       .label = QT_TRANSLATE_NOOP("Fields", "Anywhere"),
                       .tip = QT_TRANSLATE_NOOP(
                           "Fields", "Also on roofs, trees and wherever else nobody can walk to")});
}

} // namespace detail

constexpr auto PathSettings::fields()
{
    return std::tuple(
        detail::placeRadiusField<PathSettings>(), detail::placeAnywhereField<PathSettings>(),
        field(&PathSettings::kind, {.key = "at_the_end",
                                    .label = QT_TRANSLATE_NOOP("Fields", "At the end"),
                                    .choices = kPathKinds}));
}

constexpr auto EnvironmentSettings::fields()
{
    using S = EnvironmentSettings;
    using C = FieldContext;
    // Lines and areas may go anywhere: a fence begins at a house.
    const auto isRound = [](const S& s, const C&) { return s.shape == PlaceShape::Round; };
    const auto isLine = [](const S& s, const C&) { return s.shape == PlaceShape::Line; };
    return std::tuple(field(&S::role, {.key = "role",
                                       .label = QT_TRANSLATE_NOOP("Fields", "What"),
                                       .choices = kPlaceRoles}),
                      field(&S::shape, {.key = "shape",
                                        .label = QT_TRANSLATE_NOOP("Fields", "Shape"),
                                        .choices = kPlaceShapes}),
                      detail::placeRadiusField<S>().when(isRound),
                      detail::placeAnywhereField<S>().when(isRound),
                      field(&S::widthMetres, {.key = "width",
                                              .label = QT_TRANSLATE_NOOP("Fields", "Width"),
                                              .doc = "of a line",
                                              .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                              .low = 2.0 * kMinPlaceRadius,
                                              .high = 2.0 * kMaxPlaceRadius,
                                              .sliderLow = 0.1,
                                              .sliderHigh = 5.0,
                                              .step = 0.1,
                                              .isLogarithmic = true})
                          .when(isLine));
}

} // namespace crowd::model
