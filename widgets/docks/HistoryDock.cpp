// SPDX-License-Identifier: MIT
#include "widgets/docks/HistoryDock.h"

#include <QtCore/QLocale>
#include <QtWidgets/QLabel>
#include <QtWidgets/QUndoView>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

QString sizeText(std::uint64_t bytes)
{
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 0,
                                       QLocale::DataSizeTraditionalFormat);
}

} // namespace

HistoryDock::HistoryDock(EditorState& state, QWidget* parent)
    : DockBase(tr("History"), "history", parent), m_document(state.document()),
      m_memory(new QLabel(this))
{
    auto* content = new QWidget(this);
    auto* view = new QUndoView(&state.document().undoStack(), content);
    view->setEmptyLabel(tr("As opened"));
    view->setCleanIcon(iconNamed("save"));
    view->setFrameShape(QFrame::NoFrame);
    m_memory->setObjectName(QStringLiteral("undoMemory"));
    m_memory->setWordWrap(true);
    m_memory->setEnabled(false);
    m_memory->setMargin(4);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins({});
    layout->setSpacing(0);
    layout->addWidget(view, 1);
    layout->addWidget(m_memory);
    setWidget(content);
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, &HistoryDock::showMemory);
    connect(&m_document, &model::SceneDocument::undoBudgetChanged, this, &HistoryDock::showMemory);
    showMemory();
}

void HistoryDock::showMemory()
{
    const model::UndoMemory& memory = m_document.undoMemory();
    const QString held = sizeText(memory.bytes());
    if (!memory.problem().empty()) {
        m_memory->setText(tr("%1 in memory: %2").arg(held, model::translated(memory.problem())));
    } else if (memory.bytesOnDisk() > 0) {
        m_memory->setText(tr("%1 in memory, %2 on disk").arg(held, sizeText(memory.bytesOnDisk())));
    } else {
        m_memory->setText(tr("%1 in memory").arg(held));
    }
    m_memory->setVisible(m_document.undoStack().count() > 0);
}

} // namespace crowd::widgets
