// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "model/rules/Rule.h"

/// A rule's actions are lines with depths, like an indented text: the deeper ones below a Repeat or
/// a OneOf belong to it. OneOf lines of the same depth, each right after what belongs to the one
/// before, are alternatives of one choice.
namespace crowd::model {

using Actions = std::vector<Action>;

inline constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);
inline constexpr std::uint8_t kMaxDepth = 8;

/// Whether others can belong to it.
[[nodiscard]] bool isHead(const Action& action);
/// One behind the last line that belongs to it.
[[nodiscard]] std::size_t endOf(const Actions& actions, std::size_t line);
/// What it belongs to, or kNoLine.
[[nodiscard]] std::size_t parentOf(const Actions& actions, std::size_t line);
/// All alternatives of the choice that a OneOf is part of, in order.
[[nodiscard]] std::vector<std::size_t> alternativesOf(const Actions& actions, std::size_t line);

/// No line is deeper than it can be below the one before it.
void settleDepths(Actions& actions);
/// One up or down with all that belongs to it: past another line, into what stands beside it or out
/// of what it belongs to. Where there is no further it stays.
void moveUp(Actions& actions, std::size_t line);
void moveDown(Actions& actions, std::size_t line);
/// With all that belongs to it.
void removeLine(Actions& actions, std::size_t line);
/// As the last of those that belong to a line.
void addInside(Actions& actions, std::size_t line, Action added);
/// One more alternative to choose, after the others.
void addAlternative(Actions& actions, std::size_t line);

} // namespace crowd::model
