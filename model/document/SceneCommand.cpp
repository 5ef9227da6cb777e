// SPDX-License-Identifier: MIT
#include "model/document/SceneCommand.h"

#include <atomic>
#include <utility>

#include "model/document/SceneDocument.h"

namespace crowd::model {

namespace {

std::uint64_t nextSerial()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

SceneCommand::SceneCommand(SceneDocument& document, SceneDelta delta, const QString& text)
    : QUndoCommand(text), m_document(document), m_delta(document.m_undoMemory, std::move(delta)),
      m_serial(nextSerial())
{
}

void SceneCommand::undo()
{
    bringTo(false);
}

void SceneCommand::redo()
{
    bringTo(true);
}

void SceneCommand::bringTo(bool isApplied)
{
    if (isApplied != m_isApplied &&
        m_document.applyStep(m_delta, isApplied ? DeltaDirection::Redo : DeltaDirection::Undo)) {
        m_isApplied = isApplied;
    }
}

} // namespace crowd::model
