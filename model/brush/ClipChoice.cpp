// SPDX-License-Identifier: MIT
#include "model/brush/ClipChoice.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace crowd::model {

namespace {

std::optional<std::uint16_t> columnOfName(const TemplateEntry& entry, const std::string& name)
{
    const auto found = std::ranges::find(entry.clipNames, name);
    if (found == entry.clipNames.end()) {
        return std::nullopt;
    }
    return static_cast<std::uint16_t>(found - entry.clipNames.begin());
}

} // namespace

std::optional<std::uint16_t> chosenClip(const TemplateEntry& entry,
                                        std::span<const ClipWeight> wanted, double u)
{
    struct Offer
    {
        std::uint16_t column;
        double weight;
    };
    std::vector<Offer> offers;
    double total = 0.0;
    for (const ClipWeight& clip : wanted) {
        const auto column = columnOfName(entry, clip.clip);
        if (column && clip.weight > 0.0F) {
            offers.push_back({*column, clip.weight});
            total += clip.weight;
        }
    }
    double left = u * total;
    for (const Offer& offer : offers) {
        if (left < offer.weight) {
            return offer.column;
        }
        left -= offer.weight;
    }
    return offers.empty() ? std::nullopt : std::optional(offers.back().column);
}

std::optional<std::uint16_t>
suitingClip(const TemplateEntry& entry, std::span<const ClipWeight> wanted, bool isSeated, double u)
{
    std::vector<ClipWeight> suiting;
    for (const ClipWeight& each : wanted) {
        const int clip = entry.asset ? entry.asset->clipIndex(each.clip) : -1;
        if (clip >= 0) {
            const Clip& known = entry.asset->clips[static_cast<std::size_t>(clip)];
            const bool sits = known.seatHeight.has_value() || known.role == ClipRole::Sit;
            if (sits == isSeated) {
                suiting.push_back(each);
            }
        }
    }
    const auto chosen = chosenClip(entry, suiting, u);
    return chosen ? chosen : chosenClip(entry, wanted, u);
}

std::optional<std::uint16_t> clipColumnOf(const TemplateEntry& entry, int assetClip)
{
    if (!entry.asset || assetClip < 0 ||
        static_cast<std::size_t>(assetClip) >= entry.asset->clips.size()) {
        return std::nullopt;
    }
    return columnOfName(entry, entry.asset->clips[static_cast<std::size_t>(assetClip)].name);
}

namespace {

constexpr float kSlowest = 0.05F; ///< m/s

bool hasOwnSpeed(const TemplateEntry& entry, std::size_t column)
{
    return column < entry.clipSpeeds.size() && !std::isnan(entry.clipSpeeds[column]);
}

} // namespace

ClipRole clipRole(const TemplateEntry& entry, std::size_t column, std::size_t assetClip)
{
    if (column < entry.clipRoles.size() && entry.clipRoles[column]) {
        return *entry.clipRoles[column];
    }
    const Clip& clip = entry.asset->clips[assetClip];
    if (clip.role != ClipRole::Other || !clip.loop || clip.seconds <= 0.0F ||
        !hasOwnSpeed(entry, column) || entry.clipSpeeds[column] <= kSlowest) {
        return clip.role;
    }
    const float height = entry.asset->height;
    const float border =
        std::sqrt(usualSpeedOf(ClipRole::Walk, height) * usualSpeedOf(ClipRole::Run, height));
    return entry.clipSpeeds[column] > border ? ClipRole::Run : ClipRole::Walk;
}

float groundSpeed(const TemplateEntry& entry, std::size_t column, std::size_t assetClip)
{
    if (hasOwnSpeed(entry, column)) {
        return entry.clipSpeeds[column];
    }
    const Clip& clip = entry.asset->clips[assetClip];
    const ClipRole role = clipRole(entry, column, assetClip);
    const bool isUnknown = clip.speed <= kSlowest && isGait(role);
    return isUnknown ? usualSpeedOf(role, entry.asset->height) : clip.speed;
}

float usualWalkingSpeed(const TemplateEntry& entry)
{
    if (!entry.asset) {
        return kUsualWalkingSpeed;
    }
    for (const ClipRole wanted : {ClipRole::Walk, ClipRole::Fly, ClipRole::Run}) {
        for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
            const int index = entry.asset->clipIndex(entry.clipNames[i]);
            if (index >= 0 && clipRole(entry, i, static_cast<std::size_t>(index)) == wanted &&
                movesOverGround(entry, i, static_cast<std::size_t>(index))) {
                return groundSpeed(entry, i, static_cast<std::size_t>(index));
            }
        }
    }
    // It glides, no faster than it would walk.
    return std::min(kUsualWalkingSpeed, usualSpeedOf(ClipRole::Walk, entry.asset->height));
}

bool movesOverGround(const TemplateEntry& entry, std::size_t column, std::size_t assetClip)
{
    const Clip& clip = entry.asset->clips[assetClip];
    return clip.loop && clip.seconds > 0.0F && groundSpeed(entry, column, assetClip) > kSlowest;
}

std::uint16_t usualClip(const TemplateEntry& entry, bool isSeated)
{
    if (!entry.asset) {
        return 0;
    }
    const auto seated = isSeated ? clipColumnOf(entry, entry.asset->seatedClip) : std::nullopt;
    return seated ? *seated : clipColumnOf(entry, entry.asset->defaultClip).value_or(0);
}

bool isRest(const TemplateEntry& entry, std::uint16_t column, bool isSeated)
{
    if (column == usualClip(entry, isSeated)) {
        return true;
    }
    if (!entry.asset || column >= entry.clipNames.size()) {
        return false;
    }
    const int clip = entry.asset->clipIndex(entry.clipNames[column]);
    return clip >= 0 && clipRole(entry, column, static_cast<std::size_t>(clip)) ==
                            (isSeated ? ClipRole::Sit : ClipRole::Idle);
}

std::uint16_t seatedClip(const TemplateEntry& entry, double u)
{
    const std::uint16_t usual = usualClip(entry, true);
    std::vector<std::uint16_t> others;
    for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
        const auto column = static_cast<std::uint16_t>(i);
        if (column != usual && isRest(entry, column, true)) {
            others.push_back(column);
        }
    }
    if (u < 0.5 || others.empty()) {
        return usual;
    }
    const auto at = static_cast<std::size_t>((u - 0.5) * 2.0 * static_cast<double>(others.size()));
    return others[std::min(at, others.size() - 1)];
}

std::uint32_t defaultParts(const Template& asset)
{
    std::uint32_t parts = 0xFFFFFFFFU;
    for (std::size_t i = 0; i < asset.parts.size() && i < 32; ++i) {
        if (!asset.parts[i].shownByDefault) {
            parts &= ~(1U << i);
        }
    }
    return parts;
}

} // namespace crowd::model
