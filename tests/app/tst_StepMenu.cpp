// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QMenu>

#include "app/window/StepMenu.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/EditorState.h"

class TestStepMenu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aLengthIsChosenAndTakenBack();
};

void TestStepMenu::aLengthIsChosenAndTakenBack()
{
    crowd::model::SceneDocument document;
    crowd::widgets::EditorState state(document);
    QMenu menu;
    crowd::app::fillStepMenu(menu, state);
    const auto checked = [&menu] {
        Q_EMIT menu.aboutToShow();
        QString names;
        for (const QAction* action : menu.actions()) {
            names += action->isChecked() ? action->objectName() : QString();
        }
        return names;
    };
    QCOMPARE(checked(), QStringLiteral("steps30"));
    menu.findChild<QAction*>(QStringLiteral("steps120"))->trigger();
    QCOMPARE(document.scene().stepsPerSecond, 120U);
    QCOMPARE(checked(), QStringLiteral("steps120"));
    document.undoStack().undo();
    QCOMPARE(document.scene().stepsPerSecond, 30U);
    QCOMPARE(checked(), QStringLiteral("steps30"));
    // The same again is no step to undo.
    menu.findChild<QAction*>(QStringLiteral("steps30"))->trigger();
    QVERIFY(document.undoStack().canRedo());
}

CROWD_WINDOW_TEST(TestStepMenu)
#include "tst_StepMenu.moc"
