// SPDX-License-Identifier: MIT
#include "widgets/docks/StatePictures.h"

#include <algorithm>
#include <utility>

#include "model/states/StateKeeping.h"
#include "render/SceneLook.h"
#include "widgets/state/EditorState.h"
#include "widgets/state/ShownLook.h"

namespace crowd::widgets {

StatePictures::StatePictures(EditorState& state, QObject* parent)
    : ViewPictures(state, kSize, "state", parent)
{
}

QIcon StatePictures::of(const model::State& kept)
{
    std::shared_ptr<const model::StoredRows>& people = m_people[kept.id];
    if (people != kept.people) {
        people = kept.people;
        redraw(kept.id);
    }
    return pictureOf(kept.id);
}

model::CrowdFramePtr StatePictures::frameOf(std::uint32_t id, render::RenderInput& input) const
{
    const auto& states = state().scene().states;
    const auto kept = std::ranges::find(states, id, &model::State::id);
    if (kept == states.end()) {
        return nullptr;
    }
    input.look = state().viewOptions().look;
    if (const model::LookPreset* look = shownLook(state())) {
        render::useLook(input, *look);
    }
    model::Scene scene = state().scene();
    (void)recallState(scene, *kept, kept->columns);
    model::CrowdFrame frame = *state().document().frame(state().transport().seconds());
    frame.population = std::move(scene.population);
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

} // namespace crowd::widgets
