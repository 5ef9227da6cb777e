// SPDX-License-Identifier: MIT
#include "app/python/ScriptSceneParts.h"

namespace crowd::app {

using namespace model;

/// On the document's thread, as all that asks what is open.
Result<void> ScriptScene::refuseDuringEdit(const char* what) const
{
    if (m_link) {
        return Error{std::string(what) +
                     " is not possible in a brush: all it does belongs to one stroke."};
    }
    if (m_edit) {
        return Error{std::string(what) +
                     " is not possible inside 'with scene.edit(...)': end that block first."};
    }
    return {};
}

/// Somebody paints by hand at this moment: threads that a script left behind may come any time.
Result<void> ScriptScene::refuseDuringStroke() const
{
    if (!m_edit && !m_link && m_host.document->isEditOpen()) {
        return Error{"Somebody is painting in the window: try again when the stroke has ended."};
    }
    return {};
}

Result<bool> ScriptScene::step(bool isUndo)
{
    return onDocument([&]() -> Result<bool> {
        if (auto allowed = refuseDuringEdit(isUndo ? "Undo" : "Redo"); !allowed) {
            return allowed.error();
        }
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        QUndoStack& stack = m_host.document->undoStack();
        if (!(isUndo ? stack.canUndo() : stack.canRedo())) {
            return false;
        }
        QString refusal;
        const auto connection = QObject::connect(m_host.document, &SceneDocument::undoRefused,
                                                 [&refusal](const QString& why) { refusal = why; });
        isUndo ? stack.undo() : stack.redo();
        QObject::disconnect(connection);
        if (!refusal.isEmpty()) {
            return Error{refusal.toStdString()};
        }
        return true;
    });
}

Result<bool> ScriptScene::undo()
{
    return step(true);
}

Result<bool> ScriptScene::redo()
{
    return step(false);
}

std::vector<std::string> ScriptScene::history() const
{
    return onDocument([this] {
        std::vector<std::string> texts;
        const QUndoStack& stack = m_host.document->undoStack();
        texts.reserve(static_cast<std::size_t>(stack.count()));
        for (int i = 0; i < stack.count(); ++i) {
            texts.push_back(stack.text(i).toStdString());
        }
        return texts;
    });
}

int ScriptScene::historyIndex() const
{
    return onDocument([this] { return m_host.document->undoStack().index(); });
}

Result<void> ScriptScene::beginEdit(const std::string& text)
{
    return onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringEdit("Another edit"); !allowed) {
            return allowed;
        }
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        m_edit = m_host.document->beginEdit();
        m_editText = QString::fromStdString(text);
        return {};
    });
}

void ScriptScene::endEdit(bool isKept)
{
    m_host.run([this, isKept] {
        if (m_edit && isKept) {
            m_edit->commit(m_editText);
        }
        m_edit.reset(); // takes back what was not committed
    });
}

void ScriptScene::joinStroke(const ScriptStrokeLinkPtr& link)
{
    m_host.run([&] { m_link = link; });
}

void ScriptScene::leaveStroke()
{
    try {
        m_host.run([this] { m_link.reset(); });
    } catch (const std::exception&) {
        return; // the editor is closing: nobody will edit any more
    }
}

Result<void> ScriptScene::edit(const QString& text, const Work& work)
{
    if (m_link) {
        if (m_link->edit() == nullptr) {
            return Error{"The stroke was taken back."};
        }
        work(*m_link->edit());
        return {};
    }
    if (m_edit) {
        work(*m_edit);
        return {};
    }
    if (auto allowed = refuseDuringStroke(); !allowed) {
        return allowed;
    }
    const auto own = m_host.document->beginEdit();
    work(*own);
    own->commit(text);
    return {};
}

} // namespace crowd::app
