// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <QtTest/QTest>

#include "behavior/surface/WalkSurface.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"
#include "model/rules/RuleSets.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::RuleSet;

namespace {

constexpr float kGone = -1000.0F; ///< metres: below, somebody has left

model::Scene readyMade(const char* name)
{
    auto scene = model::readProject(
        QStringLiteral(CROWD_RESOURCES "/scenes/%1.crowd").arg(QLatin1String(name)));
    if (!scene.isOk()) {
        qFatal("%s", scene.error().message.c_str());
    }
    model::loadAssets(scene.value());
    return std::move(scene.value());
}

void addSet(model::Scene& scene, RuleSet set)
{
    std::vector<Rule> rules = model::rulesOf(set, scene);
    model::giveIds(rules, scene);
    scene.rules.insert(scene.rules.end(), rules.begin(), rules.end());
}

std::vector<model::IndividualId> idsOf(const model::Scene& scene)
{
    const auto ids = scene.population.ids();
    return {ids.begin(), ids.end()};
}

void letStand(Session& session, const model::Scene& scene)
{
    behavior::WalkSurface::Progress progress;
    auto built = behavior::WalkSurface::build(behavior::SurfacePlan::of(scene), progress);
    if (!built.isOk()) {
        qFatal("%s", built.error().message.c_str());
    }
    session.setSurface(built.value());
}

std::uint64_t firedOf(Session& session)
{
    std::uint64_t all = 0;
    for (const auto& [rule, count] : session.rules().counts()) {
        all += count;
    }
    return all;
}

model::Place exitAt(model::PlaceId id, const glm::vec3& position)
{
    model::Place exit{id, "exit", position, 2.0F};
    exit.role = model::PlaceRole::Exit;
    return exit;
}

/// Where each was when he was seen last.
class LastSeen
{
public:
    void look(const Session& session)
    {
        const auto frame = session.frame();
        const auto positions = frame->population.column(model::columns::position);
        m_isGone.resize(positions.size());
        m_at.resize(positions.size());
        for (std::size_t row = 0; row < positions.size(); ++row) {
            m_isGone[row] = positions[row].y < kGone;
            m_at[row] = m_isGone[row] ? m_at[row] : positions[row];
        }
    }
    [[nodiscard]] std::size_t gone() const
    {
        return static_cast<std::size_t>(std::ranges::count(m_isGone, true));
    }
    /// Farthest from the nearest of those places at which somebody was when he left.
    [[nodiscard]] float farthest(const std::vector<model::Place>& places) const
    {
        float farthest = 0.0F;
        for (std::size_t row = 0; row < m_at.size(); ++row) {
            float nearest = 1e9F;
            for (const model::Place& place : places) {
                nearest = std::min(nearest, behavior::flatDistance(place.position, m_at[row]));
            }
            farthest = m_isGone[row] ? std::max(farthest, nearest) : farthest;
        }
        return farthest;
    }

private:
    std::vector<bool> m_isGone;
    std::vector<glm::vec3> m_at;
};

/// Five rows of five, 1.2 m apart.
model::Scene smallStage()
{
    model::Scene scene = rowOf(25);
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 25; ++i) {
        positions.emplace_back(1.2F * static_cast<float>(i % 5), 0.0F,
                               1.2F * static_cast<float>(i / 5));
    }
    scene.population.setValues<glm::vec3>(model::columns::position, idsOf(scene), positions);
    return scene;
}

} // namespace

/// Ready-made rules, played to their end.
class TestRuleSets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void applauseSpreadsAndDiesDown();
    void theLatestCallWins();
    void moodsLastUntilAllIsCalm();
    void setsBringTheirCues();
    void aWaveRunsRoundTheStadium();
    void panicEmptiesASmallStage();
    void panicEmptiesTheCity();
    void withoutAnExitPanicLeavesPeopleThere();
    void pedestriansRunStopAndWalk();
    void animalsWanderAndRunWhenStartled();
    void aQueueInTheCityServesEverybody();
    void aGuideIsFollowedAndGetsOut();
    void everybodyFindsASeat();
};

/// In the theatre, from one on either side of the wedges that are empty.
void TestRuleSets::applauseSpreadsAndDiesDown()
{
    model::Scene scene = readyMade("theatre");
    addSet(scene, RuleSet::Audience);
    const std::vector<model::IndividualId> all = idsOf(scene);
    for (const char* event : {"clap", "cheer"}) {
        Session session(scene);
        session.send(event, 0.0F, {all[0], all[1], all[all.size() / 2], all[all.size() / 2 + 1]});
        run(session, 30 * 60);
        const std::uint64_t fired = firedOf(session);
        QVERIFY2(fired * 10 > all.size() * 9, QByteArray::number(static_cast<qulonglong>(fired)));
        run(session, 30 * 10);
        QCOMPARE(firedOf(session), fired);
        for (std::uint32_t agent = 0; agent < all.size(); ++agent) { // all is as it was before
            QCOMPARE(clipOf(session, agent), scene.population.column(model::columns::clip)[agent]);
        }
        QVERIFY(session.problems().empty());
    }
}

