// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

#include "behavior/surface/WalkSurface.h"
#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::SurfacePlan;
using behavior::WalkSurface;

/// What can be walked on, asked and built on several threads.
class SurfaceThreadsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAskedWhileOthersAreBuilt();
    void endsSoonAfterItWasCancelled();
};

namespace {

/// So many houses each way, 12 m apart.
SurfacePlan town(int houses)
{
    model::StageMesh mesh;
    for (int x = 0; x < houses; ++x) {
        for (int z = 0; z < houses; ++z) {
            const glm::vec3 at(12.0F * static_cast<float>(x), 0.0F, 12.0F * static_cast<float>(z));
            testing::addBox(mesh, at, at + glm::vec3(6.0F, 5.0F, 6.0F));
        }
    }
    return {{testing::stageOf(mesh)}, {}, {}, {}};
}

} // namespace

void SurfaceThreadsTest::isAskedWhileOthersAreBuilt()
{
    const SurfacePlan plan = town(3);
    WalkSurface::Progress progress;
    const auto built = WalkSurface::build(plan, progress);
    QVERIFY2(built.isOk(), built ? "" : built.error().message.c_str());
    const auto surface = built.value();
    const auto expected = surface->way({-2.0F, 0.0F, 3.0F}, {20.0F, 0.0F, 3.0F});
    QVERIFY(!expected.empty());
    std::atomic<int> different{0};
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 3; ++i) {
            threads.emplace_back([&] {
                for (int k = 0; k < 200; ++k) {
                    const auto way = surface->way({-2.0F, 0.0F, 3.0F}, {20.0F, 0.0F, 3.0F});
                    different += way != expected ? 1 : 0;
                    (void)surface->height(1.0F, -3.0F, 0.0F);
                }
            });
        }
        threads.emplace_back([&] {
            WalkSurface::Progress own;
            different += WalkSurface::build(plan, own).isOk() ? 0 : 1;
        });
    }
    QCOMPARE(different.load(), 0);
}

void SurfaceThreadsTest::endsSoonAfterItWasCancelled()
{
    constexpr int kSoonMs = 2000;
    const SurfacePlan plan = town(40);
    for (const int ms : {5, 60, 250, 700}) {
        WalkSurface::Progress progress;
        std::atomic<bool> isBuilt{false};
        std::jthread worker([&] {
            const auto built = WalkSurface::build(plan, progress);
            isBuilt = built.isOk();
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(ms));
        QElapsedTimer timer;
        timer.start();
        progress.isCancelled = true;
        worker.join();
        QVERIFY2(timer.elapsed() < kSoonMs, qPrintable(QString::number(timer.elapsed())));
    }
}

CROWD_TEST(SurfaceThreadsTest)
#include "tst_SurfaceThreads.moc"
