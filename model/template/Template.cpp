// SPDX-License-Identifier: MIT
#include "model/template/Template.h"

#include <algorithm>
#include <cmath>

namespace crowd::model {

namespace {

template<class Named>
int indexOfName(const std::vector<Named>& items, const std::string& name)
{
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].name == name) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

} // namespace

int Clip::keyframeCount() const
{
    if (seconds <= 0.0F) {
        return 1;
    }
    return static_cast<int>(std::lround(seconds * static_cast<float>(kKeyframeRate))) + 1;
}

float Clip::keyframeSeconds(int keyframe) const
{
    if (keyframe <= 0) {
        return 0.0F;
    }
    return keyframe + 1 >= keyframeCount()
               ? seconds
               : static_cast<float>(keyframe) / static_cast<float>(kKeyframeRate);
}

float Clip::keyframeAt(float secondsAfterStart) const
{
    const int last = keyframeCount() - 1;
    const float at = std::clamp(secondsAfterStart, 0.0F, seconds);
    const float lastRegular = keyframeSeconds(last - 1);
    if (last < 1 || at <= lastRegular) {
        return last < 1 ? 0.0F : at * static_cast<float>(kKeyframeRate);
    }
    return static_cast<float>(last - 1) + (at - lastRegular) / (seconds - lastRegular);
}

int Template::clipIndex(const std::string& clipName) const
{
    return indexOfName(clips, clipName);
}

int Template::slotIndex(const std::string& slotName) const
{
    return indexOfName(slots, slotName);
}

} // namespace crowd::model
