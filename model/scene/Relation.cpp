// SPDX-License-Identifier: MIT
#include "model/scene/Relation.h"

#include <algorithm>

namespace crowd::model {

namespace {

RelationKind kindOf(RelationKindId id, const char* name, const PaintColor& color, bool isMutual)
{
    RelationKind kind;
    kind.id = id;
    kind.name = name;
    kind.color = color;
    kind.isMutual = isMutual;
    return kind;
}

RelationKinds madeReady()
{
    RelationKinds kinds{kindOf(1, QT_TRANSLATE_NOOP("Relations", "family"), {240, 180, 60}, true),
                        kindOf(2, QT_TRANSLATE_NOOP("Relations", "friends"), {90, 190, 110}, true),
                        kindOf(3, QT_TRANSLATE_NOOP("Relations", "couple"), {235, 110, 160}, true),
                        kindOf(4, QT_TRANSLATE_NOOP("Relations", "leader"), {90, 160, 235}, false),
                        kindOf(5, QT_TRANSLATE_NOOP("Relations", "rivals"), {225, 80, 60}, true)};
    kinds[0].sharesFeatures = true;
    kinds[2].sharesFeatures = true;
    return kinds;
}

} // namespace

const RelationKinds& readyRelations()
{
    static const RelationKinds kReady = madeReady();
    return kReady;
}

const RelationKind* findRelation(const RelationKinds& kinds, std::string_view name)
{
    const auto found = std::ranges::find(kinds, name, &RelationKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

const RelationKind* findRelation(const RelationKinds& kinds, RelationKindId id)
{
    const auto found = std::ranges::find(kinds, id, &RelationKind::id);
    return found == kinds.end() ? nullptr : &*found;
}

RelationKindId freeRelationId(const RelationKinds& kinds)
{
    for (std::size_t id = 1; id <= kMostRelationKinds; ++id) {
        if (findRelation(kinds, static_cast<RelationKindId>(id)) == nullptr) {
            return static_cast<RelationKindId>(id);
        }
    }
    return 0;
}

} // namespace crowd::model
