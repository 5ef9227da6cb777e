// SPDX-License-Identifier: MIT
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCompleter>
#include <QtWidgets/QTreeWidget>

#include "app/console/ConsoleDock.h"
#include "app/window/MainWindow.h"
#include "model/document/SceneEdit.h"
#include "tests/gui/Patience.h"
#include "tests/program/FrameCount.h"
#include "tests/program/WindowTest.h"
#include "widgets/docks/SceneDock.h"

using namespace crowd;
using crowd::app::ScriptOutcome;
using crowd::testing::kScriptPatienceMs;

/// Python in the real window. One window for all: Python starts once in a process.
class ConsoleTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void init();

    void typedLinesChangeTheSceneAndCanBeUndone();
    void errorsAreShownWithoutOurOwnFrames();
    void blocksGoOnUntilTheyAreComplete();
    void historyComesBack();
    void namesAreCompleted();
    void endlessLoopsCanBeStopped();
    void sleepCanBeStopped();
    void handsAreHeldBackWhileAScriptRuns();
    void whatWasOpenBeforeAScriptIsHeldBackToo();
    void stoppingEndsThatScriptAlone();
    void cancellingAtOnceIsHeard();
    void floodsAreCutShort();
    void aGigabyteAtOnceIsCutShort();
    void theSceneNameCannotBeLost();
    void handlesOutliveTheirScene();
    void filesRunWithTheScene();
    void anExceptionInAnEditTakesItBack();
    void otherScenesOpenBesideTheWindows();
    void eventsReachThoseWhoPlay();
    void closingStopsTheScript();

private:
    [[nodiscard]] app::ConsoleInput& input() { return *m_input; }
    [[nodiscard]] QString output() { return m_output->toPlainText(); }
    [[nodiscard]] std::size_t people() { return m_window->document().scene().population.size(); }
    void type(const QString& text)
    {
        input().setFocus();
        QTest::keyClicks(&input(), text);
        QTest::keyClick(&input(), Qt::Key_Return);
    }
    /// Types, and waits for the end.
    [[nodiscard]] bool run(const QString& text)
    {
        QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
        type(text);
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kScriptPatienceMs);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<app::MainWindow> m_window;
    app::ConsoleInput* m_input = nullptr;
    QPlainTextEdit* m_output = nullptr;
};

void ConsoleTest::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTest"));
    QCoreApplication::setApplicationName(QStringLiteral("ConsoleTest"));
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    qputenv("CROWDBRUSH_RESOURCES", CROWD_RESOURCES);
    m_window = std::make_unique<app::MainWindow>();
    m_window->resize(900, 640);
    m_window->state().transport().setPlaying(false);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->actions().action("console")->trigger();
    m_input = m_window->findChild<app::ConsoleInput*>();
    m_output = m_window->findChild<QPlainTextEdit*>(QStringLiteral("consoleOutput"));
    QVERIFY(m_input != nullptr && m_input->isVisible() && m_output != nullptr);
    QVERIFY(run(QStringLiteral("man = scene.add_template('builtin:templates/man.glb')")));
    QCOMPARE(m_window->document().scene().templates.size(), std::size_t{1});
}

void ConsoleTest::cleanupTestCase()
{
    m_window.reset();
}

void ConsoleTest::init()
{
    m_window->console().clearOutput();
    input().clear();
}

void ConsoleTest::typedLinesChangeTheSceneAndCanBeUndone()
{
    QVERIFY(run(QStringLiteral("ids = scene.create(template=man, position=[[0,0,0],[1,0,0]])")));
    QCOMPARE(people(), std::size_t{2});
    QVERIFY(run(QStringLiteral("len(scene)")));
    QTRY_VERIFY_WITH_TIMEOUT(output().endsWith(QStringLiteral(">>> len(scene)\n2\n")),
                             kScriptPatienceMs);
    m_window->actions().action("undo")->trigger();
    QCOMPARE(people(), std::size_t{0});
    m_window->actions().action("redo")->trigger();
    QCOMPARE(people(), std::size_t{2});
}

