// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleEngine.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "behavior/motion/TravelEvents.h"
#include "model/base/Random.h"
#include "model/rules/RuleFlaws.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxLog = 4096;
constexpr int kMaxActionsAtOnce = 1024;
constexpr double kLitSeconds = 0.5;
constexpr double kEchoSeconds = 0.2;
constexpr std::uint32_t kMaxEchoes = 30;
// What rules may do in a step, beside so much for everybody.
constexpr std::size_t kActionsInStep = 100'000;
constexpr std::size_t kHeardInStep = 50'000;
constexpr std::size_t kAskedInStep = 10'000'000;
constexpr std::size_t kActionsEach = 4;
constexpr std::size_t kHeardEach = 2;

bool bringsBack(const model::Rule& rule)
{
    return std::ranges::any_of(rule.actions, [](const model::Action& action) {
        return action.is<model::actions::Appear>();
    });
}

/// Where people line up: the places on which a rule lets them move up.
std::vector<PlaceWish> linesOf(const std::vector<model::Rule>& rules)
{
    std::vector<PlaceWish> lines;
    for (const model::Rule& rule : rules) {
        for (const model::Action& action : rule.actions) {
            const auto* go = action.as<model::actions::GoToPlace>();
            if (go != nullptr && go->choice == model::PlaceChoice::Ahead) {
                lines.push_back({go->choice, go->place, go->path});
            }
        }
    }
    return lines;
}

} // namespace

void RuleEngine::setRules(const model::Scene& scene, bool areNumbersKept)
{
    std::vector<model::Rule> rules;
    for (const model::Rule& rule : scene.rules) {
        if (rule.isEnabled && !model::gapOf(rule)) {
            rules.push_back(rule);
        }
    }
    std::vector<RuleMemory> memory(rules.size());
    std::vector<std::uint32_t> now(m_rules.size(), kNone);
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const auto former = std::ranges::find(m_rules, rules[i].id, &model::Rule::id);
        if (former != m_rules.end()) {
            const auto index = static_cast<std::size_t>(former - m_rules.begin());
            memory[i] = std::move(m_memory[index]);
            // One with other actions begins anew at its next occasion.
            now[index] =
                former->actions == rules[i].actions ? static_cast<std::uint32_t>(i) : kNone;
        }
        memory[i].resize(m_minds.size());
    }
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        const std::uint32_t former = m_minds[agent].rule;
        setBusy(agent, former == kNone ? kNone : now[former]);
    }
    m_rules = std::move(rules);
    m_memory = std::move(memory);
    m_bringsBack.clear();
    for (const model::Rule& rule : m_rules) {
        m_bringsBack.push_back(bringsBack(rule));
    }
    m_places.setPlaces(scene.places, scene.paths);
    m_places.setLines(linesOf(m_rules));
    m_seed = scene.seed;
    giveNumbers(scene, areNumbersKept);
    checkRules(scene);
}

/// What is wrong with them as they stand.
void RuleEngine::checkRules(const model::Scene& scene)
{
    m_problems.clear();
    for (const model::RuleFlaw& flaw : model::flawsOf(scene)) {
        complain({model::englishOf(flaw, scene), flaw.rule});
    }
}

/// Who begins with the same as before keeps what he has.
void RuleEngine::giveNumbers(const model::Scene& scene, bool areKept)
{
    if (m_numbers == scene.numbers) {
        return;
    }
    const std::vector<model::NumberName> former = std::exchange(m_numbers, scene.numbers);
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        const model::IndividualId id = m_agentOf[agent].first;
        std::vector<float> numbers;
        for (const model::NumberName& named : m_numbers) {
            const auto known = std::ranges::find(former, named.id, &model::NumberName::id);
            const float first = firstNumber(named, id);
            const bool keeps =
                known != former.end() && (areKept || firstNumber(*known, id) == first);
            numbers.push_back(
                keeps ? m_minds[agent].numbers[static_cast<std::size_t>(known - former.begin())]
                      : first);
        }
        m_minds[agent].numbers = std::move(numbers);
    }
    m_areNumbersStale = true;
}

