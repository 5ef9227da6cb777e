// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushSettings.h"
#include "model/template/Template.h"

namespace crowd::model {

/// Whether a slot is skin, hair or face rather than something worn, going by the words of its name.
[[nodiscard]] bool isOfTheBody(const std::string& slot);

/// Which slots of a template a brush means.
class ColourSlots
{
public:
    /// `slot` by name, empty: all, where `sparesBody` leaves out skin, hair and face.
    ColourSlots(const Template& asset, const std::string& slot, bool sparesBody);
    ColourSlots(const Template& asset, const ColourSettings& settings)
        : ColourSlots(asset, settings.slot, settings.sparesBody)
    {
    }
    [[nodiscard]] bool contains(const Slot& slot) const;

private:
    const std::string& m_slot;
    bool m_sparesBody; ///< where nothing is worn, the body is meant
};

} // namespace crowd::model
