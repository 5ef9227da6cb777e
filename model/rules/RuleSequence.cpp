// SPDX-License-Identifier: MIT
#include "model/rules/RuleSequence.h"

#include <algorithm>
#include <utility>

namespace crowd::model {

namespace {

std::ptrdiff_t at(std::size_t line)
{
    return static_cast<std::ptrdiff_t>(line);
}

/// A line with what belongs to it so much deeper or less deep.
void shift(Actions& actions, std::size_t begin, std::size_t end, int by)
{
    for (std::size_t i = begin; i < end; ++i) {
        actions[i].depth = static_cast<std::uint8_t>(std::clamp(actions[i].depth + by, 0, 255));
    }
}

/// Line before it of the same depth that belongs to the same, or kNoLine.
std::size_t siblingBefore(const Actions& actions, std::size_t line)
{
    for (std::size_t i = line; i-- > 0 && actions[i].depth >= actions[line].depth;) {
        if (actions[i].depth == actions[line].depth) {
            return i;
        }
    }
    return kNoLine;
}

bool areAlternatives(const Action& a, const Action& b)
{
    return a.is<actions::OneOf>() && b.is<actions::OneOf>();
}

} // namespace

bool isHead(const Action& action)
{
    return action.kind().text.hasParts;
}

std::size_t endOf(const Actions& actions, std::size_t line)
{
    std::size_t end = line + 1;
    while (end < actions.size() && actions[end].depth > actions[line].depth) {
        ++end;
    }
    return end;
}

std::size_t parentOf(const Actions& actions, std::size_t line)
{
    for (std::size_t i = line; i-- > 0;) {
        if (actions[i].depth < actions[line].depth) {
            return i;
        }
    }
    return kNoLine;
}

std::vector<std::size_t> alternativesOf(const Actions& actions, std::size_t line)
{
    std::size_t first = line;
    for (std::size_t before = siblingBefore(actions, first);
         before != kNoLine && areAlternatives(actions[before], actions[line]);
         before = siblingBefore(actions, first)) {
        first = before;
    }
    std::vector<std::size_t> all;
    for (std::size_t i = first; i < actions.size() && actions[i].depth == actions[line].depth &&
                                areAlternatives(actions[i], actions[line]);
         i = endOf(actions, i)) {
        all.push_back(i);
    }
    return all;
}

void settleDepths(Actions& actions)
{
    int most = 0;
    for (Action& action : actions) {
        action.depth =
            static_cast<std::uint8_t>(std::min({int{action.depth}, most, int{kMaxDepth}}));
        most = action.depth + (isHead(action) ? 1 : 0);
    }
}

void moveUp(Actions& actions, std::size_t line)
{
    const std::size_t end = endOf(actions, line);
    const std::size_t before = siblingBefore(actions, line);
    if (before == kNoLine) {
        const std::size_t parent = parentOf(actions, line);
        if (parent != kNoLine) { // the first in it: out, before it
            const std::size_t other = siblingBefore(actions, parent);
            const bool isInOther =
                other != kNoLine && areAlternatives(actions[other], actions[parent]);
            shift(actions, line, end, isInOther ? 0 : -1);
            std::rotate(actions.begin() + at(parent), actions.begin() + at(line),
                        actions.begin() + at(end));
        }
        return;
    }
    if (isHead(actions[before]) && !areAlternatives(actions[before], actions[line])) {
        shift(actions, line, end, 1); // the last in it
        settleDepths(actions);
        return;
    }
    std::rotate(actions.begin() + at(before), actions.begin() + at(line),
                actions.begin() + at(end));
}

void moveDown(Actions& actions, std::size_t line)
{
    const std::size_t end = endOf(actions, line);
    const bool isLast = end == actions.size() || actions[end].depth < actions[line].depth;
    if (isLast) {
        const std::size_t parent = parentOf(actions, line);
        const bool isInOther = parent != kNoLine && end < actions.size() &&
                               actions[end].depth == actions[parent].depth &&
                               areAlternatives(actions[end], actions[parent]);
        if (isInOther) {
            std::rotate(actions.begin() + at(line), actions.begin() + at(end),
                        actions.begin() + at(end + 1));
        } else if (parent != kNoLine) {
            shift(actions, line, end, -1); // out, after it
        }
        return;
    }
    const std::size_t size = end - line;
    if (isHead(actions[end]) && !areAlternatives(actions[end], actions[line])) {
        std::rotate(actions.begin() + at(line), actions.begin() + at(end),
                    actions.begin() + at(end + 1));
        shift(actions, line + 1, line + 1 + size, 1); // the first in it
        settleDepths(actions);
        return;
    }
    std::rotate(actions.begin() + at(line), actions.begin() + at(end),
                actions.begin() + at(endOf(actions, end)));
}

void removeLine(Actions& actions, std::size_t line)
{
    actions.erase(actions.begin() + at(line), actions.begin() + at(endOf(actions, line)));
}

void addInside(Actions& actions, std::size_t line, Action added)
{
    added.depth = static_cast<std::uint8_t>(actions[line].depth + 1);
    actions.insert(actions.begin() + at(endOf(actions, line)), std::move(added));
    settleDepths(actions);
}

void addAlternative(Actions& actions, std::size_t line)
{
    const Action added(actions::OneOf(), actions[line].depth);
    const std::size_t last = alternativesOf(actions, line).back();
    actions.insert(actions.begin() + at(endOf(actions, last)), added);
}

} // namespace crowd::model
