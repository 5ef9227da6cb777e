// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"
#include "model/scene/LightCue.h"

namespace crowd::model {

inline constexpr std::array kLightDeeds{
    FieldChoice{"on", QT_TRANSLATE_NOOP("Rules", "switch on")},
    FieldChoice{"off", QT_TRANSLATE_NOOP("Rules", "switch off")},
    FieldChoice{"flash", QT_TRANSLATE_NOOP("Rules", "flash")},
    FieldChoice{"sweep", QT_TRANSLATE_NOOP("Rules", "sweep from side to side")}};

} // namespace crowd::model

namespace crowd::model::actions {

struct TellLight
{
    static constexpr KindText kText{.key = "light",
                                    .name = QT_TRANSLATE_NOOP("Rules", "tell a light"),
                                    .doc =
                                        "A light that stands in the scene goes on or off, flashes "
                                        "or sweeps, in this run alone. Once is enough, whoever "
                                        "says it."};

    std::uint32_t light = 0; ///< LightId
    LightDeed deed = LightDeed::On;
    float seconds = 1.0F; ///< that it takes

    static constexpr auto fields()
    {
        return std::tuple(
            field(&TellLight::light, rulefields::light({.doc = "its id"})),
            field(&TellLight::deed, {.key = "deed", .doc = "what it does", .choices = kLightDeeds}),
            field(&TellLight::seconds,
                  rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "over"),
                                       .doc = "that it takes; 0: at once",
                                       .zero = QT_TRANSLATE_NOOP("Rules", "at once")})));
    }
    [[nodiscard]] static constexpr bool isAtOnce(const TellLight& s, LightDeed deed)
    {
        return s.deed == deed && s.seconds <= 0.0F;
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<TellLight>{QT_TRANSLATE_NOOP("Rules", "switch the light “{light}” on"),
                                [](const TellLight& s) { return isAtOnce(s, LightDeed::On); }},
            Sentence<TellLight>{
                QT_TRANSLATE_NOOP("Rules", "switch the light “{light}” on over {seconds} s"),
                [](const TellLight& s) { return s.deed == LightDeed::On; }},
            Sentence<TellLight>{QT_TRANSLATE_NOOP("Rules", "switch the light “{light}” off"),
                                [](const TellLight& s) { return isAtOnce(s, LightDeed::Off); }},
            Sentence<TellLight>{
                QT_TRANSLATE_NOOP("Rules", "switch the light “{light}” off over {seconds} s"),
                [](const TellLight& s) { return s.deed == LightDeed::Off; }},
            Sentence<TellLight>{
                QT_TRANSLATE_NOOP("Rules", "let the light “{light}” flash for {seconds} s"),
                [](const TellLight& s) { return s.deed == LightDeed::Flash; }},
            Sentence<TellLight>{
                QT_TRANSLATE_NOOP("Rules", "let the light “{light}” sweep for {seconds} s")}};
    }
    friend bool operator==(const TellLight&, const TellLight&) = default;
};

} // namespace crowd::model::actions
