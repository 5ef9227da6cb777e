// SPDX-License-Identifier: MIT
#include "app/pictures/LookWish.h"

#include <algorithm>
#include <utility>

#include "model/view/PropertyPaint.h"
#include "render/SceneLook.h"

namespace crowd::app {

namespace {

std::string keysOf(const model::Scene& scene)
{
    std::string all = render::lookKeys();
    for (const model::LookPreset& each : scene.looks) {
        all += ", " + each.name;
    }
    return all;
}

/// Of the camera that is wished for; null: there is none.
const model::LookPreset* lookOfCamera(const LookWish& wish, const model::Scene& scene)
{
    if (wish.directed) {
        return model::findLook(scene.looks, *wish.directed);
    }
    if (!wish.camera || scene.cameras.empty()) {
        return nullptr;
    }
    const auto camera = wish.camera->empty() ? scene.cameras.begin()
                                             : std::ranges::find(scene.cameras, *wish.camera,
                                                                 &model::NamedCamera::name);
    return camera != scene.cameras.end() ? model::findLook(scene.looks, camera->look) : nullptr;
}

} // namespace

model::Result<ChosenLook> chosenLook(const LookWish& wish, const model::Scene& scene)
{
    ChosenLook chosen;
    const bool isNamed = !wish.look.empty();
    const model::LookPreset* own =
        isNamed ? model::findLook(scene.looks, wish.look) : lookOfCamera(wish, scene);
    if (own != nullptr) {
        chosen = {render::lookOf(own->style), own->property, *own};
    } else if (!isNamed) {
        chosen.look = render::Look::Lit;
    } else if (const auto look = render::lookOfKey(wish.look)) {
        chosen.look = *look;
    } else {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "There is no look \"%1\"; there are: %2."), wish.look,
            keysOf(scene)};
    }
    if (!wish.by.empty()) {
        if (isNamed && chosen.look != render::Look::Lit && chosen.look != render::Look::Property) {
            return model::Error{
                QT_TRANSLATE_NOOP("Messages", "Colours by \"%1\" are of the look \"property\", not "
                                              "of \"%2\": leave one of the two out."),
                wish.by, wish.look};
        }
        chosen.look = render::Look::Property;
        chosen.property = wish.by;
        if (chosen.own) {
            chosen.own->style = model::LookStyle::Property;
        }
    }
    if (render::lookInfo(chosen.look).isByProperty) {
        if (auto known = model::checkProperty(scene, chosen.property); !known) {
            return known.error();
        }
    }
    return chosen;
}

model::CrowdFramePtr colouredBy(const ChosenLook& look, const model::Scene& scene,
                                model::CrowdFramePtr frame)
{
    return render::lookInfo(look.look).isByProperty
               ? model::framePaintedBy(scene, *frame, look.property)
               : std::move(frame);
}

} // namespace crowd::app
