// SPDX-License-Identifier: MIT
#include "widgets/dialogs/FindDialog.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSettings>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kRowsShown = 60;  ///< more are found by typing more
constexpr int kKept = 12;       ///< of those used last
constexpr int kFindWidth = 640; ///< logical pixels
constexpr int kFindHeight = 460;

enum FindColumn { kOnColumn, kNameColumn, kPlaceColumn, kKeysColumn, kFindColumns };

QString latestKey()
{
    return QStringLiteral("find/latest");
}

/// Tells apart what has the same name elsewhere.
QString keyOf(const Findable& item)
{
    return item.place + QLatin1Char('\n') + item.name;
}

void remember(const Findable& item)
{
    QStringList keys = QSettings().value(latestKey()).toStringList();
    keys.removeAll(keyOf(item));
    keys.prepend(keyOf(item));
    QSettings().setValue(latestKey(), QStringList(keys.mid(0, kKept)));
}

QTreeWidget* makeFindList(QWidget* parent)
{
    auto* list = new QTreeWidget(parent);
    list->setObjectName(QStringLiteral("found"));
    list->setColumnCount(kFindColumns);
    list->setHeaderHidden(true);
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    list->setAllColumnsShowFocus(true);
    list->setFocusPolicy(Qt::NoFocus); // the field has the keyboard
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(kOnColumn, QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(kPlaceColumn, QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(kKeysColumn, QHeaderView::ResizeToContents);
    return list;
}

} // namespace

FindDialog::FindDialog(std::vector<Findable> all, QWidget* parent)
    : QDialog(parent), m_all(std::move(all)), m_field(new QLineEdit(this)),
      m_list(makeFindList(this)), m_tip(new QLabel(this))
{
    setObjectName(QStringLiteral("findDialog"));
    setWindowTitle(tr("Find an Action, a Brush, a Panel or a Setting"));
    m_field->setObjectName(QStringLiteral("typed"));
    m_field->setPlaceholderText(tr("Type what you want to do"));
    m_field->setClearButtonEnabled(true);
    m_field->installEventFilter(this);
    m_tip->setObjectName(QStringLiteral("tip"));
    m_tip->setWordWrap(true);
    m_tip->setMinimumHeight(2 * m_tip->fontMetrics().lineSpacing()); // nothing moves with it
    m_tip->setMinimumWidth(1); // else as wide as the longest word, which a file may have named
    m_tip->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_field);
    column->addWidget(m_list, 1);
    column->addWidget(m_tip);
    resize(kFindWidth, kFindHeight);
    connect(m_field, &QLineEdit::textChanged, this, &FindDialog::fill);
    connect(m_field, &QLineEdit::returnPressed, this, &FindDialog::take);
    connect(m_list, &QTreeWidget::itemClicked, this, &FindDialog::take);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &FindDialog::describe);
    fill();
    m_field->setFocus();
}

bool FindDialog::eventFilter(QObject* field, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
            key == Qt::Key_PageDown) {
            QApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return QDialog::eventFilter(field, event);
}

std::vector<std::size_t> FindDialog::latest() const
{
    std::vector<std::size_t> indices;
    const QStringList keys = QSettings().value(latestKey()).toStringList();
    for (const QString& key : keys) {
        const auto found =
            std::ranges::find_if(m_all, [&](const Findable& item) { return keyOf(item) == key; });
        if (found != m_all.end()) {
            indices.push_back(static_cast<std::size_t>(found - m_all.begin()));
        }
    }
    return indices;
}

void FindDialog::fill()
{
    m_list->clear();
    const QString typed = m_field->text().trimmed();
    std::vector<std::size_t> offered = typed.isEmpty() ? latest() : std::vector<std::size_t>{};
    const std::size_t first = offered.size();
    for (const std::size_t index : foundBy(typed, m_all)) {
        const auto end = offered.begin() + static_cast<std::ptrdiff_t>(first);
        if (std::find(offered.begin(), end, index) == end) {
            offered.push_back(index);
        }
    }
    const Findable* idle = nullptr;
    for (const std::size_t index : offered) {
        if (m_all[index].isApplicable) {
            addRow(index);
        } else if (idle == nullptr) {
            idle = &m_all[index];
        }
    }
    if (typed.isEmpty()) { // Return takes nothing that was not asked for
        m_none.clear();
        describe();
        return;
    }
    m_none = idle != nullptr ? tr("“%1” would do nothing now: %2").arg(idle->name, idle->tip)
                             : tr("Nothing is called so.");
    m_list->setCurrentItem(m_list->topLevelItem(0));
    describe();
}

void FindDialog::addRow(std::size_t index)
{
    if (m_list->topLevelItemCount() >= kRowsShown) {
        return;
    }
    const Findable& item = m_all[index];
    const QString on = item.isOn.value_or(false) ? QStringLiteral("✓") : QString();
    auto* row = new QTreeWidgetItem(m_list, {on, item.name, item.place, item.keys});
    row->setData(kNameColumn, Qt::UserRole, QVariant::fromValue(index));
    row->setIcon(kNameColumn, item.icon.isNull() ? iconNamed("preferences") : item.icon);
    row->setForeground(kPlaceColumn, palette().placeholderText());
}

const Findable* FindDialog::current() const
{
    const QTreeWidgetItem* row = m_list->currentItem();
    return row != nullptr ? &m_all[row->data(kNameColumn, Qt::UserRole).value<std::size_t>()]
                          : nullptr;
}

void FindDialog::describe()
{
    const Findable* item = current();
    m_tip->setText(item != nullptr ? item->tip : m_none);
}

void FindDialog::take()
{
    const Findable* item = current();
    if (item == nullptr) {
        return;
    }
    const Findable what = *item;
    remember(what);
    accept();
    Q_EMIT taken(what);
}

} // namespace crowd::widgets
