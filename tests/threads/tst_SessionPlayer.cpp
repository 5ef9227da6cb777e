// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPlayer.h"

#include <array>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

#include "behavior/session/MotionCache.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::SessionPlayer;

/// A session on its own thread while everything else goes on. Under the thread sanitizer this is
/// what looks for races between the two.
class SessionPlayerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editsWhileItRuns();
    void earlierTimesAreAsTheyWere();
    void goesOnFromAnEarlierTime();
    void whatIsToldLaterCounts();
    void stopsInTheMiddle();
    void stoppingWaitsForNobody();
    void peopleAreCountedWhenAsked();
};

namespace {

constexpr std::size_t kPeople = 3600; ///< enough for several threads a step

/// Everybody on his way across a square; whoever hears "run" runs.
model::Scene squareScene()
{
    model::Scene scene;
    std::vector<model::IndividualId> ids(kPeople);
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < kPeople; ++i) {
        rows.column(model::columns::position)[i] = {static_cast<float>(i % 60), 0.0F,
                                                    static_cast<float>(i / 60)};
        rows.column(model::columns::path)[i] = static_cast<model::PathId>(1 + i % 2);
    }
    scene.population.add(rows);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 3.0F}, {2, "b", {60.0F, 0.0F, 60.0F}, 3.0F}};
    scene.paths = {{1, "there", model::PathKind::Cyclic, {1, 2}},
                   {2, "back", model::PathKind::Cyclic, {2, 1}}};
    model::Rule rule;
    rule.id = 1;
    rule.name = "run";
    rule.trigger = model::triggers::Event{"run"};
    model::actions::SetSpeed run;
    run.value = 3.0F;
    rule.actions = {run};
    scene.rules = {rule};
    return scene;
}

/// As the window does it, over and over.
bool lookAt(const SessionPlayer& player, const model::Scene& scene, double seconds)
{
    model::CrowdFrame frame{scene.population, nullptr, seconds};
    player.pose(frame);
    const auto places = frame.population.column(model::columns::position);
    return std::ranges::all_of(places, [](const glm::vec3& at) { return std::isfinite(at.x); });
}

} // namespace

void SessionPlayerTest::editsWhileItRuns()
{
    model::Scene scene = squareScene();
    std::atomic<int> published = 0;
    SessionPlayer player([&] { ++published; });
    player.start(scene);
    std::uint64_t heard = 0;
    for (int i = 0; i < 40; ++i) {
        player.request(i / 30.0);
        const std::vector<model::IndividualId> ids{static_cast<model::IndividualId>(1 + i * 7)};
        scene.population.setValues<float>(model::columns::walkSpeed, ids,
                                          std::vector<float>{1.0F + 0.01F * static_cast<float>(i)});
        if (i % 5 == 0) {
            scene.places[0].radius += 0.1F;
            (void)scene.population.remove(ids);
        }
        player.adopt(scene, i % 3 == 0);
        model::Mark mark;
        mark.kind = model::MarkKind::Event;
        mark.event = "run";
        mark.people = {1000 + i};
        player.perform(mark);
        QVERIFY(lookAt(player, scene, i / 30.0));
        (void)player.poseAt(i / 30.0)->lit.size();
        heard += player.takeLog().size();
    }
    QTRY_VERIFY_WITH_TIMEOUT(player.available() >= 39 / 30.0 - 1e-6, 60000);
    heard += player.takeLog().size();
    QCOMPARE(heard, std::uint64_t{40});
    QVERIFY(lookAt(player, scene, player.available()));
    QVERIFY(published > 0);
    QCOMPARE(player.report().fired.at(1), std::uint64_t{40});
}

