// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/brush/BrushSettings.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// What a brush can take from the picture.
enum class PickKind : std::uint8_t {
    Colour, ///< of the person's slot under the cursor
    Point,  ///< that people are to face
    Person  ///< what the brush's settings take from somebody
};

/// What Ctrl and a click picks with a brush; nothing for those without.
[[nodiscard]] std::optional<PickKind> pickOfBrush(model::BrushKind kind);
/// What the pointer does then, for the plate above the picture.
[[nodiscard]] QString pickText(PickKind kind);

/// Takes from the picture what is under the pointer, as long as the button is held: the dropper.
class PickDrag : public DragSession
{
public:
    PickDrag(const ToolContext& context, model::BrushKind brush, PickKind kind,
             const ToolInput& press);

    void update(const ToolInput& input) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    void show(ToolPicture& picture) const override;

private:
    void pick();
    void pickFromPerson();
    void pickPoint();

    ToolContext m_context;
    model::BrushSettings m_before;
    PickKind m_kind;
    ToolInput m_current;
    QString m_label;         ///< what was taken
    bool m_isPerson = false; ///< somebody is under the pointer
};

} // namespace crowd::widgets
