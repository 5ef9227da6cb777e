// SPDX-License-Identifier: MIT
#include "widgets/tools/ToolKeys.h"

#include <algorithm>
#include <array>

#include <QtGui/QKeySequence>

#include "widgets/commands/SelectionCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/tools/PlaceHandles.h"

namespace crowd::widgets {

namespace {

struct StateKey
{
    int key;
    Qt::KeyboardModifiers modifiers;
    void (*run)(EditorState& state);
};

const std::array<StateKey, 11> kStateKeys{{
    {Qt::Key_F, Qt::NoModifier, frameSelection},
    {Qt::Key_Home, Qt::NoModifier, frameAll},
    {Qt::Key_Delete, Qt::NoModifier, deleteSelection},
    {Qt::Key_Backspace, Qt::NoModifier, deleteSelection},
    {Qt::Key_A, Qt::ControlModifier, [](EditorState& state) { state.selection().selectAll(); }},
    {Qt::Key_I, Qt::ControlModifier, [](EditorState& state) { state.selection().invert(); }},
    {Qt::Key_Z, Qt::ControlModifier, [](EditorState& state) { state.undoGroups().undo(); }},
    {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier,
     [](EditorState& state) { state.undoGroups().redo(); }},
    {Qt::Key_Return, Qt::NoModifier, endPath},
    {Qt::Key_Enter, Qt::NoModifier, endPath},
    {Qt::Key_G, Qt::NoModifier,
     [](EditorState& state) { state.setSeatGridOn(!state.isSeatGridOn()); }},
}};

/// The number pad's digits are the digits.
Qt::KeyboardModifiers modifiersOf(const KeyInput& input)
{
    return input.modifiers & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
}

bool selectTool(EditorState& state, const KeyInput& input)
{
    if (modifiersOf(input) != Qt::NoModifier) {
        return false;
    }
    const QKeySequence pressed(input.key);
    const auto& tools = toolTable();
    const auto found = std::find_if(tools.begin(), tools.end(), [&](const ToolInfo& info) {
        return QKeySequence(QLatin1String(info.shortcut)) == pressed;
    });
    if (found == tools.end()) {
        return false;
    }
    state.setTool(found->id);
    return true;
}

} // namespace

bool isFlyKey(const KeyInput& input)
{
    return input.key == Qt::Key_F && input.modifiers == Qt::ShiftModifier && !input.isRepeat;
}

int sizeSteps(const KeyInput& input)
{
    if (input.key == Qt::Key_BracketRight) {
        return 1;
    }
    return input.key == Qt::Key_BracketLeft ? -1 : 0;
}

int numberSteps(const KeyInput& input)
{
    if (input.key == Qt::Key_Plus || input.key == Qt::Key_Equal) {
        return 1;
    }
    return input.key == Qt::Key_Minus ? -1 : 0;
}

bool runStateKey(EditorState& state, const KeyInput& input)
{
    for (const StateKey& known : kStateKeys) {
        if (known.key == input.key && known.modifiers == modifiersOf(input)) {
            known.run(state);
            return true;
        }
    }
    return selectTool(state, input);
}

} // namespace crowd::widgets