namespace {

/// Where everybody is, then.
std::vector<glm::vec3> placesAt(const SessionPlayer& player, const model::Scene& scene,
                                double seconds)
{
    model::CrowdFrame frame{scene.population, nullptr, seconds};
    player.pose(frame);
    const auto places = frame.population.column(model::columns::position);
    return {places.begin(), places.end()};
}

bool comesTo(const SessionPlayer& player, double seconds)
{
    return QTest::qWaitFor(
        [&] { return !player.takenShare() && player.available() >= seconds - 1e-6; }, 60000);
}

model::Mark runMark()
{
    model::Mark mark;
    mark.id = 1;
    mark.kind = model::MarkKind::Event;
    mark.event = "run";
    mark.people = {5, 900};
    return mark;
}

} // namespace

/// Told nothing else, it comes to the same; what came before is never another.
void SessionPlayerTest::goesOnFromAnEarlierTime()
{
    const model::Scene scene = squareScene();
    SessionPlayer player([] {});
    player.start(scene, 1.0);
    player.request(1.4);
    QVERIFY(comesTo(player, 1.4));
    player.perform(runMark());
    player.request(3.0);
    QVERIFY(comesTo(player, 3.0));
    const auto early = placesAt(player, scene, 1.31);
    const auto late = placesAt(player, scene, 2.72);
    std::uint64_t fired = player.report().fired.at(1);
    QCOMPARE(fired, std::uint64_t{2});
    const auto kept = player.motion();
    QVERIFY(player.takeFrom(2.0));
    QVERIFY(player.available() <= 2.0 + 1e-9); // at once
    QVERIFY(placesAt(player, scene, 1.31) == early);
    QVERIFY(placesAt(player, scene, 2.72) == placesAt(player, scene, 2.0));
    player.request(3.0);
    QVERIFY(comesTo(player, 3.0));
    QVERIFY(placesAt(player, scene, 1.31) == early);
    QVERIFY(placesAt(player, scene, 2.72) == late);
    QCOMPARE(player.report().fired.at(1), fired);
    QCOMPARE(player.first(), 1.0);
    QVERIFY(kept->extent().last > 2.5); // who reads it goes on reading
    QVERIFY(player.takeBefore(1.3));    // nobody has heard yet
    player.request(3.0);
    QVERIFY(comesTo(player, 3.0));
    QVERIFY(placesAt(player, scene, 2.72) != late);
}

/// Also where one take follows the other before it is done.
void SessionPlayerTest::whatIsToldLaterCounts()
{
    const model::Scene scene = squareScene();
    SessionPlayer player([] {});
    player.start(scene);
    player.request(2.0);
    QVERIFY(comesTo(player, 2.0));
    (void)player.takeLog();
    QVERIFY(player.takeFrom(1.8));
    player.perform(runMark());
    QVERIFY(player.takeFrom(1.0));
    player.perform(runMark());
    QVERIFY(player.takeFrom(0.5));
    player.perform(runMark());
    QVERIFY(player.takenShare());
    player.request(2.0);
    QVERIFY(comesTo(player, 2.0));
    const auto log = player.takeLog();
    QCOMPARE(log.size(), std::size_t{2});
    QVERIFY(std::abs(log.front().seconds - 0.5) < 0.1);
    QCOMPARE(player.takePerformed().size(), std::size_t{3}); // asked for, and heard once
    QCOMPARE(player.report().fired.at(1), std::uint64_t{2});
    QVERIFY(player.takeFrom(0.2));
    player.stop();
    QVERIFY(!player.takeFrom(0.1) && !player.takeBefore(0.1));
}

