// SPDX-License-Identifier: MIT
#include "model/scene/LookPreset.h"

#include <algorithm>
#include <cstddef>

#include "model/scene/ReadyLight.h"

namespace crowd::model {

const LookPreset* findLook(const Looks& looks, LookId id)
{
    const auto found = std::ranges::find(looks, id, &LookPreset::id);
    return found == looks.end() ? nullptr : &*found;
}

const LookPreset* findLook(const Looks& looks, const std::string& name)
{
    const auto found = std::ranges::find(looks, name, &LookPreset::name);
    return found == looks.end() ? nullptr : &*found;
}

Lighting lightIn(const LookPreset& look, const Lighting& scenes)
{
    if (look.light == LookLight::Own) {
        return look.ownLight;
    }
    const auto* ready = findReadyLight(kLookLights[static_cast<std::size_t>(look.light)].key);
    return ready != nullptr ? litAs(*ready, scenes) : scenes;
}

} // namespace crowd::model
