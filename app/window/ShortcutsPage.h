// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtGui/QKeySequence>
#include <QtWidgets/QWidget>

#include "widgets/actions/ActionRegistry.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace crowd::app {

/// All actions with their keys, to be changed. Keys that belong to another action are named, and
/// can be taken from it. Nothing takes effect before apply(). Main thread only.
class ShortcutsPage : public QWidget
{
    Q_OBJECT

public:
    ShortcutsPage(widgets::ActionRegistry& actions, QWidget* parent);

    /// Gives the registry what was changed.
    void apply();

private:
    void addRow(int row);
    void setKeys(int row, const QKeySequence& typed);
    void filter(const QString& text);
    void takeKeys();
    void resetAll();
    void showConflict(int row, int owner, const QKeySequence& keys);
    void hideConflict();
    [[nodiscard]] QKeySequenceEdit* editOf(int row) const;
    [[nodiscard]] QString nameOf(int row) const;

    widgets::ActionRegistry& m_actions;
    std::vector<QKeySequence> m_keys; ///< one per row, as shown
    int m_conflictRow = -1;
    int m_conflictOwner = -1;
    QKeySequence m_conflictKeys;
    // Children of this widget.
    QLineEdit* m_filter;
    QTableWidget* m_table;
    QLabel* m_conflict;
    QPushButton* m_take;
};

} // namespace crowd::app
