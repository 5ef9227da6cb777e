// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model {

/// What one to whom somebody is related does.
enum class RelatedDeed : std::uint8_t { Arrives, Leaves, Hears };

inline constexpr std::array kRelatedDeeds{
    FieldChoice{"arrives", QT_TRANSLATE_NOOP("Rules", "arrives at")},
    FieldChoice{"leaves", QT_TRANSLATE_NOOP("Rules", "leaves")},
    FieldChoice{"hears", QT_TRANSLATE_NOOP("Rules", "hears")}};

} // namespace crowd::model

namespace crowd::model::triggers {

struct RelatedDid
{
    static constexpr KindText kText{.key = "related did",
                                    .name =
                                        QT_TRANSLATE_NOOP("Rules", "one related does something"),
                                    .doc = "One to whom he is related, whichever way, arrives at a "
                                           "place, leaves it or hears an event. It comes from that "
                                           "one."};

    std::uint32_t relation = 0; ///< RelationKindId, 0: any
    RelatedDeed deed = RelatedDeed::Arrives;
    PlaceId place = 0;   ///< 0: any; kNotChosen
    std::string event{}; ///< Hears

    static constexpr auto fields()
    {
        constexpr auto isOfPlace = [](const RelatedDid& s, const FieldContext&) {
            return s.deed != RelatedDeed::Hears;
        };
        return std::tuple(
            field(&RelatedDid::relation, rulefields::relation({.doc = "by which; 0: any"})),
            field(&RelatedDid::deed, {.key = "deed",
                                      .doc = "what that one does",
                                      .choices = kRelatedDeeds,
                                      .isBeside = true}),
            field(&RelatedDid::place,
                  rulefields::place(
                      {.doc = "where; 0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any place")}))
                .when(isOfPlace),
            field(&RelatedDid::event, rulefields::event({.doc = "its name, of hears"}))
                .when([](const RelatedDid& s, const FieldContext&) {
                    return s.deed == RelatedDeed::Hears;
                }));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<RelatedDid>{
                QT_TRANSLATE_NOOP("Rules", "When one of someone’s {relation} arrives at {place}"),
                [](const RelatedDid& s) { return s.deed == RelatedDeed::Arrives; }},
            Sentence<RelatedDid>{
                QT_TRANSLATE_NOOP("Rules", "When one of someone’s {relation} leaves {place}"),
                [](const RelatedDid& s) { return s.deed == RelatedDeed::Leaves; }},
            Sentence<RelatedDid>{
                QT_TRANSLATE_NOOP("Rules", "When one of someone’s {relation} hears “{event}”")}};
    }
    friend bool operator==(const RelatedDid&, const RelatedDid&) = default;
};

} // namespace crowd::model::triggers
