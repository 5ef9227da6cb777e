// SPDX-License-Identifier: MIT
#include "widgets/forms/CheckList.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QMenu>

namespace crowd::widgets {

CheckList::CheckList(QString none, QWidget* parent) : QPushButton(parent), m_none(std::move(none))
{
    // So much above and below that it is not lower than the boxes that it stands among.
    setStyleSheet(QStringLiteral("text-align: left; padding: 4px 6px"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* menu = new QMenu(this);
    setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, &CheckList::fillMenu);
    refreshText();
}

void CheckList::setSource(std::function<std::vector<Item>()> source)
{
    m_source = std::move(source);
    refreshText();
}

void CheckList::setChecked(std::vector<int> ids)
{
    m_checked = std::move(ids);
    refreshText();
}

void CheckList::fillMenu()
{
    menu()->clear();
    for (const Item& item : m_source()) {
        QAction* action = menu()->addAction(item.name);
        action->setCheckable(true);
        action->setChecked(std::ranges::find(m_checked, item.id) != m_checked.end());
        connect(action, &QAction::toggled, this,
                [this, id = item.id](bool isOn) { toggle(id, isOn); });
    }
}

void CheckList::toggle(int id, bool isOn)
{
    std::vector<int> ids;
    for (const Item& item : m_source()) {
        const bool wasOn = std::ranges::find(m_checked, item.id) != m_checked.end();
        if (item.id == id ? isOn : wasOn) {
            ids.push_back(item.id);
        }
    }
    setChecked(ids);
    Q_EMIT edited(ids);
}

void CheckList::refreshText()
{
    QStringList names;
    if (m_source) {
        for (const Item& item : m_source()) {
            if (std::ranges::find(m_checked, item.id) != m_checked.end()) {
                names << item.name;
            }
        }
    }
    setText(names.isEmpty() ? m_none : names.join(QStringLiteral(", ")));
}

} // namespace crowd::widgets
