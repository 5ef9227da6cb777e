// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>

#include "app/window/FindByName.h"
#include "app/window/FindWords.h"
#include "app/window/MainWindow.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/dialogs/FindDialog.h"
#include "widgets/forms/FieldForm.h"

using namespace crowd;
using namespace crowd::testing;

/// Typing a name in the real window, by its keys.
class TestFindByName : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    static void initTestCase() { prepare("FindByName"); }
    void init() { begin(); }
    void cleanup();
    void allIsThereOnce();
    void everydayWordsFindIt();
    void aBrushIsTaken();
    void aPanelComesToTheFront();
    void aPanelComesOutOfHiding();
    void aSettingIsUnfoldedAndHasTheKeyboard();
    void whatWouldDoNothingIsNotOffered();
    void theLastComeFirst();
    void theCurrentOneIsChosenByKeys();
    void escapeTakesNothing();
    static void longNamesDoNotWidenIt();

private:
    /// Open, by its key.
    widgets::FindDialog* opened();
    static QTreeWidget* list(widgets::FindDialog* dialog)
    {
        return dialog->findChild<QTreeWidget*>(QStringLiteral("found"));
    }
    static QLineEdit* field(widgets::FindDialog* dialog)
    {
        return dialog->findChild<QLineEdit*>(QStringLiteral("typed"));
    }
    void take(const QString& typed);
    [[nodiscard]] QDockWidget* dock(const char* name) const
    {
        return m_window->findChild<QDockWidget*>(QLatin1String(name));
    }
};

void TestFindByName::cleanup()
{
    document().undoStack().setClean();
    m_window.reset();
}

widgets::FindDialog* TestFindByName::opened()
{
    QTest::keyClick(m_window.get(), Qt::Key_F, Qt::ControlModifier);
    widgets::FindDialog* dialog = nullptr;
    const bool came = QTest::qWaitFor([&] {
        dialog = qobject_cast<widgets::FindDialog*>(QApplication::activeModalWidget());
        return dialog != nullptr && field(dialog)->hasFocus();
    });
    return came ? dialog : nullptr;
}

void TestFindByName::take(const QString& typed)
{
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QTest::keyClicks(field(dialog), typed);
    QVERIFY(list(dialog)->topLevelItemCount() > 0);
    QTest::keyClick(field(dialog), Qt::Key_Return);
    QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
}

void TestFindByName::allIsThereOnce()
{
    std::set<std::pair<QString, QString>> seen;
    const std::vector<widgets::Findable> all = app::findables(*m_window);
    for (const widgets::Findable& item : all) {
        QVERIFY(!item.name.isEmpty());
        QVERIFY2(!item.name.contains(QLatin1Char('&')), qPrintable(item.name));
        QVERIFY2(item.run != nullptr, qPrintable(item.name));
        QVERIFY2(seen.insert({item.place, item.name}).second,
                 qPrintable(item.place + QLatin1Char('/') + item.name));
    }
    // Each action but the one that finds, and panels, menus that fill themselves and settings.
    QVERIFY(all.size() > m_window->actions().specs().size() + m_window->docks().size() - 10);
}

/// Each of them belongs to something that is there.
void TestFindByName::everydayWordsFindIt()
{
    const auto all = app::findables(*m_window);
    for (const QString& id : app::idsWithFindWords()) {
        const QString words = app::findWords(id);
        QVERIFY2(std::ranges::any_of(
                     all, [&words](const widgets::Findable& each) { return each.words == words; }),
                 qPrintable(id));
    }
    const auto isAmongTheFirst = [&all](const char* typed, const char* name) {
        const auto found = widgets::foundBy(QLatin1String(typed), all);
        const auto end = found.begin() + std::min<std::ptrdiff_t>(3, std::ssize(found));
        return std::any_of(found.begin(), end,
                           [&](std::size_t i) { return all[i].name == QString::fromUtf8(name); });
    };
    QVERIFY(isAmongTheFirst("wall", "Environment"));
    QVERIFY(isAmongTheFirst("render video", "Make Movie…"));
    QVERIFY(isAmongTheFirst("lamp", "Light"));
}

void TestFindByName::aBrushIsTaken()
{
    QAction* colour = m_window->actions().action("brush-colour");
    QVERIFY(!colour->isChecked());
    QString name = colour->text();
    take(name.remove(QLatin1Char('&')));
    QTRY_VERIFY(colour->isChecked());
}

void TestFindByName::aPanelComesToTheFront()
{
    QVERIFY(dock("history")->visibleRegion().isEmpty());
    take(dock("history")->windowTitle());
    QTRY_VERIFY(!dock("history")->visibleRegion().isEmpty());
    // Again: it stays, as nobody asked it to go.
    take(dock("history")->windowTitle());
    QTRY_VERIFY(!dock("history")->visibleRegion().isEmpty());
}

void TestFindByName::aPanelComesOutOfHiding()
{
    m_window->dockLayout().setHidden(true);
    take(dock("rules")->windowTitle());
    QTRY_VERIFY(!dock("rules")->visibleRegion().isEmpty());
    QVERIFY(!m_window->dockLayout().isHidden());
}

