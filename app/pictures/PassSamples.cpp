// SPDX-License-Identifier: MIT
#include "app/pictures/PassSamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace crowd::app {

namespace {

constexpr float kMostSample = 65535.0F;
constexpr float kMiddleSample = 32768.0F;
constexpr float kPerMetre = 100.0F;
constexpr float kPerPixel = 64.0F;

const std::vector<float>& floatsIn(const ExrLayer& layer, std::size_t channel)
{
    return std::get<std::vector<float>>(layer.channels[channel].values);
}

std::uint16_t sampleOf(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, kMostSample)));
}

/// Three channels: value * scale + middle; where all are 0, nothing is, and it stays 0.
PassSamples threeOf(const ExrLayer& layer, float scale, float middle)
{
    const std::size_t count = floatsIn(layer, 0).size();
    PassSamples samples{3, std::vector<std::uint16_t>(3 * count)};
    for (std::size_t i = 0; i < count; ++i) {
        const float x = floatsIn(layer, 0)[i];
        const float y = floatsIn(layer, 1)[i];
        const float z = floatsIn(layer, 2)[i];
        if (x == 0.0F && y == 0.0F && z == 0.0F) {
            continue;
        }
        samples.values[3 * i] = sampleOf(x * scale + middle);
        samples.values[3 * i + 1] = sampleOf(y * scale + middle);
        samples.values[3 * i + 2] = sampleOf(z * scale + middle);
    }
    return samples;
}

} // namespace

PassSamples depthSamples(const ExrLayer& layer)
{
    PassSamples samples;
    samples.values.resize(floatsIn(layer, 0).size());
    std::ranges::transform(floatsIn(layer, 0), samples.values.begin(),
                           [](float metres) { return sampleOf(metres * kPerMetre); });
    return samples;
}

PassSamples normalSamples(const ExrLayer& layer)
{
    return threeOf(layer, kMostSample * 0.5F, kMostSample * 0.5F);
}

PassSamples positionSamples(const ExrLayer& layer)
{
    return threeOf(layer, kPerMetre, kMiddleSample);
}

PassSamples motionSamples(const ExrLayer& layer)
{
    const std::size_t count = floatsIn(layer, 0).size();
    PassSamples samples{3, std::vector<std::uint16_t>(3 * count)};
    for (std::size_t i = 0; i < count; ++i) {
        samples.values[3 * i] = sampleOf(floatsIn(layer, 0)[i] * kPerPixel + kMiddleSample);
        samples.values[3 * i + 1] = sampleOf(floatsIn(layer, 1)[i] * kPerPixel + kMiddleSample);
    }
    return samples;
}

PassSamples numberSamples(const ExrLayer& layer)
{
    const auto& numbers = std::get<std::vector<std::uint32_t>>(layer.channels[0].values);
    PassSamples samples{3, std::vector<std::uint16_t>(3 * numbers.size())};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        samples.values[3 * i] = static_cast<std::uint16_t>(numbers[i] >> 16U);
        samples.values[3 * i + 1] = static_cast<std::uint16_t>(numbers[i] & 0xFFFFU);
    }
    return samples;
}

} // namespace crowd::app
