// SPDX-License-Identifier: MIT
#include "behavior/session/RunBeginning.h"

#include <algorithm>
#include <cmath>

#include <QtTest/QTest>

#include "behavior/session/MotionReader.h"
#include "behavior/session/SessionPlayer.h"
#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::MotionCache;
using behavior::RunBeginning;
using behavior::SessionPosePtr;

namespace {

namespace beginKeys = model::columns;

constexpr double kBeginStep = 1.0 / 30.0;

/// What has been played, and the session that did.
struct Played
{
    explicit Played(const model::Scene& scene) : session(scene) { cache->add(session.pose()); }
    void play(int steps)
    {
        for (int i = 0; i < steps; ++i) {
            session.step();
            cache->add(session.pose());
        }
    }
    [[nodiscard]] RunBeginning at(int step) const
    {
        auto beginning = behavior::beginningIn(cache, (step + 0.5) * kBeginStep);
        if (!beginning) {
            qFatal("no such step");
        }
        return std::move(*beginning);
    }

    Session session;
    std::shared_ptr<MotionCache> cache = std::make_shared<MotionCache>();
};

std::unique_ptr<Session> goneOn(const model::Scene& scene, const RunBeginning& beginning)
{
    auto session = std::make_unique<Session>(scene);
    session->beginFrom(*beginning.before, *beginning.now);
    return session;
}

/// People who walk 60 m ahead, and clap, turn red, leave or count when they are told to.
model::Scene beginScene()
{
    model::Scene scene = rowOf(6);
    scene.places = {{1, "far", {5.0F, 0.0F, 80.0F}, 8.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    return scene;
}

} // namespace

class TestRunBeginning : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreWhereTheyWere();
    void theyGoOnWithoutAJump();
    void whatRulesMadeOfThemStays();
    void whoHasLeftStaysAway();
    void aClipGoesOn_data();
    void aClipGoesOn();
    void whatStatesMadeOfThemStays();
    void peopleOfNowCount();
    void theStepsBeforeAreGiven();
    void aPlayerShowsWhatWasBefore();
};

void TestRunBeginning::theyAreWhereTheyWere()
{
    const model::Scene scene = beginScene();
    Played played(scene);
    played.play(100);
    const RunBeginning beginning = played.at(60);
    QCOMPARE(beginning.now->step, std::uint64_t{60});
    QCOMPARE(beginning.before->step, std::uint64_t{59});
    const auto session = goneOn(scene, beginning);
    QCOMPARE(session->seconds(), beginning.now->seconds);
    const SessionPosePtr pose = session->pose();
    QVERIFY(pose->ids == beginning.now->ids);
    QVERIFY(pose->x == beginning.now->x && pose->z == beginning.now->z);
    QVERIFY(pose->headings == beginning.now->headings);
    QVERIFY(pose->clips == beginning.now->clips);
    QVERIFY(pose->places == beginning.now->places);
}

void TestRunBeginning::theyGoOnWithoutAJump()
{
    const model::Scene scene = beginScene();
    Played played(scene);
    played.play(100);
    const RunBeginning beginning = played.at(60);
    const auto session = goneOn(scene, beginning);
    SessionPosePtr before = session->pose();
    behavior::MotionReader reader(played.cache);
    for (int i = 1; i <= 10; ++i) {
        session->step();
        const SessionPosePtr now = session->pose();
        const SessionPosePtr then = reader.around((60 + i + 0.5) * kBeginStep).first;
        for (std::size_t k = 0; k < now->ids.size(); ++k) {
            const float way = now->z[k] - before->z[k];
            const float former = beginning.now->z[k] - beginning.before->z[k];
            QVERIFY2(
                std::abs(way - former) < 0.4F * former,
                qPrintable(QStringLiteral("%1: %2 instead of %3").arg(i).arg(way).arg(former)));
            QVERIFY(std::abs(now->z[k] - then->z[k]) < 0.001F); // nothing else happens
            QCOMPARE(now->clips[k], then->clips[k]);
            const float place = now->places[k] - before->places[k];
            QVERIFY(std::abs(place - std::round(place)) < 0.1F); // the gait goes on, too
        }
        before = now;
    }
}

void TestRunBeginning::whatRulesMadeOfThemStays()
{
    model::Scene scene = beginScene();
    actions::SetProperty red;
    red.property = model::SettableProperty::Height;
    red.value = 1.25F;
    model::NumberName mood;
    mood.id = 1;
    mood.name = "mood";
    scene.numbers = {mood};
    actions::SetNumber number;
    number.number = 1;
    number.value = 0.75F;
    scene.rules = {onEvent("now", {red, tagWith(5), number})};
    Played played(scene);
    played.session.send("now", 1.0F, {2});
    played.play(40);
    const RunBeginning beginning = played.at(30);
    QVERIFY(beginning.now->overrides != nullptr && beginning.now->numbers != nullptr);
    const auto session = goneOn(scene, beginning);
    session->step();
    const auto frame = session->frame();
    QCOMPARE(frame->population.column(beginKeys::height)[1], 1.25F);
    QCOMPARE(frame->population.column(beginKeys::height)[2], 1.0F);
    QCOMPARE(session->rules().number(1, 1), 0.75F);
    QVERIFY((session->rules().tags(1) >> 5U & 1U) != 0 && session->rules().tags(2) == 0);
}

void TestRunBeginning::whoHasLeftStaysAway()
{
    model::Scene scene = beginScene();
    scene.rules = {onEvent("go", {actions::LeaveScene()})};
    Played played(scene);
    played.session.send("go", 1.0F, {3});
    played.play(40);
    const RunBeginning beginning = played.at(35);
    QCOMPARE(beginning.now->gone, std::size_t{1});
    const auto session = goneOn(scene, beginning);
    QCOMPARE(session->pose()->gone, std::size_t{1});
    run(*session, 10);
    QCOMPARE(session->pose()->gone, std::size_t{1});
    QVERIFY(placeOf(*session, 2).y < -1000.0F);
    QVERIFY(placeOf(*session, 1).y > -1.0F);
}

void TestRunBeginning::aClipGoesOn_data()
{
    QTest::addColumn<bool>("isEndless");
    QTest::newRow("to its end") << false;
    QTest::newRow("until something else comes") << true;
}

void TestRunBeginning::aClipGoesOn()
{
    QFETCH(const bool, isEndless);
    model::Scene scene = rowOf(2);
    actions::PlayClip clap;
    clap.clips = {{"clap"}}; // a second and a half
    clap.isLooped = isEndless;
    clap.seconds = 0.0F;
    scene.rules = {onEvent("clap", {clap})};
    Played played(scene);
    played.session.send("clap", 1.0F, {1});
    played.play(30);
    const RunBeginning beginning = played.at(15);
    QCOMPARE(beginning.now->clips.front(), kClap);
    const auto session = goneOn(scene, beginning);
    const float begun = session->pose()->places.front();
    session->step();
    QCOMPARE(clipOf(*session, 0), kClap);
    QVERIFY(session->pose()->places.front() > begun);
    QVERIFY(session->pose()->places.front() < begun + 0.05F);
    run(*session, 60);
    QCOMPARE(clipOf(*session, 0), isEndless ? kClap : kIdle);
}

void TestRunBeginning::whatStatesMadeOfThemStays()
{
    const model::Scene scene = sceneWithState(3);
    model::ChangeOver change = changeOver(scene, 0.0F);
    change.ids = {2};
    Played played(scene);
    (void)played.session.recall(change);
    played.play(10);
    const auto session = goneOn(scene, played.at(8));
    session->step();
    QVERIFY(tintOf(*session, 1) == kRed && tintOf(*session, 2) == kBlue);
    QCOMPARE(heightOf(*session, 1), 2.0F);
    QVERIFY(session->pose()->recalled != nullptr);
}

/// Who has come since is where the scene has him; who is gone from it is left out.
void TestRunBeginning::peopleOfNowCount()
{
    model::Scene scene = beginScene();
    Played played(scene);
    played.play(40);
    const std::vector<model::IndividualId> gone{1, 4};
    (void)scene.population.remove(gone);
    auto rows = model::IndividualRows::withDefaults(std::vector<model::IndividualId>{9});
    rows.column(beginKeys::templateId)[0] = 1;
    rows.column(beginKeys::position)[0] = {-7.0F, 0.0F, 3.0F};
    scene.population.add(rows);
    const RunBeginning beginning = played.at(30);
    const auto session = goneOn(scene, beginning);
    const auto frame = session->frame();
    QCOMPARE(frame->population.size(), std::size_t{5});
    QCOMPARE(placeOf(*session, 4), glm::vec3(-7.0F, 0.0F, 3.0F));
    QCOMPARE(placeOf(*session, 0).z, beginning.now->z[1]); // the second of before
    run(*session, 5);
    QVERIFY(placeOf(*session, 0).z > beginning.now->z[1]);
}

void TestRunBeginning::theStepsBeforeAreGiven()
{
    const model::Scene scene = beginScene();
    Played played(scene);
    played.play(100);
    std::vector<std::uint64_t> steps;
    played.at(70).earlier([&steps](const SessionPosePtr& pose) {
        steps.push_back(pose->step);
        return true;
    });
    QCOMPARE(steps.size(), std::size_t{70});
    QCOMPARE(steps.front(), std::uint64_t{0});
    QCOMPARE(steps.back(), std::uint64_t{69});
    QVERIFY(std::ranges::is_sorted(steps));
    const RunBeginning first = played.at(0);
    QCOMPARE(first.before->step, first.now->step); // there is none before
    first.earlier([](const SessionPosePtr& /*pose*/) {
        QTest::qFail("nothing is before the first", __FILE__, __LINE__);
        return false;
    });
    QVERIFY(!behavior::beginningIn(std::make_shared<MotionCache>(), 1.0));
}

/// What it goes on from can be seen and taken from, too; the same bits each time.
void TestRunBeginning::aPlayerShowsWhatWasBefore()
{
    const model::Scene scene = beginScene();
    Played played(scene);
    played.play(100);
    behavior::SessionPlayer player([] {});
    player.start(scene, played.at(60), nullptr);
    QTRY_VERIFY(!player.takenShare());
    QCOMPARE(player.first(), 0.0);
    behavior::MotionReader reader(played.cache);
    const SessionPosePtr early = reader.around(40.5 * kBeginStep).first;
    QVERIFY(player.poseAt(40.5 * kBeginStep)->z == early->z);
    player.request(90.0 * kBeginStep);
    QTRY_VERIFY(player.available() > 89.5 * kBeginStep);
    const std::vector<float> later = player.poseAt(80.5 * kBeginStep)->z;
    QVERIFY(player.takeFrom(70.5 * kBeginStep));
    QTRY_VERIFY(!player.takenShare());
    QVERIFY(player.available() < 70.5 * kBeginStep);
    QVERIFY(player.poseAt(40.5 * kBeginStep)->z == early->z);
    QCOMPARE(player.first(), 0.0);
    player.request(90.0 * kBeginStep);
    QTRY_VERIFY(player.available() > 89.5 * kBeginStep);
    QVERIFY(player.poseAt(80.5 * kBeginStep)->z == later);
    const auto kept = player.motion()->extent();
    QCOMPARE(kept.first, 0.0);
    QVERIFY(kept.steps >= 90);
}

CROWD_TEST(TestRunBeginning)
#include "tst_RunBeginning.moc"
