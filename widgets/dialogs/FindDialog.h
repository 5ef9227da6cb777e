// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QDialog>

#include "widgets/actions/Findable.h"

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace crowd::widgets {

/// A field to type in, and below it what fits: those used last first, while nothing is typed. Up
/// and down choose, Return or a click takes; nothing is chosen before something is typed. What
/// would do nothing now is not offered; where nothing else fits, it is said so. What was taken is
/// remembered between runs. Main thread only.
class FindDialog : public QDialog
{
    Q_OBJECT

public:
    FindDialog(std::vector<Findable> all, QWidget* parent);

Q_SIGNALS:
    /// The dialog has closed. A copy: the dialog goes.
    void taken(const widgets::Findable& what);

protected:
    bool eventFilter(QObject* field, QEvent* event) override;

private:
    void fill();
    void addRow(std::size_t index);
    void describe();
    void take();
    [[nodiscard]] const Findable* current() const;
    [[nodiscard]] std::vector<std::size_t> latest() const;

    std::vector<Findable> m_all;
    QLineEdit* m_field;
    QTreeWidget* m_list;
    QLabel* m_tip;
    QString m_none; ///< said where nothing can be taken
};

} // namespace crowd::widgets
