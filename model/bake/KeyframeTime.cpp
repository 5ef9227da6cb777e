// SPDX-License-Identifier: MIT
#include "model/bake/KeyframeTime.h"

#include <algorithm>

namespace crowd::model {

namespace {

constexpr float kInterval = 1.0F / static_cast<float>(kKeyframeRate);

} // namespace

KeyframePlace keyframePlace(const Clip& clip, float phase)
{
    const int last = clip.keyframeCount() - 1;
    if (last == 0) {
        return {};
    }
    const float seconds = std::clamp(phase, 0.0F, 1.0F) * clip.seconds;
    const int first =
        std::min(static_cast<int>(seconds * static_cast<float>(kKeyframeRate)), last - 1);
    const float begin = static_cast<float>(first) * kInterval;
    const float width = first == last - 1 ? clip.seconds - begin : kInterval;
    return {first, first + 1, std::clamp((seconds - begin) / width, 0.0F, 1.0F)};
}

} // namespace crowd::model
