// SPDX-License-Identifier: MIT
#include <QtCore/QFile>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QDialog>
#include <QtWidgets/QProgressDialog>

#include "app/window/MainWindow.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

const QString kMan = QStringLiteral(CROWD_RESOURCES "/templates/man.glb");
const QString kStage = QStringLiteral(CROWD_RESOURCES "/stages/meadow.glb");
constexpr int kLongEnoughMs = 1500; ///< to read a model, and for a progress dialog to come

} // namespace

/// Work in the background ends while the artist is in the middle of a stroke.
class InterruptionsTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("InterruptionsTest"); }
    void init() { begin(); }
    void cleanup()
    {
        document().undoStack().setClean();
        m_window.reset();
    }

    void importsWaitForTheEndOfAStroke_data();
    void importsWaitForTheEndOfAStroke();
    void aFailedImportWaitsToo();
    void anotherSceneWaitsAndAsksAboutTheStroke();
    void removingMeansNothingInAStroke();
    void keysAreTheDialogsWhoeverHasTheKeyboard();

private:
    [[nodiscard]] bool beginStroke();
    void endStroke();
    [[nodiscard]] QPoint middle() const { return m_window->viewport().rect().center(); }
};

bool InterruptionsTest::beginStroke()
{
    m_window->state().setTool(widgets::ToolId::BrushCreate);
    QTest::mouseMove(&m_window->viewport(), middle());
    QTest::mousePress(&m_window->viewport(), Qt::LeftButton, {}, middle());
    QTest::mouseMove(&m_window->viewport(), middle() + QPoint(40, 10));
    return document().isEditOpen();
}

void InterruptionsTest::endStroke()
{
    QTest::mouseRelease(&m_window->viewport(), Qt::LeftButton, {}, middle() + QPoint(40, 10));
}

void InterruptionsTest::importsWaitForTheEndOfAStroke_data()
{
    QTest::addColumn<bool>("isStage");
    QTest::addColumn<bool>("isCancelled");
    QTest::newRow("template") << false << false;
    QTest::newRow("template, stroke taken back") << false << true;
    QTest::newRow("stage") << true << false;
}

void InterruptionsTest::importsWaitForTheEndOfAStroke()
{
    QFETCH(bool, isStage);
    QFETCH(bool, isCancelled);
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const auto models = [this] {
        return document().scene().templates.size() + document().scene().stages.size();
    };
    const std::size_t before = models();
    QVERIFY(beginStroke()); // first: a slow machine shows the dialog before the button is down
    isStage ? m_window->assets().addStage(kStage) : m_window->assets().addTemplate(kMan, {});
    QTest::qWait(kLongEnoughMs);
    QTRY_VERIFY_WITH_TIMEOUT(document().scene().population.size() > 1, kPatienceMs); // it sprays
    QVERIFY2(document().isEditOpen(), "the stroke goes on");
    QCOMPARE(models(), before);
    for (const auto* dialog : m_window->findChildren<QProgressDialog*>()) {
        QVERIFY2(!dialog->isVisible(), "it would take the mouse from the stroke");
    }
    isCancelled ? QTest::keyClick(&m_window->viewport(), Qt::Key_Escape) : endStroke();
    QVERIFY(!document().isEditOpen());
    QTRY_COMPARE_WITH_TIMEOUT(models(), before + 1, kPatienceMs);
    QCOMPARE(document().undoStack().count(), isCancelled ? 1 : 2);
    QVERIFY(document().undoStack().undoText().contains(QStringLiteral("Import")));
    document().undoStack().undo();
    QCOMPARE(models(), before);
    QCOMPARE(document().scene().population.size() > 1, !isCancelled);
}

void InterruptionsTest::aFailedImportWaitsToo()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    QFile broken(pathOf(QStringLiteral("broken.glb")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("no model");
    broken.close();
    QVERIFY(beginStroke()); // first: that there is no model in it is found at once
    m_window->assets().addTemplate(broken.fileName(), {});
    QTest::qWait(kLongEnoughMs);
    QVERIFY(openDialog() == nullptr);
    endStroke();
    QTRY_VERIFY_WITH_TIMEOUT(openDialog() != nullptr, kPatienceMs);
    openDialog()->reject();
}

void InterruptionsTest::anotherSceneWaitsAndAsksAboutTheStroke()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(5), pathOf(QStringLiteral("b.crowd"))).isOk());
    QVERIFY(beginStroke()); // the next begins at once, before a dialog is there
    QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
    QTest::mouseRelease(&m_window->viewport(), Qt::LeftButton, {}, middle());
    m_window->files().openPath(pathOf(QStringLiteral("b.crowd")));
    QVERIFY(beginStroke());
    QTest::qWait(kLongEnoughMs);
    QVERIFY(document().isEditOpen());
    const DialogAnswer stay(pressing(QMessageBox::Cancel));
    endStroke();
    QTRY_VERIFY_WITH_TIMEOUT(stay.hasAnswered(), kPatienceMs);
    QTRY_VERIFY(!m_window->files().isBusy());
    QCOMPARE(document().path(), pathOf(QStringLiteral("a.crowd")));
    QCOMPARE(document().undoStack().count(), 1);
}

void InterruptionsTest::removingMeansNothingInAStroke()
{
    openScene(plainScene(0), QStringLiteral("a.crowd"));
    const auto edit = document().beginEdit().value();
    m_window->assets().removeTemplate(1);
    QCOMPARE(document().scene().templates.size(), std::size_t{1});
}

void InterruptionsTest::keysAreTheDialogsWhoeverHasTheKeyboard()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    m_window->state().setTool(widgets::ToolId::Select);
    QDialog dialog(m_window.get());
    dialog.open();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QVERIFY(!m_window->dockLayout().dock(app::DockId::Brushes)->isHidden());
    m_window->activateWindow(); // as some window managers do between two dialogs
    for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_B, Qt::Key_Escape}) {
        QTest::keyClick(&m_window->viewport(), key);
    }
    QCOMPARE(m_window->state().tool(), widgets::ToolId::Select);
    QVERIFY2(!m_window->dockLayout().dock(app::DockId::Brushes)->isHidden(),
             "Tab hides the panels");
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isActiveWindow(), kPatienceMs);
    dialog.reject();
}

CROWD_WINDOW_TEST(InterruptionsTest)

#include "tst_Interruptions.moc"
