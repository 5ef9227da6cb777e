// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtTest/QTest>

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/ActionRunner.h"
#include "behavior/rules/ControlFlow.h"
#include "behavior/rules/EventDelivery.h"
#include "behavior/rules/RuleConditions.h"
#include "behavior/rules/RuleFiring.h"
#include "behavior/rules/RuleTriggers.h"
#include "tests/behavior/FakeRuleHost.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::behavior;
using crowd::testing::FakeRuleHost;
using model::Action;
using model::Rule;
namespace actions = model::actions;
namespace conditions = model::conditions;
namespace triggers = model::triggers;

namespace {

using Lines = std::vector<std::string>;

Rule ruleOf(model::RuleId id, model::Trigger trigger, std::vector<Action> actions)
{
    Rule rule;
    rule.id = id;
    rule.name = "rule " + std::to_string(id);
    rule.trigger = std::move(trigger);
    rule.actions = std::move(actions);
    return rule;
}

/// Three people, no session.
struct Stage
{
    FakeRuleHost host{3};
    RuleState state;
    RuleScope scope{state, host};

    explicit Stage(const std::vector<Rule>& rules)
    {
        const std::vector<model::IndividualId> ids{1, 2, 3};
        const std::vector<std::uint64_t> tags(3);
        const std::vector<std::uint32_t> keep(3, kNoAgent);
        state.agents.setPeople(ids, tags, keep);
        state.numbers.setPeople(ids, keep);
        state.log.setPeople(keep);
        for (const Rule& rule : rules) {
            state.rules.push_back(
                {rule, false, std::vector<RuleAgentState>(3), std::vector<double>(3, kDueUnknown)});
        }
        state.budget = {1000, 1000, 1000};
    }
    void setTime(double seconds)
    {
        state.clock = {static_cast<std::uint64_t>(seconds * 30.0), seconds};
    }
    [[nodiscard]] std::vector<std::uint64_t> counts() const
    {
        std::vector<std::uint64_t> counted;
        for (const ActiveRule& rule : state.rules) {
            counted.push_back(state.log.count(rule.data.id));
        }
        return counted;
    }
};

using Counts = std::vector<std::uint64_t>;

} // namespace

/// Each stage of the rule engine by itself, over people who do nothing of their own.
class TestRuleStages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTriggerFiresForThoseToWhomItHappened();
    void whoHasLeftIsAskedByNoTrigger();
    void triggersOfTravelAskTravellersAlone();
    void conditionsAreAllOrAny();
    void anEventReachesTheRulesThatWaitForIt();
    void eventsBeyondTheBudgetWait();
    void aBusyAgentIsInterruptedQueuedOrLeft();
    void linesRunUntilOneTakesTime();
    void aRuleThatTakesNoTimeIsEnded();
    void loopsCountTheirRounds();
    void aClipThatEndsFiresOtherRules();
    void drawsDependOnWhatKeysThem();
    void whoeverIsNearIsFoundWithoutAskingEverybody();
};

void TestRuleStages::aTriggerFiresForThoseToWhomItHappened()
{
    Stage stage({ruleOf(1, triggers::Start{}, {}), ruleOf(2, triggers::SpeedLimit{}, {})});
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{3, 0}));
    stage.host.speeds[1] = 5.0F;
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{3, 0})); // busy, and the second rule stands below the first
    for (std::uint32_t agent = 0; agent < 3; ++agent) {
        stage.state.agents.setRule(agent, kNoRule);
    }
    stage.host.speeds[2] = 5.0F;
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{3, 1}));
}

void TestRuleStages::whoHasLeftIsAskedByNoTrigger()
{
    Stage stage({ruleOf(1, triggers::Start{}, {})});
    stage.host.gone[1] = 1;
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{2}));
    stage.state.rules[0].reachesGone = true;
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{3}));
}

void TestRuleStages::triggersOfTravelAskTravellersAlone()
{
    Stage stage({ruleOf(1, triggers::PathEnded{}, {})});
    stage.host.events = {kEndedPath, 0, kEndedPath};
    stage.host.paths = {1, 1, 1};
    stage.state.travellers = {2};
    evaluateTriggers(stage.scope);
    QCOMPARE(stage.counts(), (Counts{1}));
    QCOMPARE(stage.state.agents[2].rule, std::uint32_t(0));
    QCOMPARE(stage.state.agents[0].rule, kNoRule);
}

