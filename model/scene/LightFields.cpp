// SPDX-License-Identifier: MIT
#include "model/scene/LightFields.h"

#include <vector>

#include "model/scene/Scene.h"

namespace crowd::model {

namespace {

constexpr double kMostTurned = 1e6; ///< radians
constexpr double kBrightest = 1000.0;

FieldInfo angle(const char* key, float Lighting::*member)
{
    return detail::erased<Lighting>(field(
        member, {.key = key, .low = -kMostTurned, .high = kMostTurned, .role = FieldRole::Angle}));
}

FieldInfo strength(const char* key, float Lighting::*member)
{
    return detail::erased<Lighting>(field(member, {.key = key, .high = kBrightest}));
}

FieldInfo color(const char* key, glm::vec3 Lighting::*member)
{
    return detail::erased<Lighting>(field(member, {.key = key}));
}

} // namespace

std::span<const FieldInfo> lightFields()
{
    static const std::vector<FieldInfo> kFields{
        angle("sunAzimuth", &Lighting::sunAzimuthRadians),
        angle("sunElevation", &Lighting::sunElevationRadians),
        color("sunColor", &Lighting::sunColor),
        strength("sunStrength", &Lighting::sunStrength),
        color("ambientColor", &Lighting::ambientColor),
        strength("ambientStrength", &Lighting::ambientStrength),
        color("skyZenith", &Lighting::skyZenith),
        color("skyHorizon", &Lighting::skyHorizon),
        color("ground", &Lighting::ground),
        detail::erased<Lighting>(field(&Lighting::showGroundGrid, {.key = "groundGrid"}))};
    return kFields;
}

} // namespace crowd::model
