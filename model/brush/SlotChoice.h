// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushSettings.h"
#include "model/template/Template.h"

namespace crowd::model {

/// Whether a slot is skin, hair or face rather than something worn, going by the words of its name.
[[nodiscard]] bool isOfTheBody(const std::string& slot);

/// Which slots of a template the colour brush means.
class ColourSlots
{
public:
    ColourSlots(const Template& asset, const ColourSettings& settings);
    [[nodiscard]] bool contains(const Slot& slot) const;

private:
    const ColourSettings& m_settings;
    bool m_sparesBody; ///< where nothing is worn, the body is meant
};

} // namespace crowd::model
