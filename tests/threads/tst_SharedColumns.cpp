// SPDX-License-Identifier: MIT
#include "model/population/Population.h"
#include "tests/program/Test.h"

#include <QtTest/QTest>

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

using namespace crowd::model;

/// Columns that copies share, on several threads.
class SharedColumnsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areWrittenWhileCopiesAreReadAndDropped();
};

/// One thread edits and hands out copies, others read them and let go. The thread sanitizer has
/// its say here: who finds itself the only owner must have what others read behind it.
void SharedColumnsTest::areWrittenWhileCopiesAreReadAndDropped()
{
    std::mutex mutex;
    std::deque<Population> copies;
    std::atomic<bool> isDone{false};
    std::atomic<int> torn{0};
    const auto readAndDrop = [&] {
        while (!isDone) {
            std::unique_lock lock(mutex);
            if (copies.empty()) {
                lock.unlock();
                std::this_thread::yield();
                continue;
            }
            const Population copy = std::move(copies.front());
            copies.pop_front();
            lock.unlock();
            const auto headings = copy.column(columns::heading);
            torn += std::ranges::count(headings, headings[0]) != std::ssize(headings) ? 1 : 0;
        }
    };
    Population population;
    population.add(IndividualRows::withDefaults({1, 2, 3, 4}));
    std::vector<std::jthread> readers(3);
    for (std::jthread& reader : readers) {
        reader = std::jthread(readAndDrop);
    }
    for (int i = 0; i < 20000; ++i) {
        std::ranges::fill(population.edit(columns::heading), static_cast<float>(i));
        const std::lock_guard lock(mutex);
        if (copies.size() < 4) {
            copies.push_back(population);
        }
    }
    isDone = true;
    readers.clear();
    QCOMPARE(torn.load(), 0);
}

CROWD_TEST(SharedColumnsTest)
#include "tst_SharedColumns.moc"
