// SPDX-License-Identifier: MIT
#include "app/python/ScriptFeatures.h"

#include <algorithm>
#include <cmath>

#include "app/python/ColumnRules.h"
#include "model/base/Random.h"
#include "model/base/ShownText.h"

namespace crowd::app {

using namespace model;

namespace {

/// Names of kinds or of values.
template<class Entries>
std::string listedNames(const Entries& entries)
{
    std::string names;
    for (const auto& each : entries) {
        names += (names.empty() ? "" : ", ") + shortened(each.name);
    }
    return names.empty() ? "none yet" : names;
}

Result<std::vector<WeightedFeature>> weightedMix(const FeatureKind& kind,
                                                 const std::vector<NamedWeight>& values)
{
    std::vector<WeightedFeature> mix;
    float total = 0.0F;
    for (const NamedWeight& each : values) {
        const FeatureValue* value = kind.find(each.name);
        if (value == nullptr) {
            return Error{noValueText(kind, each.name)};
        }
        if (!std::isfinite(each.weight) || each.weight < 0.0F || each.weight > 1e6F) {
            return Error{"The weight of \"" + shortened(each.name) +
                         "\" must lie from 0 to 1000000."};
        }
        mix.push_back({value->id, each.weight});
        total += each.weight;
    }
    if (!mix.empty() && total <= 0.0F) {
        return Error{"One of the weights at least must be more than 0."};
    }
    return mix;
}

} // namespace

std::string noKindText(const FeatureKinds& kinds, const std::string& name)
{
    return "the scene has no feature \"" + shortened(name) +
           "\"; there are: " + listedNames(kinds) + '.';
}

std::string noValueText(const FeatureKind& kind, const std::string& name)
{
    return "the feature \"" + shortened(kind.name) + "\" has no value \"" + shortened(name) +
           "\"; there are: " + listedNames(kind.values) + '.';
}

Result<std::size_t> setFeature(ScriptScene& script, const std::vector<IndividualId>& ids,
                               const std::string& kind, const std::vector<NamedWeight>& values)
{
    std::size_t changed = 0;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        const FeatureKind* found = findKind(now.features, kind);
        if (found == nullptr) {
            return Error{noKindText(now.features, kind)};
        }
        const auto mix = weightedMix(*found, values);
        if (!mix) {
            return mix.error();
        }
        if (auto alive = checkAlive(now, ids); !alive) {
            return alive;
        }
        const std::uint64_t seed = hashKeys(now.seed, hashText("set_feature"));
        const std::vector<FeatureId> wanted = drawnFeatures(mix.value(), ids, seed);
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Set a feature")),
                           [&](SceneEdit& open) {
                               changed = model::setFeature(open, *found, ids, wanted, seed).size();
                           });
    });
    if (!done) {
        return done.error();
    }
    return changed;
}

Result<std::vector<std::string>> featureNames(const Scene& scene, const std::string& kind)
{
    const FeatureKind* found = findKind(scene.features, kind);
    if (found == nullptr) {
        return Error{noKindText(scene.features, kind)};
    }
    std::vector<std::string> names;
    names.reserve(scene.population.size());
    for (const FeatureId borne : scene.population.column(columns::feature(found->id))) {
        const auto value = std::ranges::find(found->values, borne, &FeatureValue::id);
        names.push_back(borne != 0 && value != found->values.end() ? value->name : std::string());
    }
    return names;
}

} // namespace crowd::app
