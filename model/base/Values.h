// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/population/Columns.h"

/// Small values that settings of several kinds are made of. Colours are sRGB.
namespace crowd::model {

/// A distribution that the artist draws: equal bins from the lowest to the highest value with the
/// weights given. All zero counts as all equal.
struct DistributionCurve
{
    std::array<float, 16> weights{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

    /// The value, 0..1, below which the share u (0..1) of the distribution lies.
    [[nodiscard]] double sample(double u) const;
    friend bool operator==(const DistributionCurve&, const DistributionCurve&) = default;
};

struct ValueRange
{
    float low = 0.0F;
    float high = 0.0F;
    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

struct TemplateWeight
{
    TemplateId id = 0;
    float weight = 1.0F;
    friend bool operator==(const TemplateWeight&, const TemplateWeight&) = default;
};

struct ClipWeight
{
    std::string clip; ///< by name: each template has its own
    float weight = 1.0F;
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const ClipWeight&, const ClipWeight&) = default;
};

/// Legal scales of height and girth, of whoever sets them.
inline constexpr double kMinScale = 0.01;
inline constexpr double kMaxScale = 100.0;

using PaintColor = std::array<std::uint8_t, 3>; ///< sRGB red, green, blue

} // namespace crowd::model
