// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "model/brush/RelationStroke.h"
#include "model/brush/StrokeEffect.h"
#include "model/pick/ScenePicker.h"

namespace crowd::model {

/// Removes or changes people. They are selected as they stood at the press, at the time shown at
/// each dab; those that the stroke has removed are gone.
class SelectionEffect : public StrokeEffect
{
public:
    explicit SelectionEffect(StrokeContext& ground);
    void apply(std::span<const StrokeDab> dabs) override;
    void reevaluate(const StrokeLine& line, double shownSeconds) override;
    void end(const StrokeLine& line) override;
    [[nodiscard]] int affected() const override { return m_affected; }
    [[nodiscard]] StrokeReason reason() const override { return m_reason; }

private:
    void showTime(double seconds);
    void followMoves();
    [[nodiscard]] std::vector<IndividualId> selected(const Dab& dab) const;
    /// Whom `select` says, or whom the stroke before selected there; they are recorded.
    [[nodiscard]] std::vector<IndividualId>
    remembered(const std::function<std::vector<IndividualId>()>& select);
    /// Those of the ids on whom the brush may work; says why there is none.
    [[nodiscard]] std::vector<IndividualId> unmasked(std::vector<IndividualId> ids);
    /// Those of the ids that this stroke may still change; they are touched from now on.
    [[nodiscard]] std::vector<IndividualId> untouched(std::vector<IndividualId> ids);
    /// The share of them that a delete brush takes.
    [[nodiscard]] std::vector<IndividualId> thinned(std::vector<IndividualId> ids);
    void remove(std::vector<IndividualId> ids);
    /// The next dab of a relation brush, or a whole area.
    void relate(std::span<const IndividualId> ids);
    void settleRelations();
    void send(std::span<const IndividualId> ids);
    /// Who does a take again: all together, at the release.
    void gather(std::span<const IndividualId> ids);
    void retake();
    void change(std::span<const IndividualId> ids, const StrokeLine& line, std::uint64_t seed,
                std::optional<float> heading);
    void count(std::span<const IndividualId> changed);

    StrokeContext& m_ground;
    StrokeMask m_mask; ///< as of the press
    ScenePicker m_picker;
    CrowdFramePtr m_frame;               ///< at the press, with the time of the last dab
    CrowdFramePtr m_shown;               ///< the same, where a session has them; null: none runs
    std::vector<char> m_isTouched;       ///< by row of the frame
    std::vector<char> m_isChanged;       ///< by row of the frame
    std::vector<IndividualId> m_touched; ///< ascending
    std::optional<RelationStroke> m_relations; ///< of a relation brush
    std::size_t m_selections = 0;              ///< asked for so far
    std::size_t m_selected = 0;                ///< ids in all of them
    int m_affected = 0;
    StrokeReason m_reason = StrokeReason::NobodyUnderBrush;
};

} // namespace crowd::model
