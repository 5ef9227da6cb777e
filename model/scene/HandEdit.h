// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "model/describe/Field.h"
#include "model/scene/Timeline.h"

/// What is done by hand to people of a kept take. Plain values, part of the take.
namespace crowd::model {

/// Saved by the keys of kHandEdits.
enum class HandEditKind : std::uint8_t {
    Shift, ///< does everything later, or earlier
    Pace,  ///< does it slower or faster for a while, or stands still
    Aside, ///< goes beside his way
    Hide,  ///< is not seen
    Swap   ///< is somebody else, of another template
};

inline constexpr double kMostShift = 3600.0; ///< seconds
inline constexpr double kFastestPace = 4.0;  ///< times as fast
inline constexpr double kMostAside = 100.0;  ///< metres
/// Of one take.
inline constexpr std::size_t kMostHandEdits = 200;

/// Something that some people of a take do otherwise than it has them, over whatever it has: also
/// over what they do when they are taken again. Edits of the same people add up, in any order.
struct HandEdit
{
    HandEditKind kind = HandEditKind::Pace;
    bool isOn = true;
    /// Whom it is for, ascending; they may be gone.
    std::vector<int> people;
    /// When, by the clock; of all but Shift. An end that is not after the beginning: to the end of
    /// the take.
    double begin = 0.0;
    double end = 0.0;
    double later = 0.0; ///< seconds, of Shift; below 0: earlier
    float pace = 0.5F;  ///< times as fast, of Pace; 0: stands still
    float aside = 1.0F; ///< metres to the right of where he looks when it begins, of Aside
    /// Ids of those that they are of meanwhile, of Swap: of several each is of one, always the
    /// same.
    std::vector<int> templates{};
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    static bool isTimed(const HandEdit& edit, const FieldContext&)
    {
        return edit.kind != HandEditKind::Shift;
    }
    friend bool operator==(const HandEdit&, const HandEdit&) = default;
};

inline constexpr std::array kHandEdits{
    FieldChoice{"shift", QT_TRANSLATE_NOOP("Fields", "later or earlier"),
                QT_TRANSLATE_NOOP("Fields", "Everything that they do, by some seconds")},
    FieldChoice{"pace", QT_TRANSLATE_NOOP("Fields", "slower or faster"),
                QT_TRANSLATE_NOOP("Fields", "For a while; they are late, or early, from then on")},
    FieldChoice{"aside", QT_TRANSLATE_NOOP("Fields", "beside their way"),
                QT_TRANSLATE_NOOP("Fields", "To the right or to the left")},
    FieldChoice{"hide", QT_TRANSLATE_NOOP("Fields", "hidden"),
                QT_TRANSLATE_NOOP("Fields", "Nobody sees them for a while")},
    FieldChoice{"swap", QT_TRANSLATE_NOOP("Fields", "somebody else"),
                QT_TRANSLATE_NOOP("Fields", "Of another template, doing what they do")}};

constexpr auto HandEdit::fields()
{
    using C = FieldContext;
    return std::tuple(
        field(&HandEdit::kind, {.key = "kind",
                                .label = QT_TRANSLATE_NOOP("Fields", "They are"),
                                .doc = "what is done to them",
                                .choices = kHandEdits}),
        field(&HandEdit::isOn, {.key = "on", .doc = "whether it counts"}),
        field(&HandEdit::people, {.key = "people",
                                  .doc = "ids of those whom it is for",
                                  .low = 1.0,
                                  .high = 2147483647.0}),
        field(&HandEdit::later, {.key = "later",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Later by"),
                                 .tip = QT_TRANSLATE_NOOP("Fields", "Less than nothing: earlier"),
                                 .doc = "seconds, of \"shift\"; below 0: earlier",
                                 .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                                 .low = -kMostShift,
                                 .high = kMostShift,
                                 .sliderLow = -10.0,
                                 .sliderHigh = 10.0,
                                 .decimals = 2})
            .when([](const HandEdit& s, const C&) { return s.kind == HandEditKind::Shift; }),
        field(&HandEdit::pace, {.key = "pace",
                                .label = QT_TRANSLATE_NOOP("Fields", "Pace"),
                                .tip = QT_TRANSLATE_NOOP("Fields", "100 %: as it was; 0 %: they "
                                                                   "stand still"),
                                .doc = "times as fast as it was, of \"pace\"; 0: they stand still",
                                .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                                .high = kFastestPace,
                                .sliderHigh = 2.0,
                                .step = 0.05,
                                .decimals = 0,
                                .shownScale = 100.0})
            .when([](const HandEdit& s, const C&) { return s.kind == HandEditKind::Pace; }),
        field(&HandEdit::aside, {.key = "aside",
                                 .label = QT_TRANSLATE_NOOP("Fields", "To the right by"),
                                 .tip = QT_TRANSLATE_NOOP("Fields", "Less than nothing: to the "
                                                                    "left"),
                                 .doc = "metres to the right of where each looks when it begins, "
                                        "of \"aside\"; below 0: to the left",
                                 .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                 .low = -kMostAside,
                                 .high = kMostAside,
                                 .sliderLow = -5.0,
                                 .sliderHigh = 5.0,
                                 .decimals = 2})
            .when([](const HandEdit& s, const C&) { return s.kind == HandEditKind::Aside; }),
        field(&HandEdit::templates,
              {.key = "templates",
               .label = QT_TRANSLATE_NOOP("Fields", "Of template"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Of several, each is of one"),
               .doc = "ids of the templates that they are of meanwhile, of \"swap\"",
               .high = 65535.0,
               .role = FieldRole::Template,
               .zero = QT_TRANSLATE_NOOP("Fields", "none chosen")})
            .when([](const HandEdit& s, const C&) { return s.kind == HandEditKind::Swap; }),
        field(&HandEdit::begin, {.key = "begin",
                                 .label = QT_TRANSLATE_NOOP("Fields", "From"),
                                 .tip = QT_TRANSLATE_NOOP("Fields", "By the clock"),
                                 .doc = "seconds of the clock, of all but \"shift\"",
                                 .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                                 .low = -kLatestMark,
                                 .high = kLatestMark,
                                 .sliderLow = 0.0,
                                 .sliderHigh = 120.0,
                                 .decimals = 2})
            .when(&HandEdit::isTimed),
        field(&HandEdit::end, {.key = "end",
                               .label = QT_TRANSLATE_NOOP("Fields", "Until"),
                               .tip = QT_TRANSLATE_NOOP("Fields", "Not after the beginning: to "
                                                                  "the end of the take"),
                               .doc = "seconds of the clock, of all but \"shift\"; not after the "
                                      "beginning: to the end of the take",
                               .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                               .low = -kLatestMark,
                               .high = kLatestMark,
                               .sliderLow = 0.0,
                               .sliderHigh = 120.0,
                               .decimals = 2})
            .when(&HandEdit::isTimed));
}

} // namespace crowd::model
