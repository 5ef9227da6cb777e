// SPDX-License-Identifier: MIT
#pragma once

#include <array>
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

/// How those who are related walk.
enum class RelationWalk : std::uint8_t {
    Own,      ///< as each likes
    Together, ///< along the same path, waiting for each other
    Behind,   ///< after the one from whom the relation goes
    Apart     ///< away from each other
};

/// "friends".
struct RelationKind
{
    RelationKindId id = 0;
    std::string name;
    PaintColor color{150, 150, 150}; ///< of its arcs
    bool isMutual = true;            ///< else from one to the other alone
    RelationWalk walk = RelationWalk::Own;
    float walkMetres = 2.0F;            ///< Behind: how near; Apart: how far
    bool facesEachOther = false;        ///< where they stand near
    float faceMetres = 2.5F;            ///< how near that is
    bool passesEvents = false;          ///< an event that one hears the others hear too
    ValueRange passSeconds{0.3F, 0.9F}; ///< later; drawn each time
    bool sharesFeatures = false;        ///< what is painted on one, the others take on too
    bool sharesColors = false;          ///< likewise
    std::string unknownMembers{};       ///< see Scene::unknownMembers

    static constexpr auto fields();
    /// Whether people do something of it by themselves while it plays.
    [[nodiscard]] bool isActive() const
    {
        return facesEachOther || walk == RelationWalk::Behind || walk == RelationWalk::Apart;
    }
    friend bool operator==(const RelationKind&, const RelationKind&) = default;
};

using RelationKinds = std::vector<RelationKind>;

/// What a scene begins with: family, friends, couple, leader, rivals.
[[nodiscard]] const RelationKinds& readyRelations();

[[nodiscard]] const RelationKind* findRelation(const RelationKinds& kinds, std::string_view name);
[[nodiscard]] const RelationKind* findRelation(const RelationKinds& kinds, RelationKindId id);
/// The one behind the last, else the smallest that no kind has; 0: there are as many as there can
/// be.
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

inline constexpr std::array kRelationWalks{
    FieldChoice{"own", QT_TRANSLATE_NOOP("Fields", "As each likes")},
    FieldChoice{"together", QT_TRANSLATE_NOOP("Fields", "Together"),
                QT_TRANSLATE_NOOP("Fields", "Who walk the same path keep beside each other where "
                                            "there is room, and wait for each other")},
    FieldChoice{"behind", QT_TRANSLATE_NOOP("Fields", "Behind"),
                QT_TRANSLATE_NOOP("Fields", "Who has no path of his own follows the one from whom "
                                            "the relation goes")},
    FieldChoice{"apart", QT_TRANSLATE_NOOP("Fields", "Apart"),
                QT_TRANSLATE_NOOP("Fields", "Who walk give each other a wide berth")}};

constexpr auto RelationKind::fields()
{
    using S = RelationKind;
    using C = FieldContext;
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
        field(&S::walk, {.key = "walk",
                         .label = QT_TRANSLATE_NOOP("Fields", "Walk"),
                         .doc = "how those who are related walk",
                         .choices = kRelationWalks,
                         .section = QT_TRANSLATE_NOOP("Fields", "While it plays")}),
        field(&S::walkMetres, {.key = "walk_metres",
                               .label = QT_TRANSLATE_NOOP("Fields", "Distance"),
                               .doc = "behind: how near they come; apart: how far they keep",
                               .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                               .low = 0.5,
                               .high = 100.0,
                               .sliderLow = 0.5,
                               .sliderHigh = 10.0,
                               .step = 0.5,
                               .decimals = 1})
            .when([](const S& s, const C&) {
                return s.walk == RelationWalk::Behind || s.walk == RelationWalk::Apart;
            }),
        field(&S::facesEachOther,
              {.key = "faces",
               .label = QT_TRANSLATE_NOOP("Fields", "Face each other"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Who stand near each other turn to each other"),
               .doc = "who stand near each other turn to each other"}),
        field(&S::faceMetres, {.key = "face_metres",
                               .label = QT_TRANSLATE_NOOP("Fields", "Within"),
                               .doc = "how near that is",
                               .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                               .low = 0.5,
                               .high = 50.0,
                               .sliderLow = 0.5,
                               .sliderHigh = 10.0,
                               .step = 0.5,
                               .decimals = 1})
            .when([](const S& s, const C&) { return s.facesEachOther; }),
        field(&S::passesEvents, {.key = "passes_events",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Pass events on"),
                                 .tip = QT_TRANSLATE_NOOP(
                                     "Fields", "An event that one hears the others hear a little "
                                               "later, and so on from one to the next"),
                                 .doc = "an event that one hears those related to him hear later"}),
        field(&S::passSeconds, {.key = "pass_seconds",
                                .label = QT_TRANSLATE_NOOP("Fields", "Delay"),
                                .doc = "how much later, drawn each time",
                                .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                                .high = 3600.0,
                                .sliderLow = 0.0,
                                .sliderHigh = 5.0,
                                .step = 0.1})
            .when([](const S& s, const C&) { return s.passesEvents; }),
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
