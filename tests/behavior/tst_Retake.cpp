// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "behavior/session/MotionReader.h"
#include "behavior/takes/Retake.h"
#include "behavior/takes/TakeComposition.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::MotionCache;
using behavior::MotionReader;
using behavior::SessionPose;
using behavior::SessionPosePtr;

namespace {

constexpr double kRetakeStep = 1.0 / 30.0;
constexpr std::uint64_t kRetakeSteps = 300; ///< ten seconds
constexpr std::size_t kRetakeWalkers = 12;

using CachePtr = std::shared_ptr<MotionCache>;

/// A row of people who walk 60 m ahead, and stroll when they are told to.
model::Scene retakeScene()
{
    model::Scene scene = rowOf(kRetakeWalkers);
    scene.places = {{1, "far", {11.0F, 0.0F, 80.0F}, 14.0F},
                    {2, "back", {0.0F, 0.0F, -80.0F}, 4.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}},
                   {2, "off", model::PathKind::Simple, {2}}};
    letWalk(scene, 1);
    return scene;
}

CachePtr playedTake(const model::Scene& scene)
{
    auto cache = std::make_shared<MotionCache>();
    Session session(scene);
    cache->add(session.pose());
    for (std::uint64_t i = 0; i < kRetakeSteps; ++i) {
        session.step();
        cache->add(session.pose());
    }
    return cache;
}

SessionPosePtr poseAtStep(MotionReader& reader, std::uint64_t step)
{
    return reader.around((static_cast<double>(step) + 0.5) * kRetakeStep).first;
}

std::size_t rowInPose(const SessionPose& pose, model::IndividualId id)
{
    const auto found = std::ranges::find(pose.ids, id);
    if (found == pose.ids.end()) {
        qFatal("nobody of that id");
    }
    return static_cast<std::size_t>(found - pose.ids.begin());
}

glm::vec2 retakePlace(const SessionPose& pose, model::IndividualId id)
{
    const std::size_t row = rowInPose(pose, id);
    return {pose.x[row], pose.z[row]};
}

bool isPosedSame(const SessionPose& a, const SessionPose& b, model::IndividualId id)
{
    const std::size_t i = rowInPose(a, id);
    const std::size_t j = rowInPose(b, id);
    return a.x[i] == b.x[j] && a.y[i] == b.y[j] && a.z[i] == b.z[j] &&
           a.headings[i] == b.headings[j] && a.clips[i] == b.clips[j] && a.rates[i] == b.rates[j] &&
           a.places[i] == b.places[j] && a.flags[i] == b.flags[j];
}

/// Those of `ids` turn back from now on.
model::Scene turnedBack(model::Scene scene, const std::vector<model::IndividualId>& ids)
{
    scene.population.setValues<model::PathId>(model::columns::path, ids,
                                              std::vector<model::PathId>(ids.size(), 2));
    return scene;
}

behavior::Retaken retakeOf(const model::Scene& scene, const CachePtr& take,
                           const behavior::RetakeWish& wish)
{
    auto result = behavior::retake(scene, take, wish, nullptr);
    if (!result) {
        qFatal("%s", result.error().message.c_str());
    }
    return std::move(result).value();
}

} // namespace

class TestRetake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void othersDoWhatTheyDid();
    void theyGoOnAtTheirPace();
    void theyComeHome();
    void theyMakeWayForTheOthers();
    void toTheEndNobodyComesHome();
    void theSameTwiceAndAnotherWithAnotherSeed();
    void rulesOfNowCount();
    void whatCannotBeIsSaid_data();
    void whatCannotBeIsSaid();
    void itCanBeGivenUp();
    void aRetakeOfARetake();
    void propertiesAreMergedByPerson();
};

