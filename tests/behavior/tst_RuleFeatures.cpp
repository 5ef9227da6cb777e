// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr FeatureId kHappy = 5; ///< lets people clap, among what actors can
constexpr FeatureId kRedTeam = 13;
constexpr FeatureId kSad = 2; ///< nothing that actors can do but walking

FeatureId borne(const Session& session, std::size_t row, std::uint8_t kind = 1)
{
    return session.frame()->population.column(columns::feature(kind))[row];
}

actions::SetFeature become(FeatureId feature)
{
    return {feature};
}

Scene actors(std::size_t people = 5)
{
    return rowOf(people);
}

} // namespace

/// Rules that give features, ask for them, and hear of them.
class TestRuleFeatures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whoIsToldBearsIt();
    void theLastOneCounts();
    void conditionsAskForThem();
    void rulesHearOfThem();
    void noRuleCallsItselfForEver();
    void whoSitsByNowPlaysClipsToSitWith();
    void clipsOfRulesGiveWay();
    void editsOfTheSceneCountAgain();
    void valuesThatAreGoneAreSaid();
    void theSameForAnyNumberOfRuns();
};

void TestRuleFeatures::whoIsToldBearsIt()
{
    Scene scene = actors();
    scene.rules = {onEvent("cheer", {become(kHappy), tagWith(3)})};
    Session session(scene);
    session.send("cheer", 1.0F, {2, 4});
    run(session, 3);
    QCOMPARE(borne(session, 1), kHappy);
    QCOMPARE(clipOf(session, 1), kClap);
    QVERIFY(hasTag(session, 1, 3));
    QCOMPARE(borne(session, 0), FeatureId{0});
    QCOMPARE(clipOf(session, 0), kIdle);
    const auto phases = session.frame()->population.column(columns::phase);
    QVERIFY(phases[1] != phases[3]); // a start of one's own
    QCOMPARE(scene.population.column(columns::feature(1))[1], FeatureId{0});
}

void TestRuleFeatures::theLastOneCounts()
{
    Scene scene = actors();
    scene.rules = {onEvent("both", {become(kHappy), become(kSad)}),
                   onEvent("dress", {become(kRedTeam)})};
    scene.rules.back().id = 2;
    Session session(scene);
    session.send("both", 1.0F, {1});
    run(session, 4);
    QCOMPARE(borne(session, 0), kSad);
    session.send("dress", 1.0F, {1});
    run(session, 3);
    QCOMPARE(borne(session, 0), kSad); // another kind
    QCOMPARE(borne(session, 0, 2), kRedTeam);
}

void TestRuleFeatures::conditionsAskForThem()
{
    Scene scene = actors();
    const std::vector<FeatureId> sad(2, kSad);
    scene.population.setValues(columns::feature(1), std::vector<IndividualId>{1, 3},
                               std::span<const FeatureId>(sad));
    Rule rule = onEvent("ask", {tagWith(4)});
    rule.conditions = {conditions::HasFeature{kSad}};
    Rule other = onEvent("ask", {tagWith(5)});
    other.id = 2;
    other.conditions = {Condition(conditions::HasFeature{kSad}, true)};
    scene.rules = {rule, other};
    Session session(scene);
    session.send("ask", 1.0F, {1, 2, 3, 4, 5});
    run(session, 3);
    for (std::uint32_t agent = 0; agent < 5; ++agent) {
        const bool isSad = agent == 0 || agent == 2;
        QCOMPARE(hasTag(session, agent, 4), isSad);
        QCOMPARE(hasTag(session, agent, 5), !isSad);
    }
}

void TestRuleFeatures::rulesHearOfThem()
{
    Scene scene = actors();
    scene.rules = {onEvent("cheer", {become(kHappy)}),
                   when(triggers::FeatureChanged{kHappy}, {tagWith(6)}, 2),
                   when(triggers::FeatureChanged{}, {tagWith(7)}, 3)};
    scene.rules.back().meeting = RuleMeeting::Queue;
    Session session(scene);
    session.send("cheer", 1.0F, {2});
    run(session, 5);
    QVERIFY(hasTag(session, 1, 6) && hasTag(session, 1, 7));
    QVERIFY(!hasTag(session, 0, 6) && !hasTag(session, 0, 7));
    // Painted while it plays.
    Scene painted = scene;
    const std::vector<FeatureId> sad{kSad};
    painted.population.setValues(columns::feature(1), std::vector<IndividualId>{4},
                                 std::span<const FeatureId>(sad));
    session.adopt(painted);
    run(session, 3);
    QVERIFY(!hasTag(session, 3, 6) && hasTag(session, 3, 7));
}

