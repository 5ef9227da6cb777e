// SPDX-License-Identifier: MIT
#include <functional>

#include <QtTest/QTest>

#include "model/scene/RuleFlaws.h"
#include "model/scene/RuleSets.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

Action actionOf(ActionKind kind)
{
    Action made;
    made.kind = kind;
    return made;
}

Rule ruleOf(RuleId id, const char* event, std::vector<Action> actions)
{
    Rule rule;
    rule.id = id;
    rule.name = "rule " + std::to_string(id);
    rule.trigger.event = event;
    rule.actions = std::move(actions);
    return rule;
}

Condition conditionOf(ConditionKind kind, bool isNot = false)
{
    Condition made;
    made.kind = kind;
    made.isNot = isNot;
    return made;
}

Condition compared(ConditionKind kind, Comparison comparison, float value, bool isNot = false)
{
    Condition made = conditionOf(kind, isNot);
    made.comparison = comparison;
    made.value = value;
    return made;
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
    void rulesThatAreOffAreNotSaid();
};

void TestRuleFlaws::whatIsNotChosenIsSaid_data()
{
    QTest::addColumn<Rule>("rule");
    QTest::addColumn<int>("gap");
    const auto row = [](const char* name, const Rule& rule, RuleGap gap) {
        QTest::newRow(name) << rule << static_cast<int>(gap);
    };
    const auto doing = [&](const char* name, ActionKind kind, RuleGap gap) {
        row(name, ruleOf(1, "go", {actionOf(kind)}), gap);
    };
    const Action stop = actionOf(ActionKind::Stop);
    row("no event", ruleOf(1, "", {stop}), RuleGap::Event);
    row("nothing to do", ruleOf(1, "go", {}), RuleGap::Deed);
    Rule arrived = ruleOf(1, "", {stop});
    arrived.trigger.kind = TriggerKind::Arrived;
    arrived.trigger.place = kNotChosen;
    row("a place to arrive at", arrived, RuleGap::Place);
    Rule ahead = ruleOf(1, "", {stop});
    ahead.trigger.kind = TriggerKind::AheadFree;
    ahead.trigger.path = kNotChosen;
    row("a path to move up on", ahead, RuleGap::Path);
    doing("a clip to play", ActionKind::PlayClip, RuleGap::Clip);
    doing("a path to walk", ActionKind::FollowPath, RuleGap::Path);
    doing("a place to go to", ActionKind::GoToPlace, RuleGap::Place);
    doing("a place to appear at", ActionKind::Appear, RuleGap::Place);
    doing("an event to send", ActionKind::SendEvent, RuleGap::SentEvent);
    doing("an event to wait for", ActionKind::WaitForEvent, RuleGap::AwaitedEvent);
    doing("a number to set", ActionKind::SetNumber, RuleGap::Number);
    Action turn = actionOf(ActionKind::TurnTo);
    turn.aim = ActionAim::Place;
    row("a place to turn to", ruleOf(1, "go", {stop, turn}), RuleGap::Place);
    Action leave = actionOf(ActionKind::LeaveScene);
    leave.place = kNotChosen;
    row("a place to leave at", ruleOf(1, "go", {leave}), RuleGap::Place);
    Action lineUp = actionOf(ActionKind::GoToPlace);
    lineUp.choice = PlaceChoice::FirstFree;
    lineUp.path = kNotChosen;
    row("a path to line up on", ruleOf(1, "go", {lineUp}), RuleGap::Path);
    Rule inPlace = ruleOf(1, "go", {stop});
    inPlace.conditions = {conditionOf(ConditionKind::InPlace)};
    row("a place to be in", inPlace, RuleGap::Place);
    inPlace.conditions = {conditionOf(ConditionKind::OfTemplate)};
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
    QTest::newRow("leave where they are") << ruleOf(1, "go", {actionOf(ActionKind::LeaveScene)});
    Action nearest = actionOf(ActionKind::GoToPlace);
    nearest.choice = PlaceChoice::Nearest;
    QTest::newRow("the nearest of all places") << ruleOf(1, "go", {nearest});
    Rule any = ruleOf(1, "", {actionOf(ActionKind::Stop)});
    any.trigger.kind = TriggerKind::Arrived;
    QTest::newRow("at any place") << any;
    Action gone = actionOf(ActionKind::GoToPlace);
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
    using Kind = ConditionKind;
    const Condition seated = conditionOf(Kind::IsSeated);
    const Condition standing = conditionOf(Kind::IsSeated, true);
    row("seated and not", {seated, standing}, true);
    row("seated or not", {seated, standing}, false, true);
    row("seated twice", {seated, seated}, false);
    const Condition fast = compared(Kind::Speed, Comparison::More, 2.0F);
    const Condition slow = compared(Kind::Speed, Comparison::Less, 2.0F);
    row("above and below the same", {fast, slow}, true);
    row("above 1, below 2", {compared(Kind::Speed, Comparison::More, 1.0F), slow}, false);
    row("not below and not above",
        {compared(Kind::Speed, Comparison::Less, 2.0F, true),
         compared(Kind::Speed, Comparison::More, 2.0F, true)},
        false);
    row("at 1 and at 2",
        {compared(Kind::Payload, Comparison::Equal, 1.0F),
         compared(Kind::Payload, Comparison::Equal, 2.0F)},
        true);
    row("a speed below 0", {compared(Kind::Speed, Comparison::Less, 0.0F)}, true);
    row("a payload below 0", {compared(Kind::Payload, Comparison::Less, 0.0F)}, false);
    Condition man = conditionOf(Kind::OfTemplate);
    man.templateId = 1;
    Condition woman = man;
    woman.templateId = 2;
    row("of two templates", {man, woman}, true);
    Condition notWoman = woman;
    notWoman.isNot = true;
    row("of one and not of the other", {man, notWoman}, false);
    Condition never = conditionOf(Kind::Chance);
    never.chance = 0.0F;
    row("no chance", {never}, true);
    const Condition chance = conditionOf(Kind::Chance);
    const Condition except = conditionOf(Kind::Chance, true);
    row("two draws", {chance, except}, false);
}

