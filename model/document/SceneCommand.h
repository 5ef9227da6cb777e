// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <QtGui/QUndoCommand>

#include "model/document/StoredDelta.h"

namespace crowd::model {

class SceneDocument;

/// One undo step: a delta that was already applied when it was pushed, so the redo() that push()
/// calls does nothing. Undo and redo are the same swap. A step that cannot be done (see
/// SceneDocument::undoRefused) leaves the scene alone and stays on the side it was on.
class SceneCommand : public QUndoCommand
{
public:
    SceneCommand(SceneDocument& document, SceneDelta delta, const QString& text);

    void undo() override;
    void redo() override;
    [[nodiscard]] bool isApplied() const { return m_isApplied; }
    [[nodiscard]] const StoredDelta& delta() const { return m_delta; }
    /// Another one for every step of this run of the program, never 0.
    [[nodiscard]] std::uint64_t serial() const { return m_serial; }

private:
    void bringTo(bool isApplied);

    SceneDocument& m_document;
    StoredDelta m_delta;
    bool m_isApplied = true;
    std::uint64_t m_serial;
};

} // namespace crowd::model
