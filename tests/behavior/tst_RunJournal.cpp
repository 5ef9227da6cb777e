// SPDX-License-Identifier: MIT
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "behavior/session/PoseBytes.h"
#include "behavior/session/RunJournal.h"
#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::PoseWriter;
using behavior::RunJournal;

namespace {

constexpr std::uint64_t kToldSteps = 90;

std::vector<std::byte> bytesOf(const Session& session)
{
    PoseWriter writer;
    const auto bytes = writer.packed(*session.pose(), nullptr).bytes;
    return {bytes.begin(), bytes.end()};
}

/// People who walk, and run where they hear an event.
Scene lively()
{
    Scene scene = sceneWithState();
    scene.places = {{1, "here", {0.0F, 0.0F, 0.0F}, 1.0F}, {2, "there", {60.0F, 0.0F, 0.0F}, 1.0F}};
    scene.paths = {{1, "way", PathKind::Simple, {1, 2}}};
    const auto ids = scene.population.ids();
    const PathId way = 1;
    scene.population.setValues<PathId>(columns::path, std::vector(ids.begin(), ids.end()),
                                       std::vector{way});
    actions::SetSpeed run;
    run.value = 3.0F;
    scene.rules = {onEvent("go", {run})};
    return scene;
}

void moveFirst(Scene& scene, float x)
{
    const std::vector<IndividualId> ids{scene.population.ids().front()};
    scene.population.setValues<glm::vec3>(columns::position, ids,
                                          std::vector<glm::vec3>{{x, 0.0F, 1.0F}});
}

/// A session that is told something now and then, with its journal and what it was like.
struct ToldSession
{
    Scene scene = lively();
    Session session{scene};
    RunJournal journal{scene, 0.0, nullptr};
    std::vector<std::vector<std::byte>> seen; ///< by step

    void tell(RunJournal::Act act)
    {
        act(session);
        journal.add(session.steps(), std::move(act));
    }
    void adopt()
    {
        const auto copy = std::make_shared<const Scene>(scene);
        const auto act = [copy](Session& each) { each.adopt(*copy); };
        act(session);
        journal.add(session.steps(), act, *copy);
    }
    void play()
    {
        while (session.steps() < kToldSteps) {
            const std::uint64_t step = session.steps();
            if (step % 20 == 7) {
                moveFirst(scene, static_cast<float>(step));
                adopt();
            }
            if (step % 30 == 11) {
                tell([](Session& each) { each.send("go", 0.0F, {1, 2, 4}); });
            }
            seen.push_back(bytesOf(session));
            session.step();
        }
        seen.push_back(bytesOf(session));
    }
};

} // namespace

/// What a session was told makes another one the same.
class TestRunJournal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void toldOnceMoreItIsTheSame();
    void whatIsForgottenWasNotTold();
    void tooMuchIsNotKept();
};

void TestRunJournal::toldOnceMoreItIsTheSame()
{
    ToldSession told;
    told.play();
    QVERIFY(told.seen[9] != told.seen[8]);
    const auto again = told.journal.begin();
    while (true) {
        told.journal.tell(*again);
        QVERIFY2(bytesOf(*again) == told.seen[again->steps()],
                 qPrintable(QString::number(again->steps())));
        if (again->steps() == kToldSteps) {
            break;
        }
        again->step();
    }
}

void TestRunJournal::whatIsForgottenWasNotTold()
{
    ToldSession told;
    told.play();
    told.journal.forgetFrom(27); // where somebody is moved once more
    const auto again = told.journal.begin();
    while (again->steps() < 28) {
        told.journal.tell(*again);
        if (again->steps() < 27) {
            QVERIFY(bytesOf(*again) == told.seen[again->steps()]);
        }
        again->step();
    }
    QVERIFY(bytesOf(*again) != told.seen[28]);
    told.journal.forgetFrom(0);
    const auto untold = told.journal.begin();
    told.journal.tell(*untold);
    QVERIFY(bytesOf(*untold) == told.seen[0]);
}

/// Scenes of which nothing is shared any more.
void TestRunJournal::tooMuchIsNotKept()
{
    Scene scene = lively();
    std::vector<IndividualId> ids(400'000);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = static_cast<IndividualId>(i + 10);
    }
    scene.population.add(IndividualRows::withDefaults(ids));
    RunJournal journal(scene, 0.0, nullptr);
    journal.add(
        1, [](Session&) {}, scene);
    journal.limit();
    QVERIFY(journal.isWhole()); // all is shared
    for (int i = 0; i < 9 && journal.isWhole(); ++i) {
        Scene other = lively();
        other.population.add(IndividualRows::withDefaults(ids));
        journal.add(
            2, [](Session&) {}, other);
        journal.limit();
    }
    QVERIFY(!journal.isWhole());
}

CROWD_TEST(TestRunJournal)
#include "tst_RunJournal.moc"
