// SPDX-License-Identifier: MIT
#include "model/bake/SharedClips.h"

#include <map>
#include <mutex>
#include <utility>

namespace crowd::model {

namespace {

/// `owner` tells a template from a later one at the same address.
struct SharedClip
{
    std::weak_ptr<const Template> owner;
    std::weak_ptr<const BakedClip> clip;
};

std::mutex sharedClipsMutex;

std::map<std::pair<const Template*, int>, SharedClip>& sharedClips()
{
    static std::map<std::pair<const Template*, int>, SharedClip> clips;
    return clips;
}

} // namespace

BakedClipPtr findSharedClip(const TemplatePtr& asset, int clipIndex)
{
    const std::lock_guard<std::mutex> guard(sharedClipsMutex);
    const auto found = sharedClips().find({asset.get(), clipIndex});
    if (found == sharedClips().end() || found->second.owner.lock() != asset) {
        return nullptr;
    }
    return found->second.clip.lock();
}

void shareClip(const TemplatePtr& asset, int clipIndex, const BakedClipPtr& clip)
{
    const std::lock_guard<std::mutex> guard(sharedClipsMutex);
    std::erase_if(sharedClips(), [](const auto& item) { return item.second.clip.expired(); });
    sharedClips()[{asset.get(), clipIndex}] = {asset, clip};
}

} // namespace crowd::model
