// SPDX-License-Identifier: MIT
#include "widgets/state/Cues.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtGui/QShortcut>
#include <QtWidgets/QWidget>

#include "widgets/state/SceneChanges.h"
#include "widgets/state/ShownTake.h"

namespace crowd::widgets {

namespace {

struct CueText
{
    Q_DECLARE_TR_FUNCTIONS(Cues)
};

const model::State* stateOf(const model::Scene& scene, const model::Cue& cue)
{
    const auto found = std::ranges::find(scene.states, cue.state, &model::State::id);
    return found == scene.states.end() ? nullptr : &*found;
}

/// The cue called as it is called now.
model::Mark calling(const EditorState& state, const model::Cue& cue)
{
    model::Mark mark;
    mark.kind = model::MarkKind::Cue;
    mark.cue = cue.id;
    const glm::vec3 forward = state.camera().forward();
    mark.headingRadians = std::atan2(forward.x, forward.z);
    if (cue.reach == model::CueReach::Selected) {
        const auto& ids = state.selection().ids();
        mark.people.assign(ids.begin(), ids.end());
    }
    return mark;
}

bool canBegin(EditorState& state, const model::Cue& cue)
{
    if (saysThatTakeIsShown(state)) {
        return false;
    }
    const bool isPlaying = state.transport().isPlaying();
    if (!state.session().isRunning() && isPlaying && state.session().surfaceProgress() >= 0.0) {
        state.showStatus(CueText::tr("Where characters can walk is still being found: they hear "
                                     "cues from when they begin to move."));
        return false;
    }
    const bool beginsItself = isPlaying && stateOf(state.scene(), cue) != nullptr;
    if (!state.session().isRunning() && !beginsItself) {
        state.showStatus(CueText::tr("Press Play first: cues speak to characters while it plays."));
        return false;
    }
    return true;
}

} // namespace

QString cueTitle(const model::Scene& scene, const model::Cue& cue)
{
    const model::State* kept = stateOf(scene, cue);
    return QString::fromStdString(!cue.name.empty()    ? cue.name
                                  : !cue.event.empty() ? cue.event
                                  : kept != nullptr    ? kept->name
                                                       : std::string());
}

void sendCue(EditorState& state, const model::Cue& cue)
{
    if (!canBegin(state, cue)) {
        return;
    }
    const QString name = cueTitle(state.scene(), cue);
    const model::Mark mark = calling(state, cue);
    if (cue.reach == model::CueReach::Selected && mark.people.empty()) {
        state.showStatus(CueText::tr("Nobody is selected who could hear “%1”.").arg(name));
        return;
    }
    if (cue.state != 0 && stateOf(state.scene(), cue) == nullptr) {
        state.showStatus(CueText::tr("The state that “%1” recalls is not there any more: choose "
                                     "another one.")
                             .arg(name));
        return;
    }
    (void)state.session().perform(mark);
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
