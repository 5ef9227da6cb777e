// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numeric>

#include <QtTest/QTest>

#include <glm/geometric.hpp>

#include "behavior/motion/GaitTable.h"
#include "behavior/session/Session.h"
#include "model/base/Parallel.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::GaitTable;
using behavior::Session;
using behavior::SessionPlan;
using model::PathKind;

/// A run of the simulation: paths, gaits, frames; what it leaves alone.
class SessionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clipsGoOverIntoEachOther();
    void groupsKeepTogether();
    void hiddenGroupsAreHiddenWhileItPlays();
    void pathsEndAsTheyShould_data();
    void pathsEndAsTheyShould();
    void pathsAreJoinedWhereTheyAreNearest_data();
    void pathsAreJoinedWhereTheyAreNearest();
    void neverTouchesTheScene();
    void sameBitsForAnyNumberOfThreads();
    void flowIsAsWideAsThePlaces_data();
    void flowIsAsWideAsThePlaces();
    void gaitFollowsSpeedWithoutFlicker();
    void feetKeepToTheGround_data();
    void feetKeepToTheGround();
    void nobodySpinsRound();
    void standingPeopleStayAndAreGoneAround();
    void badPlansAreSaidAndSurvived();
};

namespace {

/// Stands, walks at 1.2 m/s, runs at 3 m/s.
model::TemplateEntry walkerTemplate()
{
    auto asset = std::make_shared<model::Template>();
    for (const auto& [name, speed] : {std::pair("run", 3.0F), {"idle", 0.0F}, {"walk", 1.2F}}) {
        model::Clip clip;
        clip.name = name;
        clip.seconds = 1.0F;
        clip.speed = speed;
        clip.role = speed <= 0.0F  ? model::ClipRole::Idle
                    : speed > 2.0F ? model::ClipRole::Run
                                   : model::ClipRole::Walk;
        asset->clips.push_back(clip);
    }
    asset->defaultClip = 1;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.name = "walker";
    entry.clipNames = {"run", "idle", "walk"};
    entry.asset = asset;
    return entry;
}

model::Scene sceneOf(const std::vector<glm::vec3>& places)
{
    model::Scene scene;
    scene.templates.push_back(walkerTemplate());
    std::vector<model::IndividualId> ids(places.size());
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < places.size(); ++i) {
        rows.column(model::columns::templateId)[i] = 1;
        rows.column(model::columns::clip)[i] = 1;
        rows.column(model::columns::position)[i] = places[i];
    }
    scene.population.add(rows);
    return scene;
}

model::Place placeAt(model::PlaceId id, float x, float z, float radius = 0.0F)
{
    return {id, std::to_string(id), {x, 0.0F, z}, radius};
}

/// A triangle of places, 6, 8 and 10 m apart, walked by the first `walkers` people.
SessionPlan trianglePlan(PathKind kind, std::size_t walkers, float speed = 1.3F)
{
    SessionPlan plan;
    plan.places = {placeAt(1, 0.0F, 0.0F), placeAt(2, 6.0F, 0.0F), placeAt(3, 6.0F, 8.0F)};
    plan.paths = {{1, "triangle", kind, {1, 2, 3}}};
    for (std::size_t i = 0; i < walkers; ++i) {
        plan.walkers.push_back({static_cast<model::IndividualId>(i + 1), 1, speed});
    }
    return plan;
}

glm::vec3 positionOf(const model::CrowdFrame& frame, std::size_t row)
{
    return frame.population.column(model::columns::position)[row];
}

double distance(const glm::vec3& a, const glm::vec3& b)
{
    return static_cast<double>(glm::distance(a, b));
}

} // namespace

void SessionTest::clipsGoOverIntoEachOther()
{
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 9.0F}});
    Session session(scene, trianglePlan(PathKind::Cyclic, 1));
    QVERIFY(session.frame()->fades.empty());
    std::uint16_t before = session.frame()->population.column(model::columns::clip)[0];
    std::vector<float> shares;
    for (int step = 0; step < 60; ++step) {
        session.step();
        const auto frame = session.frame();
        const std::uint16_t clip = frame->population.column(model::columns::clip)[0];
        for (const model::ClipFade& fade : frame->fades) {
            QCOMPARE(fade.row, 0U); // the other one stands
            QCOMPARE(fade.clip, before);
            QVERIFY(fade.place >= 0.0F && fade.place <= 1.0F);
            QVERIFY(clip != before);
            shares.push_back(fade.share);
        }
        before = frame->fades.empty() ? clip : before;
    }
    // A quarter of a second at thirty steps a second, once: from standing to walking.
    QVERIFY2(shares.size() == 8, QByteArray::number(static_cast<int>(shares.size())));
    QCOMPARE(shares.front(), 0.0F);
    QVERIFY(std::ranges::is_sorted(shares) && shares.back() > 0.85F && shares.back() < 1.0F);
}

