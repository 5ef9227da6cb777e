// SPDX-License-Identifier: MIT
#include "model/relations/RelatedPeople.h"

#include <algorithm>

#include "model/brush/IndividualEdits.h"

namespace crowd::model {

namespace {

void makeSet(std::vector<IndividualId>& ids)
{
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void copyRelations(SceneEdit& edit, std::span<const IndividualId> originals,
                   std::span<const IndividualId> copies)
{
    std::vector<Relation> made;
    for (std::size_t i = 0; i < originals.size(); ++i) {
        for (const RelationLink& link : edit.scene().relations.of(originals[i])) {
            const auto other = std::ranges::lower_bound(originals, link.other);
            if (link.isOut && other != originals.end() && *other == link.other) {
                const auto index = static_cast<std::size_t>(other - originals.begin());
                made.push_back({copies[i], copies[index], link.strength, link.kind});
            }
        }
    }
    edit.relate(made);
}

} // namespace

std::vector<Relation> relationsOf(const Scene& scene, std::span<const IndividualId> ids,
                                  RelationKindId kind)
{
    std::vector<Relation> found;
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            if (kind == 0 || link.kind == kind) {
                found.push_back(link.isOut ? Relation{id, link.other, link.strength, link.kind}
                                           : Relation{link.other, id, link.strength, link.kind});
            }
        }
    }
    return found;
}

std::vector<IndividualId> relatedTo(const Scene& scene, std::span<const IndividualId> ids,
                                    RelationKindId kind)
{
    std::vector<IndividualId> found;
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            const RelationKind* its = findRelation(scene.relationKinds, link.kind);
            const bool isMeant = kind == 0 || link.kind == kind;
            if (isMeant && its != nullptr && (its->isMutual || link.isOut)) {
                found.push_back(link.other);
            }
        }
    }
    makeSet(found);
    return found;
}

std::vector<IndividualId> withRelated(const Scene& scene, std::span<const IndividualId> ids,
                                      RelationKindId kind)
{
    std::vector<IndividualId> all(ids.begin(), ids.end());
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            if (kind == 0 || link.kind == kind) {
                all.push_back(link.other);
            }
        }
    }
    makeSet(all);
    return all;
}

std::vector<IndividualId> duplicate(SceneEdit& edit, std::span<const IndividualId> ids,
                                    const glm::vec3& offset)
{
    if (ids.empty()) {
        return {};
    }
    IndividualRows rows = edit.scene().population.rows(ids);
    for (glm::vec3& at : rows.column(columns::position)) {
        at += offset;
    }
    std::vector<IndividualId> copies = edit.addIndividuals(std::move(rows));
    standUp(edit, copies); // the seats stay the originals'
    copyRelations(edit, ids, copies);
    return copies;
}

} // namespace crowd::model
