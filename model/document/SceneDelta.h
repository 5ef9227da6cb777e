// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/document/SceneChange.h"
#include "model/document/StoredRows.h"
#include "model/scene/Scene.h"

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

/// What separates two states of a scene: only what changed, by id, never by row or pointer.
struct SceneDelta
{
    StoredRows added;
    StoredRows removed;
    std::vector<ColumnDelta> columns; ///< of individuals present on both sides
    IndividualId nextIdBefore = 1;
    IndividualId nextIdAfter = 1;
    std::vector<EntryDelta<TemplateEntry>> templates;
    std::vector<EntryDelta<StageEntry>> stages;
    std::optional<ValueDelta<std::vector<NamedCamera>>> cameras;
    std::optional<ValueDelta<Lighting>> lighting;
    std::vector<EntryDelta<Place>> places;
    std::vector<EntryDelta<Path>> paths;
    std::optional<ValueDelta<std::vector<Rule>>> rules;
    std::optional<ValueDelta<std::vector<TagName>>> tags;
    std::optional<ValueDelta<std::vector<NumberName>>> numbers;
    std::optional<ValueDelta<std::vector<Cue>>> cues;
    std::optional<ValueDelta<SurfaceSettings>> surface;
    std::optional<ValueDelta<std::uint32_t>> stepsPerSecond;

    [[nodiscard]] bool isEmpty() const;
    /// Memory held, without assets (they are shared).
    [[nodiscard]] std::size_t bytes() const;
    /// The part of it that grows with the number of individuals: added, removed and columns.
    [[nodiscard]] std::size_t bulkBytes() const;
};

enum class DeltaDirection { Undo, Redo };

/// Brings the scene from one side of the delta to the other and announces each change after it is
/// done. The scene stands on the side that the direction starts from.
void applyDelta(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                const std::function<void(const SceneChange&)>& announce);

} // namespace crowd::model
