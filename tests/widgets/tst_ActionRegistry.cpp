// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QWidget>

#include "tests/program/WindowTest.h"
#include "widgets/actions/ActionRegistry.h"

using namespace crowd;
using widgets::ActionInput;

/// Actions follow what they depend on, and nothing else.
class ActionRegistryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asksOnlyThoseThatDependOnIt();
    void staysAsItIsWhereAClickChangesNothing();
};

void ActionRegistryTest::asksOnlyThoseThatDependOnIt()
{
    QWidget window;
    widgets::ActionRegistry registry(&window);
    bool hasSelection = false;
    int asked = 0;
    const QAction* remove =
        registry.add({"remove", "Remove", "delete", "", "Removes"}, [](bool) {},
                     {.inputs = ActionInput::Selection | ActionInput::Paths, .isEnabled = [&] {
                          ++asked;
                          return hasSelection;
                      }});
    const QAction* undo =
        registry.add({"undo", "Undo", "undo", "", "Undoes"}, [](bool) {},
                     {.inputs = ActionInput::History, .text = [&] {
                          return hasSelection ? QStringLiteral("Undo it") : QStringLiteral("Undo");
                      }});
    QVERIFY2(!remove->isEnabled(), "as it is from the beginning");
    QCOMPARE(asked, 1);
    hasSelection = true;
    registry.refresh(ActionInput::History | ActionInput::Tool);
    QCOMPARE(asked, 1);
    QCOMPARE(undo->text(), QStringLiteral("Undo it"));
    QVERIFY(!remove->isEnabled());
    registry.refresh(ActionInput::Paths);
    QCOMPARE(asked, 2);
    QVERIFY(remove->isEnabled());
}

void ActionRegistryTest::staysAsItIsWhereAClickChangesNothing()
{
    QWidget window;
    widgets::ActionRegistry registry(&window);
    int chosen = 1;
    const auto tool = [&](const char* id, int number) {
        return registry.add({id, "Tool", "select", "", "A tool", true},
                            [&chosen, number](bool) { chosen = number; },
                            {.inputs = ActionInput::Tool,
                             .isChecked = [&chosen, number] { return chosen == number; }});
    };
    QAction* first = tool("first", 1);
    QAction* second = tool("second", 2);
    first->trigger();
    QVERIFY2(first->isChecked(), "chosen again, it is chosen");
    second->trigger();
    registry.refresh(ActionInput::Tool);
    QVERIFY(second->isChecked());
    QVERIFY(!first->isChecked());
}

CROWD_WINDOW_TEST(ActionRegistryTest)

#include "tst_ActionRegistry.moc"