void SessionTest::groupsKeepTogether()
{
    // Four people of very different paces, with and without a group, over 40 m.
    const auto spreadOf = [](std::uint32_t group, std::optional<bool> isParty = {}) {
        model::Scene scene = sceneOf(
            {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.5F}, {1.0F, 0.0F, 2.0F}});
        const std::vector<model::IndividualId> ids{1, 2, 3, 4};
        const std::vector<model::PathId> paths(4, 1);
        const std::vector<std::uint32_t> groups(4, group);
        const std::vector<float> speeds{0.9F, 1.1F, 1.5F, 1.8F};
        scene.population.setValues<model::PathId>(model::columns::path, ids, paths);
        scene.population.setValues<std::uint32_t>(model::columns::group, ids, groups);
        scene.population.setValues<float>(model::columns::walkSpeed, ids, speeds);
        if (isParty) {
            model::Group named;
            named.id = group;
            named.isParty = *isParty;
            scene.groups = {named};
        }
        scene.places = {placeAt(1, 0.0F, 60.0F, 4.0F)};
        scene.paths = {{1, "way", PathKind::Simple, {1}}};
        Session session(scene);
        float most = 0.0F;
        for (int step = 0; step < 30 * 25; ++step) {
            session.step();
            float first = 1e9F;
            float last = -1e9F;
            for (std::size_t row = 0; row < 4; ++row) {
                first = std::min(first, positionOf(*session.frame(), row).z);
                last = std::max(last, positionOf(*session.frame(), row).z);
            }
            most = std::max(most, last - first);
        }
        return most;
    };
    const float alone = spreadOf(0);
    const float together = spreadOf(7);
    QVERIFY2(alone > 12.0F, QByteArray::number(alone));
    QVERIFY2(together < 4.0F, QByteArray::number(together));
    QCOMPARE(spreadOf(7, true), together);
    QCOMPARE(spreadOf(7, false), alone); // a layer, not a party
}

void SessionTest::hiddenGroupsAreHiddenWhileItPlays()
{
    model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}});
    model::Group group;
    group.id = 3;
    group.isHidden = true;
    scene.groups = {group};
    Session session(scene);
    QCOMPARE(session.frame()->hiddenGroups, std::vector<model::GroupId>{3});
    scene.groups.front().isHidden = false;
    session.adopt(scene);
    QVERIFY(session.frame()->hiddenGroups.empty());
}

void SessionTest::pathsEndAsTheyShould_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("simple") << static_cast<int>(PathKind::Simple);
    QTest::newRow("cyclic") << static_cast<int>(PathKind::Cyclic);
    QTest::newRow("teleport") << static_cast<int>(PathKind::Teleport);
}

void SessionTest::pathsEndAsTheyShould()
{
    QFETCH(const int, kind);
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}});
    Session session(scene, trianglePlan(static_cast<PathKind>(kind), 1));
    glm::vec3 before = positionOf(*session.frame(), 0);
    int jumps = 0;
    double walked = 0.0;
    const std::vector<model::Place> places = trianglePlan(PathKind::Simple, 0).places;
    std::vector<model::PlaceId> order; // in which he comes to them
    for (int step = 0; step < 40 * 30; ++step) {
        session.step();
        const glm::vec3 now = positionOf(*session.frame(), 0);
        const double way = distance(before, now);
        if (way > 1.0) {
            ++jumps;
            QVERIFY(distance(now, {0.0F, 0.0F, 0.0F}) < 0.1);
            QVERIFY(distance(before, {6.0F, 0.0F, 8.0F}) < 0.5);
        } else {
            walked += way;
        }
        before = now;
        for (const model::Place& place : places) {
            if (distance(now, place.position) < 1.0 &&
                (order.empty() || order.back() != place.id)) {
                order.push_back(place.id);
            }
        }
    }
    QCOMPARE(session.steps(), std::uint64_t{1200});
    QCOMPARE(session.tally().followers.contains(1), kind != static_cast<int>(PathKind::Simple));
    if (kind == static_cast<int>(PathKind::Simple)) {
        QCOMPARE(order, (std::vector<model::PlaceId>{1, 2, 3}));
        QVERIFY(distance(before, {6.0F, 0.0F, 8.0F}) < 0.5);
        QCOMPARE(jumps, 0);
    } else if (kind == static_cast<int>(PathKind::Cyclic)) {
        QCOMPARE(order, (std::vector<model::PlaceId>{1, 2, 3, 1, 2, 3, 1})); // 24 m a round
        QCOMPARE(jumps, 0);
        QVERIFY(walked > 40.0 && walked < 1.3 * 40.0);
    } else {
        QCOMPARE(jumps, 3); // 14 m a round
        QVERIFY(walked > 40.0 && walked < 1.3 * 40.0);
    }
}