void TestRuleFeatures::noRuleCallsItselfForEver()
{
    Scene scene = actors();
    scene.rules = {onEvent("cheer", {become(kHappy)}),
                   when(triggers::FeatureChanged{kHappy}, {become(kHappy)}, 7)};
    Session session(scene);
    session.send("cheer", 1.0F, {1, 2, 3, 4, 5});
    run(session, 60);
    QCOMPARE(session.rules().count(7), std::uint64_t{5}); // once each
}

void TestRuleFeatures::whoSitsByNowPlaysClipsToSitWith()
{
    Scene scene = actors(1);
    addSeats(scene);
    scene.templates.front().clipNames.push_back("sit_clap");
    auto asset = std::make_shared<Template>(*scene.templates.front().asset);
    Clip seated = asset->clips[4];
    seated.name = "sit_clap";
    seated.seatHeight = 0.45F;
    asset->clips.push_back(seated);
    scene.templates.front().asset = asset;
    scene.rules = {onEvent("sit", {sitDown()}), onEvent("cheer", {become(kHappy)})};
    scene.rules.back().id = 2;
    Session session(scene);
    session.send("sit", 1.0F, {1});
    run(session, 20 * kStepsPerSecond);
    QVERIFY(shownSeat(session, 0) != kNoSeat);
    session.send("cheer", 1.0F, {1});
    run(session, 3);
    QCOMPARE(borne(session, 0), kHappy);
    QCOMPARE(clipOf(session, 0), std::uint16_t{8});
}

void TestRuleFeatures::clipsOfRulesGiveWay()
{
    Scene scene = actors();
    scene.rules = {onEvent("sit", {actions::PlayClip{{{"sit", 1.0F}}, true, 60.0F}}),
                   onEvent("cheer", {become(kHappy)})};
    scene.rules.back().id = 2;
    Session session(scene);
    session.send("sit", 1.0F, {1});
    run(session, 5);
    QCOMPARE(clipOf(session, 0), kSit);
    session.send("cheer", 1.0F, {1});
    run(session, 3);
    QCOMPARE(borne(session, 0), FeatureId{0}); // he is busy, and that rule stands further up
    scene.rules.front().yields = RuleYield::Anybody;
    Session yielding(scene);
    yielding.send("sit", 1.0F, {1});
    run(yielding, 5);
    yielding.send("cheer", 1.0F, {1});
    run(yielding, 4);
    QCOMPARE(borne(yielding, 0), kHappy);
    QCOMPARE(clipOf(yielding, 0), kClap);
}

void TestRuleFeatures::editsOfTheSceneCountAgain()
{
    Scene scene = actors();
    scene.rules = {onEvent("cheer", {become(kHappy)})};
    Session session(scene);
    session.send("cheer", 1.0F, {1, 2});
    run(session, 3);
    Scene painted = scene;
    const std::vector<FeatureId> sad{kSad};
    painted.population.setValues(columns::feature(1), std::vector<IndividualId>{1},
                                 std::span<const FeatureId>(sad));
    session.adopt(painted);
    run(session, 1);
    QCOMPARE(borne(session, 0), kSad);
    QCOMPARE(borne(session, 1), kHappy);
}

void TestRuleFeatures::valuesThatAreGoneAreSaid()
{
    Scene scene = actors();
    scene.rules = {onEvent("cheer", {actions::SetFeature{0x10005}, tagWith(2)})};
    Session session(scene);
    session.send("cheer", 1.0F, {1});
    run(session, 3);
    QVERIFY(hasTag(session, 0, 2));
    const auto problems = session.problems();
    QVERIFY(std::ranges::any_of(problems, [](const behavior::Problem& each) {
        return each.text.english().find("value of a feature is not there") != std::string::npos;
    }));
}

void TestRuleFeatures::theSameForAnyNumberOfRuns()
{
    Scene scene = actors(60);
    scene.rules = {onEvent("cheer", {actions::Wait{0.5F}, become(kHappy)})};
    const auto after = [&scene] {
        Session session(scene);
        const auto ids = scene.population.ids();
        session.send("cheer", 1.0F, std::vector<IndividualId>(ids.begin(), ids.end()));
        run(session, 2 * kStepsPerSecond);
        return session.frame()->population;
    };
    QCOMPARE(after(), after());
}

CROWD_TEST(TestRuleFeatures)
#include "tst_RuleFeatures.moc"
