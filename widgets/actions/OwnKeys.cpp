// SPDX-License-Identifier: MIT
#include "widgets/actions/OwnKeys.h"

#include <QtCore/QObject>
#include <QtGui/QAction>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QWidget>

namespace crowd::widgets {

namespace {

QAction* ownAction(const QWidget& list, const QKeyEvent& key)
{
    const QKeySequence pressed(key.keyCombination());
    for (QAction* action : list.actions()) {
        if (action->shortcuts().contains(pressed)) {
            return action;
        }
    }
    return nullptr;
}

class OwnKeys : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isAsked = event->type() == QEvent::ShortcutOverride;
        const auto* list = qobject_cast<QWidget*>(watched);
        // What a field in the list does not want comes here too, and is not meant for the list.
        if (list == nullptr || !(isAsked || event->type() == QEvent::KeyPress) ||
            !list->hasFocus()) {
            return false;
        }
        QAction* action = ownAction(*list, *static_cast<QKeyEvent*>(event));
        if (action == nullptr) {
            return false;
        }
        event->accept();
        if (!isAsked && action->isEnabled()) {
            action->trigger();
        }
        return true;
    }
};

} // namespace

void keepKeysOfOwnActions(QWidget& list)
{
    list.installEventFilter(new OwnKeys(&list));
}

} // namespace crowd::widgets
