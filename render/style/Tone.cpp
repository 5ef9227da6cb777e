// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/style/Style.h"

namespace crowd::render {

namespace {

constexpr float kWhite = 6500.0F; ///< kelvin that change nothing

/// Chromaticity of a black body, as the cubic fits of B. Kang et al., "Design of Advanced Color
/// Temperature Control System for HDTV Applications", 2002, give it; extended to both sides.
glm::dvec2 chromaticity(double kelvin)
{
    const double t = 1000.0 / glm::clamp(kelvin, 1667.0, 25000.0);
    const double x = kelvin < 4000.0
                         ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                         : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    const double y =
        kelvin < 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
        : kelvin < 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                          : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    return {x, y};
}

/// Linear sRGB of luminance 1.
glm::vec3 blackBody(float kelvin)
{
    const glm::dvec2 xy = chromaticity(static_cast<double>(kelvin));
    const double x = xy.x / xy.y;
    const double z = (1.0 - xy.x - xy.y) / xy.y;
    const glm::dvec3 rgb(3.2404542 * x - 1.5371385 - 0.4985314 * z,
                         -0.9692660 * x + 1.8760108 + 0.0415560 * z,
                         0.0556434 * x - 0.2040259 + 1.0572252 * z);
    return glm::max(glm::vec3(rgb), glm::vec3(0.02F));
}

float filmic(float c)
{
    c *= 0.722F;
    return glm::clamp(c * (2.51F * c + 0.03F) / (c * (2.43F * c + 0.59F) + 0.14F), 0.0F, 1.0F);
}

} // namespace

Tone Tone::from(const model::Lighting& lighting)
{
    Tone tone;
    if (lighting.whiteKelvin != kWhite) {
        const glm::vec3 gain = blackBody(kWhite) / blackBody(lighting.whiteKelvin);
        tone.gain = gain / glm::dot(gain, glm::vec3(0.2126F, 0.7152F, 0.0722F));
    }
    tone.gain *= lighting.exposureStops != 0.0F ? std::exp2(lighting.exposureStops) : 1.0F;
    tone.isFilmic = lighting.toneMap == model::ToneMap::Filmic;
    tone.hazePerMetre = lighting.haze > 0.0F ? -std::log(1.0F - lighting.haze) / 100.0F : 0.0F;
    tone.hazeHeight = lighting.hazeHeight;
    return tone;
}

std::string Tone::defines() const
{
    return isNeutral() ? "" : isFilmic ? "TONED FILMIC " : "TONED ";
}

std::string Tone::hazeDefines() const
{
    return hazePerMetre <= 0.0F ? "" : hazeHeight > 0.0F ? "HAZY LOW_HAZE " : "HAZY ";
}

glm::vec3 Tone::of(const glm::vec3& linear) const
{
    const glm::vec3 gained = linear * gain;
    return isFilmic ? glm::vec3(filmic(gained.x), filmic(gained.y), filmic(gained.z)) : gained;
}

} // namespace crowd::render
