// SPDX-License-Identifier: MIT
#include "widgets/docks/HistoryDock.h"

#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtWidgets/QLabel>
#include <QtWidgets/QStyledItemDelegate>
#include <QtWidgets/QUndoView>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

/// Steps that are undone together are joined by a line beside them. Row 0 is what was opened.
class StepDelegate : public QStyledItemDelegate
{
public:
    StepDelegate(const UndoGroups& groups, QObject* parent)
        : QStyledItemDelegate(parent), m_groups(groups)
    {
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        const bool hasBefore = isJoined(index.row() - 1);
        const bool hasAfter = isJoined(index.row());
        if (!hasBefore && !hasAfter) {
            return;
        }
        constexpr int kAway = 6;
        constexpr int kTick = 4;
        const QRect& row = option.rect;
        const int x = row.right() - kAway;
        const int middle = row.center().y();
        painter->save();
        painter->setPen(QPen(option.palette.color(QPalette::PlaceholderText), 1.0));
        painter->drawLine(x - kTick, middle, x, middle);
        painter->drawLine(x, hasBefore ? row.top() : middle, x, hasAfter ? row.bottom() : middle);
        painter->restore();
    }

private:
    /// The step of this row and that of the next.
    [[nodiscard]] bool isJoined(int row) const
    {
        const std::uint64_t group = m_groups.groupAt(row - 1);
        return group != 0 && group == m_groups.groupAt(row);
    }

    const UndoGroups& m_groups;
};

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
    view->setItemDelegate(new StepDelegate(state.undoGroups(), view));
    connect(&state.undoGroups(), &UndoGroups::changed, view->viewport(),
            qOverload<>(&QWidget::update));
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
