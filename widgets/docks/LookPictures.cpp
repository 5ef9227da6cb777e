// SPDX-License-Identifier: MIT
#include "widgets/docks/LookPictures.h"

#include <QtWidgets/QWidget>

#include "model/view/PropertyPaint.h"
#include "render/SceneLook.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

LookPictures::LookPictures(EditorState& state, QWidget& panel)
    : ViewPictures(state, kSize, "look", &panel), m_panel(panel)
{
}

QIcon LookPictures::of(const model::LookPreset& look)
{
    model::LookPreset& known = m_looks[look.id];
    if (known != look) {
        known = look;
        redraw(look.id);
    }
    return pictureOf(look.id);
}

bool LookPictures::isSeen() const
{
    return m_panel.isVisible();
}

model::CrowdFramePtr LookPictures::frameOf(std::uint32_t id, render::RenderInput& input) const
{
    const model::LookPreset* look = model::findLook(state().scene().looks, id);
    if (look == nullptr) {
        return nullptr;
    }
    render::useLook(input, *look);
    model::CrowdFramePtr frame = state().frame();
    return look->style == model::LookStyle::Property
               ? model::framePaintedBy(state().scene(), *frame, look->property)
               : frame;
}

} // namespace crowd::widgets
