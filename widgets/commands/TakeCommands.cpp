// SPDX-License-Identifier: MIT
#include "widgets/commands/TakeCommands.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>

#include "behavior/session/MotionCache.h"
#include "widgets/state/ShownTake.h"

namespace crowd::widgets {

namespace {

struct TakeText
{
    Q_DECLARE_TR_FUNCTIONS(TakeCommands)
};

/// Seconds of the clock.
std::pair<double, double> stretchOf(const EditorState& state, const model::Take& take,
                                    const model::RetakeSettings& how)
{
    const model::PlayRange& range = state.scene().playRange;
    const bool isRange = range.isSet() && range.end > take.begin && range.begin < take.end;
    if (how.stretch == model::RetakeStretch::PlayRange && isRange) {
        return {range.begin, range.end};
    }
    const double now = state.transport().seconds();
    if (how.stretch == model::RetakeStretch::PlayRange && now >= take.end) {
        return {take.begin, take.end}; // nobody has said from where, and nothing is left of it
    }
    return {now, how.stretch == model::RetakeStretch::ForSeconds
                     ? std::min(take.end, now + static_cast<double>(how.seconds))
                     : take.end};
}

} // namespace

bool canKeepTake(const EditorState& state)
{
    const SessionControl& session = state.session();
    const auto motion = session.isRunning() ? session.motion() : nullptr;
    return motion && motion->extent().steps > 0 && state.takes().keptShare() < 0.0F;
}

void keepTake(EditorState& state)
{
    if (saysThatTakeIsShown(state)) {
        return;
    }
    const QString name = freeTakeName(state.scene());
    if (!canKeepTake(state) || !state.takes().keep(name)) {
        state.showStatus(
            state.takes().keptShare() >= 0.0F ? TakeText::tr("Another take is still being kept.")
            : state.scene().hasBehaviour()
                ? TakeText::tr("Nothing has been played yet: press Play first.")
                : TakeText::tr(
                      "Nobody walks or follows rules here: there is nothing to keep yet."));
    }
}

bool canRetake(const EditorState& state)
{
    return state.session().take() != 0 && !state.selection().isEmpty() &&
           state.takes().keptShare() < 0.0F;
}

bool retake(EditorState& state, std::span<const model::IndividualId> ids,
            const model::RetakeSettings& how)
{
    const model::Take* shown = model::findTake(state.scene().takes, state.session().take());
    if (shown == nullptr) {
        return false;
    }
    const auto [begin, end] = stretchOf(state, *shown, how);
    return state.takes().retake({ids.begin(), ids.end()}, begin, end, how.isDifferent);
}

void retakeSelected(EditorState& state)
{
    const model::Take* shown = model::findTake(state.scene().takes, state.session().take());
    if (shown == nullptr) {
        state.showStatus(TakeText::tr("Keep what was played as a take and show it: then the "
                                      "selected characters can be taken again."));
        return;
    }
    const auto& ids = state.selection().ids();
    if (ids.empty()) {
        state.showStatus(TakeText::tr("Select those who are to be taken again."));
        return;
    }
    if (!retake(state, ids, model::RetakeSettings())) {
        state.showStatus(TakeText::tr("Another take is still being kept."));
    }
}

void showTake(EditorState& state, model::TakeId id)
{
    state.takes().show(id);
    const model::Take* take = model::findTake(state.scene().takes, id);
    if (take == nullptr) {
        state.showStatus(TakeText::tr("The scene as it plays. Press Play to run it."));
        return;
    }
    const QString problem = state.session().takeProblem();
    state.showStatus(
        problem.isEmpty()
            ? TakeText::tr("The take \"%1\" is shown.").arg(QString::fromStdString(take->name))
            : problem);
}

void showNextTake(EditorState& state)
{
    const model::Takes& takes = state.scene().takes;
    if (takes.empty()) {
        state.showStatus(TakeText::tr("There are no takes yet: play, then keep what was played."));
        return;
    }
    const model::Take* shown = model::shownTake(takes);
    const auto next = shown == nullptr ? takes.begin() : takes.begin() + (shown - takes.data()) + 1;
    showTake(state, next == takes.end() ? 0 : next->id);
}

} // namespace crowd::widgets
