// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <QtCore/QStringList>

#include "behavior/base/Problem.h"
#include "model/rules/RuleSets.h"
#include "model/scene/Scene.h"

/// Rules as sentences in the artist's language.
namespace crowd::widgets {

/// A text of a description of rules, in the artist's language.
[[nodiscard]] QString ruleText(const char* text);
/// As menus name the kinds, by index.
[[nodiscard]] QStringList kindNames(std::span<const model::RuleKind> kinds);
[[nodiscard]] QStringList meetingNames();  ///< by RuleMeeting
[[nodiscard]] QStringList yieldNames();    ///< by RuleYield
[[nodiscard]] QStringList cueReachNames(); ///< by CueReach
[[nodiscard]] QString ruleSetName(model::RuleSet set);
[[nodiscard]] QString tagText(const model::Scene& scene, std::uint8_t tag);

/// "When wave reaches someone seated: tell those near, play sit_cheer".
[[nodiscard]] QString ruleSentence(const model::Scene& scene, const model::Rule& rule);
/// What is wrong with a rule, and the way out; empty when it is sound.
[[nodiscard]] QString ruleProblem(const model::Scene& scene, const model::Rule& rule);
/// What came to light while it runs, of a rule as its panel says it.
[[nodiscard]] QString problemText(const model::Scene& scene, const behavior::Problem& problem);

} // namespace crowd::widgets
