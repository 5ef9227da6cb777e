// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QJsonObject>

#include "model/document/SceneDocument.h"

namespace crowd::app {

/// Ten relations for everybody, and what it costs to paint, to undo, to save and to read them:
/// relation_*. Changes the document. Milliseconds.
void measureRelations(model::SceneDocument& document, QJsonObject& report);

} // namespace crowd::app