/// Share of the people who play a clip with the word in its name.
double shareOf(const Session& session, const model::Scene& scene, const char* word)
{
    std::size_t count = 0;
    for (std::uint32_t agent = 0; agent < scene.population.size(); ++agent) {
        const model::TemplateId id = scene.population.column(model::columns::templateId)[agent];
        const model::TemplateEntry* entry = scene.findTemplate(id);
        count += entry->clipNames[clipOf(session, agent)].find(word) != std::string::npos ? 1 : 0;
    }
    return static_cast<double>(count) / static_cast<double>(scene.population.size());
}

/// Also over one that is still being passed on.
void TestRuleSets::theLatestCallWins()
{
    model::Scene scene = readyMade("theatre");
    addSet(scene, RuleSet::Audience);
    const std::vector<model::IndividualId> all = idsOf(scene);
    for (const bool isFromOne : {false, true}) {
        Session session(scene);
        session.send("clap", 0.0F, isFromOne ? std::vector{all.front()} : all);
        run(session, 60);
        QVERIFY(shareOf(session, scene, "clap") > (isFromOne ? 0.01 : 0.75));
        session.send("cheer", 0.0F, all);
        for (int second = 0; second < 4; ++second) {
            run(session, 30);
            const double share = shareOf(session, scene, "cheer");
            QVERIFY2(share > 0.75, QByteArray::number(share));
        }
        QVERIFY(shareOf(session, scene, "clap") < 0.1);
    }
}

void TestRuleSets::moodsLastUntilAllIsCalm()
{
    model::Scene scene = readyMade("theatre");
    addSet(scene, RuleSet::Audience);
    const std::vector<model::IndividualId> all = idsOf(scene);
    for (const char* mood : {"sad", "bored", "angry"}) {
        Session session(scene);
        session.send(mood, 0.0F, all);
        run(session, 30 * 60);
        QVERIFY2(shareOf(session, scene, mood) > 0.75, mood);
        session.send("calm", 0.0F, all);
        run(session, 30);
        for (std::uint32_t agent = 0; agent < all.size(); ++agent) {
            QCOMPARE(clipOf(session, agent), scene.population.column(model::columns::clip)[agent]);
        }
        QVERIFY(session.problems().empty());
    }
}

/// With keys, without those that are there, and no more than a scene may have.
void TestRuleSets::setsBringTheirCues()
{
    model::Scene scene = readyMade("theatre");
    const auto eventsSent = [&] {
        std::vector<std::string> events;
        for (const model::Cue& cue : scene.cues) {
            events.push_back(cue.event);
        }
        return events;
    };
    scene.cues = {model::Cue{.id = 7, .name = {}, .event = "sad", .key = "F3"}};
    scene.cues =
        model::cuesWith(RuleSet::Audience, model::rulesOf(RuleSet::Audience, scene), scene);
    QCOMPARE(eventsSent(),
             (std::vector<std::string>{"sad", "clap", "cheer", "wave", "bored", "angry", "calm"}));
    QCOMPARE(scene.cues[1].id, model::CueId{8});
    QCOMPARE(scene.cues[1].key, std::string("F4"));
    QVERIFY(!scene.cues[1].name.empty());
    addSet(scene, RuleSet::Panic);
    QCOMPARE(model::nextCue(scene).event, std::string("panic"));
    scene.cues.push_back(model::nextCue(scene));
    QCOMPARE(scene.cues.back().key, std::string("F10"));
    QCOMPARE(model::nextCue(scene).key, std::string());
    model::Mark mark; // of a cue that is gone
    mark.cue = 40;
    scene.timeline = {mark};
    QCOMPARE(model::nextCue(scene).id, model::CueId{41});
    scene.cues.resize(model::kMaxNamed);
    const auto full = model::cuesWith(RuleSet::Flock, model::rulesOf(RuleSet::Flock, scene), scene);
    QCOMPARE(full.size(), model::kMaxNamed);
}

void TestRuleSets::aWaveRunsRoundTheStadium()
{
    model::Scene scene = readyMade("stadium");
    addSet(scene, RuleSet::StadiumWave);
    Session session(scene);
    session.send("wave", 0.0F, {idsOf(scene).front()});
    run(session, 30 * 60);
    const std::uint64_t fired = firedOf(session);
    QVERIFY2(fired * 10 > scene.population.size() * 8,
             QByteArray::number(static_cast<qulonglong>(fired)));
    QVERIFY(session.problems().empty());
}