void TestRuleFlaws::conditionsThatExcludeEachOtherAreSaid()
{
    QFETCH(const std::vector<Condition>, conditions);
    QFETCH(const bool, isAnyEnough);
    QFETCH(const bool, isSaid);
    Rule rule = ruleOf(1, "go", {actionOf(ActionKind::Stop)});
    rule.conditions = conditions;
    rule.isAnyEnough = isAnyEnough;
    const std::vector<RuleFlaw> flaws = flawsOf(sceneOf({rule}));
    const std::vector<RuleFlaw> expected{{1, RuleFlawKind::NeverTrue}};
    QCOMPARE(flaws, isSaid ? expected : std::vector<RuleFlaw>());
}

void TestRuleFlaws::whatNeverComesIsSaid()
{
    const Rule upper = ruleOf(1, "go", {actionOf(ActionKind::Stop)});
    Rule lower = ruleOf(2, "go", {actionOf(ActionKind::Wait)});
    const auto flaws = [&] { return flawsOf(sceneOf({upper, lower})); };
    QCOMPARE(flaws(), (std::vector<RuleFlaw>{{2, RuleFlawKind::Hidden, {}, 1}}));
    QVERIFY(englishOf(flaws()[0], sceneOf({upper, lower})).find("rule \"rule 1\" above it") !=
            std::string::npos);
    lower.meeting = RuleMeeting::Queue;
    QVERIFY(flaws().empty());
    lower.meeting = RuleMeeting::Interrupt;
    lower.trigger.event = "other";
    QVERIFY(flaws().empty());
    // One for those who sit and one for the others.
    Rule seated = upper;
    seated.conditions = {conditionOf(ConditionKind::IsSeated)};
    lower.trigger.event = "go";
    lower.conditions = {conditionOf(ConditionKind::IsSeated, true)};
    QVERIFY(flawsOf(sceneOf({seated, lower})).empty());
}

void TestRuleFlaws::whatIsBrokenOffAtOnceIsSaid()
{
    Rule upper = ruleOf(1, "go", {actionOf(ActionKind::Wait)});
    upper.yields = RuleYield::Anybody;
    const Rule lower = ruleOf(2, "go", {actionOf(ActionKind::Stop)});
    QCOMPARE(flawsOf(sceneOf({upper, lower})),
             (std::vector<RuleFlaw>{{1, RuleFlawKind::BrokenOff, {}, 2}}));
}

void TestRuleFlaws::whatIsUndoneIsSaid()
{
    const Rule add = ruleOf(1, "go", {actionOf(ActionKind::AddTag)});
    Rule remove = ruleOf(2, "go", {actionOf(ActionKind::RemoveTag)});
    remove.meeting = RuleMeeting::Queue;
    QCOMPARE(flawsOf(sceneOf({add, remove})),
             (std::vector<RuleFlaw>{{2, RuleFlawKind::Undone, {}, 1}}));
    remove.actions[0].tag = 3;
    QVERIFY(flawsOf(sceneOf({add, remove})).empty());
}

void TestRuleFlaws::seatsAndExitsThatAreMissingAreSaid()
{
    Action leave = actionOf(ActionKind::LeaveScene);
    leave.choice = PlaceChoice::Nearest;
    Scene scene =
        sceneOf({ruleOf(1, "sit", {actionOf(ActionKind::SitDown)}), ruleOf(2, "home", {leave})});
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
