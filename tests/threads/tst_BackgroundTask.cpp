// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include <QtCore/QElapsedTimer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "widgets/tasks/BackgroundTask.h"

using namespace crowd;
using widgets::BackgroundTask;
using widgets::TaskReport;

namespace {

constexpr int kFreeMs = 200;    ///< within which the window is free after it was cancelled
constexpr int kLibraryMs = 600; ///< for which work may hear nothing
constexpr int kPatienceMs = 20000;

/// Looks until it is told to stop.
int workUntilStopped(const TaskReport& report)
{
    while (report(QStringLiteral("at work"), 0.5F)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 0;
}

/// As in the middle of somebody else's library.
int hearNothing(const TaskReport&)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(kLibraryMs));
    return 1;
}

} // namespace

/// Work in the background, its owner and its end.
class BackgroundTaskTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void handsOverOnTheOwnersThread();
    void showsHowFarItIs();
    void ownerIsFreeAtOnceAfterCancelling();
    void neverHasTwoAtWork();
    void outlivesItsOwnerUnheard();
    void waitsWhileAnEditIsOpen();
    void isWaitedFor();
    void nextPieceStartsWhereOneIsHandedOver();
    void doesNotKeepWhatTheWorkHeld();
};

void BackgroundTaskTest::handsOverOnTheOwnersThread()
{
    BackgroundTask task;
    const QSignalSpy ended(&task, &BackgroundTask::ended);
    std::thread::id worked;
    std::thread::id got;
    int value = 0;
    task.start([](const TaskReport&) { return std::pair(std::this_thread::get_id(), 42); },
               [&](const std::pair<std::thread::id, int>& result) {
                   worked = result.first;
                   value = result.second;
                   got = std::this_thread::get_id();
               });
    QVERIFY(task.isRunning());
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatienceMs);
    QVERIFY(!task.isRunning());
    QCOMPARE(value, 42);
    QVERIFY(got == std::this_thread::get_id());
    QVERIFY(worked != got);
}

void BackgroundTaskTest::showsHowFarItIs()
{
    BackgroundTask task;
    QSignalSpy progressed(&task, &BackgroundTask::progressed);
    task.start(
        [](const TaskReport& report) {
            for (int i = 1; i <= 1000; ++i) {
                (void)report(QString::number(i), static_cast<float>(i) / 1000.0F);
            }
            return 0;
        },
        [](int) {});
    QTRY_VERIFY_WITH_TIMEOUT(!task.isRunning(), kPatienceMs);
    QVERIFY(!progressed.isEmpty());
    QCOMPARE(progressed.last().at(0).toString(), QStringLiteral("1000"));
    QCOMPARE(progressed.last().at(1).toFloat(), 1.0F);
}

void BackgroundTaskTest::ownerIsFreeAtOnceAfterCancelling()
{
    BackgroundTask task;
    const QSignalSpy ended(&task, &BackgroundTask::ended);
    bool isHandedOver = false;
    task.start(hearNothing, [&](int) { isHandedOver = true; });
    QElapsedTimer timer;
    timer.start();
    task.cancel();
    QVERIFY(!task.isRunning());
    QCOMPARE(ended.count(), 1);
    QVERIFY2(timer.elapsed() < kFreeMs, qPrintable(QString::number(timer.elapsed())));
    QTest::qWait(2 * kLibraryMs);
    QVERIFY2(!isHandedOver, "nobody waits for it any more");
    QCOMPARE(ended.count(), 1);
    task.cancel();
    QCOMPARE(ended.count(), 1);
}

