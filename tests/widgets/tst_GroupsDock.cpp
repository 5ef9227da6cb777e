// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/GroupCommands.h"
#include "widgets/docks/GroupsDock.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

/// Groups as layers: eye, lock, name, count, and the active one.
class GroupsDockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersWithoutANameAreListed();
    void aNewGroupTakesTheSelectedAndBecomesActive();
    void eyeAndLockAreClicked();
    void theEyeWithAltShowsOneAlone();
    void lockedCannotBeSelected();
    void namesAreEditedInPlace();
    void deletingLeavesThePeople();
};

namespace {

QTreeWidget& treeOf(const Desk<GroupsDock>& desk)
{
    return *desk.dock->findChild<QTreeWidget*>();
}

void press(const Desk<GroupsDock>& desk, const char* name)
{
    QTest::mouseClick(desk.dock->findChild<QToolButton*>(QLatin1String(name)), Qt::LeftButton);
}

/// In the row of a group.
void clickOn(const Desk<GroupsDock>& desk, int row, int column, Qt::KeyboardModifiers with = {})
{
    QTreeWidget& tree = treeOf(desk);
    const QRect cell = tree.visualRect(tree.model()->index(row, column));
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, with, cell.center());
}

model::Group groupAt(const Desk<GroupsDock>& desk, std::size_t i)
{
    return desk.document.scene().groups.at(i);
}

} // namespace

void GroupsDockTest::numbersWithoutANameAreListed()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 5);
    const std::uint32_t group = 4;
    const auto edit = desk.document.beginEdit().value();
    edit->setColumn(model::columns::group, std::span(ids).first(2),
                    std::span<const std::uint32_t>(&group, 1));
    edit->commit(QStringLiteral("Group"));
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    QCOMPARE(treeOf(desk).topLevelItem(0)->text(GroupsDock::Count), QStringLiteral("3"));
    QCOMPARE(treeOf(desk).topLevelItem(1)->text(GroupsDock::Count), QStringLiteral("2"));
    clickOn(desk, 1, GroupsDock::Name);
    press(desk, "selectGroup");
    QCOMPARE(desk.state.selection().size(), std::size_t{2});
    clickOn(desk, 1, GroupsDock::Eye);
    QCOMPARE(groupAt(desk, 0).id, 4U);
    QVERIFY2(groupAt(desk, 0).isHidden && groupAt(desk, 0).isParty, "they walked as one before");
}

void GroupsDockTest::aNewGroupTakesTheSelectedAndBecomesActive()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 5);
    desk.state.selection().set(std::span(ids).first(3));
    const int steps = desk.document.undoStack().count();
    press(desk, "newGroup");
    QVERIFY(treeOf(desk).viewport()->findChild<QLineEdit*>() != nullptr); // to be named
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    QTreeWidgetItem* row = treeOf(desk).topLevelItem(1);
    QCOMPARE(row->text(GroupsDock::Count), QStringLiteral("3"));
    QVERIFY(row->font(GroupsDock::Name).bold());
    const model::GroupId group = groupAt(desk, 0).id;
    const auto create = [&] {
        return desk.state.brush(model::BrushKind::Create).as<model::CreateSettings>().group;
    };
    QCOMPARE(create(), group);
    QCOMPARE(desk.state.brush(model::BrushKind::Group).as<model::GroupSettings>().group, group);
    clickOn(desk, 0, GroupsDock::Name);
    QCOMPARE(create(), 0U);
    setActiveGroup(desk.state, group);
    desk.document.undoStack().undo();
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 1);
    QCOMPARE(create(), 0U);
}

void GroupsDockTest::eyeAndLockAreClicked()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    groupSelection(desk.state);
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    clickOn(desk, 1, GroupsDock::Eye);
    QVERIFY(groupAt(desk, 0).isHidden);
    QTRY_VERIFY(
        treeOf(desk).topLevelItem(1)->toolTip(GroupsDock::Eye).contains(QStringLiteral("Hidden")));
    clickOn(desk, 1, GroupsDock::Eye);
    QVERIFY(!groupAt(desk, 0).isHidden);
    clickOn(desk, 1, GroupsDock::Lock);
    QVERIFY(groupAt(desk, 0).isLocked);
    desk.document.undoStack().undo();
    QVERIFY(!groupAt(desk, 0).isLocked);
}

void GroupsDockTest::theEyeWithAltShowsOneAlone()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    groupSelection(desk.state);
    groupSelection(desk.state);
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 3);
    desk.dock->showAlone(groupAt(desk, 1).id);
    QVERIFY(groupAt(desk, 0).isHidden && !groupAt(desk, 1).isHidden);
    desk.dock->showAlone(groupAt(desk, 1).id);
    QVERIFY(!groupAt(desk, 0).isHidden && !groupAt(desk, 1).isHidden);
}

void GroupsDockTest::lockedCannotBeSelected()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 5);
    desk.state.selection().set(std::span(ids).first(2));
    press(desk, "newGroup");
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    QCOMPARE(desk.state.selection().size(), std::size_t{2});
    clickOn(desk, 1, GroupsDock::Lock);
    QVERIFY(desk.state.selection().isEmpty());
    desk.state.selection().selectAll();
    QCOMPARE(desk.state.selection().size(), std::size_t{3});
    press(desk, "selectGroup");
    QVERIFY(desk.state.selection().isEmpty());
}

void GroupsDockTest::namesAreEditedInPlace()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    groupSelection(desk.state);
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    treeOf(desk).topLevelItem(1)->setText(GroupsDock::Name, QStringLiteral("left stand"));
    QCOMPARE(groupAt(desk, 0).name, std::string("left stand"));
    treeOf(desk).topLevelItem(1)->setText(GroupsDock::Name, QStringLiteral("  "));
    QCOMPARE(groupAt(desk, 0).name, std::string("left stand"));
    QTRY_COMPARE(treeOf(desk).topLevelItem(1)->text(GroupsDock::Name),
                 QStringLiteral("left stand"));
}

void GroupsDockTest::deletingLeavesThePeople()
{
    Desk<GroupsDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 5);
    desk.state.selection().set(std::span(ids).first(2));
    press(desk, "newGroup");
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 2);
    press(desk, "deleteGroup");
    QTRY_COMPARE(treeOf(desk).topLevelItemCount(), 1);
    QCOMPARE(desk.document.scene().population.size(), std::size_t{5});
    QCOMPARE(activeGroup(desk.state), 0U);
}

CROWD_WINDOW_TEST(GroupsDockTest)
#include "tst_GroupsDock.moc"
