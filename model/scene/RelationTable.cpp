// SPDX-License-Identifier: MIT
#include "model/scene/RelationTable.h"

#include <algorithm>
#include <tuple>

namespace crowd::model {

namespace {

auto orderOf(const RelationLink& link)
{
    return std::tuple(link.kind, link.other, !link.isOut);
}

auto orderOf(const Relation& relation)
{
    return std::tuple(relation.from, relation.kind, relation.to);
}

Relation relationOf(IndividualId owner, const RelationLink& link)
{
    return {owner, link.other, link.strength, link.kind};
}

/// What one individual's links away from him gained and lost.
void addDifference(IndividualId owner, std::span<const RelationLink> before,
                   std::span<const RelationLink> now, RelationDelta& delta)
{
    auto old = before.begin();
    auto coming = now.begin();
    while (old != before.end() || coming != now.end()) {
        const bool isOldOnly =
            coming == now.end() || (old != before.end() && orderOf(*old) < orderOf(*coming));
        const bool isComingOnly =
            !isOldOnly && (old == before.end() || orderOf(*coming) < orderOf(*old));
        const bool isSame = !isOldOnly && !isComingOnly && *old == *coming;
        if (!isComingOnly && !isSame && old->isOut) {
            delta.removed.push_back(relationOf(owner, *old));
        }
        if (!isOldOnly && !isSame && coming->isOut) {
            delta.added.push_back(relationOf(owner, *coming));
        }
        old += isComingOnly ? 0 : 1;
        coming += isOldOnly ? 0 : 1;
    }
}

} // namespace

const RelationTable::Leaf* RelationTable::leafOf(std::size_t branch, std::size_t leaf) const
{
    const bool isThere = branch < m_branches.size() && m_branches[branch] != nullptr;
    return isThere ? (*m_branches[branch])[leaf].get() : nullptr;
}

std::span<const RelationLink> RelationTable::of(IndividualId id) const
{
    const std::size_t leaf = id / kLeafIds;
    const Leaf* found = leafOf(leaf / kBranchLeaves, leaf % kBranchLeaves);
    return found != nullptr ? found->of(id % kLeafIds) : std::span<const RelationLink>();
}

const RelationLink* RelationTable::find(IndividualId from, IndividualId to,
                                        RelationKindId kind) const
{
    const std::span<const RelationLink> links = of(from);
    const RelationLink wanted{to, 0.0F, kind, true};
    const auto place = std::ranges::lower_bound(
        links, orderOf(wanted), {}, [](const RelationLink& link) { return orderOf(link); });
    return place != links.end() && orderOf(*place) == orderOf(wanted) ? &*place : nullptr;
}

std::vector<Relation> RelationTable::all() const
{
    std::vector<Relation> all = since(RelationTable()).added;
    std::ranges::sort(all, {}, [](const Relation& relation) { return orderOf(relation); });
    return all;
}

void RelationTable::put(std::span<const Relation> relations)
{
    edit(relations, false);
}

void RelationTable::remove(std::span<const Relation> relations)
{
    edit(relations, true);
}

/// Counts those that come and go as it writes them.
RelationTable::LeafPtr RelationTable::edited(const Leaf* before, std::span<const LinkEdit> edits)
{
    auto leaf = std::make_shared<Leaf>();
    leaf->links.reserve((before != nullptr ? before->links.size() : 0) + edits.size());
    auto next = edits.begin();
    for (std::size_t index = 0; index < kLeafIds; ++index) {
        const auto old = before != nullptr ? before->of(index) : std::span<const RelationLink>();
        auto kept = old.begin();
        for (; next != edits.end() && next->owner % kLeafIds == index; ++next) {
            while (kept != old.end() && orderOf(*kept) < orderOf(next->link)) {
                leaf->links.push_back(*kept++);
            }
            const bool wasThere = kept != old.end() && orderOf(*kept) == orderOf(next->link);
            kept += wasThere ? 1 : 0;
            if (!next->isGone) {
                leaf->links.push_back(next->link);
            }
            m_count += next->link.isOut && !next->isGone ? 1 : 0;
            m_count -= next->link.isOut && wasThere ? 1 : 0;
        }
        leaf->links.insert(leaf->links.end(), kept, old.end());
        leaf->begins[index + 1] = static_cast<std::uint32_t>(leaf->links.size());
    }
    return leaf->links.empty() ? nullptr : leaf;
}

void RelationTable::edit(std::span<const Relation> relations, bool isGone)
{
    std::vector<LinkEdit> edits;
    edits.reserve(relations.size() * 2);
    for (const Relation& each : relations) {
        if (each.from != each.to) {
            edits.push_back({each.from, {each.to, each.strength, each.kind, true}, isGone});
            edits.push_back({each.to, {each.from, each.strength, each.kind, false}, isGone});
        }
    }
    const auto order = [](const LinkEdit& edit) {
        return std::tuple_cat(std::tuple(edit.owner), orderOf(edit.link));
    };
    std::ranges::stable_sort(edits, {}, order);
    std::vector<LinkEdit> last; // of several of the same
    last.reserve(edits.size());
    for (const LinkEdit& each : edits) {
        if (!last.empty() && order(last.back()) == order(each)) {
            last.back() = each;
        } else {
            last.push_back(each);
        }
    }
    const std::span<const LinkEdit> all(last);
    std::size_t next = 0;
    std::size_t copied = m_branches.size(); // the branch that is this table's own
    std::shared_ptr<Branch> own;
    while (next < all.size()) {
        const std::size_t leaf = all[next].owner / kLeafIds;
        std::size_t end = next;
        while (end < all.size() && all[end].owner / kLeafIds == leaf) {
            ++end;
        }
        const std::size_t branch = leaf / kBranchLeaves;
        if (branch >= m_branches.size()) {
            m_branches.resize(branch + 1);
        }
        if (own == nullptr || copied != branch) {
            const auto& before = m_branches[branch];
            own =
                before != nullptr ? std::make_shared<Branch>(*before) : std::make_shared<Branch>();
            m_branches[branch] = own;
            copied = branch;
        }
        LeafPtr& place = (*own)[leaf % kBranchLeaves];
        place = edited(place.get(), all.subspan(next, end - next));
        next = end;
    }
}

/// Calls visit(first id, leaf of a, leaf of b) for leaves that are not shared; null: none.
template<class Visit>
void RelationTable::forEachDifferent(const RelationTable& a, const RelationTable& b,
                                     const Visit& visit)
{
    const std::size_t branches = std::max(a.m_branches.size(), b.m_branches.size());
    for (std::size_t branch = 0; branch < branches; ++branch) {
        const auto of = [branch](const RelationTable& table) {
            return branch < table.m_branches.size() ? table.m_branches[branch].get() : nullptr;
        };
        if (of(a) == of(b)) {
            continue;
        }
        for (std::size_t leaf = 0; leaf < kBranchLeaves; ++leaf) {
            const Leaf* left = a.leafOf(branch, leaf);
            const Leaf* right = b.leafOf(branch, leaf);
            if (left != right) {
                visit(static_cast<IndividualId>((branch * kBranchLeaves + leaf) * kLeafIds), left,
                      right);
            }
        }
    }
}

RelationDelta RelationTable::since(const RelationTable& before) const
{
    RelationDelta delta;
    forEachDifferent(before, *this, [&delta](IndividualId first, const Leaf* old, const Leaf* now) {
        for (std::size_t index = 0; index < kLeafIds; ++index) {
            const auto of = [index](const Leaf* leaf) {
                return leaf != nullptr ? leaf->of(index) : std::span<const RelationLink>();
            };
            addDifference(first + static_cast<IndividualId>(index), of(old), of(now), delta);
        }
    });
    return delta;
}

void RelationTable::apply(const RelationDelta& delta, bool isUndo)
{
    remove(isUndo ? delta.added : delta.removed);
    put(isUndo ? delta.removed : delta.added);
}

bool operator==(const RelationTable& a, const RelationTable& b)
{
    return a.m_count == b.m_count && a.since(b).isEmpty();
}

} // namespace crowd::model
