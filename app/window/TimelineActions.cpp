// SPDX-License-Identifier: MIT
#include "app/window/TimelineActions.h"

#include "app/window/MainWindow.h"
#include "widgets/commands/TimelineCommands.h"

namespace crowd::app {

namespace {

using widgets::ActionInput;

const WindowAction kTimelineActions[] = {
    {{"timeline-record", QT_TRANSLATE_NOOP("Actions", "R&ecord into the Timeline"), "record",
      "Ctrl+Alt+T",
      QT_TRANSLATE_NOOP("Actions", "Cues, states and events become marks as they are performed"),
      true},
     [](MainWindow& w, bool on) { w.state().session().recorder().setOn(on); },
     {.inputs = ActionInput::Session,
      .isChecked = [](MainWindow& w) { return w.state().session().recorder().isOn(); }}},
    {{"mark-add", QT_TRANSLATE_NOOP("Actions", "Add &Marker"), "mark", "Ctrl+M",
      QT_TRANSLATE_NOOP("Actions", "A marker in the timeline at this moment")},
     [](MainWindow& w, bool) { widgets::addMarkerNow(w.state()); }},
    {{"mark-back", QT_TRANSLATE_NOOP("Actions", "Former Mar&k"), "mark-back", "Ctrl+Shift+Left",
      QT_TRANSLATE_NOOP("Actions", "Show the moment of the mark before this one")},
     [](MainWindow& w, bool) { widgets::showNextMark(w.state(), false); }},
    {{"mark-next", QT_TRANSLATE_NOOP("Actions", "&Next Mark"), "mark-next", "Ctrl+Shift+Right",
      QT_TRANSLATE_NOOP("Actions", "Show the moment of the mark after this one")},
     [](MainWindow& w, bool) { widgets::showNextMark(w.state(), true); }},
};

} // namespace

std::span<const WindowAction> timelineActions()
{
    return kTimelineActions;
}

} // namespace crowd::app
