// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <QtGui/QUndoStack>
#include <QtTest/QTest>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

#include "app/window/DockLayout.h"
#include "app/window/DockTable.h"
#include "model/document/SceneEdit.h"
#include "tests/app/PlainScene.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/commands/StateCommands.h"

using namespace crowd;
using namespace crowd::testing;

/// What undo and the Window menu say of what they do not show by themselves.
class TestRunRecall : public QObject, SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("RunRecall"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }
    void undoSaysWhatItDoesNotKnow();
    void theMenuOfPanelsShowsTheirKeys();

private:
    void setHeight(float height);
};

void TestRunRecall::setHeight(float height)
{
    const auto all = document().scene().population.ids();
    const std::vector<model::IndividualId> ids(all.begin(), all.end());
    document().edit(QStringLiteral("Height"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::height, ids, std::span<const float>(&height, 1));
    });
}

void TestRunRecall::undoSaysWhatItDoesNotKnow()
{
    openScene(plainScene(4), QStringLiteral("a.crowd"));
    widgets::EditorState& state = m_window->state();
    QVERIFY(widgets::keepStateAs(state, QStringLiteral("calm"), {model::ColumnId::Height},
                                 widgets::StateReach::Everybody, 0));
    setHeight(1.5F);
    const int steps = document().undoStack().index();
    QString said;
    connect(&state, &widgets::EditorState::statusMessage, this,
            [&said](const QString& text) { said = text; });
    state.transport().setPlaying(true);
    const model::StateId calm = document().scene().states.front().id;
    QTRY_VERIFY((widgets::recallStateOf(state, calm, widgets::RecallInto::Run),
                 state.session().isRunning() && said.contains(QStringLiteral("in this run"))));
    QAction* undo = m_window->actions().action("undo");
    said.clear();
    undo->trigger();
    QCOMPARE(document().undoStack().index(), steps);
    QVERIFY2(said.contains(QStringLiteral("calm")) && said.contains(QStringLiteral("Height")),
             qPrintable(said));
    undo->trigger();
    QCOMPARE(document().undoStack().index(), steps - 1);
    // What was done in the scene since is what undo means.
    widgets::recallStateOf(state, calm, widgets::RecallInto::Run);
    setHeight(1.2F);
    undo->trigger();
    QCOMPARE(document().undoStack().index(), steps - 1);
    document().undoStack().setClean();
}

void TestRunRecall::theMenuOfPanelsShowsTheirKeys()
{
    QAction* rules = m_window->actions().action("rules");
    QAction* timeline = m_window->actions().action("timeline");
    QList<QAction*> inside;
    for (const QAction* top : m_window->menuBar()->actions()) {
        if (top->text().contains(QStringLiteral("Window"))) {
            inside = top->menu()->actions();
        }
    }
    const std::vector<QDockWidget*>& docks = m_window->docks();
    for (std::size_t i = 0; i < docks.size(); ++i) {
        const char* own = app::dockTable()[i].action;
        const bool isOwn = own != nullptr;
        QAction* shown = isOwn ? m_window->actions().action(own) : docks[i]->toggleViewAction();
        QVERIFY2(inside.contains(shown), qPrintable(docks[i]->windowTitle()));
        QVERIFY(!isOwn || !shown->shortcut().isEmpty());
    }
    QCOMPARE(rules->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+B")));
    // They stand as their panels do, however those were shown.
    QVERIFY(!timeline->isChecked());
    timeline->trigger();
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Timeline);
    QVERIFY(timeline->isChecked() && dock->isVisible());
    dock->close();
    QTRY_VERIFY(!timeline->isChecked());
}

CROWD_WINDOW_TEST(TestRunRecall)
#include "tst_RunRecall.moc"
