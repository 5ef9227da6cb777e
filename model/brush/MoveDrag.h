// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "model/brush/BrushContext.h"
#include "model/brush/PointerInput.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"

namespace crowd::model {

/// Dragging individuals with the select tool: on the ground they keep their places to each other
/// and stand up from their seats; with the seat grid on, those near a seat sit down in it, and
/// whoever sat there takes the place that they had.
/// Owned by the drag; destruction without finish() takes everything back. Main thread.
class MoveDrag
{
public:
    /// `ids` ascending, all present. The pixel under the press stays under the pointer. Null
    /// while something else is edited.
    [[nodiscard]] static std::unique_ptr<MoveDrag> begin(SceneDocument& document,
                                                         const BrushContext& context,
                                                         std::span<const IndividualId> ids,
                                                         bool ontoSeats, const PointerInput& press);
    ~MoveDrag();
    MoveDrag(const MoveDrag&) = delete;
    MoveDrag& operator=(const MoveDrag&) = delete;

    void move(const PointerInput& input);
    [[nodiscard]] StrokeOutcome finish();
    void cancel();

private:
    struct Private;
    explicit MoveDrag(std::unique_ptr<Private> data);
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::model
