// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <QtCore/QStringList>

#include "model/rules/RuleKind.h"
#include "model/rules/RuleSets.h"

/// What can be chosen in a rule, by name, in the artist's language.
namespace crowd::widgets {

/// A text of a description of rules.
[[nodiscard]] QString ruleText(const char* text);
/// As menus name the kinds, by index.
[[nodiscard]] QStringList kindNames(std::span<const model::RuleKind> kinds);
/// As a menu says them that adds one.
[[nodiscard]] QStringList kindNamesAlone(std::span<const model::RuleKind> kinds);
[[nodiscard]] QStringList meetingNames();  ///< by RuleMeeting
[[nodiscard]] QStringList yieldNames();    ///< by RuleYield
[[nodiscard]] QStringList cueReachNames(); ///< by CueReach
[[nodiscard]] QString ruleSetName(model::RuleSet set);

} // namespace crowd::widgets
