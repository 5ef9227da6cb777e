// SPDX-License-Identifier: MIT
#include "widgets/state/ShownLook.h"

#include <algorithm>

#include "render/SceneLook.h"

namespace crowd::widgets {

using model::LookId;
using model::LookPreset;
using model::NamedCamera;

const LookPreset* shownLook(const EditorState& state)
{
    return model::findLook(state.scene().looks, state.viewOptions().ownLook);
}

void showLook(EditorState& state, LookId id)
{
    ViewOptions options = state.viewOptions();
    const bool hadOne = options.ownLook != 0;
    options.ownLook = id;
    if (const LookPreset* look = model::findLook(state.scene().looks, id)) {
        options.look = render::lookOf(look->style);
        options.property = look->property;
    } else if (hadOne) {
        options.look = ViewOptions().look; // that of the look is gone with it
    }
    state.setViewOptions(options);
}

void showLookOf(EditorState& state, const NamedCamera& camera)
{
    const auto& cameras = state.scene().cameras;
    const LookId shown = state.viewOptions().ownLook;
    const bool isOfAnother =
        shown != 0 && std::ranges::find(cameras, shown, &NamedCamera::look) != cameras.end();
    if (model::findLook(state.scene().looks, camera.look) != nullptr) {
        showLook(state, camera.look);
    } else if (isOfAnother) {
        showLook(state, 0);
    }
}

} // namespace crowd::widgets