void SessionTest::pathsAreJoinedWhereTheyAreNearest_data()
{
    QTest::addColumn<PathKind>("kind");
    QTest::addColumn<glm::vec3>("from");
    QTest::addColumn<glm::vec3>("first"); // where he goes
    const glm::vec3 second(6.0F, 0.0F, 0.0F);
    const glm::vec3 third(6.0F, 0.0F, 8.0F);
    QTest::newRow("before the beginning")
        << PathKind::Simple << glm::vec3(-4.0F, 0.0F, 1.0F) << glm::vec3(0.0F);
    QTest::newRow("beside the first leg")
        << PathKind::Simple << glm::vec3(2.0F, 0.0F, -1.0F) << second;
    QTest::newRow("beside the second") << PathKind::Simple << glm::vec3(8.0F, 0.0F, 4.0F) << third;
    QTest::newRow("behind the end") << PathKind::Simple << glm::vec3(6.0F, 0.0F, 12.0F) << third;
    QTest::newRow("on the way back")
        << PathKind::Cyclic << glm::vec3(2.5F, 0.0F, 4.0F) << glm::vec3(0.0F);
    QTest::newRow("there is no way back")
        << PathKind::Simple << glm::vec3(2.0F, 0.0F, 3.0F) << second;
}

void SessionTest::pathsAreJoinedWhereTheyAreNearest()
{
    QFETCH(PathKind, kind);
    QFETCH(glm::vec3, from);
    QFETCH(glm::vec3, first);
    Session session(sceneOf({from}), trianglePlan(kind, 1));
    for (int step = 0; step < 45; ++step) {
        session.step();
    }
    const glm::vec3 went = positionOf(*session.frame(), 0) - from;
    QVERIFY(glm::length(went) > 0.8F);
    QVERIFY2(
        glm::dot(glm::normalize(went), glm::normalize(first - from)) > 0.95F,
        qPrintable(QString::number(glm::dot(glm::normalize(went), glm::normalize(first - from)))));
}

void SessionTest::neverTouchesTheScene()
{
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.2F}});
    const model::Population before = scene.population;
    const std::uint64_t version = scene.population.version();
    Session session(scene, trianglePlan(PathKind::Cyclic, 1));
    const model::CrowdFramePtr start = session.frame();
    QVERIFY(start->population == before);
    for (int step = 0; step < 60; ++step) {
        session.step();
    }
    const model::CrowdFramePtr end = session.frame();
    QVERIFY(scene.population == before);
    QCOMPARE(scene.population.version(), version);
    QVERIFY(start->population == before); // a frame stays as it was
    QVERIFY(distance(positionOf(*end, 0), positionOf(*start, 0)) > 1.5);
    QCOMPARE(end->seconds, 2.0);
}

void SessionTest::sameBitsForAnyNumberOfThreads()
{
    std::vector<glm::vec3> places;
    for (int i = 0; i < 4000; ++i) {
        places.emplace_back(static_cast<float>(i % 80) * 0.9F, 0.0F,
                            static_cast<float>(i / 80) * 0.9F);
    }
    const model::Scene scene = sceneOf(places);
    SessionPlan plan = trianglePlan(PathKind::Teleport, places.size());
    for (model::Place& place : plan.places) {
        place.position *= 6.0F;
        place.radius = 12.0F;
    }
    std::optional<model::Population> expected;
    for (const int threads : {1, 2, 3}) {
        const model::ThreadLimit limit(threads);
        Session session(scene, plan);
        for (int step = 0; step < 60; ++step) {
            session.step();
        }
        const model::CrowdFramePtr frame = session.frame();
        expected = expected.value_or(frame->population);
        QVERIFY(frame->population == *expected);
    }
}

