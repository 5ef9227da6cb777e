// SPDX-License-Identifier: MIT
#include "model/document/SceneCommand.h"

#include <cassert>
#include <utility>

#include "model/document/SceneDocument.h"

namespace crowd::model {

SceneCommand::SceneCommand(SceneDocument& document, SceneDelta delta, const QString& text)
    : QUndoCommand(text), m_document(document), m_delta(std::move(delta))
{
}

void SceneCommand::undo()
{
    apply(DeltaDirection::Undo);
    m_isApplied = false;
}

void SceneCommand::redo()
{
    if (!m_isApplied) {
        apply(DeltaDirection::Redo);
        m_isApplied = true;
    }
}

void SceneCommand::apply(DeltaDirection direction)
{
    assert(!m_document.isEditOpen());
    applyDelta(m_document.m_scene, m_delta, direction,
               [this](const SceneChange& change) { m_document.announce(change); });
}

} // namespace crowd::model