void ConsoleTest::errorsAreShownWithoutOurOwnFrames()
{
    QVERIFY(run(QStringLiteral("scene.change([99], heading=1.0)")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("no individual 99")),
                             kScriptPatienceMs);
    QVERIFY(output().contains(QStringLiteral("<console>")));
    QVERIFY2(!output().contains(QStringLiteral("console.py")), qPrintable(output()));
    m_window->console().clearOutput();
    QVERIFY(run(QStringLiteral("1 +")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("SyntaxError")), kScriptPatienceMs);
}

void ConsoleTest::blocksGoOnUntilTheyAreComplete()
{
    QVERIFY(run(QStringLiteral("for i in range(2):")));
    QCOMPARE(input().toPlainText(), QStringLiteral("for i in range(2):\n    "));
    QVERIFY(run(QStringLiteral("print('turn', i)")));
    for (int i = 0; i < 4; ++i) {
        QTest::keyClick(&input(), Qt::Key_Backspace);
    }
    QVERIFY(run(QString()));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("turn 0\nturn 1\n")),
                             kScriptPatienceMs);
    QCOMPARE(input().toPlainText(), QString());
}

void ConsoleTest::historyComesBack()
{
    QVERIFY(run(QStringLiteral("first = 1")));
    QVERIFY(run(QStringLiteral("second = 2")));
    QTest::keyClicks(&input(), QStringLiteral("third"));
    QTest::keyClick(&input(), Qt::Key_Up);
    QCOMPARE(input().toPlainText(), QStringLiteral("second = 2"));
    QTest::keyClick(&input(), Qt::Key_Up);
    QCOMPARE(input().toPlainText(), QStringLiteral("first = 1"));
    QTest::keyClick(&input(), Qt::Key_Down);
    QTest::keyClick(&input(), Qt::Key_Down);
    QCOMPARE(input().toPlainText(), QStringLiteral("third"));
}

void ConsoleTest::namesAreCompleted()
{
    QTest::keyClicks(&input(), QStringLiteral("scene.add_te"));
    QTest::keyClick(&input(), Qt::Key_Tab);
    QTRY_COMPARE_WITH_TIMEOUT(input().toPlainText(), QStringLiteral("scene.add_template"),
                              kScriptPatienceMs);
    input().clear();
    QTest::keyClicks(&input(), QStringLiteral("scene."));
    QTest::keyClick(&input(), Qt::Key_Tab);
    auto* list = input().findChild<QCompleter*>()->popup();
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), kScriptPatienceMs);
    QVERIFY(list->model()->rowCount() > 10);
    QTest::keyClick(list, Qt::Key_Escape);
    QVERIFY(!list->isVisible());
}

void ConsoleTest::endlessLoopsCanBeStopped()
{
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    type(QStringLiteral("exec('while True: pass')"));
    QTest::qWait(300);
    QVERIFY(m_window->interpreter().isRunning());
    m_window->actions().action("script-cancel")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    QCOMPARE(finished[0][0].value<ScriptOutcome>(), ScriptOutcome::Failed);
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("Cancelled")), kScriptPatienceMs);
    QVERIFY(run(QStringLiteral("6 * 7")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("42")), kScriptPatienceMs);
}

