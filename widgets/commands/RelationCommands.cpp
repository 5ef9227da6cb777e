// SPDX-License-Identifier: MIT
#include "widgets/commands/RelationCommands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <glm/common.hpp>

#include "model/brush/NeighbourGrid.h"
#include "model/document/SceneEdit.h"
#include "model/relations/RelatedPeople.h"
#include "widgets/state/RelationTexts.h"

namespace crowd::widgets {

using model::IndividualId;
using model::Relation;
using model::RelationKind;
using model::RelationKindId;

using People = std::vector<IndividualId>; // lupdate takes std:: before a function for its context
using Name = std::string;

namespace {

constexpr std::size_t kMostEachToEach = 500;
constexpr float kBesideMetres = 1.0F; ///< of a copy
constexpr float kCopiesApart = 0.5F;
constexpr int kBesideRings = 6;
constexpr int kBesideSides = 8;

struct RelationText
{
    Q_DECLARE_TR_FUNCTIONS(RelationCommands)
};

bool editRelationKinds(EditorState& state, const QString& text,
                       const std::function<void(model::RelationKinds&)>& change)
{
    model::RelationKinds kinds = state.scene().relationKinds;
    change(kinds);
    const auto outcome = state.document().edit(
        text, [&](model::SceneEdit& edit) { edit.setRelationKinds(std::move(kinds)); });
    return outcome != model::EditOutcome::Refused;
}

People chosenPeople(EditorState& state)
{
    const auto ids = state.selection().ids();
    return {ids.begin(), ids.end()};
}

/// "Relation 6": a name that none of them has.
Name freeRelationName(const model::RelationKinds& kinds)
{
    for (std::size_t number = kinds.size() + 1;; ++number) {
        std::string name = RelationText::tr("Relation %1").arg(number).toStdString();
        if (findRelation(kinds, name) == nullptr) {
            return name;
        }
    }
}

int countFree(const model::NeighbourGrid& grid, std::span<const glm::vec3> places,
              const glm::vec3& offset)
{
    return static_cast<int>(std::ranges::count_if(
        places, [&](const glm::vec3& at) { return grid.isFree({at + offset}); }));
}

/// The larger of width and depth.
float extentOf(std::span<const glm::vec3> places)
{
    glm::vec3 low = places.front();
    glm::vec3 high = low;
    for (const glm::vec3& at : places) {
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    return std::max(high.x - low.x, high.z - low.z);
}

/// Beside them as they are seen, or farther or elsewhere around where others stand there.
glm::vec3 offsetOfCopies(const EditorState& state, std::span<const IndividualId> ids)
{
    const model::Population& people = state.scene().population;
    const auto positions = people.column(model::columns::position);
    std::vector<model::GroundDisc> discs;
    for (const glm::vec3& at : positions) {
        discs.push_back({at});
    }
    const model::NeighbourGrid grid(discs, kCopiesApart);
    std::vector<glm::vec3> places;
    for (const IndividualId id : ids) {
        places.push_back(positions[people.rowOf(id)]);
    }
    const glm::vec3 right = state.camera().orientation * glm::vec3(1.0F, 0.0F, 0.0F);
    const float start = std::atan2(right.x, right.z);
    // A group goes beside itself as a whole, as far as that is near.
    constexpr float kMostBeside = 8.0F;
    const float beside = kBesideMetres + std::min(extentOf(places), kMostBeside);
    glm::vec3 best{0.0F};
    int mostFree = -1;
    for (int i = 0; i < kBesideRings * kBesideSides; ++i) {
        const int ring = 1 + i / kBesideSides;
        const float metres = beside + kBesideMetres * static_cast<float>(ring - 1);
        const float angle = start + 2.0F * std::numbers::pi_v<float> *
                                        static_cast<float>(i % kBesideSides) / kBesideSides;
        const glm::vec3 offset = metres * glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
        const int free = countFree(grid, places, offset);
        if (free > mostFree) {
            mostFree = free;
            best = offset;
        }
        if (mostFree == static_cast<int>(places.size())) {
            break;
        }
    }
    return best;
}

} // namespace

RelationKindId addRelationKind(EditorState& state)
{
    RelationKind kind;
    kind.id = freeRelationId(state.scene().relationKinds);
    kind.name = freeRelationName(state.scene().relationKinds);
    if (kind.id == 0) {
        state.showStatus(RelationText::tr("A scene has at most %1 relations: remove one first.")
                             .arg(model::kMostRelationKinds));
        return 0;
    }
    const bool isDone = editRelationKinds(
        state, RelationText::tr("Add a relation"), [&kind](model::RelationKinds& kinds) {
            kinds.insert(std::ranges::upper_bound(kinds, kind.id, {}, &RelationKind::id), kind);
        });
    return isDone ? kind.id : RelationKindId{0};
}

void removeRelationKind(EditorState& state, RelationKindId kind)
{
    const RelationKind* gone = findRelation(state.scene().relationKinds, kind);
    const QString name = gone != nullptr ? relationText(gone->name) : QString();
    const auto all = state.scene().relations.all();
    const auto count = std::ranges::count(all, kind, &model::Relation::kind);
    const bool isDone = editRelationKinds(
        state, RelationText::tr("Remove a relation"), [kind](model::RelationKinds& kinds) {
            std::erase_if(kinds, [kind](const RelationKind& each) { return each.id == kind; });
        });
    if (isDone && gone != nullptr) {
        state.showStatus(RelationText::tr("“%1” is gone, and %n relations of that kind with it",
                                          nullptr, static_cast<int>(count))
                             .arg(name));
    }
}

bool renameRelationKind(EditorState& state, RelationKindId kind, const QString& name)
{
    const RelationKind* before = findRelation(state.scene().relationKinds, kind);
    if (before == nullptr || relationText(before->name) == name) {
        return before != nullptr;
    }
    const std::string wanted = name.simplified().toStdString();
    if (wanted.empty()) {
        state.showStatus(RelationText::tr("It needs a name."));
        return false;
    }
    const auto isSeenAs = [seen = relationText(wanted)](const RelationKind& each) {
        return relationText(each.name) == seen;
    };
    if (std::ranges::any_of(state.scene().relationKinds, isSeenAs)) {
        state.showStatus(RelationText::tr("There is one of that name already."));
        return false;
    }
    RelationKind renamed = *before;
    renamed.name = wanted;
    changeRelationKind(state, renamed);
    return true;
}

void changeRelationKind(EditorState& state, const RelationKind& kind)
{
    editRelationKinds(
        state, RelationText::tr("Change a relation"), [&kind](model::RelationKinds& kinds) {
            std::ranges::replace_if(
                kinds, [&kind](const RelationKind& each) { return each.id == kind.id; }, kind);
        });
}

void relateSelected(EditorState& state, RelationKindId kind)
{
    const RelationKind* meant = findRelation(state.scene().relationKinds, kind);
    const std::vector<IndividualId> people = chosenPeople(state);
    if (people.size() < 2) {
        state.showStatus(RelationText::tr("It takes two: select whom to relate."));
        return;
    }
    if (people.size() > kMostEachToEach) {
        state.showStatus(RelationText::tr("Those are too many: select at most %1 characters.")
                             .arg(kMostEachToEach));
        return;
    }
    std::vector<Relation> made;
    const std::size_t froms = meant != nullptr && !meant->isMutual ? 1 : people.size();
    for (std::size_t from = 0; meant != nullptr && from < froms; ++from) {
        for (std::size_t to = from + 1; to < people.size(); ++to) {
            made.push_back({people[from], people[to], 1.0F, kind});
        }
    }
    state.document().edit(
        RelationText::tr("Relate %n character(s)", nullptr, static_cast<int>(people.size())),
        [&made](model::SceneEdit& edit) { edit.relate(made); });
}

void unrelateSelected(EditorState& state, RelationKindId kind)
{
    const std::vector<Relation> gone = relationsOf(state.scene(), state.selection().ids(), kind);
    if (gone.empty()) {
        state.showStatus(RelationText::tr("None of the selected has such a relation."));
        return;
    }
    state.document().edit(RelationText::tr("Take relations away"),
                          [&gone](model::SceneEdit& edit) { edit.unrelate(gone); });
}

void selectThoseRelated(EditorState& state, RelationKindId kind)
{
    std::vector<IndividualId> people;
    for (const Relation& each : state.scene().relations.all()) {
        if (each.kind == kind) {
            people.insert(people.end(), {each.from, each.to});
        }
    }
    std::ranges::sort(people);
    people.erase(std::unique(people.begin(), people.end()), people.end());
    if (people.empty()) {
        state.showStatus(RelationText::tr("Nobody has such a relation."));
    }
    state.selection().set(people);
}

void growSelectionToRelated(EditorState& state, RelationKindId kind)
{
    const std::vector<IndividualId> people = chosenPeople(state);
    const std::vector<IndividualId> grown = withRelated(state.scene(), people, kind);
    if (grown.size() == people.size()) {
        state.showStatus(people.empty()
                             ? RelationText::tr("Nobody is selected.")
                             : RelationText::tr("Nobody else is related so to the selected."));
        return;
    }
    state.selection().set(grown);
    state.showStatus(RelationText::tr("%n more are selected now", nullptr,
                                      static_cast<int>(grown.size() - people.size())));
}

namespace {

int sitting(const EditorState& state, std::span<const IndividualId> ids)
{
    const model::Population& people = state.scene().population;
    const auto seats = people.column(model::columns::seat);
    return static_cast<int>(std::ranges::count_if(
        ids, [&](IndividualId id) { return seats[people.rowOf(id)] != model::kNoSeat; }));
}

} // namespace

void duplicateSelection(EditorState& state)
{
    const std::vector<IndividualId> people = chosenPeople(state);
    if (people.empty()) {
        state.showStatus(RelationText::tr("Nobody is selected: there is nobody to duplicate."));
        return;
    }
    const glm::vec3 offset = offsetOfCopies(state, people);
    std::vector<IndividualId> copies;
    const auto outcome = state.document().edit(
        RelationText::tr("Duplicate %n character(s)", nullptr, static_cast<int>(people.size())),
        [&](model::SceneEdit& edit) { copies = duplicate(edit, people, offset); });
    if (outcome == model::EditOutcome::Committed) {
        state.selection().set(copies);
        const int standing = sitting(state, people) - sitting(state, copies);
        if (standing > 0) {
            state.showStatus(
                RelationText::tr("No seat is free near %n of them: they stand", nullptr, standing));
        }
    }
}

} // namespace crowd::widgets