void TestFindByName::aSettingIsUnfoldedAndHasTheKeyboard()
{
    m_window->actions().action("brush-colour")->trigger();
    QTRY_COMPARE(dock("brushSettings")->windowTitle(), QStringLiteral("Colour Brush"));
    const auto forms = dock("brushSettings")->findChildren<widgets::FieldForm*>();
    QVERIFY(!forms.isEmpty());
    const widgets::FieldForm* form = nullptr;
    for (const widgets::FieldForm* shown : forms) {
        form = shown->isVisible() ? shown : form;
    }
    QVERIFY(form != nullptr);
    widgets::FieldForm::Setting setting;
    for (const widgets::FieldForm::Setting& each : form->settings()) {
        if (!each.section.isEmpty()) {
            setting = each; // the last: the panel must scroll, too
        }
    }
    QVERIFY(setting.row != nullptr);
    for (auto* header : form->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (header->text() == setting.section) {
            header->click();
        }
    }
    QVERIFY(!setting.row->isVisible());
    const QString place = dock("brushSettings")->windowTitle() + QStringLiteral(" › ");
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QTest::keyClicks(field(dialog), setting.name);
    const auto isCurrent = [&] { // others are called the same
        const QTreeWidgetItem* item = list(dialog)->currentItem();
        return item->text(1) == setting.name && item->text(2) == place + setting.section;
    };
    for (int i = 0; i < list(dialog)->topLevelItemCount() && !isCurrent(); ++i) {
        QTest::keyClick(field(dialog), Qt::Key_Down);
    }
    QVERIFY2(isCurrent(), qPrintable(place + setting.section + setting.name));
    QTest::keyClick(field(dialog), Qt::Key_Return);
    QTRY_VERIFY(!setting.row->visibleRegion().isEmpty());
    QTRY_VERIFY(setting.row->hasFocus() || setting.row->isAncestorOf(QApplication::focusWidget()));
}

void TestFindByName::whatWouldDoNothingIsNotOffered()
{
    openScene(plainScene(2), QStringLiteral("two.crowd"));
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QTest::keyClicks(field(dialog), QStringLiteral("undo"));
    const auto undo = QStringLiteral("Undo");
    const auto isOffered = [&] { // not what says the word in its tip
        return !list(dialog)->findItems(undo, Qt::MatchStartsWith, 1).isEmpty();
    };
    QVERIFY(!isOffered());
    field(dialog)->clear();
    QTest::keyClicks(field(dialog), QStringLiteral("zzz"));
    QCOMPARE(list(dialog)->topLevelItemCount(), 0);
    QVERIFY(!dialog->findChild<QLabel*>(QStringLiteral("tip"))->text().isEmpty());
    QTest::keyClick(field(dialog), Qt::Key_Return); // takes nothing, and stays
    QVERIFY(dialog->isVisible());
    QTest::keyClick(field(dialog), Qt::Key_Escape);
    QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
    moveEverybody(document(), 3.0F);
    dialog = opened();
    QVERIFY(dialog != nullptr);
    QTest::keyClicks(field(dialog), QStringLiteral("undo"));
    QVERIFY(isOffered());
    QTest::keyClick(field(dialog), Qt::Key_Return);
    QTRY_VERIFY(document().undoStack().index() == 0);
}

void TestFindByName::theLastComeFirst()
{
    take(dock("history")->windowTitle());
    take(dock("rules")->windowTitle());
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QCOMPARE(list(dialog)->topLevelItem(0)->text(1), dock("rules")->windowTitle());
    QCOMPARE(list(dialog)->topLevelItem(1)->text(1), dock("history")->windowTitle());
    dialog->reject();
}

void TestFindByName::theCurrentOneIsChosenByKeys()
{
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QTreeWidget* rows = list(dialog);
    // Letters may still be on their way: Return alone takes nothing.
    QVERIFY(rows->currentItem() == nullptr);
    QTest::keyClick(field(dialog), Qt::Key_Return);
    QVERIFY(dialog->isVisible());
    QTest::keyClick(field(dialog), Qt::Key_Down);
    QCOMPARE(rows->indexOfTopLevelItem(rows->currentItem()), 0);
    QTest::keyClick(field(dialog), Qt::Key_Down);
    QCOMPARE(rows->indexOfTopLevelItem(rows->currentItem()), 1);
    QTest::keyClick(field(dialog), Qt::Key_Up);
    QCOMPARE(rows->indexOfTopLevelItem(rows->currentItem()), 0);
    QVERIFY(field(dialog)->hasFocus());
    dialog->reject();
}

void TestFindByName::escapeTakesNothing()
{
    const QSize before = m_window->size();
    widgets::FindDialog* dialog = opened();
    QVERIFY(dialog != nullptr);
    QTest::keyClicks(field(dialog), dock("history")->windowTitle());
    QTest::keyClick(field(dialog), Qt::Key_Escape);
    QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
    QVERIFY(dock("history")->visibleRegion().isEmpty());
    QCOMPARE(m_window->size(), before);
    widgets::FindDialog* again = opened();
    QVERIFY(again != nullptr); // and it was not remembered
    QVERIFY(list(again)->topLevelItem(0)->text(1) != dock("history")->windowTitle());
    again->reject();
}

/// Names and sentences may come from files.
void TestFindByName::longNamesDoNotWidenIt()
{
    widgets::Findable item{QString(5000, QLatin1Char('x')), QStringLiteral("File")};
    item.tip = item.name;
    item.isApplicable = false;
    widgets::FindDialog dialog({item}, nullptr);
    const int before = dialog.minimumSizeHint().width();
    field(&dialog)->setText(QStringLiteral("xxx")); // said below the list: it would do nothing
    QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("tip"))->text().contains(item.name));
    QCOMPARE(dialog.minimumSizeHint().width(), before);
}

CROWD_WINDOW_TEST(TestFindByName)
#include "tst_FindByName.moc"