void BackgroundTaskTest::neverHasTwoAtWork()
{
    BackgroundTask task;
    const auto atWork = std::make_shared<std::atomic<int>>(0);
    const auto most = std::make_shared<std::atomic<int>>(0);
    const auto work = [atWork, most](const TaskReport& report) {
        *most = std::max(most->load(), ++*atWork);
        (void)workUntilStopped(report);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return --*atWork;
    };
    for (int i = 0; i < 5; ++i) {
        task.start(work, [](int) {});
        QTest::qWait(i % 2 == 0 ? 10 : 0);
        task.cancel();
    }
    int last = -1;
    task.start([](const TaskReport&) { return 7; }, [&](int value) { last = value; });
    QTRY_COMPARE_WITH_TIMEOUT(last, 7, kPatienceMs);
    QCOMPARE(most->load(), 1);
    QCOMPARE(atWork->load(), 0);
}

void BackgroundTaskTest::outlivesItsOwnerUnheard()
{
    bool isHandedOver = false;
    const auto isDone = std::make_shared<std::atomic<bool>>(false);
    QElapsedTimer timer;
    {
        BackgroundTask task;
        task.start(
            [isDone](const TaskReport& report) {
                (void)report(QStringLiteral("begun"), 0.0F);
                const int value = hearNothing(report);
                *isDone = true;
                return value;
            },
            [&](int) { isHandedOver = true; });
        QTest::qWait(20);
        timer.start();
    }
    QVERIFY2(timer.elapsed() < kFreeMs, qPrintable(QString::number(timer.elapsed())));
    QTRY_VERIFY_WITH_TIMEOUT(isDone->load(), kPatienceMs);
    QTest::qWait(20);
    QVERIFY(!isHandedOver);
}

void BackgroundTaskTest::waitsWhileAnEditIsOpen()
{
    bool isEditOpen = true;
    BackgroundTask task([&isEditOpen] { return !isEditOpen; });
    int got = 0;
    task.start([](const TaskReport&) { return 3; }, [&](int value) { got = value; });
    QTest::qWait(300);
    QCOMPARE(got, 0);
    QVERIFY(task.isRunning());
    isEditOpen = false;
    QTRY_COMPARE_WITH_TIMEOUT(got, 3, kPatienceMs);

    isEditOpen = true;
    task.start([](const TaskReport&) { return 4; }, [&](int value) { got = value; });
    QTest::qWait(100);
    task.cancel(); // while it waits
    isEditOpen = false;
    QTest::qWait(100);
    QCOMPARE(got, 3);
}

void BackgroundTaskTest::isWaitedFor()
{
    BackgroundTask task([] { return false; });
    const QSignalSpy ended(&task, &BackgroundTask::ended);
    int got = 0;
    task.start(hearNothing, [&](int value) { got = value; });
    task.wait();
    QCOMPARE(got, 1);
    QVERIFY(!task.isRunning());
    task.wait();
    task.start([](const TaskReport&) { return 2; }, [&](int value) { got = value; });
    QTest::qWait(50); // the end of the first is heard of only now
    QCOMPARE(got, 1);
    task.wait();
    QCOMPARE(got, 2);
    QCOMPARE(ended.count(), 2);
}

void BackgroundTaskTest::nextPieceStartsWhereOneIsHandedOver()
{
    BackgroundTask task;
    int got = 0;
    task.start([](const TaskReport&) { return 1; },
               [&](int first) {
                   task.start([first](const TaskReport&) { return first + 1; },
                              [&got](int second) { got = second; });
               });
    QTRY_COMPARE_WITH_TIMEOUT(got, 2, kPatienceMs);
}

void BackgroundTaskTest::doesNotKeepWhatTheWorkHeld()
{
    BackgroundTask task;
    auto held = std::make_shared<int>(1);
    bool wasFree = false;
    const std::weak_ptr<int> watched = held;
    task.start([held = std::move(held)](const TaskReport&) { return *held; },
               [&](int) { wasFree = watched.expired(); });
    QTRY_VERIFY_WITH_TIMEOUT(!task.isRunning(), kPatienceMs);
    QVERIFY(wasFree);
}

CROWD_TEST(BackgroundTaskTest)
#include "tst_BackgroundTask.moc"
