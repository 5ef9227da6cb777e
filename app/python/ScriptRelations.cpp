// SPDX-License-Identifier: MIT
#include "app/python/ScriptRelations.h"

#include <algorithm>
#include <cmath>

#include "app/python/ColumnRules.h"
#include "model/base/ShownText.h"
#include "model/relations/RelatedPeople.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr std::size_t kMostRelations = 8'000'000;

Result<void> checkThere(const Scene& scene, const std::vector<IndividualId>& ids)
{
    for (const IndividualId id : ids) {
        if (auto alive = checkAlive(scene, std::span(&id, 1)); !alive) {
            return alive;
        }
    }
    return {};
}

/// How many relations lists are of, one of which may stand for all.
Result<std::size_t> countOf(std::size_t from, std::size_t to, std::size_t strength)
{
    const std::size_t count =
        std::min({from, to, strength}) == 0 ? 0 : std::max({from, to, strength});
    for (const std::size_t each : {from, to, strength}) {
        if (each != count && each != 1 && count != 0) {
            return Error{"from_ids, to_ids and strength must be as long as each other, or one for "
                         "all: they are " +
                         std::to_string(from) + ", " + std::to_string(to) + " and " +
                         std::to_string(strength) + " long."};
        }
    }
    if (count > kMostRelations) {
        return Error{"Those are more than " + std::to_string(kMostRelations) +
                     " relations at once."};
    }
    return count;
}

template<class Item>
const Item& itemAt(const std::vector<Item>& items, std::size_t index)
{
    return items[items.size() == 1 ? 0 : index];
}

Result<std::vector<Relation>> relationsMeant(const RelationKind& kind, const GivenRelations& given)
{
    const auto count = countOf(given.from.size(), given.to.size(), given.strength.size());
    if (!count) {
        return count.error();
    }
    std::vector<Relation> relations;
    relations.reserve(count.value());
    for (std::size_t i = 0; i < count.value(); ++i) {
        const Relation next{itemAt(given.from, i), itemAt(given.to, i), itemAt(given.strength, i),
                            kind.id};
        if (!(next.strength >= 0.0F && next.strength <= 1.0F)) {
            return Error{"strength must lie from 0 to 1, not be " + std::to_string(next.strength) +
                         '.'};
        }
        if (next.from == next.to) {
            return Error{"Individual " + std::to_string(next.from) +
                         " cannot be related to itself."};
        }
        relations.push_back(next);
    }
    return relations;
}

/// From one to another; of a mutual one, either way.
bool goes(const Scene& scene, const Relation& relation, IndividualId from, IndividualId to)
{
    const RelationKind* kind = findRelation(scene.relationKinds, relation.kind);
    const bool isMutual = kind != nullptr && kind->isMutual;
    return (relation.from == from && relation.to == to) ||
           (isMutual && relation.from == to && relation.to == from);
}

/// 0 where no name is given.
Result<RelationKindId> kindNamed(const Scene& scene, const std::optional<std::string>& name)
{
    const RelationKind* kind = name ? findRelation(scene.relationKinds, *name) : nullptr;
    if (name && kind == nullptr) {
        return Error{noRelationText(scene.relationKinds, *name)};
    }
    return kind != nullptr ? kind->id : RelationKindId{0};
}

} // namespace

std::string noRelationText(const RelationKinds& kinds, const std::string& name)
{
    std::string names;
    for (const RelationKind& each : kinds) {
        names += (names.empty() ? "" : ", ") + shortened(each.name);
    }
    return "the scene has no relation \"" + shortened(name) +
           "\"; there are: " + (names.empty() ? "none yet" : names) + '.';
}

Result<std::size_t> relate(ScriptScene& script, const GivenRelations& given,
                           const std::string& name)
{
    std::size_t changed = 0;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        const RelationKind* kind = findRelation(now.relationKinds, name);
        if (kind == nullptr) {
            return Error{noRelationText(now.relationKinds, name)};
        }
        for (const auto* ids : {&given.from, &given.to}) {
            if (auto alive = checkThere(now, *ids); !alive) {
                return alive;
            }
        }
        const auto relations = relationsMeant(*kind, given);
        if (!relations) {
            return relations.error();
        }
        const RelationTable before = now.relations;
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Relate characters")),
                           [&](SceneEdit& open) {
                               open.relate(relations.value());
                               changed = open.scene().relations.since(before).added.size();
                           });
    });
    if (!done) {
        return done.error();
    }
    return changed;
}

Result<std::size_t> unrelate(ScriptScene& script, const std::vector<IndividualId>& from,
                             const std::optional<std::vector<IndividualId>>& to,
                             const std::optional<std::string>& name)
{
    std::size_t gone = 0;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        const auto kind = kindNamed(now, name);
        if (!kind) {
            return kind.error();
        }
        if (auto alive = checkThere(now, from); !alive) {
            return alive;
        }
        std::vector<Relation> leaving =
            to ? std::vector<Relation>() : relationsOf(now, from, kind.value());
        const auto count = to ? countOf(from.size(), to->size(), 1) : Result<std::size_t>(0);
        if (!count) {
            return count.error();
        }
        for (std::size_t i = 0; to && i < count.value(); ++i) {
            const IndividualId& who = itemAt(from, i);
            std::vector<Relation> his = relationsOf(now, std::span(&who, 1), kind.value());
            std::erase_if(
                his, [&](const Relation& each) { return !goes(now, each, who, itemAt(*to, i)); });
            leaving.insert(leaving.end(), his.begin(), his.end());
        }
        const std::size_t before = now.relations.count();
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Take relations away")),
                           [&](SceneEdit& open) {
                               open.unrelate(leaving);
                               gone = before - open.scene().relations.count();
                           });
    });
    if (!done) {
        return done.error();
    }
    return gone;
}

Result<std::vector<IndividualId>> related(const Scene& scene, const std::vector<IndividualId>& ids,
                                          const std::optional<std::string>& name)
{
    const auto kind = kindNamed(scene, name);
    if (!kind) {
        return kind.error();
    }
    if (auto alive = checkThere(scene, ids); !alive) {
        return alive.error();
    }
    return relatedTo(scene, ids, kind.value());
}

Result<std::vector<IndividualId>>
duplicatePeople(ScriptScene& script, const std::vector<IndividualId>& ids, const glm::vec3& offset)
{
    std::vector<IndividualId> copies;
    const auto done = script.onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(script.document().scene(), ids); !alive) {
            return alive;
        }
        if (!std::isfinite(offset.x) || !std::isfinite(offset.y) || !std::isfinite(offset.z)) {
            return Error{"offset must be three finite numbers."};
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Duplicate characters")),
                           [&](SceneEdit& open) { copies = model::duplicate(open, ids, offset); });
    });
    if (!done) {
        return done.error();
    }
    return copies;
}

} // namespace crowd::app
