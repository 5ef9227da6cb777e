// SPDX-License-Identifier: MIT
#include "model/brush/RelationStroke.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <glm/gtx/norm.hpp>

#include "model/base/Random.h"
#include "model/population/FootCells.h"
#include "model/relations/RelatedPeople.h"

namespace crowd::model {

namespace {

constexpr std::size_t kMostTogether = 300;     ///< each to each
constexpr std::size_t kMostAtOnce = 2'000'000; ///< relations of one stroke
constexpr float kSmaller = 0.87F;              ///< of the tallest of a family: a child
constexpr float kLookWeight = 1.6F;            ///< how much further off one of the same look is

struct Relative
{
    IndividualId id = 0;
    std::size_t row = 0;
    float height = 1.0F; ///< metres
    TemplateId look = 0;
    bool isTaken = false;
};

std::vector<Relative> relativesOf(const Scene& scene, const Population& people,
                                  std::span<const IndividualId> ids)
{
    std::vector<Relative> all;
    all.reserve(ids.size());
    for (const IndividualId id : ids) {
        const std::size_t row = people.rowOf(id);
        const TemplateId look = people.column(columns::templateId)[row];
        const TemplateEntry* entry = scene.findTemplate(look);
        const float own = entry != nullptr && entry->asset ? entry->asset->height : 1.0F;
        all.push_back({id, row, own * people.column(columns::height)[row], look, false});
    }
    return all;
}

/// The members of one family, the tallest first; indices into the candidates.
class FamilyFinder
{
public:
    FamilyFinder(const std::vector<Relative>& all, const Population& people,
                 const RelationSettings& settings)
        : m_all(all), m_settings(settings)
    {
        m_points.reserve(all.size());
        for (const Relative& each : all) {
            m_points.push_back(people.column(columns::position)[each.row]);
        }
        m_cells.emplace(m_points, settings.metres);
    }

    /// Empty where there are too few around.
    [[nodiscard]] std::vector<std::size_t> around(std::size_t first, std::size_t size) const
    {
        std::vector<std::size_t> family{first};
        std::vector<std::size_t> near;
        m_cells->forEachNear(m_points[first], [&](std::uint32_t at) {
            if (at != first && !m_all[at].isTaken) {
                near.push_back(at);
            }
        });
        while (family.size() < size && !near.empty()) {
            const auto best = std::ranges::min_element(near, {}, [&](std::size_t at) {
                return std::pair(distanceOf(family, at), m_all[at].id);
            });
            family.push_back(*best);
            near.erase(best);
        }
        return family.size() >= m_settings.least ? family : std::vector<std::size_t>();
    }

private:
    /// The second one is rather of another look, the others are rather smaller.
    [[nodiscard]] float distanceOf(const std::vector<std::size_t>& family, std::size_t at) const
    {
        const Relative& first = m_all[family.front()];
        const Relative& other = m_all[at];
        const bool isChild = other.height < first.height * kSmaller;
        const bool isOdd = family.size() == 1 ? isChild || other.look == first.look : !isChild;
        const float metres = glm::distance(m_points[family.front()], m_points[at]);
        return metres * (isOdd ? kLookWeight : 1.0F);
    }

