// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/brush/BrushContext.h"
#include "model/brush/Sampler.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneEdit.h"
#include "model/pick/ScreenArea.h"

namespace crowd::model {

/// What a stroke works on, shared by its parts.
struct StrokeContext
{
    SceneDocument& document;
    BrushContext context;
    BrushSettings settings;
    std::uint64_t seed = 0;
    std::unique_ptr<SceneEdit> edit;
    std::vector<WorldSeat> seats;                      ///< ascending by id
    std::vector<glm::ivec2> way{};                     ///< of the pointer, grid points, bends alone
    std::vector<std::vector<IndividualId>> selected{}; ///< so far, as RecordedStroke has it
    const RecordedStroke* before = nullptr; ///< whose selection is taken; null: it selects itself
    std::vector<IndividualId> gathered{};   ///< see Stroke::gathered()
};

/// Goes on to a grid point; what lies straight between two bends is left out, so that the way is
/// the same however it was split into inputs.
void extendWay(std::vector<glm::ivec2>& way, glm::ivec2 point);
/// What a stroke with hasWholeArea() is about: between press and current, or inside its way.
[[nodiscard]] ScreenArea wholeArea(const StrokeContext& ground, const StrokeLine& line);

/// A dab with what the stroke has learnt about its way.
struct StrokeDab
{
    Dab dab;
    std::optional<float> heading; ///< of the way, on the ground
};

/// Logical pixels between two dabs along the way; of a spray, as of a point.
[[nodiscard]] double dabSpacing(const BrushSettings& settings);
/// Radius of a dab, logical pixels.
[[nodiscard]] double dabRadius(const BrushSettings& settings, const Dab& dab);
/// The k-th point of a spray's dab: equally spread over the circle.
[[nodiscard]] glm::dvec2 sprayPoint(const BrushSettings& settings, std::uint64_t seed,
                                    const Dab& dab, int k);

/// What a stroke does to the scene, dab by dab; its sampling and its end are Stroke's.
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

} // namespace crowd::model
