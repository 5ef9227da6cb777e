// SPDX-License-Identifier: MIT
#include "model/scene/LookPreset.h"

#include <algorithm>

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

} // namespace crowd::model