    const std::vector<Relative>& m_all;
    std::vector<glm::vec3> m_points;
    const RelationSettings& m_settings;
    std::optional<FootCells> m_cells;
};

bool hasKind(const Scene& scene, IndividualId id, RelationKindId kind)
{
    return std::ranges::any_of(scene.relations.of(id),
                               [kind](const RelationLink& link) { return link.kind == kind; });
}

void addSorted(std::vector<IndividualId>& to, std::span<const IndividualId> ids)
{
    std::vector<IndividualId> all;
    all.reserve(to.size() + ids.size());
    std::ranges::set_union(to, ids, std::back_inserter(all));
    to = std::move(all);
}

} // namespace

RelationStroke::RelationStroke(const BrushSettings& brush, std::uint64_t seed)
    : m_settings(brush.as<RelationSettings>()), m_isArea(brush.hasWholeArea()), m_seed(seed)
{
}

void RelationStroke::restart()
{
    m_isBegun = false;
    m_from.clear();
    m_to.clear();
    m_met.clear();
    m_alone.clear();
    m_last = 0;
    m_changed.clear();
    m_reason = StrokeReason::NobodyUnderBrush;
}

Relation RelationStroke::relation(IndividualId from, IndividualId to) const
{
    const std::uint64_t key = hashKeys(m_seed, hashText("relation.strength"), from, to);
    const ValueRange& range = m_settings.strength;
    return {from, to, range.low + (range.high - range.low) * unitFloat(key), m_kind};
}

void RelationStroke::add(SceneEdit& edit, const Population& people,
                         std::span<const IndividualId> ids)
{
    const RelationKind* kind = findRelation(edit.scene().relationKinds, m_settings.relation);
    if (kind == nullptr) {
        m_reason = StrokeReason::NoSuchRelation;
        return;
    }
    m_kind = kind->id;
    if (isFromTo()) {
        meet(ids);
    }
    if (ids.empty()) {
        return;
    }
    std::vector<IndividualId> fresh;
    std::ranges::set_difference(ids, m_met, std::back_inserter(fresh));
    addSorted(m_met, fresh);
    if (m_settings.erases) {
        if (!isFromTo()) {
            erase(edit, fresh);
        }
    } else if (m_settings.how != RelationHow::FromTo) {
        addNew(edit, people, fresh);
    } else if (m_isArea) {
        m_from.assign(m_settings.sources.begin(), m_settings.sources.end());
        std::erase_if(m_from,
                      [&people](IndividualId id) { return people.rowOf(id) == Population::npos; });
        m_to.assign(ids.begin(), ids.end());
        m_reason =
            m_settings.sources.empty() ? StrokeReason::SourcesChosen : StrokeReason::NobodyElse;
    }
}

/// Those on the way do not count, nor where there is nobody at one end.
void RelationStroke::meet(std::span<const IndividualId> ids)
{
    (m_isBegun ? m_to : m_from).assign(ids.begin(), ids.end());
    m_isBegun = true;
    m_reason = m_from.empty() ? StrokeReason::NobodyUnderBrush : StrokeReason::NobodyElse;
}

bool RelationStroke::isFromTo() const
{
    return !m_isArea && m_settings.how == RelationHow::FromTo;
}

/// Where it ends at somebody else, what is between the two; else all of those where it began.
void RelationStroke::eraseBetween(SceneEdit& edit)
{
    std::vector<Relation> gone = relationsOf(edit.scene(), m_from, m_kind);
    std::vector<IndividualId> others;
    std::ranges::set_difference(m_to, m_from, std::back_inserter(others));
    const auto isBetween = [&](const Relation& each) {
        const auto joins = [&](IndividualId from, IndividualId to) {
            return std::ranges::binary_search(m_from, from) && std::ranges::binary_search(m_to, to);
        };
        return joins(each.from, each.to) || joins(each.to, each.from);
    };
    if (!others.empty()) {
        std::erase_if(gone, [&](const Relation& each) { return !isBetween(each); });
    }
    unrelate(edit, gone);
}

void RelationStroke::settle(SceneEdit& edit)
{
    const bool isErasedAtOnce = m_settings.erases && m_isArea;
    if (m_settings.how != RelationHow::FromTo || m_from.empty() || isErasedAtOnce) {
        return;
    }
    edit.rollback();
    m_changed.clear();
    if (m_settings.erases) {
        eraseBetween(edit);
        return;
    }
    if (m_from.size() * m_to.size() > kMostAtOnce) {
        m_reason = StrokeReason::TooManyAtOnce;
        return;
    }
    std::vector<Relation> made;
    made.reserve(m_from.size() * m_to.size());
    for (const IndividualId from : m_from) {
        for (const IndividualId to : m_to) {
            if (from != to) {
                made.push_back(relation(from, to));
            }
        }
    }
    m_reason = StrokeReason::NobodyElse;
    commit(edit, std::move(made));
}

void RelationStroke::addNew(SceneEdit& edit, const Population& people,
                            std::span<const IndividualId> ids)
{
    if (ids.empty()) {
        return;
    }
    std::vector<Relation> made;
    m_reason = m_changed.empty() ? StrokeReason::NobodyElse : m_reason;
    switch (m_settings.how) {
    case RelationHow::FromTo:
        break;
    case RelationHow::Chain:
        chain(people, ids, made);
        break;
    case RelationHow::Family:
        gatherFamilies(edit.scene(), people, ids, made);
        break;
    case RelationHow::Near:
        relateNear(edit.scene(), people, ids, made);
        break;
    case RelationHow::Together:
        together(ids, made);
        break;
    }
    commit(edit, std::move(made));
}

/// From the last one to the nearest of the new ones, and so on.
void RelationStroke::chain(const Population& people, std::span<const IndividualId> ids,
                           std::vector<Relation>& made)
{
    const auto positions = people.column(columns::position);
    std::vector<std::pair<IndividualId, glm::vec3>> left; // ascending ids
    left.reserve(ids.size());
    for (const IndividualId id : ids) {
        left.emplace_back(id, positions[people.rowOf(id)]);
    }
    while (!left.empty()) {
        auto next = left.begin();
        if (m_last != 0) {
            const glm::vec3 at = positions[people.rowOf(m_last)];
            next = std::ranges::min_element(
                left, {}, [&at](const auto& each) { return glm::distance2(at, each.second); });
            made.push_back(relation(m_last, next->first));
        }
        m_last = next->first;
        left.erase(next);
    }
}

/// The tallest come first, so that children come to them.
void RelationStroke::gatherFamilies(const Scene& scene, const Population& people,
                                    std::span<const IndividualId> ids, std::vector<Relation>& made)
{
    addSorted(m_alone, ids);
    std::erase_if(m_alone, [&](IndividualId id) { return hasKind(scene, id, m_kind); });
    std::vector<Relative> all = relativesOf(scene, people, m_alone);
    std::ranges::stable_sort(all, std::ranges::greater(), &Relative::height);
    const FamilyFinder finder(all, people, m_settings);
    const std::uint32_t most = std::max(m_settings.least, m_settings.most);
    for (std::size_t first = 0; first < all.size(); ++first) {
        if (all[first].isTaken) {
            continue;
        }
        const std::uint64_t key = hashKeys(m_seed, hashText("relation.family"), all[first].id);
        const std::size_t size = m_settings.least + key % (most - m_settings.least + 1);
        const std::vector<std::size_t> family = finder.around(first, size);
        for (std::size_t i = 0; i < family.size(); ++i) {
            all[family[i]].isTaken = true;
            for (std::size_t k = i + 1; k < family.size(); ++k) {
                made.push_back(relation(all[family[i]].id, all[family[k]].id));
            }
        }
    }
    m_alone.clear();
    for (const Relative& each : all) {
        if (!each.isTaken) {
            m_alone.push_back(each.id);
        }
    }
    std::ranges::sort(m_alone);
}

void RelationStroke::relateNear(const Scene& scene, const Population& people,
                                std::span<const IndividualId> ids,
                                std::vector<Relation>& made) const
{
    std::vector<std::size_t> rows;
    rows.reserve(ids.size());
    for (const IndividualId id : ids) {
        rows.push_back(people.rowOf(id));
    }
    const FootCells cells(people.column(columns::position), m_settings.metres, rows);
    std::vector<std::pair<std::uint64_t, IndividualId>> near;
    for (const std::size_t row : rows) {
        const IndividualId id = people.ids()[row];
        near.clear();
        cells.forEachNear(row, [&](std::uint32_t other) {
            const IndividualId whom = people.ids()[other];
            const std::size_t now = scene.population.rowOf(whom);
            if (other != row && now != Population::npos && scene.isTouchable(now)) {
                near.emplace_back(hashKeys(m_seed, hashText("relation.near"), id, whom), whom);
            }
        });
        const std::size_t count = std::min<std::size_t>(m_settings.count, near.size());
        std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i) {
            made.push_back(relation(id, near[i].second));
        }
    }
}

