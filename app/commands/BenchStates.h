// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <QtCore/QJsonObject>

#include "model/document/SceneDocument.h"

namespace crowd::app {

/// What a state of everybody in nearly all columns costs: keeping it, recalling it, taking that
/// back, and a frame of a session half way through a cross-fade, beside one of a session where
/// nobody changes. Adds its figures, milliseconds; changes the document.
void measureStates(model::SceneDocument& document, QJsonObject& report);

/// Everybody gets values of his own in what can be painted, decided by the seed.
void shuffleLooks(model::Scene& scene, std::uint64_t seed);

} // namespace crowd::app
