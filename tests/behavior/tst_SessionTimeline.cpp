// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

Mark eventAt(double seconds, const char* event = "go", MarkId id = 1)
{
    Mark mark;
    mark.id = id;
    mark.seconds = seconds;
    mark.kind = MarkKind::Event;
    mark.event = event;
    return mark;
}

Mark stateAt(double seconds, float fade = 0.0F, MarkId id = 1)
{
    Mark mark;
    mark.id = id;
    mark.seconds = seconds;
    mark.kind = MarkKind::State;
    mark.state = 1;
    mark.fade = fade;
    return mark;
}

Mark callAt(double seconds, CueId cue)
{
    Mark mark;
    mark.id = 1;
    mark.seconds = seconds;
    mark.kind = MarkKind::Cue;
    mark.cue = cue;
    return mark;
}

/// Who hears "go" is tagged, who hears "grow" becomes red, sooner or later.
Scene sceneThatListens()
{
    Scene scene = sceneWithState();
    scene.rules = {onEvent("go", {tagWith(3)}),
                   onEvent("grow", {actions::TakeOnState{1, 1.0F, 1.0F}})};
    scene.rules.back().id = 2;
    return scene;
}

int howManyAreTagged(Session& session)
{
    int tagged = 0;
    for (std::uint32_t agent = 0; agent < 5; ++agent) {
        tagged += hasTag(session, agent, 3) ? 1 : 0;
    }
    return tagged;
}

bool says(const Session& session, const char* part)
{
    return std::ranges::any_of(session.warnings(), [part](const behavior::Problem& problem) {
        return problem.text.english().find(part) != std::string::npos;
    });
}

std::vector<float> heightsOf(const Session& session)
{
    const CrowdFramePtr frame = session.frame();
    const auto heights = frame->population.column(columns::height);
    return {heights.begin(), heights.end()};
}

} // namespace

/// What the timeline says happens by itself, once, at its time.
class TestSessionTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anEventIsHeardAtItsTime();
    void aStateIsTakenOn();
    void cuesReachWhomTheyMean();
    void whatIsPerformedIsRepeatedByItsMark();
    void whatHasHappenedDoesNotHappenAgain();
    void whatWasBeforeTheBeginningDoesNotHappen();
    void itIsBehaviour();
    void whatIsSprayedIsHeardOneAfterTheOther();
    void whatIsGoneIsSaid();
};

void TestSessionTimeline::anEventIsHeardAtItsTime()
{
    Scene scene = sceneThatListens();
    scene.timeline = {eventAt(1.0)};
    scene.timeline.front().people = {2, 4, 77};
    Session session(scene);
    run(session, kStepsPerSecond);
    QCOMPARE(howManyAreTagged(session), 0);
    run(session, 1);
    QCOMPARE(howManyAreTagged(session), 2);
    QVERIFY(hasTag(session, 1, 3) && hasTag(session, 3, 3));
    scene.timeline.front().people.clear(); // everybody
    Session all(scene);
    run(all, kStepsPerSecond + 1);
    QCOMPARE(howManyAreTagged(all), 5);
}

void TestSessionTimeline::aStateIsTakenOn()
{
    Scene scene = sceneWithState();
    scene.timeline = {stateAt(0.5, 1.0F)};
    Session session(scene);
    run(session, kStepsPerSecond / 2);
    QCOMPARE(heightOf(session, 0), 1.0F);
    run(session, kStepsPerSecond / 2);
    QVERIFY(heightOf(session, 0) > 1.2F && heightOf(session, 0) < 1.8F);
    run(session, kStepsPerSecond);
    QCOMPARE(heightOf(session, 4), 2.0F);
    QCOMPARE(tintOf(session, 4), kRed);
}

void TestSessionTimeline::cuesReachWhomTheyMean()
{
    Scene scene = sceneThatListens();
    putAll(scene, columns::tags, std::uint64_t{0});
    const std::vector<IndividualId> some{1, 2, 3};
    scene.population.setValues(columns::tags, std::span<const IndividualId>(some),
                               std::span<const std::uint64_t>(std::vector<std::uint64_t>(3, 64)));
    Cue cue;
    cue.id = 1;
    cue.event = "go";
    scene.cues = {cue, cue};
    scene.cues[1].id = 2;
    scene.cues[1].reach = CueReach::Tagged;
    scene.cues[1].tag = 6;
    for (const auto& [id, heard] : std::vector<std::pair<CueId, int>>{{1, 5}, {2, 3}}) {
        scene.timeline = {callAt(0.2, id)};
        Session session(scene);
        run(session, kStepsPerSecond / 2);
        QCOMPARE(howManyAreTagged(session), heard);
    }
    scene.cues[0].state = 1;
    scene.timeline = {callAt(0.2, 1)};
    Session session(scene);
    run(session, kStepsPerSecond / 2);
    QCOMPARE(tintOf(session, 0), kRed);
}

