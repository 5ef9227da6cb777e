// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/python/ScriptScene.h"
#include "model/features/FeatureWriting.h"

/// Features as scripts give them: each call is a part of the open edit, or a step of its own. What
/// is refused is refused before anything changes.
namespace crowd::app {

/// What to say of names that there are not.
[[nodiscard]] std::string noKindText(const model::FeatureKinds& kinds, const std::string& name);
[[nodiscard]] std::string noValueText(const model::FeatureKind& kind, const std::string& name);

struct NamedWeight
{
    std::string name;
    float weight = 1.0F;
};

/// Lets each of them bear one of the values of a kind, by weight; none of them: no value any more.
/// Ids ascending, all alive. How many are another way than before.
[[nodiscard]] model::Result<std::size_t> setFeature(ScriptScene& script,
                                                    const std::vector<model::IndividualId>& ids,
                                                    const std::string& kind,
                                                    const std::vector<NamedWeight>& values);
/// Names by individual, in the order of the rows; empty for none.
[[nodiscard]] model::Result<std::vector<std::string>> featureNames(const model::Scene& scene,
                                                                   const std::string& kind);

} // namespace crowd::app
