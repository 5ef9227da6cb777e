// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "model/document/FirstTouch.h"
#include "model/document/SceneDelta.h"

namespace crowd::model {

template<class M>
using MemberEntry = typename M::Type::value_type;

/// What a scene's member was before an edit, as far as the edit touched it.
template<class M>
struct FirstMember
{
    std::optional<typename M::Type> before;
};
template<class M>
requires(M::kind == MemberKind::Entries) struct FirstMember<M>
{
    std::map<decltype(MemberEntry<M>::id), std::optional<MemberEntry<M>>> before;
};

template<class Members>
struct FirstMembers;
template<class... M>
struct FirstMembers<std::tuple<M...>>
{
    using type = std::tuple<FirstMember<M>...>;
};

/// Of entries by ascending id; nothing where there is none of that id.
template<class Entry>
[[nodiscard]] std::optional<Entry> entryOf(const std::vector<Entry>& entries,
                                           decltype(Entry::id) id)
{
    const auto found = std::ranges::lower_bound(entries, id, {}, &Entry::id);
    const bool isThere = found != entries.end() && found->id == id;
    return isThere ? std::optional<Entry>(*found) : std::nullopt;
}

/// What an edit must remember to become a delta: ids that it added, rows that it removed, and
/// first-touch values of everything else. Each function is called just before the scene changes.
class EditRecord
{
public:
    explicit EditRecord(IndividualId nextId) : m_nextIdBefore(nextId) {}

    /// ids ascend and come after all that were ever added.
    void addIndividuals(std::span<const IndividualId> ids);
    void removeIndividuals(std::span<const IndividualId> ids, const Population& population);
    void touchColumn(ColumnId column, std::span<const IndividualId> ids,
                     const Population& population);
    /// Of a member that is a list of entries.
    template<class M>
    requires(M::kind == MemberKind::Entries) void touch(decltype(MemberEntry<M>::id) id,
                                                        const Scene& scene)
    {
        std::get<FirstMember<M>>(m_members).before.try_emplace(id, entryOf(M::of(scene), id));
    }
    /// Of a member that is kept as a whole.
    template<class M>
    requires(M::kind != MemberKind::Entries) void touch(const Scene& scene)
    {
        auto& before = std::get<FirstMember<M>>(m_members).before;
        if (!before) {
            before = M::of(scene);
        }
    }

    [[nodiscard]] IndividualId nextIdBefore() const { return m_nextIdBefore; }
    /// From the scene before the edit to `scene`.
    [[nodiscard]] SceneDelta delta(const Scene& scene) const;

private:
    IndividualId m_nextIdBefore;
    std::vector<IndividualId> m_added; ///< ascending, all present
    IndividualRows m_removed = IndividualRows::withDefaults({});
    std::map<ColumnId, FirstTouch> m_touched;
    FirstMembers<SceneMembers>::type m_members;
};

} // namespace crowd::model
