// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model {

/// What a condition can compare.
enum class ComparedProperty : std::uint8_t {
    Height,        ///< scale
    Girth,         ///< scale
    PlaybackSpeed, ///< of the clip that they have while they stand or sit
    WalkSpeed,     ///< that they would like to walk with, m/s
    Clip           ///< the one that is seen is the one named
};

inline constexpr std::array kComparedProperties{
    FieldChoice{"height", QT_TRANSLATE_NOOP("Rules", "height")},
    FieldChoice{"girth", QT_TRANSLATE_NOOP("Rules", "girth")},
    FieldChoice{"playback speed", QT_TRANSLATE_NOOP("Rules", "playback speed")},
    FieldChoice{"walk speed", QT_TRANSLATE_NOOP("Rules", "walking speed")},
    FieldChoice{"clip", QT_TRANSLATE_NOOP("Rules", "clip")}};

} // namespace crowd::model

namespace crowd::model::conditions {

struct Property
{
    static constexpr KindText kText{.key = "property",
                                    .name = QT_TRANSLATE_NOOP("Rules", "property"),
                                    .doc = "A property of his, compared.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone =
                                        QT_TRANSLATE_NOOP("Rules", "one of their properties is…")};

    ComparedProperty property = ComparedProperty::Height;
    std::string clip{}; ///< Clip
    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Property::property,
                  {.key = "property", .doc = "which", .choices = kComparedProperties}),
            field(&Property::clip,
                  {.key = "clip", .doc = "of the property clip: its name", .role = FieldRole::Clip})
                .when([](const Property& s, const FieldContext&) { return s.isClip(); }),
            field(&Property::comparison, rulefields::comparison())
                .when([](const Property& s, const FieldContext&) { return !s.isClip(); }),
            field(&Property::value, rulefields::value({.doc = "that it is compared with",
                                                       .unit = QT_TRANSLATE_NOOP("Rules", " ×"),
                                                       .isBeside = true}))
                .when([](const Property& s, const FieldContext&) {
                    return !s.isClip() && s.property != ComparedProperty::WalkSpeed;
                }),
            field(&Property::value, rulefields::value({.doc = "that it is compared with",
                                                       .unit = QT_TRANSLATE_NOOP("Rules", " m/s"),
                                                       .isBeside = true}))
                .when([](const Property& s, const FieldContext&) {
                    return s.property == ComparedProperty::WalkSpeed;
                }));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Property>{QT_TRANSLATE_NOOP("Rules", "showing {clip}"),
                               [](const Property& s) { return s.isClip(); },
                               QT_TRANSLATE_NOOP("Rules", "not showing {clip}")},
            Sentence<Property>{QT_TRANSLATE_NOOP("Rules", "{property} below {value}"),
                               [](const Property& s) { return s.comparison == Comparison::Less; },
                               QT_TRANSLATE_NOOP("Rules", "{property} not below {value}")},
            Sentence<Property>{QT_TRANSLATE_NOOP("Rules", "{property} at {value}"),
                               [](const Property& s) { return s.comparison == Comparison::Equal; },
                               QT_TRANSLATE_NOOP("Rules", "{property} not at {value}")},
            Sentence<Property>{QT_TRANSLATE_NOOP("Rules", "{property} above {value}"), nullptr,
                               QT_TRANSLATE_NOOP("Rules", "{property} not above {value}")}};
    }
    [[nodiscard]] constexpr bool isClip() const { return property == ComparedProperty::Clip; }
    friend bool operator==(const Property&, const Property&) = default;
};

} // namespace crowd::model::conditions
