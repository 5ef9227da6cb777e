// SPDX-License-Identifier: MIT
#include "behavior/agents/StateFades.h"

#include <QtTest/QTest>

#include "behavior/session/PoseKeeping.h"
#include "model/document/SceneEdit.h"
#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// The share of their clip that people in transition show, by row; below 0: none.
std::vector<float> sharesOf(const Session& session)
{
    const auto frame = session.frame();
    std::vector<float> shares(frame->population.size(), -1.0F);
    for (const ClipFade& fade : frame->fades) {
        shares[fade.row] = fade.share;
    }
    return shares;
}

int rowsThatHaveBegun(const Session& session)
{
    int begun = 0;
    for (std::size_t row = 0; row < session.frame()->population.size(); ++row) {
        begun += tintOf(session, row) == kBlue ? 0 : 1;
    }
    return begun;
}

} // namespace

/// People who take on a state while a session runs.
class TestStateFades : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void coloursAndSizesRun();
    void clipsFadeIntoEachOther();
    void theyFollowEachOther_data();
    void theyFollowEachOther();
    void rowsAndBlocksOfSeats();
    void inTheRunAlone();
    void editsCountAgain();
    void theLaterWinsFromWhatIsShown();
    void recalledAgainItBeginsAnew();
    void whatIsEditedIsSeenAtOnce();
    void rulesCountNoMore();
    void anotherTemplateComesHalfWay();
    void whoWalksGoesOn();
    void whoWasLedAwayIsBack();
    void whoHasLeftStaysAway();
    void isKeptWithThePose();
    void whatDoesNotFitIsSaid();
    void nobodyAndNoState();
};

void TestStateFades::coloursAndSizesRun()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    run(session, 3);
    session.adopt(recalled(scene), changeOver(scene, 2.0F));
    QCOMPARE(tintOf(session, 0), kBlue); // as before, until time goes on
    QCOMPARE(heightOf(session, 0), 1.0F);
    run(session, kStepsPerSecond);
    const Tint half = tintOf(session, 4);
    QVERIFY2(half.red >= 99 && half.red <= 101 && half.blue >= 49 && half.blue <= 51,
             qPrintable(QStringLiteral("%1 %2").arg(half.red).arg(half.blue)));
    QVERIFY(std::abs(heightOf(session, 4) - 1.5F) < 0.01F);
    run(session, kStepsPerSecond);
    QCOMPARE(session.frame()->population, recalled(scene).population);
    run(session, 1);
    QVERIFY(session.pose()->stateFades == nullptr);
}

void TestStateFades::clipsFadeIntoEachOther()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    run(session, 5);
    session.adopt(recalled(scene), changeOver(scene, 1.0F));
    QCOMPARE(clipOf(session, 1), kIdle);
    QVERIFY(session.frame()->fades.empty());
    run(session, kStepsPerSecond / 2);
    QCOMPARE(clipOf(session, 1), kSit);
    const auto frame = session.frame();
    QCOMPARE(frame->fades.size(), std::size_t{5});
    QCOMPARE(frame->fades[1].clip, kIdle);
    QVERIFY(std::abs(frame->fades[1].share - 0.5F) < 0.02F);
    const float there =
        shownPhase(scene.templates.front().asset->clips[kIdle], 0.0F, 1.0F, frame->seconds);
    QVERIFY2(std::abs(frame->fades[1].place - there) < 1e-4F, "it goes on while it fades");
    run(session, kStepsPerSecond / 2 + 1);
    QVERIFY(session.frame()->fades.empty());
}

void TestStateFades::theyFollowEachOther_data()
{
    QTest::addColumn<int>("order");
    QTest::addColumn<float>("heading");
    QTest::addColumn<std::vector<int>>("halfWay"); ///< who has begun; 2 m apart along X
    const float toX = std::numbers::pi_v<float> / 2.0F;
    QTest::newRow("from a point") << int(StaggerOrder::Distance) << 0.0F << std::vector{0, 1};
    QTest::newRow("along a way") << int(StaggerOrder::Heading) << toX << std::vector{0, 1};
    QTest::newRow("the other way") << int(StaggerOrder::Heading) << -toX << std::vector{3, 4};
}