/// What somebody begins with.
float RuleEngine::firstNumber(const model::NumberName& named, model::IndividualId id) const
{
    const auto own = std::ranges::lower_bound(named.values, id, {},
                                              &std::pair<model::IndividualId, float>::first);
    if (own != named.values.end() && own->first == id) {
        return own->second;
    }
    const float share = model::unitFloat(model::hashKeys(m_seed, id, named.id, 55));
    return named.low + (named.high - named.low) * share;
}

std::vector<float> RuleEngine::firstNumbers(model::IndividualId id) const
{
    std::vector<float> numbers;
    for (const model::NumberName& named : m_numbers) {
        numbers.push_back(firstNumber(named, id));
    }
    return numbers;
}

std::shared_ptr<const std::vector<OwnNumber>> RuleEngine::ownNumbers()
{
    if (m_areNumbersStale) {
        m_areNumbersStale = false;
        auto own = std::make_shared<std::vector<OwnNumber>>();
        for (std::size_t i = 0; i < m_numbers.size(); ++i) {
            for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
                const model::IndividualId id = m_agentOf[agent].first;
                const float value = m_minds[agent].numbers[i];
                if (value != firstNumber(m_numbers[i], id)) {
                    own->push_back({m_numbers[i].id, id, value});
                }
            }
        }
        m_ownNumbers = std::move(own);
    }
    return m_ownNumbers;
}

float RuleEngine::number(std::uint32_t agent, model::NumberId id) const
{
    const auto found = std::ranges::find(m_numbers, id, &model::NumberName::id);
    return found == m_numbers.end()
               ? 0.0F
               : m_minds[agent].numbers[static_cast<std::size_t>(found - m_numbers.begin())];
}

void RuleEngine::setPeople(const model::Population& people, std::span<const std::uint32_t> keep)
{
    const auto tags = people.column(model::columns::tags);
    std::vector<Mind> minds(keep.size());
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] != kNoAgent) {
            minds[i] = std::move(m_minds[keep[i]]);
        } else {
            minds[i].tags = tags[i];
            minds[i].numbers = firstNumbers(people.ids()[i]);
        }
    }
    for (RuleMemory& memory : m_memory) {
        RuleMemory kept;
        kept.resize(keep.size());
        for (std::size_t i = 0; i < keep.size(); ++i) {
            if (keep[i] != kNoAgent) {
                kept.of[i] = memory.of[keep[i]];
                kept.due[i] = memory.due[keep[i]];
            }
        }
        memory = std::move(kept);
    }
    m_minds = std::move(minds);
    m_isBusy.resize(m_minds.size());
    m_lit.clear();
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        setBusy(agent, m_minds[agent].rule);
        if (m_minds[agent].litUntil >= 0.0) {
            m_lit.push_back(agent);
        }
    }
    m_agentOf.clear();
    for (std::size_t i = 0; i < keep.size(); ++i) {
        m_agentOf.emplace_back(people.ids()[i], static_cast<std::uint32_t>(i));
    }
}

void RuleEngine::setBusy(std::uint32_t agent, std::uint32_t rule)
{
    m_minds[agent].rule = rule;
    m_isBusy[agent] = rule != kNone ? 1 : 0;
}

std::uint32_t RuleEngine::nextBusy(std::uint32_t agent) const
{
    if (agent >= m_isBusy.size()) {
        return static_cast<std::uint32_t>(m_isBusy.size()); // nobody at all, perhaps
    }
    const std::uint8_t* from = m_isBusy.data() + agent;
    const void* found = std::memchr(from, 1, m_isBusy.size() - agent);
    return found == nullptr
               ? static_cast<std::uint32_t>(m_isBusy.size())
               : agent + static_cast<std::uint32_t>(static_cast<const std::uint8_t*>(found) - from);
}

void RuleEngine::setTags(std::uint32_t agent, std::uint64_t tags)
{
    m_minds[agent].tags = tags;
}

void RuleEngine::complain(Problem problem)
{
    if (std::ranges::find(m_problems, problem) == m_problems.end() && m_problems.size() < 50) {
        m_problems.push_back(std::move(problem));
    }
}

void RuleEngine::complainOf(std::uint32_t rule, const std::string& problem)
{
    complain({"Rule \"" + m_rules[rule].name + "\"" + problem, m_rules[rule].id});
}