void TestRuleStages::conditionsAreAllOrAny()
{
    Stage stage({});
    stage.state.agents[0].tags = 0b10;
    Rule rule = ruleOf(1, triggers::Start{}, {});
    rule.conditions = {conditions::HasTag{1}, conditions::IsSeated{}};
    QVERIFY(!conditionsHold(stage.scope, rule, 0, {}));
    rule.isAnyEnough = true;
    QVERIFY(conditionsHold(stage.scope, rule, 0, {}));
    QVERIFY(!conditionsHold(stage.scope, rule, 1, {}));
    rule.isAnyEnough = false;
    rule.conditions[1].isNot = true;
    QVERIFY(conditionsHold(stage.scope, rule, 0, {}));
    rule.conditions = {conditions::Payload{model::Comparison::More, 2.0F}};
    QVERIFY(!conditionsHold(stage.scope, rule, 0, {2.0F}));
    QVERIFY(conditionsHold(stage.scope, rule, 0, {2.5F}));
}

void TestRuleStages::anEventReachesTheRulesThatWaitForIt()
{
    Stage stage({ruleOf(1, triggers::Event{"clap"}, {actions::WaitForEvent{"go", 0.0F}}),
                 ruleOf(2, triggers::Event{"boo"}, {})});
    stage.state.events.post({0.0, "clap", 0.5F, 2, {}, 0});
    stage.state.events.post({0.0, "clap", 0.5F, 99, {}, 0}); // nobody is called that
    deliverEvents(stage.scope);
    QCOMPARE(stage.counts(), (Counts{1, 0}));
    QCOMPARE(stage.state.agents[1].context.payload, 0.5F);
    runAgents(stage.scope);
    QVERIFY(!stage.state.agents[1].progress.hasHeardEvent);
    notify(stage.scope, 1, {0.0, "go", 0.75F, 2, {}, 3});
    QVERIFY(stage.state.agents[1].progress.hasHeardEvent);
    QCOMPARE(stage.state.agents[1].context.sender, model::IndividualId(3));
    runAgents(stage.scope);
    QCOMPARE(stage.state.agents[1].rule, kNoRule);
}

void TestRuleStages::eventsBeyondTheBudgetWait()
{
    Stage stage({ruleOf(1, triggers::Event{"clap"}, {})});
    for (model::IndividualId id = 1; id <= 3; ++id) {
        stage.state.events.post({0.0, "clap", 0.0F, id, {}, 0});
    }
    stage.state.budget.heard = 2;
    deliverEvents(stage.scope);
    QCOMPARE(stage.counts(), (Counts{2}));
    QCOMPARE(stage.state.problems.all().size(), std::size_t(1));
    stage.state.budget.heard = 2;
    deliverEvents(stage.scope);
    QCOMPARE(stage.counts(), (Counts{3}));
    QCOMPARE(stage.state.problems.all().size(), std::size_t(1)); // said once
}

void TestRuleStages::aBusyAgentIsInterruptedQueuedOrLeft()
{
    Rule first = ruleOf(1, triggers::Event{"a"}, {});
    Rule second = ruleOf(2, triggers::Event{"b"}, {});
    const auto fireBoth = [&](model::RuleMeeting meeting, model::RuleYield yields) {
        second.meeting = meeting;
        first.yields = yields;
        Stage stage({first, second});
        fire(stage.scope, 0, 0, {});
        fire(stage.scope, 1, 0, {});
        return std::pair(stage.state.agents[0].rule, stage.state.agents[0].queue.size());
    };
    using Outcome = std::pair<std::uint32_t, std::size_t>;
    using enum model::RuleMeeting;
    using enum model::RuleYield;
    QCOMPARE(fireBoth(Interrupt, FurtherUp), (Outcome{0, 0}));
    QCOMPARE(fireBoth(Interrupt, Anybody), (Outcome{1, 0}));
    QCOMPARE(fireBoth(Interrupt, Nobody), (Outcome{0, 0}));
    QCOMPARE(fireBoth(Queue, Anybody), (Outcome{0, 1}));
    QCOMPARE(fireBoth(Ignore, Anybody), (Outcome{0, 0}));
}

