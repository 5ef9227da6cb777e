// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <tuple>
#include <vector>

#include "model/population/StoredRows.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

/// Old and new values of one column for some individuals. A side that is the same for all of them
/// is kept once.
struct ColumnDelta
{
    ColumnId column{};
    std::vector<IndividualId> ids; ///< ascending
    std::vector<std::byte> before; ///< ids.size() × stride, or one stride
    std::vector<std::byte> after;  ///< likewise
};

/// One scene-level entry with an id: no value means that there is none.
template<class Entry>
struct EntryDelta
{
    std::optional<Entry> before;
    std::optional<Entry> after;
};

template<class Value>
struct ValueDelta
{
    Value before;
    Value after;
};

/// Of one of SceneMembers.
template<class M>
struct MemberDelta
{
    std::optional<ValueDelta<typename M::Type>> changes;
};
template<class M>
requires(M::kind == MemberKind::Entries) struct MemberDelta<M>
{
    std::vector<EntryDelta<typename M::Type::value_type>> changes; ///< ascending ids
};
template<class M>
requires(M::kind == MemberKind::Table) struct MemberDelta<M>
{
    typename M::Type::Delta changes;
};

template<class Members>
struct MemberDeltas;
template<class... M>
struct MemberDeltas<std::tuple<M...>>
{
    using type = std::tuple<MemberDelta<M>...>;
};

/// What separates two states of a scene: only what changed, by id, never by row or pointer.
struct SceneDelta
{
    StoredRows added;
    StoredRows removed;
    std::vector<ColumnDelta> columns; ///< of individuals present on both sides
    IndividualId nextIdBefore = 1;
    IndividualId nextIdAfter = 1;

    /// What changed of a scene's member: entries by ascending id, or the whole value.
    template<class M>
    [[nodiscard]] const auto& of() const
    {
        return std::get<MemberDelta<M>>(m_members).changes;
    }
    template<class M>
    [[nodiscard]] auto& of()
    {
        return std::get<MemberDelta<M>>(m_members).changes;
    }
    [[nodiscard]] MemberSet changedMembers() const;

    [[nodiscard]] bool isEmpty() const;
    /// Memory held, without assets (they are shared).
    [[nodiscard]] std::size_t bytes() const;
    /// The part of it that grows with the number of individuals: added, removed, columns and
    /// relations.
    [[nodiscard]] std::size_t bulkBytes() const;

private:
    MemberDeltas<SceneMembers>::type m_members;
};

enum class DeltaDirection { Undo, Redo };

/// Brings the scene from one side of the delta to the other and announces each change after it is
/// done. The scene stands on the side that the direction starts from.
void applyDelta(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                const std::function<void(const SceneChange&)>& announce);

} // namespace crowd::model