void TestRuleSets::panicEmptiesASmallStage()
{
    model::Scene scene = smallStage();
    scene.places = {exitAt(1, {-15.0F, 0.0F, 0.0F}), exitAt(2, {20.0F, 0.0F, 4.0F})};
    addSet(scene, RuleSet::Panic);
    Session session(scene);
    session.send("panic", 0.0F, {13}); // the one in the middle
    LastSeen seen;
    for (int step = 0; step < 30 * 60; ++step) {
        session.step();
        seen.look(session);
    }
    QCOMPARE(seen.gone(), std::size_t{25});
    QVERIFY2(seen.farthest(scene.places) < 3.5F,
             QByteArray::number(static_cast<double>(seen.farthest(scene.places))));
    QVERIFY(seen.farthest({scene.places[0]}) > 20.0F); // both are taken
    QVERIFY(session.problems().empty());
}

void TestRuleSets::panicEmptiesTheCity()
{
    model::Scene scene = readyMade("city");
    scene.places = {exitAt(1, {-60.0F, 0.0F, -0.2F}), exitAt(2, {0.0F, 0.0F, -60.0F})};
    addSet(scene, RuleSet::Panic);
    Session session(scene);
    letStand(session, scene);
    session.send("panic", 0.0F, idsOf(scene));
    LastSeen seen;
    for (int step = 0; step < 30 * 150 && seen.gone() < scene.population.size(); ++step) {
        session.step();
        if (step % 5 == 0) {
            seen.look(session);
        }
    }
    QVERIFY2(seen.farthest(scene.places) < 4.0F,
             QByteArray::number(static_cast<double>(seen.farthest(scene.places))));
    QCOMPARE(seen.gone(), scene.population.size()); // also those who run up against a house
    QVERIFY(session.problems().empty());
}

void TestRuleSets::withoutAnExitPanicLeavesPeopleThere()
{
    model::Scene scene = smallStage();
    addSet(scene, RuleSet::Panic);
    Session session(scene);
    session.send("panic", 0.0F, {13});
    run(session, 30 * 30);
    LastSeen seen;
    seen.look(session);
    QCOMPARE(seen.gone(), std::size_t{0});
    QCOMPARE(session.problems().size(), std::size_t{1});
    QVERIFY(session.problems().front().text.english().find("there is none") != std::string::npos);
}

