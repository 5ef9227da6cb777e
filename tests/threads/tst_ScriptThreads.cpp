// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include <QtTest/QTest>

#include "app/python/ScriptPeople.h"
#include "app/python/ScriptSession.h"
#include "tests/program/Test.h"

using namespace crowd;
using app::ColumnValues;
using app::ScriptHost;
using app::ScriptScene;
using app::ScriptSession;

/// What scripts work on, without a script: the host's document on one thread, those who edit it and
/// ask a session on others. Under the thread sanitizer this looks for races.
class ScriptThreadsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editsAreInterruptedByTheHost();
    void aSessionIsSteppedAskedAndEdited();
    void anOlderSceneIsNotTakenForANewerOne();
};

namespace {

/// As the editor's gate: work is handed to the thread of the document and waited for.
class Gate
{
public:
    void run(const std::function<void()>& work)
    {
        std::unique_lock lock(m_mutex);
        m_isFree.wait(lock, [this] { return m_work == nullptr; });
        m_work = &work;
        m_isDone = false;
        m_changed.wait(lock, [&] { return m_isDone; });
        m_work = nullptr;
        m_isFree.notify_one();
    }
    /// The document's thread: whoever waits is served.
    void serve()
    {
        const std::lock_guard lock(m_mutex);
        if (m_work != nullptr && !m_isDone) {
            (*m_work)();
            m_isDone = true;
            m_changed.notify_all();
        }
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_isFree;
    std::condition_variable m_changed;
    const std::function<void()>* m_work = nullptr;
    bool m_isDone = false;
};

model::Scene walkers(std::size_t count)
{
    model::Scene scene;
    std::vector<model::IndividualId> ids(count);
    for (std::size_t i = 0; i < count; ++i) {
        ids[i] = static_cast<model::IndividualId>(i + 1);
    }
    auto rows = model::IndividualRows::withDefaults(ids);
    std::ranges::fill(rows.column(model::columns::path), model::PathId{1});
    scene.population.add(rows);
    scene.nextId = static_cast<model::IndividualId>(count + 1);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 1.0F}, {2, "b", {30.0F, 0.0F, 0.0F}, 1.0F}};
    scene.paths = {{1, "there", model::PathKind::Cyclic, {1, 2}}};
    return scene;
}

ColumnValues headings(std::size_t count, float value)
{
    ColumnValues values{model::ColumnId::Heading, std::vector<std::byte>(count * sizeof(float))};
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&values.bytes[i * sizeof(float)], &value, sizeof(float));
    }
    return values;
}

} // namespace

void ScriptThreadsTest::editsAreInterruptedByTheHost()
{
    model::SceneDocument document;
    document.replaceScene(walkers(50), {});
    model::KeyframeStore keyframes;
    model::StageRays stage;
    Gate gate;
    std::atomic<bool> isDone{false};
    std::atomic<int> made{0};
    std::jthread script([&] {
        ScriptScene scene(
            ScriptHost{&document, &keyframes, &stage,
                       [&gate](const std::function<void()>& work) { gate.run(work); }});
        const std::vector<model::IndividualId> ids{3, 7};
        for (int i = 0; i < 200; ++i) {
            const bool isBegun = scene.beginEdit("step").isOk();
            const std::vector<ColumnValues> values{headings(2, 0.01F * static_cast<float>(i))};
            made += app::changePeople(scene, ids, values).isOk() ? 1 : 0;
            (void)scene.undo(); // refused, inside of an edit
            (void)scene.scene()->population.column(model::columns::heading)[2];
            if (isBegun) {
                scene.endEdit(i % 3 != 0);
            }
        }
        isDone = true;
    });
    for (int turn = 0; !isDone; ++turn) {
        gate.serve();
        if (turn % 500 == 0) {
            document.interruptEdit();
        }
        std::this_thread::yield();
    }
    // The script's scene goes in there, too.
    std::jthread joiner([&] {
        script.join();
        isDone = false;
    });
    while (isDone) {
        gate.serve();
        std::this_thread::yield();
    }
    QVERIFY(made > 0);
    QVERIFY(!document.isEditOpen());
}

void ScriptThreadsTest::aSessionIsSteppedAskedAndEdited()
{
    std::mutex language; // as Python's lock: who edits or looks at the scene has it
    auto scene = std::make_shared<ScriptScene>();
    const model::Scene begin = walkers(200);
    const auto session = std::make_shared<ScriptSession>(scene);
    const std::atomic<bool> isCancelled{false};
    std::uint64_t revision = 1;
    auto state = std::make_shared<const model::Scene>(begin);
    session->follow({state, revision}, isCancelled);
    std::atomic<bool> isDone{false};
    {
        std::vector<std::jthread> askers;
        for (int i = 0; i < 2; ++i) {
            askers.emplace_back([&] {
                while (!isDone) {
                    (void)session->seconds();
                    (void)session->fired();
                    (void)session->problems();
                    (void)session->pose();
                    (void)session->frame()->population.column(model::columns::position)[0];
                }
            });
        }
        askers.emplace_back([&] {
            for (int i = 0; i < 60; ++i) {
                session->step();
                session->send("go", 1.0F, {1, 2, 3});
            }
        });
        model::Scene edited = begin;
        for (int i = 0; i < 60; ++i) {
            std::ranges::fill(edited.population.edit(model::columns::heading),
                              static_cast<float>(i));
            ScriptScene::Snapshot now;
            {
                const std::lock_guard lock(language);
                now = {std::make_shared<const model::Scene>(edited), ++revision};
            }
            session->follow(now, isCancelled);
        }
        askers.back().join();
        isDone = true;
    }
    QCOMPARE(session->steps(), std::uint64_t{60});
    QVERIFY(session->isUpToDate(revision));
}

void ScriptThreadsTest::anOlderSceneIsNotTakenForANewerOne()
{
    auto scene = std::make_shared<ScriptScene>();
    ScriptSession session(scene);
    const std::atomic<bool> isCancelled{false};
    const auto small = std::make_shared<const model::Scene>(walkers(3));
    const auto large = std::make_shared<const model::Scene>(walkers(5));
    session.follow({small, 1}, isCancelled);
    session.follow({large, 3}, isCancelled);
    session.follow({small, 2}, isCancelled); // of a thread that was slow
    QCOMPARE(session.frame()->population.size(), std::size_t{5});
    session.adoptKept({small, 2});
    QCOMPARE(session.frame()->population.size(), std::size_t{5});
    QVERIFY(session.isUpToDate(3) && !session.isUpToDate(4));
}

CROWD_TEST(ScriptThreadsTest)
#include "tst_ScriptThreads.moc"
