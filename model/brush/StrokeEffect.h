// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/brush/BrushContext.h"
#include "model/brush/CreationSite.h"
#include "model/brush/Operator.h"
#include "model/brush/Sampler.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneEdit.h"
#include "model/pick/ScenePicker.h"

namespace crowd::model {

/// What a stroke works on, shared by its parts.
struct StrokeContext
{
    SceneDocument& document;
    BrushContext context;
    BrushSettings settings;
    std::uint64_t seed = 0;
    std::unique_ptr<SceneEdit> edit;
    std::vector<WorldSeat> seats; ///< ascending by id
};

/// A dab with what the stroke has learnt about its way.
struct StrokeDab
{
    Dab dab;
    std::optional<float> heading; ///< of the way, on the ground
};

/// Radius of a dab, logical pixels.
[[nodiscard]] double dabRadius(const BrushSettings& settings, const Dab& dab);
/// The k-th point of a spray's dab: equally spread over the circle.
[[nodiscard]] glm::dvec2 sprayPoint(const BrushSettings& settings, std::uint64_t seed,
                                    const Dab& dab, int k);

/// Where the dab of a creation brush puts people.
[[nodiscard]] std::vector<Spot> spotsOfDab(CreationSite& site, const BrushSettings& settings,
                                           std::uint64_t seed, const Dab& dab);

/// The doing of a stroke, apart from its sampling and its end.
class StrokeEffect
{
public:
    virtual ~StrokeEffect() = default;
    /// The next dabs, in order.
    virtual void apply(std::span<const StrokeDab> dabs) = 0;
    /// Everything once more, for strokes that are evaluated from press to current.
    virtual void reevaluate(const StrokeLine& line, double shownSeconds) = 0;
    /// The button is up: what waited for that.
    virtual void end(const StrokeLine& /*line*/) {}
    [[nodiscard]] virtual int affected() const = 0;
    /// Why nobody is affected.
    [[nodiscard]] virtual StrokeReason reason() const = 0;
};

/// Creates people.
class CreationEffect : public StrokeEffect
{
public:
    explicit CreationEffect(StrokeContext& ground);
    void apply(std::span<const StrokeDab> dabs) override;
    void reevaluate(const StrokeLine& line, double shownSeconds) override;
    [[nodiscard]] int affected() const override { return m_created; }
    [[nodiscard]] StrokeReason reason() const override { return m_reason; }

private:
    void create(std::span<const Spot> spots, std::optional<float> strokeHeading);

    StrokeContext& m_ground;
    CreationSite m_site;
    int m_created = 0;
    StrokeReason m_reason = StrokeReason::None;
};

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
    [[nodiscard]] std::vector<IndividualId> selected(const Dab& dab) const;
    /// Those of the ids that this stroke may still change; they are touched from now on.
    [[nodiscard]] std::vector<IndividualId> untouched(std::vector<IndividualId> ids);
    /// The share of them that a delete brush takes.
    [[nodiscard]] std::vector<IndividualId> thinned(std::vector<IndividualId> ids);
    void remove(std::vector<IndividualId> ids);
    void send(std::span<const IndividualId> ids);
    void change(std::span<const IndividualId> ids, const StrokeLine& line, std::uint64_t seed,
                std::optional<float> heading);
    void count(std::span<const IndividualId> changed);

    StrokeContext& m_ground;
    ScenePicker m_picker;
    CrowdFramePtr m_frame;               ///< at the press, with the time of the last dab
    CrowdFramePtr m_shown;               ///< the same, where a session has them; null: none runs
    std::vector<char> m_isTouched;       ///< by row of the frame
    std::vector<char> m_isChanged;       ///< by row of the frame
    std::vector<IndividualId> m_touched; ///< ascending
    int m_affected = 0;
    StrokeReason m_reason = StrokeReason::NobodyUnderBrush;
};

} // namespace crowd::model