std::uint64_t RuleEngine::count(model::RuleId rule) const
{
    const auto found = m_counts.find(rule);
    return found == m_counts.end() ? 0 : found->second;
}

std::vector<RuleFired> RuleEngine::takeLog()
{
    return std::exchange(m_log, {});
}

float RuleEngine::draw(RuleHost& host, std::uint32_t agent, std::uint64_t purpose) const
{
    return model::unitFloat(
        model::hashKeys(m_seed, host.id(agent), purpose, m_minds[agent].firings, m_step));
}

std::vector<std::uint32_t> RuleEngine::lit() const
{
    std::vector<std::uint32_t> lit = m_lit;
    std::ranges::sort(lit);
    return lit;
}

void RuleEngine::step(RuleHost& host, std::uint64_t step)
{
    m_step = step;
    m_now = static_cast<double>(step) / m_stepsPerSecond;
    m_places.forget();
    m_tagged.clear();
    m_cells.clear();
    m_groups.clear();
    m_carriers.clear();
    m_clipsEnded.clear();
    m_left = {kActionsInStep + kActionsEach * m_minds.size(),
              kHeardInStep + kHeardEach * m_minds.size(), kAskedInStep};
    m_isStormSaid = false;
    std::erase_if(m_lit, [this](std::uint32_t agent) {
        const bool isOut = m_minds[agent].litUntil <= m_now;
        m_minds[agent].litUntil = isOut ? -1.0 : m_minds[agent].litUntil;
        return isOut;
    });
    noteTravelEvents(host);
    deliver(host);
    endErrands(host);
    lookAround(host);
    goOnWithAll(host);
    endClips(host);
}

/// With those first to whom it did not come in the step before.
void RuleEngine::goOnWithAll(RuleHost& host)
{
    const auto all = static_cast<std::uint32_t>(m_minds.size());
    const std::uint32_t first = m_goesOnFirst < all ? m_goesOnFirst : 0;
    m_goesOnFirst = 0;
    for (const auto& [begin, end] : {std::pair(first, all), std::pair(0U, first)}) {
        for (std::uint32_t agent = nextBusy(begin); agent < end; agent = nextBusy(agent + 1)) {
            if (m_left.actions == 0) {
                m_goesOnFirst = agent;
                sayStorm(m_minds[agent].rule);
                return;
            }
            goOn(host, agent);
        }
    }
}

void RuleEngine::noteTravelEvents(const RuleHost& host)
{
    const std::span<const std::uint8_t> events = host.travelEvents();
    m_happenedTo.clear();
    for (std::uint32_t agent = 0; agent < events.size(); ++agent) {
        if (events[agent] != 0) {
            m_happenedTo.push_back(agent);
            Mind& mind = m_minds[agent]; // before he sets out for somewhere else
            mind.arrived = (events[agent] & kEndedErrand) != 0 ? mind.goal : 0;
        }
    }
}

/// The errand that he is on: what happened in this step may be the end of the one before.
bool RuleEngine::hasErrandEnded(RuleHost& host, std::uint32_t agent) const
{
    return (host.travelEvents()[agent] & kEndedErrand) != 0 && m_minds[agent].setOutIn != m_step;
}

void RuleEngine::sendTo(RuleHost& host, std::uint32_t agent, const glm::vec3& point, float atLeast)
{
    m_minds[agent].setOutIn = m_step;
    host.sendTo(agent, point, atLeast);
}

/// Who has got where his rule sent him goes on with it, before others hear that he arrived.
void RuleEngine::endErrands(RuleHost& host)
{
    for (const std::uint32_t agent : m_happenedTo) {
        if (m_minds[agent].isTravelling && m_minds[agent].rule != kNone &&
            hasErrandEnded(host, agent)) {
            goOn(host, agent);
        }
    }
}

bool RuleEngine::holds(RuleHost& host, const model::Rule& rule, std::uint32_t agent,
                       const Cause& cause)
{
    bool isAny = rule.conditions.empty();
    bool areAll = true;
    for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
        const model::Condition& condition = rule.conditions[i];
        const bool isTrue = holds(host, condition, model::hashKeys(rule.id, i, 61), agent, cause) !=
                            condition.isNot;
        isAny = isAny || isTrue;
        areAll = areAll && isTrue;
    }
    return rule.isAnyEnough ? isAny : areAll;
}