void TestStateFades::theyFollowEachOther()
{
    QFETCH(int, order);
    QFETCH(float, heading);
    QFETCH(std::vector<int>, halfWay);
    const Scene scene = sceneWithState();
    Session session(scene);
    session.adopt(
        recalled(scene),
        changeOver(scene, 1.0F,
                   {4.0F, static_cast<StaggerOrder>(order), {0.0F, 0.0F, 0.0F}, heading}));
    run(session, 2 * kStepsPerSecond); // of 4: who is in the middle begins now
    for (int row = 0; row < 5; ++row) {
        const bool hasBegun = std::ranges::find(halfWay, row) != halfWay.end();
        QCOMPARE(tintOf(session, static_cast<std::size_t>(row)) != kBlue, hasBegun);
        QCOMPARE(clipOf(session, static_cast<std::size_t>(row)) == kSit, hasBegun);
    }
    run(session, 3 * kStepsPerSecond + 1);
    QCOMPARE(session.frame()->population, recalled(scene).population);
}

void TestStateFades::rowsAndBlocksOfSeats()
{
    Scene scene = sceneWithState();
    auto theatre = std::make_shared<StageAsset>();
    for (int seat = 0; seat < 4; ++seat) {
        theatre->seats.push_back({{2.0F * static_cast<float>(seat), 0.0F, 0.0F},
                                  0.0F,
                                  0.4F,
                                  /*rank=*/seat / 2,
                                  /*wedge=*/seat % 2});
    }
    StageEntry entry;
    entry.id = 1;
    entry.asset = theatre;
    scene.stages.push_back(entry);
    const std::vector<IndividualId> seated{1, 2, 3, 4};
    scene.population.setValues<SeatId>(
        columns::seat, seated,
        std::vector<SeatId>{1U << 24U, 1U << 24U | 1U, 1U << 24U | 2U, 1U << 24U | 3U});
    for (const auto& [order, later] :
         {std::pair{StaggerOrder::Row, std::vector<float>{0, 0, 3, 3, 0}},
          std::pair{StaggerOrder::Wedge, std::vector<float>{0, 3, 0, 3, 0}}}) {
        QCOMPARE(delaysOf(changeOver(scene, 1.0F, {3.0F, order}), scene, scene.population), later);
    }
    // At random: in between, the same each time, and not all alike.
    const ChangeOver random = changeOver(scene, 1.0F, {3.0F, StaggerOrder::Random});
    const std::vector<float> delays = delaysOf(random, scene, scene.population);
    QCOMPARE(delaysOf(random, scene, scene.population), delays);
    QVERIFY(std::ranges::all_of(delays, [](float each) { return each >= 0.0F && each < 3.0F; }));
    QVERIFY(delays[0] != delays[1] && delays[1] != delays[2]);
}

void TestStateFades::inTheRunAlone()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    run(session, 3);
    QCOMPARE(session.recall(changeOver(scene, 0.0F)).changed.size(), std::size_t{5});
    QCOMPARE(session.frame()->population, recalled(scene).population);
    session.adopt(scene); // an edit of something else
    run(session, 3);
    QCOMPARE(session.frame()->population, recalled(scene).population);
    // A reader that has the scene's people gets the same.
    CrowdFrame frame{scene.population, session.frame()->templates, session.seconds()};
    behavior::applyPose(*session.pose(), *session.pose(), frame);
    QCOMPARE(frame.population, recalled(scene).population);
    Scene edited = scene;
    putAll(edited, columns::walkSpeed, 1.1F); // others than the session knows
    frame.population = edited.population;
    behavior::applyPose(*session.pose(), *session.pose(), frame);
    QCOMPARE(frame.population.column(columns::tint(0))[2], kRed);
    QCOMPARE(frame.population.column(columns::walkSpeed)[2], 1.1F);
}

void TestStateFades::editsCountAgain()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    (void)session.recall(changeOver(scene, 0.0F));
    Scene edited = scene;
    const std::vector<IndividualId> one{3};
    edited.population.setValues<Tint>(columns::tint(0), one, std::vector<Tint>{{1, 2, 3, 4}});
    session.adopt(edited);
    QCOMPARE(tintOf(session, 2), (Tint{1, 2, 3, 4}));
    QCOMPARE(tintOf(session, 1), kRed);
    QCOMPARE(heightOf(session, 2), 2.0F); // of him too
    (void)edited.population.remove(one);
    session.adopt(edited);
    run(session, 2);
    QCOMPARE(session.frame()->population.size(), std::size_t{4});
    QCOMPARE(tintOf(session, 2), kRed); // the next one
}

