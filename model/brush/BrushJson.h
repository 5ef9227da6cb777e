// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"

/// A brush as it is set, as JSON: what presets are kept as, and what the editor remembers. The
/// members are the fields of BrushSettings, "brush" with the kind's id, and "settings" with the
/// fields of the kind alone.
namespace crowd::model {

/// Which fields: all, or those alone that outlast a scene (FieldMeta::isRemembered), or these and
/// what names something by a word, which another scene may have too.
enum class BrushFields : std::uint8_t { All, Remembered, Portable };

[[nodiscard]] nlohmann::json brushJson(const BrushSettings& brush,
                                       BrushFields which = BrushFields::All);

/// What is not there is as initialBrush() has it. Fails where "brush" is none that there is, where
/// a value is wrong, and at members that no field knows: each is named.
[[nodiscard]] Result<BrushSettings> brushFromJson(const nlohmann::json& json);

/// Settings that another program version may have kept: what is not there, wrong or unknown leaves
/// `brush` as it is in that.
[[nodiscard]] BrushSettings withRemembered(BrushSettings brush, const nlohmann::json& json,
                                           BrushFields which = BrushFields::Remembered);

} // namespace crowd::model
