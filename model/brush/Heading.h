// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <QtCore/QtGlobal>

#include "model/describe/Field.h"

namespace crowd::model {

/// Which way the created or the turned ones face. A seat's heading always wins at creation.
enum class HeadingMode : std::uint8_t {
    Direction,    ///< headingRadians
    Random,       ///< headingRadians ± spreadRadians, by the distribution
    AlongStroke,  ///< the way the pointer goes, on the ground
    TowardsPoint, ///< towardsPoint
    TowardsViewer ///< the camera
};

inline constexpr FieldChoice kHeadingModes[] = {
    {"DIRECTION", QT_TRANSLATE_NOOP("Fields", "A direction")},
    {"RANDOM", QT_TRANSLATE_NOOP("Fields", "Random")},
    {"ALONG_STROKE", QT_TRANSLATE_NOOP("Fields", "Along the stroke")},
    {"TOWARDS_POINT", QT_TRANSLATE_NOOP("Fields", "A point")},
    {"TOWARDS_VIEWER", QT_TRANSLATE_NOOP("Fields", "The viewer")}};

struct HeadingSettings
{
    HeadingMode mode = HeadingMode::Direction;
    float headingRadians = 0.0F;
    float spreadRadians = 3.14159265F; ///< to each side
    glm::vec3 towardsPoint{0.0F};
    /// Added where the heading follows something else (stroke, point, viewer): π faces away.
    float turnRadians = 0.0F;

    static constexpr auto fields();
    friend bool operator==(const HeadingSettings&, const HeadingSettings&) = default;
};

/// Whether the spread matters: drawn headings, and orientation brushes that draw around others.
[[nodiscard]] bool spreads(const HeadingSettings& heading, const FieldContext& context);

constexpr auto HeadingSettings::fields()
{
    constexpr double kFar = 1e6;
    constexpr double kDegrees = 57.29577951308232;
    using H = HeadingSettings;
    using C = FieldContext;
    const auto follows = [](const H& h, const C&) {
        return h.mode != HeadingMode::Direction && h.mode != HeadingMode::Random;
    };
    return std::tuple(
        field(&H::mode, {.key = "mode",
                         .label = QT_TRANSLATE_NOOP("Fields", "Towards"),
                         .choices = kHeadingModes,
                         .section = QT_TRANSLATE_NOOP("Fields", "Facing")}),
        field(&H::towardsPoint, {.key = "towards_point",
                                 .label = QT_TRANSLATE_NOOP("Fields", "The point to face"),
                                 .doc = "(x, y, z) in metres.",
                                 .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                 .low = -kFar,
                                 .high = kFar,
                                 .sliderLow = -100.0,
                                 .sliderHigh = 100.0,
                                 .step = 0.5,
                                 .decimals = 1,
                                 .role = FieldRole::Point,
                                 .isRemembered = false})
            .when([](const H& h, const C&) { return h.mode == HeadingMode::TowardsPoint; }),
        field(&H::headingRadians, {.key = "heading",
                                   .label = QT_TRANSLATE_NOOP("Fields", "Direction"),
                                   .doc = "Radians, 0 faces +Z.",
                                   .unit = "°",
                                   .low = -kFar,
                                   .high = kFar,
                                   .sliderLow = -180.0,
                                   .sliderHigh = 180.0,
                                   .step = 5.0,
                                   .decimals = 0,
                                   .shownScale = kDegrees,
                                   .role = FieldRole::Angle})
            .when([](const H& h, const C&) {
                return h.mode == HeadingMode::Direction || h.mode == HeadingMode::Random;
            }),
        field(&H::turnRadians, {.key = "turn",
                                .label = QT_TRANSLATE_NOOP("Fields", "Turned by"),
                                .doc = "Radians, added where the heading follows something else.",
                                .unit = "°",
                                .low = -kFar,
                                .high = kFar,
                                .sliderLow = -180.0,
                                .sliderHigh = 180.0,
                                .step = 5.0,
                                .decimals = 0,
                                .shownScale = kDegrees,
                                .role = FieldRole::Angle})
            .when(follows),
        field(&H::spreadRadians, {.key = "spread",
                                  .label = QT_TRANSLATE_NOOP("Fields", "Spread"),
                                  .doc = "Radians to each side.",
                                  .unit = "°",
                                  .low = -kFar,
                                  .high = kFar,
                                  .sliderLow = 0.0,
                                  .sliderHigh = 180.0,
                                  .step = 5.0,
                                  .decimals = 0,
                                  .shownScale = kDegrees,
                                  .role = FieldRole::Angle})
            .when(&spreads));
}

} // namespace crowd::model