void TestRuleStages::linesRunUntilOneTakesTime()
{
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}};
    Stage stage({ruleOf(1, triggers::Start{}, {actions::Stop{}, clap, actions::GoOn{}})});
    fire(stage.scope, 0, 1, {});
    runAgents(stage.scope);
    QCOMPARE(stage.host.done, (Lines{"1 stop", "1 play clap"}));
    QCOMPARE(stage.state.agents[1].line, std::uint32_t(1));
    stage.setTime(1.4);
    runAgents(stage.scope);
    QCOMPARE(stage.host.done.size(), std::size_t(2));
    stage.setTime(1.5);
    runAgents(stage.scope);
    QCOMPARE(stage.host.done, (Lines{"1 stop", "1 play clap", "1 end clip", "1 go on"}));
    QCOMPARE(stage.state.agents[1].rule, kNoRule);
}

void TestRuleStages::aRuleThatTakesNoTimeIsEnded()
{
    Stage stage({ruleOf(1, triggers::Start{}, {actions::Stop{}, actions::Again{}})});
    stage.state.budget.actions = 10'000;
    fire(stage.scope, 0, 0, {});
    runAgent(stage.scope, 0);
    QCOMPARE(stage.state.agents[0].rule, kNoRule);
    QCOMPARE(stage.state.problems.all().size(), std::size_t(1));
    QCOMPARE(stage.state.problems.all()[0].rule, model::RuleId(1));
}

void TestRuleStages::loopsCountTheirRounds()
{
    const model::Actions lines{actions::Repeat{2}, Action(actions::Repeat{3}, 1),
                               Action(actions::Stop{}, 2), actions::GoOn{}};
    Stage stage({ruleOf(1, triggers::Start{}, lines)});
    fire(stage.scope, 0, 0, {});
    runAgent(stage.scope, 0);
    Lines expected(6, "0 stop");
    expected.emplace_back("0 go on");
    QCOMPARE(stage.host.done, expected);

    AgentRuleState empty;
    enterLoop(empty, {actions::Repeat{5}, actions::Stop{}}, 5); // nothing belongs to it
    QCOMPARE(empty.line, std::uint32_t(1));
    QVERIFY(empty.loops.empty());
}

void TestRuleStages::aClipThatEndsFiresOtherRules()
{
    Stage stage({ruleOf(1, triggers::ClipEnded{}, {actions::Stop{}}),
                 ruleOf(2, triggers::ClipEnded{}, {actions::GoOn{}})});
    stage.state.endedClips = {{2, 0, {}}}; // rule 1 itself had it played
    fireForEndedClips(stage.scope);
    QCOMPARE(stage.counts(), (Counts{0, 1}));
    QCOMPARE(stage.host.done, (Lines{"2 go on"}));
}

void TestRuleStages::drawsDependOnWhatKeysThem()
{
    Stage stage({});
    const float first = draw(stage.scope, 0, 5);
    QCOMPARE(draw(stage.scope, 0, 5), first);
    QVERIFY(draw(stage.scope, 1, 5) != first);
    QVERIFY(draw(stage.scope, 0, 6) != first);
    ++stage.state.agents[0].firings;
    QVERIFY(draw(stage.scope, 0, 5) != first);
}

void TestRuleStages::whoeverIsNearIsFoundWithoutAskingEverybody()
{
    const FakeRuleHost host(100);
    PeopleIndex index;
    const std::vector<std::uint32_t>* few = index.near(host, 50, 3.0F);
    QVERIFY(few != nullptr);
    QVERIFY(few->size() < 20);
    for (const std::uint32_t agent : {49U, 50U, 51U}) {
        QVERIFY(std::ranges::binary_search(*few, agent));
    }
    index.noteAppeared(7, host.position(50));
    QVERIFY(std::ranges::binary_search(*index.near(host, 50, 3.0F), 7U));
    QVERIFY(index.near(host, 50, 500.0F) == nullptr); // it is shorter to ask everybody
}

CROWD_TEST(TestRuleStages)
#include "tst_RuleStages.moc"
