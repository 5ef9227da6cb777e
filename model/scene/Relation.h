// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/scene/RelationTable.h"

/// Kinds of relations between people, in words of the artist. Plain values, part of the scene; who
/// is related to whom is in its RelationTable.
namespace crowd::model {

inline constexpr std::size_t kMostRelationKinds = 64;

/// "friends".
struct RelationKind
{
    RelationKindId id = 0;
    std::string name;
    PaintColor color{150, 150, 150}; ///< of its arcs
    bool isMutual = true;            ///< else from one to the other alone
    bool sharesFeatures = false;     ///< what is painted on one, the others take on too
    bool sharesColors = false;       ///< likewise
    std::string unknownMembers{};    ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const RelationKind&, const RelationKind&) = default;
};

using RelationKinds = std::vector<RelationKind>;

/// What a scene begins with: family, friends, couple, leader, rivals.
[[nodiscard]] const RelationKinds& readyRelations();

[[nodiscard]] const RelationKind* findRelation(const RelationKinds& kinds, std::string_view name);
[[nodiscard]] const RelationKind* findRelation(const RelationKinds& kinds, RelationKindId id);
/// The smallest that no kind has; 0: there are as many as there can be.
[[nodiscard]] RelationKindId freeRelationId(const RelationKinds& kinds);

/// As the table keeps it: a mutual one goes from the older to the younger.
[[nodiscard]] constexpr Relation canonical(const RelationKind& kind, Relation relation)
{
    if (kind.isMutual && relation.from > relation.to) {
        const IndividualId older = relation.to;
        relation.to = relation.from;
        relation.from = older;
    }
    return relation;
}

constexpr auto RelationKind::fields()
{
    using S = RelationKind;
    return std::tuple(
        field(&S::id, {.key = "id",
                       .doc = "what relations and rules have: of no other kind of the scene",
                       .low = 1.0,
                       .high = kMostRelationKinds}),
        field(&S::name, {.key = "name",
                         .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                         .doc = "as scripts and brushes call it"}),
        field(&S::color, {.key = "color",
                          .label = QT_TRANSLATE_NOOP("Fields", "Shown in"),
                          .doc = "of its arcs in the picture"}),
        field(&S::isMutual,
              {.key = "mutual",
               .label = QT_TRANSLATE_NOOP("Fields", "Mutual"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Else it goes from one to the other alone, as "
                                                  "from a leader to a follower"),
               .doc = "it goes both ways; else from one to the other alone"}),
        field(&S::sharesFeatures,
              {.key = "shares_features",
               .label = QT_TRANSLATE_NOOP("Fields", "Share features"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Whoever is related to somebody on whom an "
                                                  "emotion or an outfit is painted gets the same"),
               .doc = "what is painted of features on one, those related to him get too",
               .section = QT_TRANSLATE_NOOP("Fields", "When painted")}),
        field(&S::sharesColors,
              {.key = "shares_colors",
               .label = QT_TRANSLATE_NOOP("Fields", "Share colours"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Whoever is related to somebody who is coloured "
                                                  "gets the same colour"),
               .doc = "what is painted of colours on one, those related to him get too"}));
}

} // namespace crowd::model