void TestRetake::othersDoWhatTheyDid()
{
    const model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    const std::vector<model::IndividualId> ids{3, 7};
    const auto anew = retakeOf(turnedBack(scene, ids), take, {ids, 3.0, 7.0, 5});
    QCOMPARE(anew.people, std::size_t{2});
    QCOMPARE(anew.steps, std::uint64_t{120});
    QCOMPARE(anew.motion->extent().steps, take->extent().steps);
    MotionReader before(take);
    MotionReader after(anew.motion);
    for (std::uint64_t step = 0; step <= kRetakeSteps; ++step) {
        const SessionPosePtr a = poseAtStep(before, step);
        const SessionPosePtr b = poseAtStep(after, step);
        QCOMPARE(b->step, a->step);
        QCOMPARE(b->seconds, a->seconds);
        QVERIFY(b->ids == a->ids);
        for (const model::IndividualId id : a->ids) {
            const bool isMeant = std::ranges::binary_search(ids, id);
            const bool isWithin = step > 90 && step <= 210;
            if (!isMeant || !isWithin) {
                QVERIFY2(isPosedSame(*a, *b, id), qPrintable(QString::number(step)));
            }
        }
    }
    // In its middle they are elsewhere.
    QVERIFY(glm::distance(retakePlace(*poseAtStep(before, 150), 3),
                          retakePlace(*poseAtStep(after, 150), 3)) > 1.0F);
}

void TestRetake::theyGoOnAtTheirPace()
{
    const model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    const auto anew = retakeOf(scene, take, {{5}, 4.0, 10.0, 1});
    MotionReader after(anew.motion);
    const auto wayAt = [&](std::uint64_t step) {
        return glm::distance(retakePlace(*poseAtStep(after, step), 5),
                             retakePlace(*poseAtStep(after, step + 1), 5));
    };
    const float usual = wayAt(110);
    QVERIFY(usual > 0.02F);
    for (std::uint64_t step = 119; step < 124; ++step) { // at once, not from standing
        QVERIFY2(std::abs(wayAt(step) - usual) < 0.4F * usual,
                 qPrintable(QString::number(static_cast<double>(wayAt(step)))));
    }
    // In the same clip, and nothing fades.
    const SessionPosePtr begun = poseAtStep(after, 121);
    QCOMPARE(begun->clips[rowInPose(*begun, 5)], std::uint16_t{1});
    QVERIFY(begun->fades.empty());
}

void TestRetake::theyComeHome()
{
    const model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    const std::vector<model::IndividualId> ids{3, 4};
    const auto anew = retakeOf(turnedBack(scene, ids), take, {ids, 2.0, 9.0, 5});
    MotionReader before(take);
    MotionReader after(anew.motion);
    for (std::uint64_t step = 60; step < 290; ++step) { // nobody jumps
        for (const model::IndividualId id : ids) {
            const float way = glm::distance(retakePlace(*poseAtStep(after, step), id),
                                            retakePlace(*poseAtStep(after, step + 1), id));
            QVERIFY2(way < 0.5F,
                     qPrintable(QStringLiteral("%1: %2").arg(step).arg(static_cast<double>(way))));
        }
    }
    QVERIFY(isPosedSame(*poseAtStep(before, 280), *poseAtStep(after, 280), 3));
    // From the clip that they came home in to that of the take.
    const SessionPosePtr next = poseAtStep(after, 272);
    QCOMPARE(next->fades.size(), std::size_t{2});
    QCOMPARE(next->fades.front().begin, 9.0);
    QVERIFY(poseAtStep(after, 285)->fades.empty());
    QVERIFY(anew.furthestFromHome > 0.0F);
    // One who has little to go is there by himself.
    const auto near = retakeOf(scene, take, {{6}, 2.0, 9.0, 5});
    QVERIFY2(near.furthestFromHome < 0.3F,
             qPrintable(QString::number(static_cast<double>(near.furthestFromHome))));
}

