// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model {

/// What an action can set of somebody while a session runs.
enum class SettableProperty : std::uint8_t {
    Tint,          ///< of a slot
    Height,        ///< value: scale
    PlaybackSpeed, ///< value: of the clip that they have while they stand or sit
    Clip,          ///< that they have while they stand or sit: one of the clips, by weight
    Phase          ///< value: where they are in that clip now, 0..1
};

inline constexpr std::array kSettableProperties{
    FieldChoice{"tint", QT_TRANSLATE_NOOP("Rules", "colour")},
    FieldChoice{"height", QT_TRANSLATE_NOOP("Rules", "height")},
    FieldChoice{"playback speed", QT_TRANSLATE_NOOP("Rules", "playback speed")},
    FieldChoice{"clip", QT_TRANSLATE_NOOP("Rules", "clip while at rest")},
    FieldChoice{"phase", QT_TRANSLATE_NOOP("Rules", "place in that clip")}};

} // namespace crowd::model

namespace crowd::model::actions {

struct SetProperty
{
    static constexpr KindText kText{
        .key = "set property",
        .name = QT_TRANSLATE_NOOP("Rules", "change a property"),
        .doc = "Sets a property for the rest of the session; Keep Pose puts it into the scene."};

    SettableProperty property = SettableProperty::Tint;
    std::string slot; ///< Tint: by name; empty: all tintable slots
    PaintColor color{200, 60, 60};
    std::uint8_t strength = 255;   ///< of the colour
    float value = 0.0F;            ///< Height, PlaybackSpeed, Phase
    std::vector<ClipWeight> clips; ///< Clip

    static constexpr auto fields()
    {
        return std::tuple(
            computed<SetProperty, SettableProperty>(
                [](const SetProperty& s) { return s.property; },
                [](SetProperty& s, SettableProperty wanted) {
                    s.property = wanted;
                    s.suit();
                },
                {.key = "property", .choices = kSettableProperties}),
            field(&SetProperty::property,
                  {.key = "property", .doc = "which", .choices = kSettableProperties})
                .when([](const SetProperty&, const FieldContext&) { return false; }),
            field(&SetProperty::slot, {.key = "slot",
                                       .doc = "of tint: its name; empty: all that can be tinted",
                                       .role = FieldRole::Slot,
                                       .zero = QT_TRANSLATE_NOOP("Rules", "all that can be")})
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Tint;
                }),
            field(&SetProperty::color,
                  {.key = "color",
                   .label = QT_TRANSLATE_NOOP("Rules", "to"),
                   .tip = QT_TRANSLATE_NOOP("Rules", "The colour; how much of it beside"),
                   .doc = "of tint, sRGB",
                   .isBeside = true})
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Tint;
                }),
            field(&SetProperty::strength,
                  rulefields::numeric({.doc = "of tint: how much of the colour, 0 to 255",
                                       .unit = QT_TRANSLATE_NOOP("Rules", " %"),
                                       .sliderLow = 0.0,
                                       .sliderHigh = 100.0,
                                       .decimals = 2,
                                       .shownScale = 100.0 / 255.0,
                                       .isBeside = true},
                                      "strength", 0.0, 255.0))
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Tint;
                }),
            field(&SetProperty::value,
                  rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                     .doc = "of height, playback speed and phase",
                                     .unit = QT_TRANSLATE_NOOP("Rules", " ×"),
                                     .sliderLow = 0.05,
                                     .sliderHigh = 20.0}))
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Height;
                }),
            field(&SetProperty::value, rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                                          .unit = QT_TRANSLATE_NOOP("Rules", " ×"),
                                                          .sliderLow = 0.0,
                                                          .sliderHigh = 100.0}))
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::PlaybackSpeed;
                }),
            field(&SetProperty::value, rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                                          .sliderLow = 0.0,
                                                          .sliderHigh = 1.0}))
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Phase;
                }),
            field(&SetProperty::clips,
                  rulefields::clips({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                     .doc = "of clip: those drawn from, with their weights"}))
                .when([](const SetProperty& s, const FieldContext&) {
                    return s.property == SettableProperty::Clip;
                }));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<SetProperty>{QT_TRANSLATE_NOOP("Rules", "turn {color}"),
                                  [](const SetProperty& s) {
                                      return s.property == SettableProperty::Tint && s.slot.empty();
                                  }},
            Sentence<SetProperty>{
                QT_TRANSLATE_NOOP("Rules", "turn {color} at {slot}"),
                [](const SetProperty& s) { return s.property == SettableProperty::Tint; }},
            Sentence<SetProperty>{
                QT_TRANSLATE_NOOP("Rules", "become {value} × as tall"),
                [](const SetProperty& s) { return s.property == SettableProperty::Height; }},
            Sentence<SetProperty>{
                QT_TRANSLATE_NOOP("Rules", "move {value} × as fast"),
                [](const SetProperty& s) { return s.property == SettableProperty::PlaybackSpeed; }},
            Sentence<SetProperty>{
                QT_TRANSLATE_NOOP("Rules", "from now on {clips}"),
                [](const SetProperty& s) { return s.property == SettableProperty::Clip; }},
            Sentence<SetProperty>{QT_TRANSLATE_NOOP("Rules", "go to {value} of their clip")}};
    }
    void suit() { value = property == SettableProperty::Phase ? 0.0F : 1.0F; }
    [[nodiscard]] Tint tint() const { return {color[0], color[1], color[2], strength}; }
    friend bool operator==(const SetProperty&, const SetProperty&) = default;
};

} // namespace crowd::model::actions
