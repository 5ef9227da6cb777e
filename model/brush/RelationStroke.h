// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/brush/BrushSettings.h"
#include "model/brush/PropertyChange.h"
#include "model/document/SceneEdit.h"

namespace crowd::model {

/// A stroke of the relation brush, dab by dab: whom it has found so far, and what follows from
/// that. How the stroke was split into moves changes nothing.
class RelationStroke
{
public:
    /// `brush` outlives it.
    RelationStroke(const BrushSettings& brush, std::uint64_t seed);

    /// The people of the next dab, ascending; of an area, all of them. `people`: where they are.
    void add(SceneEdit& edit, const Population& people, std::span<const IndividualId> ids);
    /// After the dabs of a move. Those between press and release are related anew, through an edit
    /// that is rolled back.
    void settle(SceneEdit& edit);
    /// Forgets everything, for an area that is looked at anew.
    void restart();

    /// Whom the stroke has related, or freed; ascending.
    [[nodiscard]] const std::vector<IndividualId>& changed() const { return m_changed; }
    /// Why nobody is.
    [[nodiscard]] StrokeReason reason() const { return m_reason; }

private:
    void meet(std::span<const IndividualId> ids);
    void addNew(SceneEdit& edit, const Population& people, std::span<const IndividualId> ids);
    void chain(const Population& people, std::span<const IndividualId> ids,
               std::vector<Relation>& made);
    void gatherFamilies(const Scene& scene, const Population& people,
                        std::span<const IndividualId> ids, std::vector<Relation>& made);
    void relateNear(const Scene& scene, const Population& people, std::span<const IndividualId> ids,
                    std::vector<Relation>& made) const;
    void together(std::span<const IndividualId> ids, std::vector<Relation>& made);
    [[nodiscard]] bool isFromTo() const; ///< from where a drag begins to where it ends
    void erase(SceneEdit& edit, std::span<const IndividualId> ids);
    void eraseBetween(SceneEdit& edit);
    void unrelate(SceneEdit& edit, const std::vector<Relation>& gone);
    void commit(SceneEdit& edit, std::vector<Relation> made);
    [[nodiscard]] Relation relation(IndividualId from, IndividualId to) const;

    const RelationSettings& m_settings;
    bool m_isArea;
    std::uint64_t m_seed;
    RelationKindId m_kind = 0;
    bool m_isBegun = false;            ///< FromTo: the first dab was
    std::vector<IndividualId> m_from;  ///< FromTo: of the press
    std::vector<IndividualId> m_to;    ///< FromTo: of the last dab
    std::vector<IndividualId> m_met;   ///< so far, ascending
    std::vector<IndividualId> m_alone; ///< Family: met, and still in none
    IndividualId m_last = 0;           ///< Chain
    std::vector<IndividualId> m_changed;
    StrokeReason m_reason = StrokeReason::NobodyUnderBrush;
};

} // namespace crowd::model
