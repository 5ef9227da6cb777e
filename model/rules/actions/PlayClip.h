// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct PlayClip
{
    static constexpr KindText kText{.key = "play",
                                    .name = QT_TRANSLATE_NOOP("Rules", "play a clip"),
                                    .doc = "Plays one of the clips, drawn by weight."};

    std::vector<ClipWeight> clips;
    bool isLooped = false; ///< for `seconds`, else once
    float seconds = 3.0F;  ///< 0: until another rule comes

    static constexpr auto fields()
    {
        return std::tuple(
            field(&PlayClip::clips,
                  rulefields::clips(
                      {.doc = "with their weights; whoever has none of them goes on at once"})),
            field(&PlayClip::isLooped, {.key = "loop",
                                        .doc = "for so many seconds, else once",
                                        .choices = kOnceOrFor,
                                        .isBeside = true}),
            field(&PlayClip::seconds,
                  rulefields::seconds(
                      {.doc = "how long a loop goes on; 0: until another rule comes",
                       .isBeside = true,
                       .zero = QT_TRANSLATE_NOOP("Rules", "until something else comes")}))
                .when([](const PlayClip& s, const FieldContext&) { return s.isLooped; }));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<PlayClip>{
                              QT_TRANSLATE_NOOP("Rules", "play {clips} until something else comes"),
                              [](const PlayClip& s) { return s.isLooped && s.seconds <= 0.0F; }},
                          Sentence<PlayClip>{QT_TRANSLATE_NOOP("Rules", "play {clips}")}};
    }
    static constexpr std::array kOnceOrFor{FieldChoice{"false", QT_TRANSLATE_NOOP("Rules", "once")},
                                           FieldChoice{"true", QT_TRANSLATE_NOOP("Rules", "for")}};
    friend bool operator==(const PlayClip&, const PlayClip&) = default;
};

} // namespace crowd::model::actions
