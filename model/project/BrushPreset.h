// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"

/// Brushes kept as files: JSON with the format's name and version, the preset's name and the brush
/// (BrushJson.h). The panel of presets and scripts read and write the same.
namespace crowd::model {

/// A brush kept under a name. Words of the name that begin with # are tags.
struct BrushPreset
{
    QString name; ///< with its tags; single spaces between words
    QString file; ///< empty: in none yet
    BrushKind kind = BrushKind::Create;
    std::string json; ///< of the brush; what means something in one scene alone is not in it

    friend bool operator==(const BrushPreset& a, const BrushPreset& b) = default;
};

/// Where the editor keeps the artist's presets. Outside the editor it is the same folder.
[[nodiscard]] QString presetFolder();

[[nodiscard]] BrushPreset presetOf(const QString& name, const BrushSettings& brush);
/// The brush as it is kept; what the preset does not say is as in `now`, of the same kind.
[[nodiscard]] BrushSettings applied(const BrushPreset& preset, const BrushSettings& now);

/// Errors name the file, the place in it and what to do.
[[nodiscard]] Result<BrushPreset> readPreset(const QString& path);
/// Whole or not at all. Fails without a name.
[[nodiscard]] Result<void> writePreset(const BrushPreset& preset, const QString& path);

} // namespace crowd::model
