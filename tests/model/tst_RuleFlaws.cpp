// SPDX-License-Identifier: MIT
#include <functional>

#include <QtTest/QTest>

#include "model/rules/RuleFlaws.h"
#include "model/rules/RuleSets.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

Rule ruleOf(RuleId id, const char* event, std::vector<Action> actions)
{
    Rule rule;
    rule.id = id;
    rule.name = "rule " + std::to_string(id);
    rule.trigger = triggers::Event{event};
    rule.actions = std::move(actions);
    return rule;
}

template<class Kind>
Condition compared(Comparison comparison, float value, bool isNot = false)
{
    Kind kind;
    kind.comparison = comparison;
    kind.value = value;
    return {kind, isNot};
}

Scene sceneOf(std::vector<Rule> rules)
{
    Scene scene;
    scene.rules = std::move(rules);
    return scene;
}

} // namespace

class TestRuleFlaws : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsNotChosenIsSaid_data();
    void whatIsNotChosenIsSaid();
    void whatIsChosenIsComplete_data();
    void whatIsChosenIsComplete();
    void conditionsThatExcludeEachOtherAreSaid_data();
    void conditionsThatExcludeEachOtherAreSaid();
    void whatNeverComesIsSaid();
    void whatIsBrokenOffAtOnceIsSaid();
    void whatIsUndoneIsSaid();
    void seatsAndExitsThatAreMissingAreSaid();
    void whoeverItCameFromIsSomebody();
    void theNumberOfAnEventComesWithOne();
    void whatIsNeverReachedIsSaid();
    void rulesThatAreOffAreNotSaid();
};

void TestRuleFlaws::whatIsNotChosenIsSaid_data()
{
    QTest::addColumn<Rule>("rule");
    QTest::addColumn<int>("gap");
    const auto row = [](const char* name, const Rule& rule, RuleGap gap) {
        QTest::newRow(name) << rule << static_cast<int>(gap);
    };
    const auto doing = [&](const char* name, const Action& action, RuleGap gap) {
        row(name, ruleOf(1, "go", {action}), gap);
    };
    const Action stop = actions::Stop();
    row("no event", ruleOf(1, "", {stop}), RuleGap::Event);
    row("nothing to do", ruleOf(1, "go", {}), RuleGap::Deed);
    Rule arrived = ruleOf(1, "", {stop});
    arrived.trigger = triggers::Arrived{kNotChosen};
    row("a place to arrive at", arrived, RuleGap::Place);
    Rule ahead = ruleOf(1, "", {stop});
    ahead.trigger = triggers::AheadFree{kNotChosen};
    row("a path to move up on", ahead, RuleGap::Path);
    doing("a clip to play", actions::PlayClip(), RuleGap::Clip);
    doing("a path to walk", actions::FollowPath(), RuleGap::Path);
    doing("a place to go to", actions::GoToPlace(), RuleGap::Place);
    doing("a place to appear at", actions::Appear(), RuleGap::Place);
    doing("an event to send", actions::SendEvent(), RuleGap::SentEvent);
    doing("an event to wait for", actions::WaitForEvent(), RuleGap::AwaitedEvent);
    doing("a number to set", actions::SetNumber(), RuleGap::Number);
    doing("a state to take on", actions::TakeOnState(), RuleGap::State);
    doing("a light to tell", actions::TellLight(), RuleGap::Light);
    actions::TurnTo turn;
    turn.aim = ActionAim::Place;
    row("a place to turn to", ruleOf(1, "go", {stop, turn}), RuleGap::Place);
    actions::LeaveScene leave;
    leave.place = kNotChosen;
    row("a place to leave at", ruleOf(1, "go", {leave}), RuleGap::Place);
    actions::GoToPlace lineUp;
    lineUp.choice = PlaceChoice::FirstFree;
    lineUp.path = kNotChosen;
    row("a path to line up on", ruleOf(1, "go", {lineUp}), RuleGap::Path);
    Rule inPlace = ruleOf(1, "go", {stop});
    inPlace.conditions = {conditions::InPlace()};
    row("a place to be in", inPlace, RuleGap::Place);
    inPlace.conditions = {conditions::OfTemplate()};
    row("a template", inPlace, RuleGap::Template);
}

void TestRuleFlaws::whatIsNotChosenIsSaid()
{
    QFETCH(const Rule, rule);
    QFETCH(const int, gap);
    QVERIFY(gapOf(rule).has_value());
    QCOMPARE(static_cast<int>(*gapOf(rule)), gap);
    const Scene scene = sceneOf({rule});
    QCOMPARE(flawsOf(scene).size(), std::size_t{1});
    QVERIFY(englishOf(flawsOf(scene)[0], scene).starts_with("Rule \"rule 1\" does nothing yet: "));
}

