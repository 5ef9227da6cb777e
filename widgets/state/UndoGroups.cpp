// SPDX-License-Identifier: MIT
#include "widgets/state/UndoGroups.h"

#include "model/document/SceneCommand.h"

namespace crowd::widgets {

namespace {

constexpr double kShortSeconds = 0.4; ///< a click, a dab
constexpr double kPauseSeconds = 1.0; ///< from one to the next

std::uint64_t stepAt(const QUndoStack& stack, int index)
{
    const auto* command = index >= 0 && index < stack.count()
                              ? dynamic_cast<const model::SceneCommand*>(stack.command(index))
                              : nullptr;
    return command != nullptr ? command->serial() : 0;
}

} // namespace

void UndoGroups::setOn(bool isOn)
{
    m_isOn = isOn;
    Q_EMIT changed();
}

void UndoGroups::note(int brush, double begin, double end)
{
    const QUndoStack& stack = m_document.undoStack();
    const std::uint64_t step = stepAt(stack, stack.index() - 1);
    if (end - begin > kShortSeconds || step == 0) {
        m_last = {};
        return;
    }
    const bool isNext = m_last.step != 0 && m_last.step == stepAt(stack, stack.index() - 2) &&
                        m_last.brush == brush && begin - m_last.end <= kPauseSeconds;
    m_last = {step, brush, end, isNext ? m_last.group : step};
    m_groups[step] = m_last.group;
    Q_EMIT changed();
}

std::uint64_t UndoGroups::groupAt(int index) const
{
    const auto found = m_groups.find(stepAt(m_document.undoStack(), index));
    return m_isOn && found != m_groups.end() ? found->second : 0;
}

int UndoGroups::undo()
{
    QUndoStack& stack = m_document.undoStack();
    const std::uint64_t group = groupAt(stack.index() - 1);
    int done = 0;
    for (bool goesOn = true; goesOn;) {
        const int before = stack.index();
        stack.undo();
        const bool isDone = stack.index() != before;
        done += isDone ? 1 : 0;
        goesOn = isDone && group != 0 && groupAt(stack.index() - 1) == group;
    }
    return done;
}

int UndoGroups::redo()
{
    QUndoStack& stack = m_document.undoStack();
    const std::uint64_t group = groupAt(stack.index());
    int done = 0;
    for (bool goesOn = true; goesOn;) {
        const int before = stack.index();
        stack.redo();
        const bool isDone = stack.index() != before;
        done += isDone ? 1 : 0;
        goesOn = isDone && group != 0 && groupAt(stack.index()) == group;
    }
    return done;
}

} // namespace crowd::widgets
