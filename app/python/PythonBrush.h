// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "app/python/ScriptScene.h"
#include "model/brush/BrushSettings.h"

namespace crowd::app {

/// Settings of creation as scripts hold them: they name templates by number, and these are the
/// scenes of those that were given by a handle.
struct PythonCreateSettings : model::CreateSettings
{
    std::vector<std::weak_ptr<ScriptScene>> owners;
};

/// crowdbrush.Brush. Its own `create` stands for the settings' one.
struct PythonBrush : model::BrushSettings
{
    PythonCreateSettings creation;

    [[nodiscard]] model::BrushSettings settings() const
    {
        model::BrushSettings settings = *this;
        settings.create = creation;
        return settings;
    }
};

} // namespace crowd::app
