// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QUndoCommand>

#include "model/document/SceneDelta.h"

namespace crowd::model {

class SceneDocument;

/// One undo step: a delta that was already applied when it was pushed, so the redo() that push()
/// calls does nothing. Undo and redo are the same swap.
class SceneCommand : public QUndoCommand
{
public:
    SceneCommand(SceneDocument& document, SceneDelta delta, const QString& text);

    void undo() override;
    void redo() override;
    [[nodiscard]] std::size_t bytes() const { return m_delta.bytes(); }

private:
    void apply(DeltaDirection direction);

    SceneDocument& m_document;
    SceneDelta m_delta;
    bool m_isApplied = true;
};

} // namespace crowd::model
