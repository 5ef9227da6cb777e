// SPDX-License-Identifier: MIT
#include <algorithm>

#include "behavior/rules/RuleEngine.h"
#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"

/// In which order rules do what they do: what repeats, what is one of several, and what comes
/// after.
namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxQueue = 8;

} // namespace

std::size_t RuleEngine::drawAlternative(RuleHost& host, std::uint32_t agent,
                                        const model::Actions& actions,
                                        const std::vector<std::size_t>& lines) const
{
    const Mind& mind = m_minds[agent];
    const float share = draw(host, agent, model::hashKeys(mind.action, 72, mind.turns));
    return lines[model::weightedIndex(lines, share, [&actions](std::size_t line) {
        return actions[line].as<model::actions::OneOf>()->weight;
    })];
}

bool RuleEngine::branch(RuleHost& host, std::uint32_t agent, const model::Actions& actions)
{
    Mind& mind = m_minds[agent];
    const std::size_t line = mind.action;
    if (actions[line].is<model::actions::Again>()) {
        mind.rounds.clear();
        ++mind.turns;
        mind.action = 0;
        return true;
    }
    if (const auto* repeat = actions[line].as<model::actions::Repeat>()) {
        std::erase_if(mind.rounds, [line](const Round& round) { return round.line >= line; });
        if (model::endOf(actions, line) == line + 1) {
            mind.action = lineAfter(mind, actions, line); // there is nothing in it
        } else {
            mind.rounds.push_back({mind.action, repeat->times});
            ++mind.action;
        }
        return true;
    }
    if (actions[line].is<model::actions::OneOf>()) {
        const std::vector<std::size_t> lines = model::alternativesOf(actions, line);
        const std::size_t chosen = drawAlternative(host, agent, actions, lines);
        ++mind.turns;
        mind.action = model::endOf(actions, chosen) == chosen + 1
                          ? lineAfter(mind, actions, lines.back())
                          : static_cast<std::uint32_t>(chosen + 1);
        return true;
    }
    return false;
}

/// Whether what belongs to a Repeat comes once more.
bool RuleEngine::goesRound(Mind& mind, const model::actions::Repeat& repeat, std::size_t line) const
{
    const auto round = std::ranges::find(mind.rounds, line, &Round::line);
    if (round == mind.rounds.end()) {
        return false;
    }
    ++mind.turns;
    if (repeat.times != 0 && --round->left == 0) {
        mind.rounds.erase(round, mind.rounds.end());
        return false;
    }
    return true;
}

std::uint32_t RuleEngine::lineAfter(Mind& mind, const model::Actions& actions,
                                    std::size_t line) const
{
    std::size_t next = model::endOf(actions, line);
    for (std::size_t parent = model::parentOf(actions, line);
         parent != model::kNoLine && next >= model::endOf(actions, parent);
         parent = model::parentOf(actions, parent)) {
        const auto* repeat = actions[parent].as<model::actions::Repeat>();
        if (repeat == nullptr) {
            next = model::endOf(actions, model::alternativesOf(actions, parent).back());
        } else if (goesRound(mind, *repeat, parent)) {
            return static_cast<std::uint32_t>(parent + 1);
        }
    }
    return static_cast<std::uint32_t>(next);
}

/// Those of the same rule that wait already count too.
bool RuleEngine::isQueueable(std::uint32_t index, std::uint32_t agent) const
{
    const model::Rule& rule = m_rules[index];
    const std::vector<Waiting>& queue = m_minds[agent].queue;
    const auto waiting = std::ranges::count(queue, rule.id, &Waiting::rule);
    return queue.size() < kMaxQueue && (rule.cooldownSeconds <= 0.0F || waiting == 0) &&
           (rule.limit == 0 ||
            m_memory[index].of[agent].count + static_cast<std::size_t>(waiting) < rule.limit);
}

void RuleEngine::takeNextOfQueue(RuleHost& host, std::uint32_t agent)
{
    Mind& mind = m_minds[agent];
    while (mind.rule == kNone && !mind.queue.empty()) {
        const Waiting next = mind.queue.front();
        mind.queue.erase(mind.queue.begin());
        const auto found = std::ranges::find(m_rules, next.rule, &model::Rule::id);
        const auto index = static_cast<std::uint32_t>(found - m_rules.begin());
        if (found != m_rules.end() && isDue(index, agent)) {
            begin(host, index, agent, next.cause);
        }
    }
}

/// Rules that wait for a clip to be over. What else the rule that let it be played has to do comes
/// first.
void RuleEngine::endClips(RuleHost& host)
{
    for (std::size_t i = 0; i < m_clipsEnded.size(); ++i) {
        const ClipEnd end = m_clipsEnded[i];
        const bool wasFree = m_minds[end.agent].rule == kNone;
        for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
            if (m_rules[rule].trigger.is<model::triggers::ClipEnded>() && rule != end.rule &&
                (m_bringsBack[rule] || !host.isGone(end.agent))) {
                hearClipEnd(host, rule, end);
            }
        }
        if (wasFree && m_minds[end.agent].rule != kNone) {
            goOn(host, end.agent);
        }
    }
}

void RuleEngine::hearClipEnd(RuleHost& host, std::uint32_t rule, const ClipEnd& end)
{
    Mind& mind = m_minds[end.agent];
    if (mind.rule == kNone) {
        fire(host, rule, end.agent, end.cause);
    } else if (m_rules[rule].meeting != model::RuleMeeting::Ignore && isDue(rule, end.agent) &&
               isQueueable(rule, end.agent) && holds(host, m_rules[rule], end.agent, end.cause)) {
        mind.queue.push_back({m_rules[rule].id, end.cause});
    }
}

} // namespace crowd::behavior
