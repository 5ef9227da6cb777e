// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QPushButton>

namespace crowd::widgets {

/// A button that opens a list to tick some of; it says which are ticked. Main thread.
class CheckList : public QPushButton
{
    Q_OBJECT

public:
    struct Item
    {
        int id;
        QString name;
    };

    /// `none` is said where nothing is ticked.
    CheckList(QString none, QWidget* parent);

    /// Asked for when the list opens, and for the names that the button says.
    void setSource(std::function<std::vector<Item>()> source);
    void setChecked(std::vector<int> ids);
    [[nodiscard]] const std::vector<int>& checkedIds() const { return m_checked; }

Q_SIGNALS:
    /// By the artist; in the order of the list.
    void edited(const std::vector<int>& ids);

private:
    void fillMenu();
    void toggle(int id, bool isOn);
    void refreshText();

    QString m_none;
    std::function<std::vector<Item>()> m_source;
    std::vector<int> m_checked;
};

} // namespace crowd::widgets