void ConsoleTest::sleepCanBeStopped()
{
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    type(QStringLiteral("import time; time.sleep(1000)"));
    QTest::qWait(300);
    auto* cancel = m_window->findChild<QToolButton*>(QStringLiteral("consoleCancel"));
    QTest::mouseClick(cancel, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
}

void ConsoleTest::handsAreHeldBackWhileAScriptRuns()
{
    const std::size_t before = people();
    QString said;
    const auto listening = connect(&m_window->state(), &widgets::EditorState::statusMessage, this,
                                   [&said](const QString& text) { said = text; });
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    type(QStringLiteral("import time; time.sleep(1000)"));
    QTest::qWait(200);
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, {200, 300});
    QTest::keyClick(&m_window->viewport(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(people(), before);
    QVERIFY2(said.contains(QStringLiteral("script")), qPrintable(said));
    const testing::FrameCount drawn(m_window->viewport());
    m_window->viewport().update();
    QTRY_VERIFY_WITH_TIMEOUT(drawn.frames() > 0, kScriptPatienceMs);
    m_window->interpreter().cancel();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    disconnect(listening);
}

/// Cue keys, a menu, a panel that floats.
void ConsoleTest::whatWasOpenBeforeAScriptIsHeldBackToo()
{
    model::Cue cue;
    cue.id = 1;
    cue.event = "clap";
    cue.key = "F9";
    m_window->document().edit(QStringLiteral("Add a cue"),
                              [&](model::SceneEdit& edit) { edit.setCues({cue}); });
    auto* panel = m_window->findChild<widgets::SceneDock*>();
    QVERIFY(panel != nullptr);
    panel->show();
    panel->setFloating(true);
    QVERIFY(QTest::qWaitForWindowExposed(panel));
    QStringList said;
    const auto listening = connect(&m_window->state(), &widgets::EditorState::statusMessage, this,
                                   [&said](const QString& text) { said << text; });
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    type(QStringLiteral("import time; time.sleep(1000)"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->interpreter().isRunning(), kScriptPatienceMs);
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QTest::keyClick(&m_window->viewport(), Qt::Key_F9);
    QTRY_VERIFY(!said.isEmpty() && said.back().contains(QStringLiteral("script")));
    QVERIFY2(!said.join(u' ').contains(QStringLiteral("Play")), qPrintable(said.join(u'\n')));
    said.clear();
    QTest::mouseClick(panel->findChild<QTreeWidget*>()->viewport(), Qt::LeftButton);
    QVERIFY(!said.isEmpty() && said.back().contains(QStringLiteral("script")));
    disconnect(listening);
    m_window->interpreter().stop([](bool) {}); // until it has heard
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    panel->setFloating(false);
}

/// Whoever stops one script and begins the next at once means the first alone.
void ConsoleTest::stoppingEndsThatScriptAlone()
{
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    type(QStringLiteral("import time; time.sleep(1000)"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->interpreter().isRunning(), kScriptPatienceMs);
    bool hasStopped = false;
    m_window->interpreter().stop([&hasStopped](bool stopped) { hasStopped = stopped; });
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    QVERIFY(run(QStringLiteral("time.sleep(0.6); print('to its', 'end')")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("to its end")), kScriptPatienceMs);
    QVERIFY(hasStopped);
}

/// Also in the moment in which the script has not begun yet.
void ConsoleTest::cancellingAtOnceIsHeard()
{
    for (int round = 0; round < 20; ++round) {
        QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
        m_window->interpreter().run(QStringLiteral("import time; time.sleep(1000)"));
        m_window->interpreter().cancel();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    }
    QVERIFY(run(QStringLiteral("print('and', 'on')")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("and on")), kScriptPatienceMs);
}

void ConsoleTest::floodsAreCutShort()
{
    QVERIFY(run(QStringLiteral("exec('for i in range(300): print(\"x\" * 100000)')")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("left out")), kScriptPatienceMs);
    QVERIFY(output().size() < 5'000'000);
}

void ConsoleTest::aGigabyteAtOnceIsCutShort()
{
    QVERIFY(run(QStringLiteral("print('y' * 10**9)")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("999900000 characters are left out")),
                             kScriptPatienceMs);
    QVERIFY(output().size() < 1'000'000);
}

/// The window opens another scene under a script's feet.
void ConsoleTest::handlesOutliveTheirScene()
{
    const model::Scene before = m_window->document().scene();
    QVERIFY(run(QStringLiteral("t = scene.templates[0]; block = scene.edit('never ended')")));
    QVERIFY(run(QStringLiteral("_ = block.__enter__()")));
    QVERIFY(m_window->document().isEditOpen());
    m_window->document().replaceScene(model::Scene(), {});
    QVERIFY(!m_window->document().isEditOpen());
    QVERIFY(run(QStringLiteral("t.name")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("no longer in the scene")),
                             kScriptPatienceMs);
    QVERIFY(run(QStringLiteral("block.__exit__(None, None, None)")));
    QVERIFY(run(QStringLiteral("print('people:', len(scene))")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("people: 0")), kScriptPatienceMs);
    m_window->document().replaceScene(before, {});
}

void ConsoleTest::theSceneNameCannotBeLost()
{
    QVERIFY(run(QStringLiteral("del scene")));
    QVERIFY(run(QStringLiteral("scene = None")));
    QVERIFY(run(QStringLiteral("print('there are', len(scene))")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("there are 2")), kScriptPatienceMs);
}

void ConsoleTest::filesRunWithTheScene()
{
    const QString path = m_folder.filePath(QStringLiteral("mänge.py"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("import sys\nprint(__name__, len(scene), sys.argv[0].endswith('.py'))\n"
               "raise ValueError('at the end')\n");
    file.close();
    QSignalSpy finished(&m_window->interpreter(), &app::Interpreter::finished);
    m_window->console().runFile(path);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kScriptPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("__main__ 2 True")),
                             kScriptPatienceMs);
    QVERIFY(output().contains(QStringLiteral("line 3")));
    QVERIFY(output().contains(QStringLiteral("ValueError: at the end")));
}

void ConsoleTest::anExceptionInAnEditTakesItBack()
{
    const int steps = m_window->document().undoStack().count();
    QVERIFY(run(QStringLiteral(
        "exec('with scene.edit(\"no\"):\\n scene.remove(scene.ids)\\n raise KeyError(1)')")));
    QCOMPARE(people(), std::size_t{2});
    QCOMPARE(m_window->document().undoStack().count(), steps);
    QVERIFY(!m_window->document().isEditOpen());
}

void ConsoleTest::otherScenesOpenBesideTheWindows()
{
    QVERIFY(run(QStringLiteral("crowdbrush.open('builtin:scenes/theatre.crowd')")));
    QCOMPARE(people(), std::size_t{2});
    QVERIFY2(!output().contains(QStringLiteral("Error")), qPrintable(output()));
}

void ConsoleTest::eventsReachThoseWhoPlay()
{
    QVERIFY(
        run(QStringLiteral("scene.set_environment({'rules': [{'id': 1, 'when': {'kind': 'event', "
                           "'event': 'show'}, 'do': [{'kind': 'tag', 'tag': 5}]}]})")));
    QVERIFY(run(QStringLiteral("scene.send('show')")));
    QTRY_VERIFY_WITH_TIMEOUT(output().contains(QStringLiteral("press play first")),
                             kScriptPatienceMs);
    widgets::SessionControl& session = m_window->state().session();
    m_window->state().transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session.isRunning(), kScriptPatienceMs);
    QVERIFY(run(QStringLiteral("scene.send('show', scene.ids[:1])")));
    QTRY_COMPARE_WITH_TIMEOUT(session.firedCount(1), std::uint64_t{1}, kScriptPatienceMs);
    QVERIFY(run(QStringLiteral("scene.send('show')")));
    QTRY_COMPARE_WITH_TIMEOUT(session.firedCount(1), std::uint64_t{3}, kScriptPatienceMs);
    session.stop();
}

void ConsoleTest::closingStopsTheScript()
{
    m_window->document().undoStack().setClean();
    type(QStringLiteral("exec('while True: len(scene)')"));
    QTest::qWait(200);
    QVERIFY(m_window->interpreter().isRunning());
    QVERIFY(!m_window->close()); // at once, without waiting
    QVERIFY(m_window->interpreter().isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kScriptPatienceMs);
    QVERIFY(!m_window->interpreter().isRunning());
}

CROWD_WINDOW_TEST(ConsoleTest)
#include "tst_Console.moc"
