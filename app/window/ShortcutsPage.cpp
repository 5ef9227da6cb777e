// SPDX-License-Identifier: MIT
#include "app/window/ShortcutsPage.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QKeySequenceEdit>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableWidget>
#include <QtWidgets/QVBoxLayout>

#include "widgets/actions/MenuText.h"

namespace crowd::app {

namespace {

constexpr int kKeysWidth = 190;

/// Actions have one combination each, not a sequence of them.
QKeySequence firstOf(const QKeySequence& keys)
{
    return keys.isEmpty() ? keys : QKeySequence(keys[0]);
}

} // namespace

ShortcutsPage::ShortcutsPage(widgets::ActionRegistry& actions, QWidget* parent)
    : QWidget(parent), m_actions(actions), m_filter(new QLineEdit(this)),
      m_table(new QTableWidget(static_cast<int>(actions.specs().size()), 2, this)),
      m_conflict(new QLabel(this)), m_take(new QPushButton(this))
{
    m_filter->setPlaceholderText(tr("Search for an action or its keys"));
    m_filter->setClearButtonEnabled(true);
    m_table->setHorizontalHeaderLabels({tr("Action"), tr("Keys")});
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->setColumnWidth(1, kKeysWidth);
    m_table->verticalHeader()->hide();
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        addRow(row);
    }
    m_conflict->setWordWrap(true);
    auto* reset = new QPushButton(tr("All Back to Defaults"), this);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_conflict, 1);
    foot->addWidget(m_take);
    foot->addWidget(reset);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_filter);
    layout->addWidget(m_table, 1);
    layout->addLayout(foot);
    hideConflict();
    connect(m_filter, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
    connect(m_take, &QPushButton::clicked, this, &ShortcutsPage::takeKeys);
    connect(reset, &QPushButton::clicked, this, &ShortcutsPage::resetAll);
}

void ShortcutsPage::addRow(int row)
{
    const widgets::ActionSpec& spec = m_actions.specs()[static_cast<std::size_t>(row)];
    const QAction* action = m_actions.action(spec.id);
    const QString text = QCoreApplication::translate("Actions", spec.text);
    auto* name = new QTableWidgetItem(action->icon(), widgets::menuText(text));
    name->setFlags(Qt::ItemIsEnabled);
    name->setToolTip(action->statusTip());
    m_table->setItem(row, 0, name);
    m_keys.push_back(action->shortcut());
    auto* edit = new QKeySequenceEdit(action->shortcut(), m_table);
    edit->setClearButtonEnabled(true);
    connect(edit, &QKeySequenceEdit::editingFinished, this,
            [this, row, edit] { setKeys(row, edit->keySequence()); });
    m_table->setCellWidget(row, 1, edit);
}

QKeySequenceEdit* ShortcutsPage::editOf(int row) const
{
    return static_cast<QKeySequenceEdit*>(m_table->cellWidget(row, 1));
}

QString ShortcutsPage::nameOf(int row) const
{
    return m_table->item(row, 0)->text();
}

void ShortcutsPage::setKeys(int row, const QKeySequence& typed)
{
    const QKeySequence keys = firstOf(typed);
    QKeySequence& kept = m_keys[static_cast<std::size_t>(row)];
    if (keys == kept) {
        editOf(row)->setKeySequence(keys);
        return;
    }
    const auto owner = std::ranges::find(m_keys, keys);
    if (!keys.isEmpty() && owner != m_keys.end()) {
        editOf(row)->setKeySequence(kept);
        showConflict(row, static_cast<int>(owner - m_keys.begin()), keys);
        return;
    }
    kept = keys;
    editOf(row)->setKeySequence(keys);
    hideConflict();
}

void ShortcutsPage::showConflict(int row, int owner, const QKeySequence& keys)
{
    m_conflictRow = row;
    m_conflictOwner = owner;
    m_conflictKeys = keys;
    m_conflict->setText(
        tr("%1 belongs to “%2”.").arg(keys.toString(QKeySequence::NativeText), nameOf(owner)));
    m_take->setText(tr("Give It to “%1”").arg(nameOf(row)));
    m_take->show();
}

void ShortcutsPage::hideConflict()
{
    m_conflictRow = -1;
    m_conflict->setText(tr("Click a field and press the keys."));
    m_take->hide();
}

void ShortcutsPage::takeKeys()
{
    m_keys[static_cast<std::size_t>(m_conflictOwner)] = {};
    editOf(m_conflictOwner)->clear();
    setKeys(m_conflictRow, m_conflictKeys);
}

void ShortcutsPage::resetAll()
{
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const auto& spec = m_actions.specs()[static_cast<std::size_t>(row)];
        const QList<QKeySequence> keys = widgets::ActionRegistry::defaultShortcuts(spec);
        m_keys[static_cast<std::size_t>(row)] = keys.isEmpty() ? QKeySequence() : keys.front();
        editOf(row)->setKeySequence(m_keys[static_cast<std::size_t>(row)]);
    }
    hideConflict();
}

void ShortcutsPage::filter(const QString& text)
{
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString keys =
            m_keys[static_cast<std::size_t>(row)].toString(QKeySequence::NativeText);
        m_table->setRowHidden(row, !nameOf(row).contains(text, Qt::CaseInsensitive) &&
                                       !keys.contains(text, Qt::CaseInsensitive));
    }
}

void ShortcutsPage::apply()
{
    for (std::size_t row = 0; row < m_keys.size(); ++row) {
        const char* id = m_actions.specs()[row].id;
        if (m_actions.action(id)->shortcut() != m_keys[row]) {
            m_actions.setShortcut(id, m_keys[row]);
        }
    }
}

} // namespace crowd::app
