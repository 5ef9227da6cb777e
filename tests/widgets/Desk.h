// SPDX-License-Identifier: MIT
#pragma once

#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMainWindow>

#include "tests/widgets/SmallTheatre.h"
#include "widgets/state/EditorState.h"

/// What tests of the docks share: a window to put one into, and hands to use it.
namespace crowd::testing {

/// A window with one dock over the small theatre.
template<class Dock>
struct Desk
{
    Desk() : state(document), dock(nullptr)
    {
        document.replaceScene(smallTheatre(), {});
        dock = new Dock(state, &window);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.resize(300, 700);
        window.show();
    }
    ~Desk() { delete dock; }
    /// Laid out; events are handed to the widgets, so the window need not be exposed.
    [[nodiscard]] bool isReady()
    {
        return QTest::qWaitFor([this] { return dock->isVisible() && dock->width() > 0; });
    }
    template<class Child>
    [[nodiscard]] QList<Child*> all() const
    {
        QList<Child*> found;
        for (Child* child : dock->template findChildren<Child*>()) {
            if (child->isVisible()) {
                found << child;
            }
        }
        return found;
    }

    model::SceneDocument document;
    widgets::EditorState state;
    QMainWindow window;
    Dock* dock;
};

inline void type(QLineEdit& field, const QString& text)
{
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// The field of a form that a label stands beside.
template<class Field>
Field* fieldBeside(const QWidget& dock, const QString& label)
{
    for (const QLabel* item : dock.findChildren<QLabel*>()) {
        if (item->text() == label && item->buddy() != nullptr) {
            return qobject_cast<Field*>(item->buddy());
        }
    }
    return nullptr;
}

} // namespace crowd::testing