/// The new ones with each other and with those before.
void RelationStroke::together(std::span<const IndividualId> ids, std::vector<Relation>& made)
{
    if (m_met.size() > kMostTogether) {
        m_reason = StrokeReason::TooManyAtOnce;
        return;
    }
    for (const IndividualId to : ids) {
        for (const IndividualId from : m_met) {
            const bool isNew = std::ranges::binary_search(ids, from);
            if (from != to && (!isNew || from < to)) {
                made.push_back(relation(from, to));
            }
        }
    }
}

void RelationStroke::erase(SceneEdit& edit, std::span<const IndividualId> ids)
{
    unrelate(edit, relationsOf(edit.scene(), ids, m_kind));
}

void RelationStroke::unrelate(SceneEdit& edit, const std::vector<Relation>& gone)
{
    m_reason = m_changed.empty() ? StrokeReason::NothingToErase : m_reason;
    std::vector<IndividualId> freed;
    for (const Relation& each : gone) {
        freed.insert(freed.end(), {each.from, each.to});
    }
    std::ranges::sort(freed);
    freed.erase(std::unique(freed.begin(), freed.end()), freed.end());
    edit.unrelate(gone);
    addSorted(m_changed, freed);
}

void RelationStroke::commit(SceneEdit& edit, std::vector<Relation> made)
{
    const RelationKind& kind = *findRelation(edit.scene().relationKinds, m_kind);
    const RelationTable& now = edit.scene().relations;
    const std::size_t meant = made.size();
    std::vector<IndividualId> related;
    std::erase_if(made, [&](Relation& each) {
        each = canonical(kind, each);
        const RelationLink* before = now.find(each.from, each.to, each.kind);
        return before != nullptr && before->strength == each.strength;
    });
    for (const Relation& each : made) {
        related.insert(related.end(), {each.from, each.to});
    }
    std::ranges::sort(related);
    related.erase(std::unique(related.begin(), related.end()), related.end());
    edit.relate(made);
    addSorted(m_changed, related);
    if (m_changed.empty() && meant > 0) {
        m_reason = StrokeReason::Unchanged;
    }
}

} // namespace crowd::model
