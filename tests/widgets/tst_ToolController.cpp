// SPDX-License-Identifier: MIT
#include "widgets/tools/ToolController.h"

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using crowd::testing::kCenter;

class TestToolController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void changingTheToolTakesTheStrokeBack();
    void rightButtonAsksForThePalette();
    void keysDoNothingElseInTheMiddleOfADrag();
    void lateEventsNeverTurnTimeBack();
};

void TestToolController::changingTheToolTakesTheStrokeBack()
{
    Hand hand;
    hand.press(kCenter);
    QVERIFY(hand.tools.isDragging());
    hand.state.setTool(ToolId::Select);
    QVERIFY(!hand.tools.isDragging());
    QVERIFY(!hand.document.isEditOpen());
    QVERIFY(hand.document.scene().population.isEmpty());
}

void TestToolController::rightButtonAsksForThePalette()
{
    Hand hand;
    QSignalSpy requests(&hand.tools, &ToolController::paletteRequested);
    hand.press(kCenter, Qt::RightButton);
    hand.release(kCenter, Qt::RightButton);
    QCOMPARE(requests.count(), 1);
    QCOMPARE(requests.front().front().toPointF(), kCenter);
    QCOMPARE(hand.document.undoStack().count(), 0);
}

void TestToolController::keysDoNothingElseInTheMiddleOfADrag()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.selection().set(ids);
    hand.press(kCenter);
    QVERIFY(hand.tools.claimsKey(Qt::Key_Delete, Qt::NoModifier));
    hand.key(Qt::Key_Delete);
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    hand.key(Qt::Key_V);
    QVERIFY(hand.tools.isDragging());
    QVERIFY(hand.document.scene().population.size() >= 3);
    hand.release(kCenter);
    QVERIFY(!hand.tools.claimsKey(Qt::Key_Delete, Qt::NoModifier));
}

void TestToolController::lateEventsNeverTurnTimeBack()
{
    Hand hand;
    hand.press(kCenter);
    hand.rest(0.5);
    ToolInput late = hand.at(kCenter + QPointF(5.0, 0.0));
    late.pointer.timeSeconds -= 0.4;
    hand.tools.move(late);
    hand.release(kCenter);
    QVERIFY(!hand.document.isEditOpen());
    QCOMPARE(hand.document.undoStack().count(), 1);
}

CROWD_TEST(TestToolController)
#include "tst_ToolController.moc"