void TestRuleFlaws::whatIsChosenIsComplete_data()
{
    QTest::addColumn<Rule>("rule");
    QTest::newRow("leave where they are") << ruleOf(1, "go", {actions::LeaveScene()});
    actions::GoToPlace nearest;
    nearest.choice = PlaceChoice::Nearest;
    QTest::newRow("the nearest of all places") << ruleOf(1, "go", {nearest});
    Rule any = ruleOf(1, "", {actions::Stop()});
    any.trigger = triggers::Arrived();
    QTest::newRow("at any place") << any;
    actions::GoToPlace gone;
    gone.place = 77;
    QTest::newRow("a place that is gone is said while it runs") << ruleOf(1, "go", {gone});
}

void TestRuleFlaws::whatIsChosenIsComplete()
{
    QFETCH(const Rule, rule);
    QVERIFY(!gapOf(rule).has_value());
    QVERIFY(flawsOf(sceneOf({rule})).empty());
}

void TestRuleFlaws::conditionsThatExcludeEachOtherAreSaid_data()
{
    QTest::addColumn<std::vector<Condition>>("conditions");
    QTest::addColumn<bool>("isAnyEnough");
    QTest::addColumn<bool>("isSaid");
    const auto row = [](const char* name, std::vector<Condition> conditions, bool isSaid,
                        bool isAnyEnough = false) {
        QTest::newRow(name) << std::move(conditions) << isAnyEnough << isSaid;
    };
    using conditions::Payload;
    using conditions::Speed;
    const Condition seated = conditions::IsSeated();
    const Condition standing(conditions::IsSeated(), true);
    row("seated and not", {seated, standing}, true);
    row("seated or not", {seated, standing}, false, true);
    row("seated twice", {seated, seated}, false);
    const Condition fast = compared<Speed>(Comparison::More, 2.0F);
    const Condition slow = compared<Speed>(Comparison::Less, 2.0F);
    row("above and below the same", {fast, slow}, true);
    row("above 1, below 2", {compared<Speed>(Comparison::More, 1.0F), slow}, false);
    row("not below and not above",
        {compared<Speed>(Comparison::Less, 2.0F, true),
         compared<Speed>(Comparison::More, 2.0F, true)},
        false);
    row("at 1 and at 2",
        {compared<Payload>(Comparison::Equal, 1.0F), compared<Payload>(Comparison::Equal, 2.0F)},
        true);
    row("a speed below 0", {compared<Speed>(Comparison::Less, 0.0F)}, true);
    row("a payload below 0", {compared<Payload>(Comparison::Less, 0.0F)}, false);
    const Condition man = conditions::OfTemplate{1};
    const Condition woman = conditions::OfTemplate{2};
    row("of two templates", {man, woman}, true);
    Condition notWoman = woman;
    notWoman.isNot = true;
    row("of one and not of the other", {man, notWoman}, false);
    row("no chance", {conditions::Chance{0.0F}}, true);
    const Condition chance = conditions::Chance();
    const Condition except(conditions::Chance(), true);
    row("two draws", {chance, except}, false);
}

void TestRuleFlaws::conditionsThatExcludeEachOtherAreSaid()
{
    QFETCH(const std::vector<Condition>, conditions);
    QFETCH(const bool, isAnyEnough);
    QFETCH(const bool, isSaid);
    Rule rule = ruleOf(1, "go", {actions::Stop()});
    rule.conditions = conditions;
    rule.isAnyEnough = isAnyEnough;
    const std::vector<RuleFlaw> flaws = flawsOf(sceneOf({rule}));
    const std::vector<RuleFlaw> expected{{1, RuleFlawKind::NeverTrue}};
    QCOMPARE(flaws, isSaid ? expected : std::vector<RuleFlaw>());
}

void TestRuleFlaws::whatNeverComesIsSaid()
{
    const Rule upper = ruleOf(1, "go", {actions::Stop()});
    Rule lower = ruleOf(2, "go", {actions::Wait()});
    const auto flaws = [&] { return flawsOf(sceneOf({upper, lower})); };
    QCOMPARE(flaws(), (std::vector<RuleFlaw>{{2, RuleFlawKind::Hidden, {}, 1}}));
    QVERIFY(englishOf(flaws()[0], sceneOf({upper, lower})).find("rule \"rule 1\" above it") !=
            std::string::npos);
    lower.meeting = RuleMeeting::Queue;
    QVERIFY(flaws().empty());
    lower.meeting = RuleMeeting::Interrupt;
    lower.trigger = triggers::Event{"other"};
    QVERIFY(flaws().empty());
    // One for those who sit and one for the others.
    Rule seated = upper;
    seated.conditions = {conditions::IsSeated()};
    lower.trigger = triggers::Event{"go"};
    lower.conditions = {{conditions::IsSeated(), true}};
    QVERIFY(flawsOf(sceneOf({seated, lower})).empty());
}

