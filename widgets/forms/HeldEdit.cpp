// SPDX-License-Identifier: MIT
#include "widgets/forms/HeldEdit.h"

#include <utility>

namespace crowd::widgets {

HeldEdit::HeldEdit(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&document, &model::SceneDocument::editInterrupted, this, [this] { m_edit.reset(); });
}

bool HeldEdit::put(const QString& undoText, const std::function<void(model::SceneEdit&)>& apply)
{
    if (m_edit) {
        m_undoText = undoText;
        apply(*m_edit);
        return true;
    }
    return m_document.edit(undoText, apply) != model::EditOutcome::Refused;
}

void HeldEdit::hold(bool isHeld)
{
    if (isHeld && !m_edit) {
        if (auto edit = m_document.beginEdit()) {
            m_edit = std::move(edit).value();
        }
    } else if (!isHeld && m_edit) {
        const std::unique_ptr<model::SceneEdit> edit = std::move(m_edit);
        edit->commit(m_undoText);
    }
}

} // namespace crowd::widgets
