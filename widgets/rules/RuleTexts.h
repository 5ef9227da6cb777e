// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/scene/Scene.h"

/// Rules as sentences in the artist's language.
namespace crowd::widgets {

[[nodiscard]] QString tagText(const model::Scene& scene, std::uint8_t tag);
/// "When wave reaches someone seated: tell those near, play sit_cheer".
[[nodiscard]] QString ruleSentence(const model::Scene& scene, const model::Rule& rule);

} // namespace crowd::widgets
