// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crowd::model {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

bool followsSomething(HeadingMode mode)
{
    return mode != HeadingMode::Direction && mode != HeadingMode::Random;
}

bool isAmong(const std::vector<int>& chosen, int number)
{
    return chosen.empty() || std::ranges::find(chosen, number) != chosen.end();
}

MainNumber numberOfCreation(const BrushSettings& settings)
{
    if (settings.create.seats.isOn) {
        return {MainQuantity::SeatPercent, settings.create.seatPercent, 0.0, 100.0, 5.0, 0};
    }
    if (settings.selection == BrushSelection::Point) {
        return {MainQuantity::Distance, settings.create.minimalDistance, 0.1, 10.0, 0.1, 2};
    }
    return {MainQuantity::Density, settings.create.density, 0.05, 6.0, 0.25, 2};
}

MainNumber numberOfOrientation(const HeadingSettings& heading)
{
    const bool isTurn = followsSomething(heading.mode);
    return {isTurn ? MainQuantity::Turn : MainQuantity::Heading,
            (isTurn ? heading.turnRadians : heading.headingRadians) * kDegrees,
            -180.0,
            180.0,
            5.0,
            0};
}

/// The range from another lowest speed on, as wide as before where that can be walked.
ValueRange movedTo(float low, const ValueRange& range)
{
    return {low, std::min(kMaxWalkingSpeed, std::max(low, low + range.high - range.low))};
}

} // namespace

bool SeatGridSettings::allows(int rank, int wedge) const
{
    return isAmong(ranks, rank) && isAmong(wedges, wedge);
}

double DistributionCurve::sample(double u) const
{
    double total = 0.0;
    for (const float weight : weights) {
        total += std::max(0.0F, weight);
    }
    if (!(total > 0.0)) {
        return u;
    }
    double left = u * total;
    for (std::size_t bin = 0; bin < weights.size(); ++bin) {
        const double weight = std::max(0.0F, weights[bin]);
        if (left < weight) {
            return (static_cast<double>(bin) + left / weight) / static_cast<double>(weights.size());
        }
        left -= weight;
    }
    return 1.0;
}

MainNumber BrushSettings::mainNumber() const
{
    switch (kind) {
    case BrushKind::Create:
        if (takesShare()) {
            return numberOfCreation(*this);
        }
        break;
    case BrushKind::Delete:
        if (takesShare()) {
            return {MainQuantity::DeletePercent, removal.percent, 5.0, 100.0, 5.0, 0};
        }
        break;
    case BrushKind::Colour:
        return {MainQuantity::Strength, colour.strength * 100.0, 0.0, 100.0, 5.0, 0};
    case BrushKind::Orientation:
        return numberOfOrientation(orientation.heading);
    case BrushKind::Animation:
        return {MainQuantity::Speed, animation.speed.low, 0.0, 4.0, 0.1, 1};
    case BrushKind::Walk:
        return {MainQuantity::WalkSpeed, walk.speed.low, 0.0, kMaxWalkingSpeed, 0.1, 1};
    case BrushKind::Style:
        return {MainQuantity::WalkSpeed, style.speed.low, 0.0, kMaxWalkingSpeed, 0.1, 1};
    case BrushKind::Tag:
    case BrushKind::Untag:
        return {MainQuantity::Tag, tag.tag + 1.0, 1.0, kTagCount, 1.0, 0};
    case BrushKind::Event:
        return {MainQuantity::Payload, event.payload, -1000.0, 1000.0, 0.1, 1};
    case BrushKind::Path:
    case BrushKind::Environment:
        return {MainQuantity::PlaceRadius,
                place.radiusMetres,
                kMinPlaceRadius,
                kMaxPlaceRadius,
                0.25,
                2};
    case BrushKind::Script:
        break;
    }
    return {MainQuantity::Rate, ratePerSecond, 1.0, 500.0, 5.0, 0};
}

BrushSettings BrushSettings::withMainNumber(double value) const
{
    BrushSettings changed = *this;
    const MainNumber number = mainNumber();
    const auto kept = static_cast<float>(std::clamp(value, number.low, number.high));
    switch (number.quantity) {
    case MainQuantity::Density:
        changed.create.density = kept;
        break;
    case MainQuantity::SeatPercent:
        changed.create.seatPercent = kept;
        break;
    case MainQuantity::Distance:
        changed.create.minimalDistance = kept;
        break;
    case MainQuantity::Rate:
        changed.ratePerSecond = kept;
        break;
    case MainQuantity::DeletePercent:
        changed.removal.percent = kept;
        break;
    case MainQuantity::Strength:
        changed.colour.strength = kept / 100.0F;
        break;
    case MainQuantity::Heading:
        // Turning on past the back comes out at the other side.
        changed.orientation.heading.headingRadians =
            static_cast<float>(std::remainder(value, 360.0) / kDegrees);
        break;
    case MainQuantity::Turn:
        changed.orientation.heading.turnRadians =
            static_cast<float>(std::remainder(value, 360.0) / kDegrees);
        break;
    case MainQuantity::Speed:
        changed.animation.speed.high =
            std::max(kept, kept + animation.speed.high - animation.speed.low);
        changed.animation.speed.low = kept;
        changed.animation.setsSpeed = true;
        break;
    case MainQuantity::WalkSpeed:
        if (kind == BrushKind::Style) {
            changed.style.speed = movedTo(kept, style.speed);
            changed.style.setsSpeed = true;
        } else {
            changed.walk.speed = movedTo(kept, walk.speed);
            changed.walk.setsSpeed = true;
        }
        break;
    case MainQuantity::Tag:
        changed.tag.tag = static_cast<std::uint8_t>(std::lround(kept) - 1);
        break;
    case MainQuantity::Payload:
        changed.event.payload = kept;
        break;
    case MainQuantity::PlaceRadius:
        changed.place.radiusMetres = kept;
        break;
    }
    return changed;
}

BrushSettings BrushSettings::resized(float deltaPixels) const
{
    BrushSettings changed = *this;
    changed.radiusPixels =
        std::clamp(radiusPixels + deltaPixels, kMinRadiusPixels, kMaxRadiusPixels);
    return changed;
}

} // namespace crowd::model