bool RuleEngine::fire(RuleHost& host, std::uint32_t index, std::uint32_t agent, const Cause& cause)
{
    const model::Rule& rule = m_rules[index];
    Mind& mind = m_minds[agent];
    if (!isDue(index, agent) || !holds(host, rule, agent, cause)) {
        return false;
    }
    if (mind.rule != kNone) {
        if (rule.meeting == model::RuleMeeting::Queue && isQueueable(index, agent)) {
            mind.queue.push_back({rule.id, cause});
            return true;
        }
        if (rule.meeting != model::RuleMeeting::Interrupt || !mayBreakOff(mind.rule, index)) {
            return false;
        }
        host.endClip(agent);
    }
    begin(host, index, agent, cause);
    return true;
}

bool RuleEngine::isDue(std::uint32_t index, std::uint32_t agent) const
{
    const model::Rule& rule = m_rules[index];
    const Memory& memory = m_memory[index].of[agent];
    return m_now >= memory.last + static_cast<double>(rule.cooldownSeconds) &&
           (rule.limit == 0 || memory.count < rule.limit);
}

bool RuleEngine::mayBreakOff(std::uint32_t busy, std::uint32_t other) const
{
    switch (m_rules[busy].yields) {
    case model::RuleYield::FurtherUp:
        return other <= busy;
    case model::RuleYield::Anybody:
        return true;
    case model::RuleYield::Nobody:
        break;
    }
    return false;
}

/// Events that people send each other round and round, as fast as steps follow each other.
void RuleEngine::noticeEcho(std::uint32_t index, Memory& memory, const Cause& cause)
{
    memory.echoes =
        cause.sender != 0 && m_now - memory.last <= kEchoSeconds ? memory.echoes + 1 : 0;
    if (memory.echoes == kMaxEchoes) {
        complainOf(index,
                   " fires over and over for the same characters: events go round in a circle. "
                   "Give it a pause, or say how often at most.");
    }
}

void RuleEngine::begin(RuleHost& host, std::uint32_t index, std::uint32_t agent, const Cause& cause)
{
    Mind& mind = m_minds[agent];
    Memory& memory = m_memory[index].of[agent];
    noticeEcho(index, memory, cause);
    memory.last = m_now;
    ++memory.count;
    ++mind.firings;
    ++m_counts[m_rules[index].id];
    setBusy(agent, index);
    mind.action = 0;
    mind.turns = 0;
    mind.rounds.clear();
    mind.isStarted = false;
    mind.isTravelling = false;
    mind.ticket = 0;
    mind.cause = cause;
    if (mind.litUntil < 0.0) {
        m_lit.push_back(agent);
    }
    mind.litUntil = m_now + kLitSeconds;
    if (m_log.size() < kMaxLog) {
        m_log.push_back({m_now, m_rules[index].id, host.id(agent)});
    }
}

void RuleEngine::goOn(RuleHost& host, std::uint32_t agent)
{
    Mind& mind = m_minds[agent];
    for (int count = 0; mind.rule != kNone; ++count) {
        if (count > 0 && m_left.actions == 0) {
            sayStorm(mind.rule);
            return; // in the next step
        }
        m_left.actions -= std::min<std::size_t>(1, m_left.actions);
        const std::vector<model::Action>& actions = m_rules[mind.rule].actions;
        if (count > kMaxActionsAtOnce) {
            complainOf(mind.rule, " repeats without any time passing: let it wait or play a clip. "
                                  "It was ended.");
            setBusy(agent, kNone);
            return;
        }
        if (mind.action >= actions.size()) {
            setBusy(agent, kNone);
            takeNextOfQueue(host, agent);
            continue;
        }
        const std::uint32_t rule = mind.rule;
        if (branch(host, agent, actions)) {
            continue;
        }
        if (!run(host, agent, actions[mind.action])) {
            return;
        }
        if (mind.rule == rule) {
            mind.action = lineAfter(mind, actions, mind.action);
            mind.isStarted = false;
            mind.isTravelling = false;
            mind.ticket = 0;
        }
    }
}

} // namespace crowd::behavior
