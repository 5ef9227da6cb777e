// SPDX-License-Identifier: MIT
#include "model/scene/Relation.h"

#include <algorithm>

namespace crowd::model {

namespace {

RelationKind readyKind(RelationKindId id, const char* name, const PaintColor& color, bool isMutual)
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
    RelationKinds kinds{
        readyKind(1, QT_TRANSLATE_NOOP("Relations", "family"), {240, 180, 60}, true),
        readyKind(2, QT_TRANSLATE_NOOP("Relations", "friends"), {90, 190, 110}, true),
        readyKind(3, QT_TRANSLATE_NOOP("Relations", "couple"), {235, 110, 160}, true),
        readyKind(4, QT_TRANSLATE_NOOP("Relations", "leader"), {90, 160, 235}, false),
        readyKind(5, QT_TRANSLATE_NOOP("Relations", "rivals"), {225, 80, 60}, true)};
    for (const std::size_t close : {0U, 2U}) { // family and couple
        kinds[close].walk = RelationWalk::Together;
        kinds[close].facesEachOther = true;
        kinds[close].sharesFeatures = true;
    }
    kinds[1].facesEachOther = true;
    kinds[1].passesEvents = true;
    kinds[3].walk = RelationWalk::Behind;
    kinds[3].passesEvents = true;
    kinds[4].walk = RelationWalk::Apart;
    kinds[4].walkMetres = 4.0F;
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
    if (!kinds.empty()) {
        const RelationKindId last = std::ranges::max(kinds, {}, &RelationKind::id).id;
        if (last < kMostRelationKinds) {
            return static_cast<RelationKindId>(last + 1); // a new one comes behind the others
        }
    }
    for (std::size_t id = 1; id <= kMostRelationKinds; ++id) {
        if (findRelation(kinds, static_cast<RelationKindId>(id)) == nullptr) {
            return static_cast<RelationKindId>(id);
        }
    }
    return 0;
}

} // namespace crowd::model
