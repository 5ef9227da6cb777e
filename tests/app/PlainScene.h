// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "model/scene/Scene.h"

namespace crowd::testing {

/// Men on empty ground.
inline model::Scene plainScene(std::size_t people)
{
    model::Scene scene;
    scene.name = "plain";
    scene.cameras.push_back(
        {"front", model::Camera::lookingAt({0.0F, 6.0F, 12.0F}, {0.0F, 0.0F, 0.0F})});
    model::TemplateEntry man;
    man.id = 1;
    man.name = "man";
    man.path = "builtin:templates/man.glb";
    man.clipNames = {"idle"};
    scene.templates.push_back(man);
    std::vector<model::IndividualId> ids;
    for (std::size_t i = 0; i < people; ++i) {
        ids.push_back(scene.nextId++);
    }
    model::IndividualRows rows = model::IndividualRows::withDefaults(ids);
    std::ranges::fill(rows.column(model::columns::templateId), man.id);
    scene.population.add(rows);
    return scene;
}

} // namespace crowd::testing
