// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"

namespace crowd::widgets {

/// What a form changes of a scene: each change is an undo step, those of a slider that is held are
/// one, and seen while it lasts. The document outlives it. Main thread.
class HeldEdit : public QObject
{
    Q_OBJECT

public:
    HeldEdit(model::SceneDocument& document, QObject* parent);

    /// False: nothing can be edited now.
    bool put(const QString& undoText, const std::function<void(model::SceneEdit&)>& apply);
    void hold(bool isHeld);

private:
    model::SceneDocument& m_document;
    std::unique_ptr<model::SceneEdit> m_edit; ///< while something is held
    QString m_undoText;                       ///< of what was put meanwhile
};

} // namespace crowd::widgets
