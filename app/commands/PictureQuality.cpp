// SPDX-License-Identifier: MIT
#include "app/commands/PictureQuality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "model/base/Color.h"

namespace crowd::app {

namespace {

constexpr float kPeak = 255.0F;
constexpr int kReach = 5; ///< of the Gaussian, pixels to each side

/// One number a pixel.
struct Plane
{
    glm::ivec2 size{0};
    std::vector<float> values;

    [[nodiscard]] float at(int x, int y) const
    {
        const int column = std::clamp(x, 0, size.x - 1);
        const int row = std::clamp(y, 0, size.y - 1);
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(column)];
    }
};

/// ITU-R BT.709, of the encoded colours.
Plane lumaOf(std::span<const std::uint8_t> rgba, glm::ivec2 size)
{
    Plane plane{size, {}};
    plane.values.reserve(rgba.size() / 4);
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        plane.values.push_back(0.2126F * static_cast<float>(rgba[i]) +
                               0.7152F * static_cast<float>(rgba[i + 1]) +
                               0.0722F * static_cast<float>(rgba[i + 2]));
    }
    return plane;
}

Plane product(const Plane& a, const Plane& b)
{
    Plane plane{a.size, std::vector<float>(a.values.size())};
    std::ranges::transform(a.values, b.values, plane.values.begin(), std::multiplies<>());
    return plane;
}

std::array<float, 2 * kReach + 1> gaussian()
{
    constexpr float kDeviation = 1.5F;
    std::array<float, 2 * kReach + 1> weights{};
    float sum = 0.0F;
    float distance = -static_cast<float>(kReach);
    for (float& weight : weights) {
        weight = std::exp(-distance * distance / (2.0F * kDeviation * kDeviation));
        sum += weight;
        distance += 1.0F;
    }
    for (float& weight : weights) {
        weight /= sum;
    }
    return weights;
}

/// Along one axis after the other.
Plane smoothed(const Plane& plane)
{
    const auto weights = gaussian();
    Plane between = plane;
    for (const bool isAcross : {true, false}) {
        const Plane from = between;
        std::size_t i = 0;
        for (int y = 0; y < plane.size.y; ++y) {
            for (int x = 0; x < plane.size.x; ++x, ++i) {
                float sum = 0.0F;
                int away = -kReach;
                for (const float weight : weights) {
                    sum += weight * (isAcross ? from.at(x + away, y) : from.at(x, y + away));
                    ++away;
                }
                between.values[i] = sum;
            }
        }
    }
    return between;
}

double psnrOf(const Plane& picture, const Plane& truth)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const auto off = static_cast<double>(picture.values[i] - truth.values[i]);
        sum += off * off;
    }
    const double mean = sum / static_cast<double>(picture.values.size());
    constexpr double kPeakSquare = 255.0 * 255.0;
    return mean > 0.0 ? std::min(kSamePsnr, 10.0 * std::log10(kPeakSquare / mean)) : kSamePsnr;
}

double ssimOf(const Plane& picture, const Plane& truth)
{
    constexpr float kLuminance = 0.01F * kPeak * 0.01F * kPeak;
    constexpr float kContrast = 0.03F * kPeak * 0.03F * kPeak;
    const Plane a = smoothed(picture);
    const Plane b = smoothed(truth);
    const Plane aa = smoothed(product(picture, picture));
    const Plane bb = smoothed(product(truth, truth));
    const Plane ab = smoothed(product(picture, truth));
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const float means = a.values[i] * b.values[i];
        const float squares = a.values[i] * a.values[i] + b.values[i] * b.values[i];
        const float covariance = ab.values[i] - means;
        const float variances = aa.values[i] + bb.values[i] - squares;
        sum += static_cast<double>((2.0F * means + kLuminance) * (2.0F * covariance + kContrast) /
                                   ((squares + kLuminance) * (variances + kContrast)));
    }
    return sum / static_cast<double>(a.values.size());
}

} // namespace

PictureQuality qualityOf(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> truth,
                         glm::ivec2 size)
{
    const Plane seen = lumaOf(picture, size);
    const Plane wanted = lumaOf(truth, size);
    return {psnrOf(seen, wanted), ssimOf(seen, wanted)};
}

std::vector<std::uint8_t> halved(std::span<const std::uint8_t> picture, glm::ivec2 size)
{
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] = model::linearFromSrgb(static_cast<float>(i) / kPeak);
    }
    const auto width = static_cast<std::size_t>(size.x);
    const auto half = static_cast<std::size_t>(size.x / 2);
    std::vector<std::uint8_t> small;
    small.reserve(picture.size() / 4);
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y / 2); ++y) {
        for (std::size_t x = 0; x < half; ++x) {
            const std::size_t first = (2 * y * width + 2 * x) * 4;
            for (std::size_t channel = first; channel < first + 4; ++channel) {
                const float sum = light[picture[channel]] + light[picture[channel + 4]] +
                                  light[picture[channel + width * 4]] +
                                  light[picture[channel + width * 4 + 4]];
                const float mixed = kPeak * model::srgbFromLinear(0.25F * sum);
                small.push_back(static_cast<std::uint8_t>(std::lround(mixed)));
            }
        }
    }
    return small;
}

} // namespace crowd::app