/// Bit for bit: a show that was performed once is the same each time.
void TestSessionTimeline::whatIsPerformedIsRepeatedByItsMark()
{
    Scene scene = sceneThatListens();
    Session live(scene);
    run(live, 17);
    Mark event = eventAt(live.seconds(), "grow");
    event.people = {1, 3, 5};
    live.perform(event);
    run(live, 20);
    const Mark state = stateAt(live.seconds(), 0.7F, 2);
    live.perform(state);
    run(live, 9);

    scene.timeline = {event, state};
    Session again(scene);
    run(again, 17 + 20 + 9);
    QVERIFY(heightsOf(again) == heightsOf(live));
}

void TestSessionTimeline::whatHasHappenedDoesNotHappenAgain()
{
    Scene scene = sceneWithState();
    scene.rules = {onEvent("go", {tagWith(3)})};
    Session session(scene);
    run(session, 10);
    const Mark mark = eventAt(session.seconds());
    session.perform(mark);
    scene.timeline = {mark}; // as it is recorded
    session.adopt(scene);
    run(session, 10);
    scene.timeline = {mark, eventAt(0.1, "go", 2)}; // put into the past
    session.adopt(scene);
    run(session, 10);
    QCOMPARE(session.rules().counts().at(1), std::uint64_t{5});
    scene.timeline.push_back(eventAt(2.0, "go", 3));
    session.adopt(scene);
    run(session, 2 * kStepsPerSecond);
    QCOMPARE(session.rules().counts().at(1), std::uint64_t{10});
}

void TestSessionTimeline::whatWasBeforeTheBeginningDoesNotHappen()
{
    Scene scene = sceneThatListens();
    scene.timeline = {eventAt(4.9), eventAt(5.0, "go", 2)};
    scene.timeline[0].people = {1};
    scene.timeline[1].people = {2};
    Session session(scene);
    session.setStart(5.0);
    run(session, 2);
    QVERIFY(!hasTag(session, 0, 3) && hasTag(session, 1, 3));
}

void TestSessionTimeline::itIsBehaviour()
{
    Scene scene = sceneWithState();
    QVERIFY(!scene.hasBehaviour());
    Mark marker;
    marker.id = 1;
    scene.timeline = {marker};
    QVERIFY(!scene.hasBehaviour());
    scene.timeline = {stateAt(2.0)};
    QVERIFY(scene.hasBehaviour());
}

void TestSessionTimeline::whatIsSprayedIsHeardOneAfterTheOther()
{
    Scene scene = sceneThatListens();
    scene.timeline = {eventAt(0.5)};
    scene.timeline.front().people = {1, 3, 4};
    scene.timeline.front().delays = {500, 0, 233}; // 233 ms: the seventh step
    Session session(scene);
    run(session, kStepsPerSecond / 2 + 1);
    QVERIFY(howManyAreTagged(session) == 1 && hasTag(session, 2, 3));
    run(session, 6);
    QCOMPARE(howManyAreTagged(session), 1);
    run(session, 1);
    QVERIFY(howManyAreTagged(session) == 2 && hasTag(session, 3, 3));
    run(session, kStepsPerSecond);
    QVERIFY(howManyAreTagged(session) == 3 && hasTag(session, 0, 3));
}

void TestSessionTimeline::whatIsGoneIsSaid()
{
    Scene scene = sceneThatListens();
    Cue chosen;
    chosen.id = 4;
    chosen.name = "chosen ones";
    chosen.event = "go";
    chosen.reach = CueReach::Selected;
    scene.cues = {chosen};
    Mark gone = stateAt(0.1);
    gone.state = 9;
    scene.timeline = {gone};
    Session state(scene);
    run(state, 10);
    QVERIFY(says(state, "At 0.10 seconds the timeline recalls a state that is not there"));
    scene.timeline = {callAt(0.1, 3)};
    Session cue(scene);
    run(cue, 10);
    QVERIFY(says(cue, "calls a cue that is not there"));
    scene.timeline = {callAt(0.1, 4)};
    Session nobody(scene);
    run(nobody, 10);
    QVERIFY(says(nobody, "“chosen ones”, which speaks to the selected"));
    scene.timeline.front().people = {2};
    Session one(scene);
    run(one, 10);
    QCOMPARE(howManyAreTagged(one), 1);
    scene.timeline.front().people = {77};
    Session none(scene);
    run(none, 10);
    QVERIFY(says(none, "characters of whom none is there"));
    scene.timeline = {eventAt(0.1, "")};
    Session nameless(scene);
    run(nameless, 10);
    QVERIFY(says(nameless, "an event without a name"));
}

CROWD_TEST(TestSessionTimeline)
#include "tst_SessionTimeline.moc"