void TestRuleFlaws::whatIsBrokenOffAtOnceIsSaid()
{
    Rule upper = ruleOf(1, "go", {actions::Wait()});
    upper.yields = RuleYield::Anybody;
    const Rule lower = ruleOf(2, "go", {actions::Stop()});
    QCOMPARE(flawsOf(sceneOf({upper, lower})),
             (std::vector<RuleFlaw>{{1, RuleFlawKind::BrokenOff, {}, 2}}));
}

void TestRuleFlaws::whatIsUndoneIsSaid()
{
    const Rule add = ruleOf(1, "go", {actions::AddTag()});
    Rule remove = ruleOf(2, "go", {actions::RemoveTag()});
    remove.meeting = RuleMeeting::Queue;
    QCOMPARE(flawsOf(sceneOf({add, remove})),
             (std::vector<RuleFlaw>{{2, RuleFlawKind::Undone, {}, 1}}));
    remove.actions = {actions::RemoveTag{3}};
    QVERIFY(flawsOf(sceneOf({add, remove})).empty());
}

void TestRuleFlaws::whoeverItCameFromIsSomebody()
{
    actions::Follow after; // whoever it came from
    Rule rule = ruleOf(1, "go", {after});
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.trigger = triggers::TagNear();
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.trigger = triggers::Start();
    QCOMPARE(flawsOf(sceneOf({rule})), (std::vector<RuleFlaw>{{1, RuleFlawKind::NoSender}}));
    rule.actions = {actions::WaitForEvent{"go", 0.0F}, after};
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.actions = {after, actions::WaitForEvent{"go", 0.0F}};
    QCOMPARE(flawsOf(sceneOf({rule})), (std::vector<RuleFlaw>{{1, RuleFlawKind::NoSender}}));
    rule.actions = {actions::Flee()}; // anywhere then, as animals wander
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    after.aim = ActionAim::Tagged;
    rule.actions = {after};
    QVERIFY(flawsOf(sceneOf({rule})).empty());
}

void TestRuleFlaws::theNumberOfAnEventComesWithOne()
{
    Rule rule = ruleOf(1, "go", {actions::SetSpeed()}); // the event's
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.trigger = triggers::Every();
    QCOMPARE(flawsOf(sceneOf({rule})), (std::vector<RuleFlaw>{{1, RuleFlawKind::NoPayload}}));
    rule.actions = {actions::SetSpeed{1.5F}};
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.conditions = {compared<conditions::Payload>(Comparison::More, 1.0F)};
    QCOMPARE(flawsOf(sceneOf({rule})), (std::vector<RuleFlaw>{{1, RuleFlawKind::NoPayload}}));
}

void TestRuleFlaws::whatIsNeverReachedIsSaid()
{
    Rule rule = ruleOf(1, "go", {actions::Stop(), actions::Again()});
    QVERIFY(flawsOf(sceneOf({rule})).empty());
    rule.actions.emplace_back(actions::AddTag());
    QCOMPARE(flawsOf(sceneOf({rule})), (std::vector<RuleFlaw>{{1, RuleFlawKind::AfterAgain}}));
    // One of several that begins anew keeps the others from nothing.
    Action first = actions::OneOf();
    Action again = actions::Again();
    again.depth = 1;
    Action second = actions::OneOf();
    Action stop = actions::Stop();
    stop.depth = 1;
    rule.actions = {first, again, second, stop, actions::AddTag()};
    QVERIFY(flawsOf(sceneOf({rule})).empty());
}

void TestRuleFlaws::seatsAndExitsThatAreMissingAreSaid()
{
    actions::LeaveScene leave;
    leave.choice = PlaceChoice::Nearest;
    Scene scene = sceneOf({ruleOf(1, "sit", {actions::SitDown()}), ruleOf(2, "home", {leave})});
    QCOMPARE(flawsOf(scene),
             (std::vector<RuleFlaw>{{1, RuleFlawKind::NoSeats}, {2, RuleFlawKind::NoExit}}));
    auto asset = std::make_shared<StageAsset>();
    asset->seats.emplace_back();
    scene.stages.emplace_back().asset = asset;
    Place exit;
    exit.id = 1;
    exit.role = PlaceRole::Exit;
    scene.places.push_back(exit);
    QVERIFY(flawsOf(scene).empty());
}

void TestRuleFlaws::rulesThatAreOffAreNotSaid()
{
    Rule rule = ruleOf(1, "", {});
    rule.isEnabled = false;
    QVERIFY(flawsOf(sceneOf({rule})).empty());
}

CROWD_TEST(TestRuleFlaws)
#include "tst_RuleFlaws.moc"
