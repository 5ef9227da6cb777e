// SPDX-License-Identifier: MIT
#include "widgets/state/Cues.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtGui/QShortcut>
#include <QtWidgets/QWidget>

#include "model/states/StateKeeping.h"
#include "widgets/state/SceneChanges.h"

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

/// Those whom a cue reaches now; nothing: nobody is selected.
std::optional<std::vector<model::IndividualId>> reachedBy(EditorState& state, const model::Cue& cue)
{
    const model::Population& people = state.scene().population;
    if (cue.reach == model::CueReach::Everybody) {
        return std::vector<model::IndividualId>(people.ids().begin(), people.ids().end());
    }
    if (cue.reach == model::CueReach::Selected) {
        const auto& ids = state.selection().ids();
        return ids.empty()
                   ? std::nullopt
                   : std::optional(std::vector<model::IndividualId>(ids.begin(), ids.end()));
    }
    const model::CrowdFramePtr shown = state.frame();
    const auto tags = shown->population.column(model::columns::tags);
    std::vector<model::IndividualId> tagged;
    for (std::size_t row = 0; row < tags.size(); ++row) {
        if ((tags[row] >> cue.tag & 1U) != 0) {
            tagged.push_back(shown->population.ids()[row]);
        }
    }
    return tagged;
}

model::RecallTiming timingOf(const EditorState& state, const model::Cue& cue)
{
    const glm::vec3 forward = state.camera().forward();
    return {cue.seconds, {cue.spread, cue.order, cue.point, std::atan2(forward.x, forward.z)}};
}

bool canBegin(EditorState& state, const model::Cue& cue)
{
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
    const auto people = reachedBy(state, cue);
    if (!people) {
        state.showStatus(CueText::tr("Nobody is selected who could hear “%1”.").arg(name));
        return;
    }
    if (const model::State* kept = stateOf(state.scene(), cue)) {
        (void)state.session().recall({kept->id, peopleOf(state.scene(), *kept, &*people),
                                      kept->columns, timingOf(state, cue)});
    } else if (cue.state != 0) {
        state.showStatus(CueText::tr("The state that “%1” recalls is not there any more: choose "
                                     "another one.")
                             .arg(name));
        return;
    }
    if (!cue.event.empty() && cue.reach == model::CueReach::Tagged) {
        state.session().sendTagged({cue.event, cue.payload}, cue.tag);
    } else if (!cue.event.empty()) {
        state.session().send({cue.event, cue.payload}, *people);
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