void TestRetake::theyMakeWayForTheOthers()
{
    // One walks along the row of all others, who stand.
    model::Scene scene = rowOf(kRetakeWalkers);
    scene.places = {{1, "end", {40.0F, 0.0F, 0.0F}, 0.3F}};
    scene.paths = {{1, "along", model::PathKind::Simple, {1}}};
    const CachePtr take = playedTake(scene);
    scene.population.setValues<model::PathId>(
        model::columns::path, std::vector<model::IndividualId>{1}, std::vector<model::PathId>{1});
    const auto anew = retakeOf(scene, take, {{1}, 0.0, 10.0, 0});
    MotionReader after(anew.motion);
    const auto stand = scene.population.column(model::columns::position);
    float nearest = 1e9F;
    for (std::uint64_t step = 0; step <= kRetakeSteps; ++step) {
        const SessionPosePtr pose = poseAtStep(after, step);
        if (pose->ids.empty()) {
            continue; // nobody has moved yet
        }
        for (std::size_t row = 1; row < stand.size(); ++row) {
            nearest = std::min(nearest, glm::distance(retakePlace(*pose, 1),
                                                      glm::vec2(stand[row].x, stand[row].z)));
        }
    }
    const float went = retakePlace(*poseAtStep(after, kRetakeSteps), 1).x - stand[0].x;
    QVERIFY2(went > 6.0F, qPrintable(QString::number(static_cast<double>(went))));
    QVERIFY2(nearest > 0.35F, qPrintable(QString::number(static_cast<double>(nearest))));
}

void TestRetake::toTheEndNobodyComesHome()
{
    const model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    const std::vector<model::IndividualId> ids{4};
    const auto anew = retakeOf(turnedBack(scene, ids), take, {ids, 5.0, 100.0, 5});
    QCOMPARE(anew.steps, std::uint64_t{150});
    QCOMPARE(anew.furthestFromHome, 0.0F);
    MotionReader before(take);
    MotionReader after(anew.motion);
    QVERIFY(retakePlace(*poseAtStep(after, kRetakeSteps), 4).y <
            retakePlace(*poseAtStep(before, kRetakeSteps), 4).y - 5.0F);
}

void TestRetake::theSameTwiceAndAnotherWithAnotherSeed()
{
    model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    scene.rules = {when(triggers::Start(), {actions::Stop()})};
    scene.rules.front().conditions = {conditions::Chance{0.5F}};
    const QTemporaryDir folder;
    const auto nameOf = [&](std::uint32_t seed) {
        const auto anew = retakeOf(scene, take, {{2, 3, 4, 5}, 1.0, 8.0, seed});
        return behavior::writeTake(*anew.motion, folder.path()).value().file;
    };
    const std::string third = nameOf(3);
    QCOMPARE(nameOf(3), third);
    bool isAnother = false;
    for (std::uint32_t seed = 4; seed < 12; ++seed) { // two may draw the same
        isAnother = isAnother || nameOf(seed) != third;
    }
    QVERIFY(isAnother);
}

void TestRetake::rulesOfNowCount()
{
    model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    scene.rules = {when(triggers::Start(), {tagWith(3), actions::Stop()})};
    const auto anew = retakeOf(scene, take, {{5}, 3.0, 10.0, 1});
    MotionReader after(anew.motion);
    const glm::vec2 there = retakePlace(*poseAtStep(after, 200), 5);
    QVERIFY(glm::distance(there, retakePlace(*poseAtStep(after, kRetakeSteps), 5)) <
            0.05F); // he stands
    const glm::vec2 other = retakePlace(*poseAtStep(after, 200), 6);
    QVERIFY(glm::distance(other, retakePlace(*poseAtStep(after, kRetakeSteps), 6)) > 2.0F);
}

void TestRetake::whatCannotBeIsSaid_data()
{
    QTest::addColumn<behavior::RetakeWish>("wish");
    QTest::newRow("nobody") << behavior::RetakeWish{{}, 1.0, 2.0, 1};
    QTest::newRow("people who are gone") << behavior::RetakeWish{{700, 900}, 1.0, 2.0, 1};
    QTest::newRow("no time") << behavior::RetakeWish{{3}, 2.0, 2.0, 1};
    QTest::newRow("backwards") << behavior::RetakeWish{{3}, 4.0, 2.0, 1};
    QTest::newRow("after the end") << behavior::RetakeWish{{3}, 50.0, 60.0, 1};
    QTest::newRow("before the beginning") << behavior::RetakeWish{{3}, -9.0, -1.0, 1};
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("none") << behavior::RetakeWish{{3}, kNone, 2.0, 1};
    QTest::newRow("endless") << behavior::RetakeWish{
        {3}, 1.0, std::numeric_limits<double>::infinity(), 1};
}

