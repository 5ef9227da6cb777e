// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include <QtCore/QtGlobal>
#include <glm/vec3.hpp>

#include "model/describe/Field.h"

/// How people take on a state while it plays: over some time, one after the other.
namespace crowd::model {

/// Who begins when.
enum class StaggerOrder : std::uint8_t {
    Distance, ///< like a ring that grows on the ground
    Heading,  ///< like a line that moves on across the ground
    Row,      ///< from the front to the back; who has no seat begins at once
    Wedge,    ///< from the lowest number to the highest; who has no seat begins at once
    Random
};

inline constexpr double kLongestRecall = 600.0; ///< seconds

/// People begin one after the other. World frame.
struct Stagger
{
    float seconds = 0.0F; ///< from the first to the last; 0: all together
    StaggerOrder order = StaggerOrder::Distance;
    glm::vec3 point{0.0F};       ///< metres; of Distance
    float headingRadians = 0.0F; ///< of Heading

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Stagger::seconds,
                  {.key = "seconds",
                   .label = QT_TRANSLATE_NOOP("Fields", "The last begins after"),
                   .tip = QT_TRANSLATE_NOOP("Fields", "0: all begin at the same moment"),
                   .doc = "from the first who begins to the last; 0: all together",
                   .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                   .high = kLongestRecall,
                   .sliderHigh = 20.0}),
            field(&Stagger::order, {.key = "order",
                                    .label = QT_TRANSLATE_NOOP("Fields", "Order"),
                                    .doc = "who begins when",
                                    .choices = kOrders}),
            field(&Stagger::point, {.key = "point",
                                    .label = QT_TRANSLATE_NOOP("Fields", "From"),
                                    .doc = "metres; of `distance`",
                                    .low = -1e6,
                                    .high = 1e6,
                                    .sliderLow = -1000.0,
                                    .sliderHigh = 1000.0,
                                    .role = FieldRole::Point})
                .when([](const Stagger& s, const FieldContext& context) {
                    return isStaggered(s, context) && s.order == StaggerOrder::Distance;
                }),
            field(&Stagger::headingRadians, {.key = "heading",
                                             .doc = "radians; of `heading`, in which it moves on",
                                             .low = -1e6,
                                             .high = 1e6,
                                             .role = FieldRole::Angle}));
    }
    static bool isStaggered(const Stagger& stagger, const FieldContext& /*context*/)
    {
        return stagger.seconds > 0.0F;
    }
    static constexpr std::array kOrders{
        FieldChoice{"distance", QT_TRANSLATE_NOOP("Fields", "from a point"),
                    QT_TRANSLATE_NOOP("Fields", "Like a ring that grows on the ground")},
        FieldChoice{"heading", QT_TRANSLATE_NOOP("Fields", "along the view"),
                    QT_TRANSLATE_NOOP("Fields", "Who is near in the picture begins")},
        FieldChoice{"row", QT_TRANSLATE_NOOP("Fields", "row by row"),
                    QT_TRANSLATE_NOOP("Fields", "From the front seats to the last row")},
        FieldChoice{"wedge", QT_TRANSLATE_NOOP("Fields", "block by block"),
                    QT_TRANSLATE_NOOP("Fields", "From one wedge of seats to the next")},
        FieldChoice{"random", QT_TRANSLATE_NOOP("Fields", "at random")}};
    friend bool operator==(const Stagger&, const Stagger&) = default;
};

struct RecallTiming
{
    float seconds = 0.0F; ///< that each takes
    Stagger stagger;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&RecallTiming::seconds,
                  {.key = "seconds",
                   .label = QT_TRANSLATE_NOOP("Fields", "Each takes"),
                   .tip = QT_TRANSLATE_NOOP("Fields", "Clips fade into each other, colours and "
                                                      "sizes run, while it plays"),
                   .doc = "that each takes",
                   .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                   .high = kLongestRecall,
                   .sliderHigh = 10.0}),
            field(&RecallTiming::stagger, {.key = "stagger", .doc = "one after the other"}));
    }
    /// Nobody is seen in between.
    [[nodiscard]] bool isAtOnce() const { return seconds <= 0.0F && stagger.seconds <= 0.0F; }
    friend bool operator==(const RecallTiming&, const RecallTiming&) = default;
};

} // namespace crowd::model