void SessionTest::flowIsAsWideAsThePlaces_data()
{
    QTest::addColumn<float>("radius");
    QTest::newRow("narrow") << 1.0F;
    QTest::newRow("wide") << 4.0F;
}

/// One after the other past two places: uniform in a disk, they spread by half its radius.
void SessionTest::flowIsAsWideAsThePlaces()
{
    QFETCH(const float, radius);
    std::vector<glm::vec3> starts;
    for (int i = 0; i < 300; ++i) {
        starts.emplace_back(-5.0F - 3.0F * static_cast<float>(i), 0.0F, 0.0F);
    }
    const model::Scene scene = sceneOf(starts);
    SessionPlan plan;
    plan.places = {placeAt(1, 20.0F, 0.0F, radius), placeAt(2, 60.0F, 0.0F, radius),
                   placeAt(3, 100.0F, 0.0F, radius)};
    plan.paths = {{1, "straight", PathKind::Simple, {1, 2, 3}}};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        plan.walkers.push_back({static_cast<model::IndividualId>(i + 1), 1, 4.0F});
    }
    Session session(scene, plan);
    std::vector<float> asides;
    std::vector<float> before(starts.size(), -1e3F);
    for (int step = 0; step < 9000 && asides.size() < starts.size(); ++step) {
        session.step();
        const auto bodies = session.crowd().bodies();
        for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
            float& last = before[agent];
            if (last < 40.0F && bodies[agent].x >= 40.0F) { // half the way between two places
                asides.push_back(bodies[agent].z);
            }
            last = bodies[agent].x;
        }
    }
    QCOMPARE(asides.size(), starts.size());
    double squares = 0.0;
    for (const float aside : asides) {
        squares += static_cast<double>(aside) * static_cast<double>(aside);
    }
    const double spread = std::sqrt(squares / static_cast<double>(asides.size()));
    const double expected = 0.5 * static_cast<double>(radius);
    QVERIFY2(std::abs(spread - expected) < 0.15 * expected, QByteArray::number(spread));
}

void SessionTest::gaitFollowsSpeedWithoutFlicker()
{
    const GaitTable table(walkerTemplate());
    QVERIFY(!table.isEmpty());
    QCOMPARE(table.gait(0).clip, std::uint16_t{1}); // idle, walk, run
    QCOMPARE(table.gait(1).clip, std::uint16_t{2});
    QCOMPARE(table.gait(2).clip, std::uint16_t{0});
    QCOMPARE(table.choose(0, 0.0F), std::size_t{0});
    QCOMPARE(table.choose(0, 1.3F), std::size_t{1});
    QCOMPARE(table.choose(0, 3.0F), std::size_t{2});
    const float border = std::sqrt(1.2F * 3.0F);
    QCOMPARE(table.choose(1, border * 1.1F), std::size_t{1}); // stays on either side
    QCOMPARE(table.choose(2, border * 0.9F), std::size_t{2});
    QCOMPARE(table.choose(2, 0.05F), std::size_t{0});
    model::TemplateEntry edited = walkerTemplate();
    edited.clipSpeeds = {std::numeric_limits<float>::quiet_NaN(), 0.0F, 2.0F};
    QCOMPARE(GaitTable(edited).gait(1).metresPerSecond, 2.0F);
    edited.asset = nullptr;
    QVERIFY(GaitTable(edited).isEmpty());
}

void SessionTest::feetKeepToTheGround_data()
{
    QTest::addColumn<float>("speed");
    QTest::addColumn<int>("clip");
    QTest::newRow("walking") << 1.0F << 2;
    QTest::newRow("running") << 2.8F << 0;
}

