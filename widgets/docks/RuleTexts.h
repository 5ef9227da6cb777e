// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QStringList>

#include "behavior/base/Problem.h"
#include "model/scene/RuleSets.h"
#include "model/scene/Scene.h"

/// Rules as sentences in the artist's language.
namespace crowd::widgets {

[[nodiscard]] QStringList triggerNames(); ///< by TriggerKind
[[nodiscard]] QStringList conditionNames();
/// What stands before it, or is compared: yes and no.
[[nodiscard]] QStringList verbsOf(model::ConditionKind kind); ///< by ConditionKind
[[nodiscard]] QStringList actionNames();                      ///< by ActionKind
[[nodiscard]] QStringList reachNames();                       ///< by EventReach
[[nodiscard]] QStringList meetingNames();                     ///< by RuleMeeting
[[nodiscard]] QStringList yieldNames();                       ///< by RuleYield
[[nodiscard]] QStringList comparisonNames();                  ///< by Comparison
[[nodiscard]] QStringList choiceNames();                      ///< by PlaceChoice
[[nodiscard]] QStringList cueReachNames();                    ///< by CueReach
[[nodiscard]] QStringList aimNames();                         ///< by ActionAim
[[nodiscard]] QStringList comparedNames();                    ///< by ComparedProperty
[[nodiscard]] QStringList settableNames();                    ///< by SettableProperty
[[nodiscard]] QString ruleSetName(model::RuleSet set);
[[nodiscard]] QString tagText(const model::Scene& scene, std::uint8_t tag);

/// "When wave reaches someone seated: tell those near, play sit_cheer".
[[nodiscard]] QString ruleSentence(const model::Scene& scene, const model::Rule& rule);
/// What is wrong with a rule, and the way out; empty when it is sound.
[[nodiscard]] QString ruleProblem(const model::Scene& scene, const model::Rule& rule);
/// What came to light while it runs, of a rule as its panel says it.
[[nodiscard]] QString problemText(const model::Scene& scene, const behavior::Problem& problem);

} // namespace crowd::widgets
