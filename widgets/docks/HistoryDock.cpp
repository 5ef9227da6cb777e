// SPDX-License-Identifier: MIT
#include "widgets/docks/HistoryDock.h"

#include <QtWidgets/QUndoView>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

HistoryDock::HistoryDock(EditorState& state, QWidget* parent)
    : DockBase(tr("History"), "history", parent)
{
    auto* view = new QUndoView(&state.document().undoStack(), this);
    view->setEmptyLabel(tr("As opened"));
    view->setCleanIcon(iconNamed("save"));
    view->setFrameShape(QFrame::NoFrame);
    setWidget(view);
}

} // namespace crowd::widgets