/// Once under way, the clip moves the feet by what the body moves, from frame to frame.
void SessionTest::feetKeepToTheGround()
{
    QFETCH(const float, speed);
    QFETCH(const int, clip);
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}});
    SessionPlan plan = trianglePlan(PathKind::Simple, 1, speed);
    plan.places[1].position = {100.0F, 0.0F, 0.0F};
    plan.places[2].position = {200.0F, 0.0F, 0.0F};
    Session session(scene, plan);
    for (int step = 0; step < 120; ++step) {
        session.step();
    }
    const model::Clip& shown = scene.templates[0].asset->clips[static_cast<std::size_t>(clip)];
    const auto phaseIn = [&](const model::CrowdFrame& frame) {
        return model::shownPhase(shown, frame.population.column(model::columns::phase)[0],
                                 frame.population.column(model::columns::playbackSpeed)[0],
                                 frame.seconds);
    };
    model::CrowdFramePtr before = session.frame();
    for (int step = 0; step < 60; ++step) {
        session.step();
        const model::CrowdFramePtr now = session.frame();
        QCOMPARE(int{now->population.column(model::columns::clip)[0]}, clip);
        const float turns = phaseIn(*now) - phaseIn(*before);
        const double stride = static_cast<double>((turns - std::floor(turns)) * shown.speed);
        const double way = distance(positionOf(*before, 0), positionOf(*now, 0));
        QVERIFY2(std::abs(stride - way) < 0.001, QByteArray::number(stride - way));
        before = now;
    }
}

void SessionTest::nobodySpinsRound()
{
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}}); // faces +Z, has to go to +X and back
    Session session(scene, trianglePlan(PathKind::Cyclic, 1));
    float before = 0.0F;
    for (int step = 0; step < 900; ++step) {
        session.step();
        const float heading = session.frame()->population.column(model::columns::heading)[0];
        const float turn = std::remainder(heading - before, 6.2831853F);
        QVERIFY(std::fabs(turn) < 4.0F / 30.0F + 1e-4F);
        before = heading;
        if (step == 60) {
            QVERIFY(std::fabs(heading - 1.5707963F) < 0.05F); // along +X by now
        }
    }
}

void SessionTest::standingPeopleStayAndAreGoneAround()
{
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.05F}});
    Session session(scene, trianglePlan(PathKind::Simple, 1));
    double nearest = 1e3;
    for (int step = 0; step < 600; ++step) {
        session.step();
        const model::CrowdFramePtr frame = session.frame();
        QCOMPARE(positionOf(*frame, 1), glm::vec3(3.0F, 0.0F, 0.05F));
        nearest = std::min(nearest, distance(positionOf(*frame, 0), positionOf(*frame, 1)));
    }
    QVERIFY(session.tally().followers.empty());
    QVERIFY2(nearest > 0.4, QByteArray::number(nearest));
}

void SessionTest::badPlansAreSaidAndSurvived()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const model::Scene scene = sceneOf({{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}});
    SessionPlan plan = trianglePlan(PathKind::Cyclic, 2);
    plan.places[1].position.x = nan;                          // a place without a position
    plan.paths[0].places.push_back(99);                       // a place that is gone
    plan.paths.push_back({2, "empty", PathKind::Simple, {}}); // nowhere to go
    plan.walkers = {{1, 1, nan}, {1, 1, 1.0F}, {2, 7, 1.0F}, {50, 1, 1.0F}};
    Session session(scene, plan);
    QCOMPARE(session.warnings().size(), std::size_t{5});
    const auto isSaid = [&](const char* words) {
        return std::ranges::any_of(session.warnings(), [&](const behavior::Problem& warning) {
            return warning.text.english().find(words) != std::string::npos;
        });
    };
    QVERIFY(isSaid("Place \"2\" has no position"));
    QVERIFY(isSaid("Path \"triangle\" names a place that is not there"));
    QVERIFY(isSaid("Path \"empty\" has no places"));
    QVERIFY(isSaid("Left out: 2."));
    QVERIFY(isSaid("Standing still, since their paths cannot be walked: 1."));
    for (int step = 0; step < 100; ++step) {
        session.step();
    }
    const model::CrowdFramePtr frame = session.frame();
    QVERIFY(distance(positionOf(*frame, 0), {0.0F, 0.0F, 0.0F}) > 1.0); // goes on, at 1.3 m/s
    QCOMPARE(positionOf(*frame, 1), glm::vec3(1.0F, 0.0F, 0.0F));
    Session nobody(model::Scene{}, {});
    nobody.step();
    QVERIFY(nobody.frame()->population.isEmpty());
}

CROWD_TEST(SessionTest)
#include "tst_Session.moc"
