// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/rules/EventQueue.h"
#include "tests/program/Test.h"

using crowd::behavior::EventQueue;
using crowd::behavior::QueuedEvent;

namespace {

QueuedEvent eventAt(double due, const char* name)
{
    QueuedEvent event;
    event.due = due;
    event.name = name;
    return event;
}

std::string takeAllDue(EventQueue& queue, double now)
{
    std::string names;
    while (queue.hasDue(now)) {
        names += queue.take().name;
    }
    return names;
}

} // namespace

class TestEventQueue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comesInTheOrderOfTime();
    void thoseOfOneTimeComeAsTheyWerePosted();
    void staysUntilItIsDue();
    void whatIsPostedWhileOthersAreTakenComesInItsPlace();
    void isFullAtHalfAMillion();
};

void TestEventQueue::comesInTheOrderOfTime()
{
    EventQueue queue;
    queue.post(eventAt(3.0, "c"));
    queue.post(eventAt(1.0, "a"));
    queue.post(eventAt(2.0, "b"));
    QCOMPARE(takeAllDue(queue, 10.0), std::string("abc"));
    QCOMPARE(queue.size(), std::size_t(0));
}

void TestEventQueue::thoseOfOneTimeComeAsTheyWerePosted()
{
    EventQueue queue;
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
        queue.post(eventAt(1.0, name));
    }
    QCOMPARE(takeAllDue(queue, 1.0), std::string("abcdefg"));
}

void TestEventQueue::staysUntilItIsDue()
{
    EventQueue queue;
    queue.post(eventAt(2.0, "late"));
    queue.post(eventAt(1.0, "soon"));
    QVERIFY(!queue.hasDue(0.99));
    QCOMPARE(takeAllDue(queue, 1.0), std::string("soon"));
    QCOMPARE(queue.size(), std::size_t(1));
    QCOMPARE(takeAllDue(queue, 2.0), std::string("late"));
}

void TestEventQueue::whatIsPostedWhileOthersAreTakenComesInItsPlace()
{
    EventQueue queue;
    queue.post(eventAt(1.0, "a"));
    queue.post(eventAt(3.0, "c"));
    QCOMPARE(queue.take().name, std::string("a"));
    queue.post(eventAt(2.0, "b"));
    QCOMPARE(takeAllDue(queue, 3.0), std::string("bc"));
}

void TestEventQueue::isFullAtHalfAMillion()
{
    EventQueue queue;
    for (int i = 0; i < 500'000; ++i) {
        queue.post(eventAt(0.0, "x"));
    }
    QVERIFY(!queue.isFull());
    queue.post(eventAt(0.0, "x"));
    QVERIFY(queue.isFull());
    (void)queue.take();
    QVERIFY(!queue.isFull());
}

CROWD_TEST(TestEventQueue)
#include "tst_EventQueue.moc"