void TestStateFades::theLaterWinsFromWhatIsShown()
{
    Scene scene = sceneWithState();
    Session session(scene);
    (void)session.recall(changeOver(scene, 2.0F));
    run(session, kStepsPerSecond);
    const Tint half = tintOf(session, 0);
    // Back again: what is shown does not jump, and ends at what the scene has.
    State blue = keepState(scene, "blue", usualStateColumns(), scene.population.ids());
    blue.id = 2;
    scene.states.push_back(blue);
    session.adopt(scene);
    ChangeOver back = changeOver(scene, 2.0F);
    back.state = 2;
    (void)session.recall(back);
    QCOMPARE(tintOf(session, 0), half);
    run(session, kStepsPerSecond);
    QVERIFY(tintOf(session, 0).red < half.red && tintOf(session, 0).red > 0);
    run(session, kStepsPerSecond + 1);
    QCOMPARE(session.frame()->population, scene.population);
}

void TestStateFades::recalledAgainItBeginsAnew()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    (void)session.recall(changeOver(scene, 2.0F, {10.0F, StaggerOrder::Distance}));
    run(session, kStepsPerSecond);
    QCOMPARE(tintOf(session, 4), kBlue); // its turn has not come
    (void)session.recall(changeOver(scene, 1.0F));
    QCOMPARE(tintOf(session, 4), kBlue);
    run(session, kStepsPerSecond / 2);
    QVERIFY(tintOf(session, 4).red > 50);
    ChangeOver one = changeOver(scene, 0.0F);
    one.ids = {5};
    (void)session.recall(one);
    QCOMPARE(tintOf(session, 4), kRed);
    QCOMPARE(sharesOf(session)[4], -1.0F);
    QVERIFY(tintOf(session, 3) != kRed);
}

void TestStateFades::whatIsEditedIsSeenAtOnce()
{
    const Scene scene = sceneWithState();
    Session session(scene);
    Scene now = recalled(scene);
    session.adopt(now, changeOver(scene, 4.0F));
    run(session, kStepsPerSecond);
    const std::vector<IndividualId> one{2};
    now.population.setValues<Tint>(columns::tint(0), one, std::vector<Tint>{{9, 9, 9, 9}});
    session.adopt(now);
    QCOMPARE(tintOf(session, 1), (Tint{9, 9, 9, 9}));
    QVERIFY(tintOf(session, 0) != kRed && tintOf(session, 0) != kBlue);
    session.adopt(scene); // undone: as it was
    QCOMPARE(session.frame()->population, scene.population);
}

void TestStateFades::rulesCountNoMore()
{
    Scene scene = sceneWithState();
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}};
    clap.isLooped = true;
    clap.seconds = 0.0F;
    scene.rules = {onEvent("applause", {clap})};
    Session session(scene);
    session.send("applause", 1.0F, {1, 2});
    run(session, kStepsPerSecond);
    QCOMPARE(clipOf(session, 0), kClap);
    (void)session.recall(changeOver(scene, 1.0F));
    QCOMPARE(clipOf(session, 0), kClap); // fades from here
    run(session, kStepsPerSecond / 2);
    QCOMPARE(clipOf(session, 0), kSit);
    QVERIFY(sharesOf(session)[0] > 0.4F && sharesOf(session)[0] < 0.6F);
    run(session, kStepsPerSecond);
    QCOMPARE(clipOf(session, 0), kSit);
    QCOMPARE(sharesOf(session)[0], -1.0F);
}

void TestStateFades::anotherTemplateComesHalfWay()
{
    Scene scene = sceneWithState();
    scene.templates.push_back(actorTemplate());
    scene.templates.back().id = 2;
    Scene other = scene;
    putAll<TemplateId>(other, columns::templateId, 2);
    putAll(other, columns::clip, kSit);
    ColumnSet columns = usualStateColumns();
    columns.insert(ColumnId::Template);
    scene.states.front() = keepState(other, "others", columns, other.population.ids());
    scene.states.front().id = 1;
    Session session(scene);
    session.adopt(recalled(scene), changeOver(scene, 2.0F));
    run(session, kStepsPerSecond - 2);
    QCOMPARE(session.frame()->population.column(columns::templateId)[0], TemplateId{1});
    QCOMPARE(clipOf(session, 0), kIdle);
    QVERIFY2(session.frame()->fades.empty(), "clips of two templates cannot fade");
    run(session, 4);
    QCOMPARE(session.frame()->population.column(columns::templateId)[0], TemplateId{2});
    QCOMPARE(clipOf(session, 0), kSit);
}

