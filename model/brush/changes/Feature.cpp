// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"
#include "model/brush/ColumnWriting.h"
#include "model/brush/FeatureBrush.h"
#include "model/features/FeatureWriting.h"

namespace crowd::model {

namespace {

struct Offer
{
    FeatureId id = 0;
    float weight = 1.0F;
};

/// Ticks that were set for another kind say nothing of this one.
bool areOfOthers(const FeatureKinds& kinds, const std::vector<ClipWeight>& values)
{
    return std::ranges::all_of(values, [&kinds](const ClipWeight& each) {
        return std::ranges::any_of(
            kinds, [&each](const FeatureKind& kind) { return kind.find(each.clip) != nullptr; });
    });
}

/// The values that are meant, in their order.
std::vector<Offer> offersOf(const FeatureKinds& kinds, const FeatureKind& kind,
                            const FeatureSettings& settings)
{
    std::vector<Offer> offers;
    const bool isAnyNamed = std::ranges::any_of(settings.values, [&kind](const ClipWeight& each) {
        return kind.find(each.clip) != nullptr;
    });
    for (const ClipWeight& each : settings.values) {
        const FeatureValue* value = kind.find(each.clip);
        if (value != nullptr && each.weight > 0.0F) {
            offers.push_back({value->id, each.weight});
        }
    }
    for (const FeatureValue& value : kind.values) {
        if (!isAnyNamed && areOfOthers(kinds, settings.values)) {
            offers.push_back({value.id, 1.0F});
        }
    }
    return offers;
}

constexpr double kPureShare = 0.5; ///< of the way between two values nobody bears the other one

/// The steps of a gradient mix where they meet: no line is seen between the calm and the wild.
std::size_t stepAt(double place, IndividualId id, std::uint64_t seed)
{
    constexpr std::uint64_t kFeatureSteps = 92; // purpose of draws
    const double draw = unitDouble(hashKeys(seed, id, kFeatureSteps)) - 0.5;
    return static_cast<std::size_t>(
        std::floor(std::max(0.0, place + 0.5 + draw * (1.0 - kPureShare))));
}

/// One of them for each: a draw goes by weight, else shares run from the first to the last.
std::vector<FeatureId> wantedOf(const std::vector<Offer>& offers, const OperatorResult& values,
                                const ChangeRequest& request)
{
    std::vector<FeatureId> wanted;
    wanted.reserve(values.shares.size());
    const bool isGraded = operatorInfo(request.settings.op).followsLine;
    for (std::size_t i = 0; i < values.shares.size(); ++i) {
        const double share = values.shares[i];
        const double place = share * static_cast<double>(offers.size() - 1);
        const std::size_t step = isGraded ? stepAt(place, request.ids[i], request.seed)
                                          : static_cast<std::size_t>(std::floor(place + 0.5));
        const std::size_t at = values.isDraw
                                   ? weightedIndex(offers, static_cast<float>(share),
                                                   [](const Offer& each) { return each.weight; })
                                   : step;
        wanted.push_back(offers[std::min(at, offers.size() - 1)].id);
    }
    return wanted;
}

} // namespace

ChangeResult FeatureSettings::change(const ChangeRequest& request)
{
    const FeatureSettings& settings = *featureSettings(request.settings);
    const FeatureKind* kind = findKind(request.edit.scene().features, settings.kind);
    ChangeResult result;
    result.reason = StrokeReason::NoSuchFeature;
    if (kind == nullptr) {
        return result;
    }
    const std::vector<Offer> offers = offersOf(request.edit.scene().features, *kind, settings);
    if (offers.empty() && !settings.takesOff) {
        return result;
    }
    const OperatorShares shares(request);
    const std::vector<FeatureId> wanted =
        settings.takesOff
            ? std::vector<FeatureId>(request.ids.size(), FeatureId{0})
            : wantedOf(offers, shares.of(request.settings.op, "feature.value"), request);
    result.changed = setFeature(request.edit, *kind, request.ids, wanted, request.seed);
    result.reason = StrokeReason::Unchanged;
    return result;
}

void FeatureSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.op = BrushOperator::Random;
}

std::string FeatureSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    FeatureSettings& settings = *featureSettings(brush);
    const FeatureKind* kind = findKind(from.scene.features, settings.kind);
    const FeatureValue* value =
        kind != nullptr ? findFeature(from.scene.features, from.value(columns::feature(kind->id)))
                        : nullptr;
    if (value == nullptr) {
        return {};
    }
    settings.values = {{value->name, 1.0F}};
    settings.takesOff = false;
    return value->name;
}

} // namespace crowd::model