void TestRetake::whatCannotBeIsSaid()
{
    QFETCH(const behavior::RetakeWish, wish);
    const model::Scene scene = retakeScene();
    const auto result = behavior::retake(scene, playedTake(scene), wish, nullptr);
    QVERIFY(!result);
    QVERIFY(!result.error().message.empty());
}

void TestRetake::itCanBeGivenUp()
{
    const model::Scene scene = retakeScene();
    int asked = 0;
    const auto result = behavior::retake(scene, playedTake(scene), {{3}, 1.0, 9.0, 1}, nullptr,
                                         [&asked](double) { return ++asked < 4; });
    QVERIFY(!result);
}

void TestRetake::aRetakeOfARetake()
{
    const model::Scene scene = retakeScene();
    const CachePtr take = playedTake(scene);
    const auto first = retakeOf(turnedBack(scene, {3}), take, {{3}, 2.0, 10.0, 1});
    const auto second = retakeOf(turnedBack(scene, {8}), first.motion, {{8}, 4.0, 10.0, 2});
    MotionReader before(first.motion);
    MotionReader after(second.motion);
    for (std::uint64_t step = 7; step <= kRetakeSteps; step += 7) {
        QVERIFY(isPosedSame(*poseAtStep(before, step), *poseAtStep(after, step), 3));
    }
    QVERIFY(!isPosedSame(*poseAtStep(before, 250), *poseAtStep(after, 250), 8));
}

/// Of others as in the take; of these as they were at the beginning, until the other run says more.
void TestRetake::propertiesAreMergedByPerson()
{
    using behavior::OverrideColumn;
    using behavior::OverrideColumns;
    const auto columns = [](const std::vector<model::IndividualId>& ids, std::byte value) {
        auto all = std::make_shared<OverrideColumns>();
        all->put(model::ColumnId::Height,
                 OverrideColumn{ids, std::vector<std::byte>(4 * ids.size(), value)});
        return all;
    };
    const auto posed = [&](std::shared_ptr<const OverrideColumns> overrides) {
        auto pose = std::make_shared<SessionPose>();
        pose->overrides = std::move(overrides);
        return pose;
    };
    const model::Scene scene = rowOf(4);
    behavior::TakeComposition composition({2, 3}, posed(columns({1, 2}, std::byte{1})),
                                          scene.population);
    const auto take = posed(columns({1, 2, 4}, std::byte{2}));
    const auto of = [&](const SessionPosePtr& other) {
        const auto all = composition.composed(take, *other, 0.0F)->overrides;
        return *all->column(model::ColumnId::Height);
    };
    const OverrideColumn none = of(posed(nullptr));
    QVERIFY((none.ids == std::vector<model::IndividualId>{1, 2, 4}));
    QCOMPARE(none.bytes[0], std::byte{2});
    QCOMPARE(none.bytes[4], std::byte{1}); // as he began
    const OverrideColumn more = of(posed(columns({2, 3}, std::byte{3})));
    QVERIFY((more.ids == std::vector<model::IndividualId>{1, 2, 3, 4}));
    QCOMPARE(more.bytes[4], std::byte{3});
    QCOMPARE(more.bytes[8], std::byte{3});
    QCOMPARE(more.bytes[12], std::byte{2});
    // What nobody changed is shared from step to step.
    const auto other = posed(nullptr);
    QCOMPARE(composition.composed(take, *other, 0.0F)->overrides,
             composition.composed(take, *other, 0.0F)->overrides);
}

CROWD_TEST(TestRetake)
#include "tst_Retake.moc"