/// Also those that are packed, and while it goes on.
void SessionPlayerTest::earlierTimesAreAsTheyWere()
{
    const model::Scene scene = squareScene();
    SessionPlayer player([] {});
    player.start(scene, 1.0);
    std::vector<std::vector<glm::vec3>> seen;
    const auto look = [&](double seconds) {
        model::CrowdFrame frame{scene.population, nullptr, seconds};
        player.pose(frame);
        const auto places = frame.population.column(model::columns::position);
        return std::vector<glm::vec3>(places.begin(), places.end());
    };
    constexpr int kFrames = 70; // at other times than the steps
    const auto timeOf = [](int frame) { return 1.0 + frame * 0.0471; };
    for (int i = 0; i < kFrames; ++i) {
        player.request(timeOf(i) + 0.1);
        QTRY_VERIFY_WITH_TIMEOUT(player.available() >= timeOf(i) + 0.05, 60000);
        seen.push_back(look(timeOf(i)));
    }
    QCOMPARE(player.first(), 1.0);
    player.request(timeOf(kFrames) + 3.0);
    for (int i = 0; i < kFrames; ++i) {
        const int frame = i * 37 % kFrames;
        QVERIFY2(look(timeOf(frame)) == seen[static_cast<std::size_t>(frame)],
                 qPrintable(QString::number(frame)));
    }
    QVERIFY(look(0.0) == seen.front()); // before the beginning it is as then
    player.stop();
    QCOMPARE(player.first(), 0.0);
}

void SessionPlayerTest::stopsInTheMiddle()
{
    const model::Scene scene = squareScene();
    SessionPlayer player([] {});
    for (int i = 0; i < 8; ++i) {
        player.start(scene, 2.0);
        player.request(4.0);
        player.adopt(scene);
        std::this_thread::yield();
        player.stop();
        QVERIFY(!player.isRunning());
        QCOMPARE(player.available(), 0.0);
    }
}

/// The window must stay alive however long a step takes.
void SessionPlayerTest::stoppingWaitsForNobody()
{
    constexpr std::chrono::milliseconds kStep{1500};
    const model::Scene scene = squareScene();
    std::atomic<int> steps = 0;
    SessionPlayer player([&] {
        ++steps;
        std::this_thread::sleep_for(kStep); // on the session's thread
    });
    player.start(scene);
    player.request(4.0);
    QTRY_VERIFY(steps > 0);
    QElapsedTimer timer;
    timer.start();
    player.stop();
    player.start(scene, 2.0); // nor does the next one
    QVERIFY2(timer.elapsed() < kStep.count() / 2, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(player.available(), 2.0);
    QVERIFY(player.isRunning());
    player.stop();
    QVERIFY(!player.isRunning());
}

/// Two walk past a place, one stands in it, one leaves by an exit there.
void SessionPlayerTest::peopleAreCountedWhenAsked()
{
    model::Scene scene;
    const std::vector<model::IndividualId> ids{1, 2, 3, 4};
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        rows.column(model::columns::position)[i] = {4.0F * static_cast<float>(i), 0.0F, 0.0F};
        rows.column(model::columns::path)[i] =
            static_cast<model::PathId>(std::array{1, 1, 0, 2}[i]);
    }
    scene.population.add(rows);
    scene.places = {{1, "a", {8.0F, 0.0F, 0.0F}, 1.0F},
                    {2, "out", {14.0F, 0.0F, 0.0F}, 0.6F},
                    {3, "b", {8.0F, 0.0F, 30.0F}, 1.0F}};
    scene.places[1].role = model::PlaceRole::Exit;
    scene.paths = {{1, "to and fro", model::PathKind::Cyclic, {1, 3}}, {2, "away", {}, {2}}};
    std::atomic<int> published = 0;
    SessionPlayer player([&] { ++published; });
    player.start(scene);
    const behavior::SessionTally before{{{1, 2}, {2, 1}}, {{1, 1}}};
    QVERIFY(player.tally() == before);
    player.request(8.0);
    QTRY_VERIFY_WITH_TIMEOUT(player.available() >= 8.0 - 1e-6, 60000);
    QVERIFY(player.tally() == before); // nobody has asked
    const int told = published;
    player.askTally();
    QTRY_VERIFY(published > told);
    const behavior::SessionTally after = player.tally();
    QVERIFY(!after.followers.contains(2) && !after.inside.contains(2));
    QCOMPARE(after.followers.at(1), 2U);
    QVERIFY(after.inside.at(1) >= 1);
    player.stop();
}

CROWD_TEST(SessionPlayerTest)
#include "tst_SessionPlayer.moc"