void TestStateFades::whoWalksGoesOn()
{
    Scene scene = sceneWithState();
    scene.places = {{1, "far", {0.0F, 0.0F, 60.0F}, 0.2F}};
    scene.paths = {{1, "way", PathKind::Simple, {1}}};
    letWalk(scene, 1);
    // A state without the way that they follow.
    ColumnSet columns = columnsOf(PropertyAspect::Colours);
    columns.insert(ColumnId::Clip);
    scene.states.front() =
        keepState(recalled(sceneWithState()), "red", columns, scene.population.ids());
    scene.states.front().id = 1;
    Session session(scene);
    run(session, 2 * kStepsPerSecond);
    const std::uint16_t walk = clipOf(session, 0);
    QVERIFY(walk != kIdle);
    (void)session.recall(changeOver(scene, 1.0F));
    run(session, kStepsPerSecond / 2);
    QCOMPARE(clipOf(session, 0), walk);
    QVERIFY(tintOf(session, 0).red > 50);
    const float before = placeOf(session, 0).z;
    run(session, kStepsPerSecond);
    QVERIFY(placeOf(session, 0).z > before + 0.5F);
}

/// What the run has done to a place is no edit of the scene, which has it as the state does.
void TestStateFades::whoWasLedAwayIsBack()
{
    Scene scene = rowOf(3);
    addLine(scene, 2);
    letWalk(scene, 1);
    ColumnSet places;
    places.insert(ColumnId::Position);
    places.insert(ColumnId::Heading);
    places.insert(ColumnId::Path);
    Scene standing = scene;
    putAll(standing, columns::path, PathId{0});
    State here = keepState(standing, "here", places, standing.population.ids());
    here.id = 1;
    scene.states = {here};
    Session session(scene);
    run(session, 2 * kStepsPerSecond);
    const glm::vec3 begun = scene.population.column(columns::position)[0];
    QVERIFY(glm::distance(placeOf(session, 0), begun) > 0.5F);
    ChangeOver change = changeOver(scene, 0.0F);
    (void)session.recall(change);
    run(session, 2);
    const auto shown = session.frame();
    for (std::size_t row = 0; row < 3; ++row) {
        const glm::vec3 kept = scene.population.column(columns::position)[row];
        QVERIFY(glm::distance(placeOf(session, row), kept) < 0.1F);
        QCOMPARE(shown->population.column(columns::heading)[row],
                 scene.population.column(columns::heading)[row]);
    }
}

void TestStateFades::whoHasLeftStaysAway()
{
    Scene scene = rowOf(2);
    scene.rules = {onEvent("out", {actions::LeaveScene()})};
    State here = keepState(scene, "here", columnsOf(PropertyAspect::Place), scene.population.ids());
    here.id = 1;
    scene.states = {here};
    Session session(scene);
    session.send("out", 0.0F, {2});
    run(session, kStepsPerSecond);
    const float away = placeOf(session, 1).y;
    QVERIFY(away < -1000.0F);
    (void)session.recall(changeOver(scene, 0.0F));
    run(session, 2);
    QCOMPARE(placeOf(session, 1).y, away);
}

void TestStateFades::isKeptWithThePose()
{
    SceneDocument document;
    document.replaceScene(sceneWithState(), {});
    const Scene scene = document.scene();
    Session session(scene);
    (void)session.recall(changeOver(scene, 0.0F));
    run(session, 2);
    document.edit(QStringLiteral("Keep"), [&](SceneEdit& edit) {
        (void)behavior::keepPose(edit, session.frame()->population, session.pose().get());
    });
    QCOMPARE(document.scene().population, recalled(scene).population);
    session.adopt(document.scene(), true);
    run(session, 2);
    QVERIFY(session.pose()->recalled == nullptr);
    QCOMPARE(session.frame()->population, recalled(scene).population);
}

void TestStateFades::whatDoesNotFitIsSaid()
{
    Scene scene = sceneWithState();
    scene.templates.front().clipNames[kSit] = "lie";
    Session session(scene);
    QCOMPARE(session.recall(changeOver(scene, 0.0F)).notes.size(), std::size_t{1});
    QVERIFY(!session.problems().empty());
    QVERIFY(session.problems().front().text.english().find("\"sit\"") != std::string::npos);
    QCOMPARE(clipOf(session, 0), kIdle);
    QCOMPARE(tintOf(session, 0), kRed);
}

void TestStateFades::nobodyAndNoState()
{
    Scene scene = sceneWithState();
    Session session(scene);
    ChangeOver change = changeOver(scene, 1.0F);
    change.state = 77;
    QVERIFY(session.recall(change).changed.empty());
    change = changeOver(scene, 1.0F);
    change.ids = {900, 901};
    QVERIFY(session.recall(change).changed.empty());
    change.ids.clear();
    session.adopt(scene, change);
    run(session, 3);
    QCOMPARE(session.frame()->population, scene.population);
    QCOMPARE(rowsThatHaveBegun(session), 0);
}

CROWD_TEST(TestStateFades)

#include "tst_StateFades.moc"
