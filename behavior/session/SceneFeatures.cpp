// SPDX-License-Identifier: MIT
#include "behavior/session/SceneFeatures.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "behavior/session/PoseCapture.h"
#include "behavior/session/SceneAdoption.h"
#include "behavior/session/SceneRecall.h"
#include "model/base/Random.h"
#include "model/features/FeatureWriting.h"

namespace crowd::behavior {

namespace {

/// Who is told twice in a step bears what he is told last.
struct Told
{
    std::vector<model::IndividualId> ids; ///< ascending
    std::vector<model::FeatureId> wanted;
};

Told toldOf(const std::vector<RuleFeature>& all, const model::FeatureKind& kind,
            const model::Population& people)
{
    std::vector<RuleFeature> meant;
    for (const RuleFeature& each : all) {
        const bool isOfKind = std::ranges::find(kind.values, each.feature,
                                                &model::FeatureValue::id) != kind.values.end();
        if (isOfKind && people.rowOf(each.id) != model::Population::npos) {
            meant.push_back(each);
        }
    }
    std::ranges::stable_sort(meant, {}, &RuleFeature::id);
    Told told;
    for (const RuleFeature& each : meant) {
        if (told.ids.empty() || told.ids.back() != each.id) {
            told.ids.push_back(each.id);
            told.wanted.push_back(each.feature);
        } else {
            told.wanted.back() = each.feature;
        }
    }
    return told;
}

void takeOn(SessionParts& parts, const model::FeatureKind& kind, const Told& told)
{
    namespace keys = model::columns;
    model::Scene scene = parts.lastScene;
    scene.population = parts.population;
    const model::Population shown = captureFrame(parts).population; // who sits by now
    scene.population.setValues(keys::seat, shown.ids(), shown.column(keys::seat));
    const std::uint64_t seed = model::hashKeys(scene.seed, parts.clock.steps);
    model::Population now = parts.population;
    model::ColumnSet columns;
    std::vector<model::IndividualId> moving; // in another clip
    for (const model::ChangedColumn& each :
         featureChanges(scene, kind, told.ids, told.wanted, seed)) {
        now.setValues(each.column, each.ids, each.bytes);
        columns.insert(each.column);
        moving = each.column == model::ColumnId::Clip ? each.ids : moving;
    }
    parts.recalled.take(parts.lastScene.population, now, columns);
    adoptPeople(parts, parts.lastScene, now, false);
    forgetRuleValues(parts, told.ids, columns);
    for (const model::IndividualId id : moving) {
        parts.idle.reset(static_cast<std::uint32_t>(parts.population.rowOf(id))); // of a posture
    }
}

} // namespace

void takeOnFeatures(SessionParts& parts)
{
    const std::vector<RuleFeature> all = std::exchange(parts.ruleFeatures, {});
    if (all.empty()) {
        return;
    }
    for (const model::FeatureKind& kind : parts.lastScene.features) {
        if (const Told told = toldOf(all, kind, parts.population); !told.ids.empty()) {
            takeOn(parts, kind, told);
        }
    }
}

} // namespace crowd::behavior
