// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/base/Result.h"
#include "model/project/LocateAssets.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

/// Assets that were missing, read from where they are now.
struct FoundAssets
{
    template<class Id, class Asset>
    struct Item
    {
        Id id;
        std::string path;
        Asset asset;
    };
    std::vector<Item<model::TemplateId, model::TemplatePtr>> templates;
    std::vector<Item<std::uint8_t, model::StagePtr>> stages;
};

/// The asset read from its new place `path`, and those of the scene's other missing ones that moved
/// along with it (see model::movedAlong); of these, what cannot be read stays missing. Any thread.
[[nodiscard]] model::Result<FoundAssets> findAssets(const model::Scene& scene,
                                                    const model::MissingAsset& asset,
                                                    const std::string& path,
                                                    const model::LoadProgress& progress);

} // namespace crowd::app
