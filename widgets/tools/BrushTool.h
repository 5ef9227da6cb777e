// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/brush/BrushSettings.h"
#include "widgets/tools/PickDrag.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Paints with the active brush: one stroke, one undo step. Shift and dragging resizes.
class BrushTool : public Tool
{
public:
    BrushTool(const ToolContext& context, model::BrushKind kind);

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] DragSessionPtr press(const ToolInput& input) override;
    void hover(const ToolInput& input, ToolPicture& picture) const override;
    void preview(const ToolInput& input, ToolPicture& picture) const override;

private:
    [[nodiscard]] const model::BrushSettings& settings() const;
    [[nodiscard]] std::uint64_t nextSeed() const;
    /// What a click picks instead of painting.
    [[nodiscard]] std::optional<PickKind> pickFor(Qt::KeyboardModifiers modifiers) const;
    [[nodiscard]] DragSessionPtr scriptStroke(std::uint64_t seed, const ToolInput& input);
    [[nodiscard]] bool isSourceMissing() const;
    void showTarget(ToolPicture& picture) const;

    ToolContext m_context;
    model::BrushKind m_kind;
    std::uint64_t m_strokes = 0; ///< begun so far: each has a seed of its own
};

/// The settings that a button paints with: with the paper's mapping each button has its selection.
[[nodiscard]] model::BrushSettings settingsForButton(const model::BrushSettings& settings,
                                                     Qt::MouseButton button, ButtonMapping mapping);

/// Larger or smaller by a share of the present size, at least a pixel.
[[nodiscard]] model::BrushSettings resizedBySteps(const model::BrushSettings& settings,
                                                  double steps, bool isFine = false);
/// The main number by steps.
[[nodiscard]] model::BrushSettings steppedMainNumber(const model::BrushSettings& settings,
                                                     int steps);

} // namespace crowd::widgets
