// SPDX-License-Identifier: MIT
#include "app/window/Autosaver.h"

#include "model/base/Translated.h"
#include "model/project/Autosave.h"

namespace crowd::app {

Autosaver::Autosaver(widgets::EditorState& state, QObject* parent) : QObject(parent), m_state(state)
{
    connect(&m_timer, &QTimer::timeout, this, &Autosaver::keep);
}

void Autosaver::setSeconds(int seconds)
{
    m_timer.stop();
    if (seconds > 0) {
        m_timer.start(seconds * 1000);
    }
}

void Autosaver::forget()
{
    model::removeAutosave(m_state.document().path());
    m_keptRevision.reset();
}

void Autosaver::adopt(const QString& recovery)
{
    model::adoptRecovery(recovery, m_state.document().path());
    m_keptRevision = m_state.document().revision();
}

void Autosaver::keep()
{
    const model::SceneDocument& document = m_state.document();
    if (document.isEditOpen()) {
        return; // a stroke that may yet be taken back
    }
    if (!document.isModified()) {
        if (m_keptRevision) {
            forget();
        }
        return;
    }
    if (m_keptRevision == document.revision()) {
        return;
    }
    if (const auto kept = model::writeAutosave(document.scene(), document.path()); kept) {
        m_keptRevision = document.revision();
        m_hasFailed = false;
    } else if (!m_hasFailed) {
        m_state.showStatus(tr("Unsaved work is not kept for the case of a crash. %1")
                               .arg(model::translated(kept.error())));
        m_hasFailed = true;
    }
}

} // namespace crowd::app
