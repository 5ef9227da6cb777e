// SPDX-License-Identifier: MIT
#include "app/window/SelectActions.h"

#include "app/window/MainWindow.h"
#include "widgets/commands/GroupCommands.h"
#include "widgets/commands/RelationCommands.h"
#include "widgets/commands/SelectionCommands.h"

namespace crowd::app {

namespace {

using widgets::ActionInput;
using widgets::ViewOptions;

bool hasSelection(MainWindow& window)
{
    return !window.state().selection().isEmpty();
}

/// The brush in hand that has an area; null: it is the tool Select that the lasso is of.
const model::BrushSettings* brushWithArea(MainWindow& window)
{
    const model::BrushSettings* brush = window.state().activeBrush();
    return brush != nullptr && !brush->addsPlaces() ? brush : nullptr;
}

bool usesLasso(MainWindow& window)
{
    const model::BrushSettings* brush = brushWithArea(window);
    return brush != nullptr ? brush->selection == model::BrushSelection::Lasso
                            : window.state().viewOptions().selectsByLasso;
}

void useLasso(MainWindow& window, bool isOn)
{
    if (const model::BrushSettings* brush = brushWithArea(window)) {
        model::BrushSettings changed = *brush;
        changed.selection =
            isOn ? model::BrushSelection::Lasso : model::BrushSelection::AllInCircle;
        window.state().setBrush(changed);
        return;
    }
    ViewOptions options = window.state().viewOptions();
    options.selectsByLasso = isOn;
    window.state().setViewOptions(options);
}

const WindowAction kSelectActions[] = {
    {{"select-all", QT_TRANSLATE_NOOP("Actions", "Select &All"), "select-all", "Ctrl+A",
      QT_TRANSLATE_NOOP("Actions", "Select everybody")},
     [](MainWindow& w, bool) { w.state().selection().selectAll(); }},
    {{"select-none", QT_TRANSLATE_NOOP("Actions", "Select &None"), "select-none", "Ctrl+Shift+A",
      QT_TRANSLATE_NOOP("Actions", "Select nobody")},
     [](MainWindow& w, bool) { w.state().selection().clear(); },
     {.inputs = ActionInput::Selection,
      .isEnabled = [](MainWindow& w) { return !w.state().selection().isEmpty(); }}},
    {{"select-invert", QT_TRANSLATE_NOOP("Actions", "In&vert Selection"), "select-invert",
      "Ctrl+Alt+I", QT_TRANSLATE_NOOP("Actions", "Select those who are not selected")},
     [](MainWindow& w, bool) { w.state().selection().invert(); }},
    {{"select-similar", QT_TRANSLATE_NOOP("Actions", "Select Si&milar"), "select-all", "Ctrl+Alt+A",
      QT_TRANSLATE_NOOP(
          "Actions", "Also those who look like one of the selected: template, materials, colours")},
     [](MainWindow& w, bool) { widgets::selectSimilar(w.state()); },
     {.inputs = ActionInput::Selection, .isEnabled = hasSelection}},
    {{"select-grow", QT_TRANSLATE_NOOP("Actions", "&Grow Selection"), "larger", "Ctrl+Alt++",
      QT_TRANSLATE_NOOP("Actions", "Also those who stand beside the selected")},
     [](MainWindow& w, bool) { widgets::growSelection(w.state()); },
     {.inputs = ActionInput::Selection, .isEnabled = hasSelection}},
    {{"select-related", QT_TRANSLATE_NOOP("Actions", "Grow to R&elated"), "brush-relation",
      "Ctrl+Alt+E",
      QT_TRANSLATE_NOOP("Actions", "Select also those who are related to one of the selected")},
     [](MainWindow& w, bool) { widgets::growSelectionToRelated(w.state(), 0); },
     {.inputs = ActionInput::Selection, .isEnabled = hasSelection}},
    {{"select-shrink", QT_TRANSLATE_NOOP("Actions", "Sh&rink Selection"), "smaller", "Ctrl+Alt+-",
      QT_TRANSLATE_NOOP("Actions", "Without those who stand beside somebody not selected")},
     [](MainWindow& w, bool) { widgets::shrinkSelection(w.state()); },
     {.inputs = ActionInput::Selection, .isEnabled = hasSelection}},
    {{"select-lasso", QT_TRANSLATE_NOOP("Actions", "Select with a &Lasso"), "select", "L",
      QT_TRANSLATE_NOOP("Actions", "Draw a line round those to select, or to paint with a brush; "
                                   "else a rectangle, or a circle"),
      true},
     &useLasso,
     {.inputs = ActionInput::View | ActionInput::Tool | ActionInput::Brush,
      .isChecked = &usesLasso}},
    {{"group-selected", QT_TRANSLATE_NOOP("Actions", "&Group Selected"), "group", "Ctrl+Alt+G",
      QT_TRANSLATE_NOOP("Actions", "A new group of the selected characters; it becomes active")},
     [](MainWindow& w, bool) { widgets::groupSelection(w.state()); },
     {.inputs = ActionInput::Selection,
      .isEnabled = [](MainWindow& w) { return !w.state().selection().isEmpty(); }}},
};

} // namespace

std::span<const WindowAction> selectActions()
{
    return kSelectActions;
}

} // namespace crowd::app
