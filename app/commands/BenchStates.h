// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QJsonObject>

#include "model/document/SceneDocument.h"

namespace crowd::app {

/// What a state of everybody in nearly all columns costs: keeping it, recalling it, taking that
/// back, and a frame of a session half way through a cross-fade, beside one of a session where
/// nobody changes. Adds its figures, milliseconds; changes the document.
void measureStates(model::SceneDocument& document, QJsonObject& report);

} // namespace crowd::app
