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
    {{"camera-mark", QT_TRANSLATE_NOOP("Actions", "&Camera as Now"), "camera-mark", "Ctrl+Alt+K",
      QT_TRANSLATE_NOOP("Actions", "From this moment of the timeline on the camera looks as the "
                                   "view does now")},
     [](MainWindow& w, bool) { widgets::addCameraNow(w.state()); }},
    {{"camera-follow", QT_TRANSLATE_NOOP("Actions", "Follow the T&imeline"), "camera-follow",
      "Ctrl+Alt+C",
      QT_TRANSLATE_NOOP("Actions", "The view looks through the timeline's camera, where there is "
                                   "one"),
      true},
     [](MainWindow& w, bool on) { w.state().director().setOn(on); },
     {.inputs = ActionInput::View,
      .isChecked = [](MainWindow& w) { return w.state().director().isOn(); }}},
    {{"mark-back", QT_TRANSLATE_NOOP("Actions", "Former Mar&k"), "mark-back", "Ctrl+Shift+Left",
      QT_TRANSLATE_NOOP("Actions", "Show the moment of the mark before this one")},
     [](MainWindow& w, bool) { widgets::showNextMark(w.state(), false); }},
    {{"mark-next", QT_TRANSLATE_NOOP("Actions", "&Next Mark"), "mark-next", "Ctrl+Shift+Right",
      QT_TRANSLATE_NOOP("Actions", "Show the moment of the mark after this one")},
     [](MainWindow& w, bool) { widgets::showNextMark(w.state(), true); }},
    {{"range-begin", QT_TRANSLATE_NOOP("Actions", "Play &from Here On"), "range-begin",
      "Ctrl+Shift+Home", QT_TRANSLATE_NOOP("Actions", "What is played begins at this moment")},
     [](MainWindow& w, bool) {
         widgets::beginPlayRange(w.state(), w.state().transport().seconds());
     }},
    {{"range-end", QT_TRANSLATE_NOOP("Actions", "Play &until Here"), "range-end", "Ctrl+Shift+End",
      QT_TRANSLATE_NOOP("Actions", "What is played ends at this moment")},
     [](MainWindow& w, bool) {
         widgets::endPlayRange(w.state(), w.state().transport().seconds());
     }},
    {{"range-all", QT_TRANSLATE_NOOP("Actions", "Play &All Time"), "range-all", "Ctrl+Alt+O",
      QT_TRANSLATE_NOOP("Actions", "Play neither begins nor ends early")},
     [](MainWindow& w, bool) { widgets::setPlayRange(w.state(), {}); },
     {.inputs = ActionInput::History,
      .isEnabled = [](MainWindow& w) { return w.state().scene().playRange.isSet(); }}},
    {{"play-loop", QT_TRANSLATE_NOOP("Actions", "Play &Over and Over"), "loop", "Ctrl+Shift+O",
      QT_TRANSLATE_NOOP("Actions", "At the end of what is played it begins again"), true},
     [](MainWindow& w, bool on) { widgets::setPlayLoop(w.state(), on); },
     {.inputs = ActionInput::History,
      .isChecked = [](MainWindow& w) { return w.state().scene().playRange.isLoop; }}},
    {{"range-first", QT_TRANSLATE_NOOP("Actions", "Show the Be&ginning"), "range-first",
      "Ctrl+Alt+Home",
      QT_TRANSLATE_NOOP("Actions", "The first moment of what is played, or has been")},
     [](MainWindow& w, bool) { widgets::showRangeEdge(w.state(), false); }},
    {{"range-last", QT_TRANSLATE_NOOP("Actions", "Show the &End"), "range-last", "Ctrl+Alt+End",
      QT_TRANSLATE_NOOP("Actions", "The last moment of what is played, or has been")},
     [](MainWindow& w, bool) { widgets::showRangeEdge(w.state(), true); }},
};

} // namespace

std::span<const WindowAction> timelineActions()
{
    return kTimelineActions;
}

} // namespace crowd::app
