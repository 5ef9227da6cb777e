// SPDX-License-Identifier: MIT
#include "widgets/state/Cues.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtGui/QShortcut>
#include <QtWidgets/QWidget>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

struct CueText
{
    Q_DECLARE_TR_FUNCTIONS(Cues)
};

} // namespace

void sendCue(EditorState& state, const model::Cue& cue)
{
    if (!state.session().isRunning() && state.transport().isPlaying() &&
        state.session().surfaceProgress() >= 0.0) {
        state.showStatus(CueText::tr("Where characters can walk is still being found: they hear "
                                     "cues from when they begin to move."));
        return;
    }
    if (!state.session().isRunning()) {
        state.showStatus(CueText::tr("Press Play first: cues speak to characters while it plays."));
        return;
    }
    const model::EventSettings event{cue.event, cue.payload};
    const QString name = QString::fromStdString(cue.event);
    switch (cue.reach) {
    case model::CueReach::Everybody:
        state.session().send(event, state.scene().population.ids());
        break;
    case model::CueReach::Selected:
        if (state.selection().isEmpty()) {
            state.showStatus(CueText::tr("Nobody is selected who could hear “%1”.").arg(name));
            return;
        }
        state.session().send(event, state.selection().ids());
        break;
    case model::CueReach::Tagged:
        state.session().sendTagged(event, cue.tag);
        break;
    }
    state.showStatus(CueText::tr("Cue: “%1”").arg(name));
}

CueKeys::CueKeys(EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window)
{
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::RulesChanged, model::SceneReplaced>(change)) {
                    rebuild();
                }
            });
    rebuild();
}

void CueKeys::rebuild()
{
    for (QShortcut* shortcut : m_shortcuts) {
        shortcut->setEnabled(false); // it may be the one that is being run
        shortcut->deleteLater();
    }
    m_shortcuts.clear();
    std::vector<std::string> known;
    for (const model::Cue& cue : m_state.scene().cues) {
        if (cue.key.empty() || std::ranges::find(known, cue.key) != known.end()) {
            continue; // the first one has the key
        }
        known.push_back(cue.key);
        auto* shortcut = new QShortcut(QKeySequence(QString::fromStdString(cue.key)), m_window);
        shortcut->setAutoRepeat(false);
        connect(shortcut, &QShortcut::activated, this, [this, id = cue.id] {
            const auto& cues = m_state.scene().cues;
            const auto found = std::ranges::find(cues, id, &model::Cue::id);
            if (found != cues.end()) {
                sendCue(m_state, *found);
            }
        });
        m_shortcuts.push_back(shortcut);
    }
}

} // namespace crowd::widgets
