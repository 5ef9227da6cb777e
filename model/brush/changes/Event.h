// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Lets an event happen to people of the running session; changes nothing of the document.
struct EventSettings
{
    std::string name = "cheer";
    float payload = 2.5F;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    friend bool operator==(const EventSettings&, const EventSettings&) = default;
};

inline constexpr BrushInfo EventSettings::kInfo{
    .id = "event",
    .name = QT_TRANSLATE_NOOP("Tools", "Event Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Event"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Let an event happen to the characters under the brush"),
    .shortcut = "E",
    .order = 120,
    .section = BrushSection::Mind,
    .hint =
        QT_TRANSLATE_NOOP("BrushTool", "Drag: let an event happen to characters · + −: its number"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters heard it"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Event reached %n character(s)"),
    .note = QT_TRANSLATE_NOOP("Fields",
                              "Characters under the brush hear the event while it plays. Rules say "
                              "what they do then; the number can be a walking speed.")};

constexpr auto EventSettings::fields()
{
    using S = EventSettings;
    return std::tuple(field(&S::name, {.key = "event",
                                       .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                                       .role = FieldRole::Event,
                                       .section = QT_TRANSLATE_NOOP("Fields", "Event")}),
                      field(&S::payload, {.key = "payload",
                                          .label = QT_TRANSLATE_NOOP("Fields", "Number"),
                                          .low = -1e6,
                                          .high = 1e6,
                                          .sliderLow = -10.0,
                                          .sliderHigh = 10.0,
                                          .decimals = 1}));
}

} // namespace crowd::model
