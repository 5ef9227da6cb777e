// SPDX-License-Identifier: MIT
#include "widgets/state/Selection.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

using model::IndividualId;
using Ids = std::vector<IndividualId>;

namespace {

Ids sortedUnique(std::span<const IndividualId> ids)
{
    Ids sorted(ids.begin(), ids.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

} // namespace

Selection::Selection(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&document, &model::SceneDocument::changed, this, &Selection::follow);
    connect(&document, &model::SceneDocument::stepTaken, this, [this] {
        const Ids back = takeBack();
        Ids all;
        std::set_union(m_ids.begin(), m_ids.end(), back.begin(), back.end(),
                       std::back_inserter(all));
        replace(std::move(all));
    });
    // Whoever is new may have got the id of somebody whose creation was undone.
    connect(&document, &model::SceneDocument::stepCommitted, this, [this] { (void)takeBack(); });
}

Ids Selection::takeBack()
{
    const std::span<const IndividualId> present = m_document.scene().population.ids();
    Ids back;
    std::set_intersection(m_gone.begin(), m_gone.end(), present.begin(), present.end(),
                          std::back_inserter(back));
    Ids rest;
    std::set_difference(m_gone.begin(), m_gone.end(), back.begin(), back.end(),
                        std::back_inserter(rest));
    m_gone = std::move(rest);
    return back;
}

bool Selection::contains(IndividualId id) const
{
    return std::binary_search(m_ids.begin(), m_ids.end(), id);
}

void Selection::apply(std::span<const IndividualId> ids, SelectionMode mode)
{
    m_gone.clear();
    const Ids sorted = sortedUnique(ids);
    const std::span<const IndividualId> present = m_document.scene().population.ids();
    Ids known;
    std::set_intersection(sorted.begin(), sorted.end(), present.begin(), present.end(),
                          std::back_inserter(known));
    Ids result;
    switch (mode) {
    case SelectionMode::Replace:
        result = std::move(known);
        break;
    case SelectionMode::Add:
        std::set_union(m_ids.begin(), m_ids.end(), known.begin(), known.end(),
                       std::back_inserter(result));
        break;
    case SelectionMode::Toggle:
        std::set_symmetric_difference(m_ids.begin(), m_ids.end(), known.begin(), known.end(),
                                      std::back_inserter(result));
        break;
    }
    replace(std::move(result));
}

void Selection::selectAll()
{
    m_gone.clear();
    const std::span<const IndividualId> present = m_document.scene().population.ids();
    replace(Ids(present.begin(), present.end()));
}

void Selection::invert()
{
    apply(m_document.scene().population.ids(), SelectionMode::Toggle);
}

void Selection::replace(Ids ids)
{
    const model::Scene& scene = m_document.scene();
    if (!scene.groups.empty()) {
        std::erase_if(ids, [&scene](IndividualId id) {
            return !scene.isTouchable(scene.population.rowOf(id));
        });
    }
    if (ids == m_ids) {
        return;
    }
    m_ids = std::move(ids);
    Q_EMIT changed();
}

void Selection::follow(const model::SceneChange& change)
{
    visitChange(
        change,
        [this](const model::SceneReplaced&) {
            m_gone.clear();
            replace({});
        },
        [this](const model::GroupsChanged&) { replace(m_ids); },
        [this](const model::ColumnsChanged& columns) {
            if (columns.columns.contains(model::ColumnId::Group)) {
                replace(m_ids);
            }
        },
        [this](const model::IndividualsRemoved& removed) {
            Ids rest;
            std::set_difference(m_ids.begin(), m_ids.end(), removed.ids.begin(), removed.ids.end(),
                                std::back_inserter(rest));
            Ids lost;
            std::set_intersection(m_ids.begin(), m_ids.end(), removed.ids.begin(),
                                  removed.ids.end(), std::back_inserter(lost));
            Ids gone;
            std::set_union(m_gone.begin(), m_gone.end(), lost.begin(), lost.end(),
                           std::back_inserter(gone));
            m_gone = std::move(gone);
            replace(std::move(rest));
        });
}

} // namespace crowd::widgets
