// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Which part of a take people do again.
enum class RetakeStretch : std::uint8_t {
    PlayRange, ///< as the timeline has it; where it has none, as ToEnd
    ToEnd,     ///< from the moment shown
    ForSeconds ///< from the moment shown
};

inline constexpr FieldChoice kRetakeStretches[] = {
    {"RANGE", QT_TRANSLATE_NOOP("Fields", "The play range")},
    {"TO_END", QT_TRANSLATE_NOOP("Fields", "From now to the end")},
    {"SECONDS", QT_TRANSLATE_NOOP("Fields", "From now for a while")}};

inline constexpr float kShortestRetake = 0.2F;   ///< seconds
inline constexpr float kLongestRetake = 3600.0F; ///< seconds

/// Lets people of the take that is shown do a part of it again while everybody else does what he
/// did: another take comes of it. Changes nothing else of the document.
struct RetakeSettings
{
    RetakeStretch stretch = RetakeStretch::PlayRange;
    float seconds = 10.0F;   ///< of ForSeconds
    bool isDifferent = true; ///< else only what has been changed since makes a difference

    static constexpr bool kHasOperator = false;
    static const BrushInfo kInfo;
    static constexpr auto fields();
    friend bool operator==(const RetakeSettings&, const RetakeSettings&) = default;
};

inline constexpr BrushInfo RetakeSettings::kInfo{
    .id = "retake",
    .name = QT_TRANSLATE_NOOP("Tools", "Retake Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Reta&ke"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Let the characters under the brush do it again while all "
                                        "others do what they did in the take"),
    .shortcut = "Shift+A",
    .order = 160,
    .section = BrushSection::Mind,
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: choose who does it again; they begin when you "
                                           "let go"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters do it again…"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Retake %n character(s)"),
    .note = QT_TRANSLATE_NOOP(
        "Fields", "While a take is shown: those under the brush do this part of it "
                  "again, by the rules and properties that they have now. Everybody "
                  "else does what he did, and is avoided. The result is another take.")};

constexpr auto RetakeSettings::fields()
{
    using S = RetakeSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::stretch,
              {.key = "stretch",
               .label = QT_TRANSLATE_NOOP("Fields", "Which part"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The play range is set in the timeline; without "
                                                  "one it is from now to the end"),
               .doc = "Which part of the take.",
               .choices = kRetakeStretches,
               .section = QT_TRANSLATE_NOOP("Fields", "Retake")}),
        field(&S::seconds, {.key = "seconds",
                            .label = QT_TRANSLATE_NOOP("Fields", "Seconds"),
                            .doc = "Of SECONDS.",
                            .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                            .low = kShortestRetake,
                            .high = kLongestRetake,
                            .sliderLow = 1.0,
                            .sliderHigh = 60.0,
                            .decimals = 1})
            .when([](const S& s, const C&) { return s.stretch == RetakeStretch::ForSeconds; }),
        field(&S::isDifferent,
              {.key = "different",
               .label = QT_TRANSLATE_NOOP("Fields", "Different each time"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Chance falls otherwise each time. Off: only "
                                                  "what has been changed since makes a "
                                                  "difference.")}));
}

} // namespace crowd::model