void TestRuleSets::pedestriansRunStopAndWalk()
{
    model::Scene scene = smallStage();
    scene.places = {{1, "far", {0.0F, 0.0F, 400.0F}, 3.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    addSet(scene, RuleSet::Pedestrians);
    Session session(scene);
    const std::vector<model::IndividualId> all = idsOf(scene);
    const auto metresIn = [&](int steps) {
        const auto before = session.frame();
        run(session, steps);
        const auto after = session.frame();
        float sum = 0.0F;
        for (std::size_t row = 0; row < all.size(); ++row) {
            sum += after->population.column(model::columns::position)[row].z -
                   before->population.column(model::columns::position)[row].z;
        }
        return sum / static_cast<float>(all.size());
    };
    run(session, 60);
    session.send("run", 3.0F, all);
    run(session, 60);
    QVERIFY(metresIn(60) > 4.0F);
    session.send("stop", 0.0F, all);
    run(session, 60);
    QVERIFY(metresIn(60) < 0.6F); // some have just looked around, and go on
    session.send("walk", 0.0F, all);
    run(session, 60);
    const float walked = metresIn(60);
    QVERIFY2(walked > 1.6F && walked < 3.4F, QByteArray::number(static_cast<double>(walked)));
    run(session, 30 * 60);
    QVERIFY(session.rules().count(4) > 5); // some stop and look, and all get on
    QVERIFY(metresIn(60) > 1.2F);
    QVERIFY(session.problems().empty());
}

void TestRuleSets::animalsWanderAndRunWhenStartled()
{
    model::Scene scene = readyMade("meadow");
    addSet(scene, RuleSet::Flock);
    Session session(scene);
    run(session, 30 * 40);
    const auto wandered = session.frame();
    std::size_t moved = 0;
    for (std::size_t row = 0; row < scene.population.size(); ++row) {
        moved += glm::distance(wandered->population.column(model::columns::position)[row],
                               scene.population.column(model::columns::position)[row]) > 0.5F
                     ? 1
                     : 0;
    }
    QVERIFY(moved * 2 > scene.population.size());
    session.send("startle", 0.0F, idsOf(scene));
    run(session, 30 * 6);
    QVERIFY(session.rules().count(1) >= scene.population.size());
    QVERIFY(session.problems().empty());
}

/// On the square, all who are there and eight places.
void TestRuleSets::aQueueInTheCityServesEverybody()
{
    model::Scene scene = readyMade("city");
    std::vector<model::IndividualId> others = idsOf(scene);
    std::vector<model::IndividualId> guests;
    for (std::size_t row = 0; row < scene.population.size() && guests.size() < 22; ++row) {
        const glm::vec3 at = scene.population.column(model::columns::position)[row];
        if (std::fabs(at.x) < 18.0F && std::fabs(at.z) < 18.0F && at.y < 0.5F &&
            glm::length(glm::vec2(at.x, at.z)) > 6.0F) {
            guests.push_back(scene.population.ids()[row]);
        }
    }
    QCOMPARE(guests.size(), std::size_t{22});
    std::erase_if(others, [&](model::IndividualId id) {
        return std::ranges::find(guests, id) != guests.end();
    });
    (void)scene.population.remove(others);
    model::Path line{1, "line", model::PathKind::Simple, {}};
    for (model::PlaceId id = 1; id <= 8; ++id) {
        scene.places.push_back(
            {id, "spot", {7.8F + 1.0F * static_cast<float>(id), 0.15F, 8.2F}, 0.3F});
        line.places.push_back(id);
    }
    scene.paths = {line};
    addSet(scene, RuleSet::Queue);
    Session session(scene);
    letStand(session, scene);
    session.send("queue", 0.0F, guests);
    LastSeen seen;
    std::vector<model::IndividualId> order;
    for (int step = 0; step < 30 * 400 && order.size() < guests.size(); ++step) {
        session.step();
        const auto frame = session.frame();
        for (std::size_t row = 0; row < guests.size(); ++row) {
            if (frame->population.column(model::columns::position)[row].y < kGone &&
                std::ranges::find(order, guests[row]) == order.end()) {
                order.push_back(guests[row]);
            }
        }
    }
    QCOMPARE(order, guests);
}

/// Twelve around one who walks through them and on.
void TestRuleSets::aGuideIsFollowedAndGetsOut()
{
    model::Scene scene = smallStage();
    scene.places = {{1, "far", {2.4F, 0.0F, 40.0F}, 0.3F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    const std::vector<model::IndividualId> guide{13}; // in the middle
    scene.population.setValues<std::uint64_t>(model::columns::tags, guide,
                                              std::vector<std::uint64_t>{1});
    actions::Follow follow;
    follow.aim = model::ActionAim::Tagged;
    follow.metres = 2.5F;
    follow.seconds = 0.0F;
    actions::FollowPath walk;
    walk.path = 1;
    Rule others = onEvent("follow", {follow});
    Rule lead = onEvent("lead", {walk});
    lead.id = 2;
    scene.rules = {others, lead};
    for (const float metres : {2.5F, 1.5F}) { // also where they stand as near as they can
        scene.rules[0].actions[0].as<actions::Follow>()->metres = metres;
        Session session(scene);
        std::vector<model::IndividualId> crowd = idsOf(scene);
        std::erase(crowd, model::IndividualId{13});
        session.send("follow", 0.0F, crowd);
        run(session, 90); // they have closed in on him
        session.send("lead", 0.0F, guide);
        run(session, 30 * 50);
        QVERIFY2(placeOf(session, 12).z > 38.0F,
                 QByteArray::number(static_cast<double>(placeOf(session, 12).z)));
        std::size_t with = 0;
        for (std::size_t row = 0; row < 25; ++row) {
            with +=
                behavior::flatDistance(placeOf(session, row), placeOf(session, 12)) < 6.0F ? 1 : 0;
        }
        QVERIFY2(with >= 23, QByteArray::number(static_cast<qulonglong>(with)));
    }
}

void TestRuleSets::everybodyFindsASeat()
{
    model::Scene scene = smallStage();
    addSeats(scene, 30);
    scene.rules = {onEvent("sit", {sitDown()})};
    Session session(scene);
    session.send("sit", 0.0F, idsOf(scene));
    run(session, 30 * 90);
    std::map<model::SeatId, int> taken;
    for (std::size_t row = 0; row < 25; ++row) {
        QVERIFY(shownSeat(session, row) != model::kNoSeat);
        ++taken[shownSeat(session, row)];
    }
    QCOMPARE(taken.size(), std::size_t{25});
    QVERIFY(session.problems().empty());
}

CROWD_TEST(TestRuleSets)
#include "tst_RuleSets.moc"
