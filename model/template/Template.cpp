// SPDX-License-Identifier: MIT
#include "model/template/Template.h"

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

int Template::clipIndex(const std::string& clipName) const
{
    return indexOfName(clips, clipName);
}

int Template::slotIndex(const std::string& slotName) const
{
    return indexOfName(slots, slotName);
}

} // namespace crowd::model
