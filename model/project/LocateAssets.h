// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene/Scene.h"

namespace crowd::model {

/// An entry of the scene whose asset could not be loaded.
struct MissingAsset
{
    bool isStage = false;
    unsigned id = 0; ///< of the template or the stage
    std::string name;
    std::string path; ///< where it was looked for
    Message problem;  ///< why it is not there
};

[[nodiscard]] std::vector<MissingAsset> missingAssets(const Scene& scene);

/// What pictures of the scene lack: stages, and characters of whom there is somebody. One or more
/// sentences each.
[[nodiscard]] std::vector<std::string> missingFromPictures(const Scene& scene);

/// Where a missing file probably is now that another one, missing at `oldPath`, was found at
/// `newPath`: in the folder found under its own name, or moved the same way with a whole tree of
/// folders. Empty when neither is there.
[[nodiscard]] std::string movedAlong(const std::string& missingPath, const std::string& oldPath,
                                     const std::string& newPath);

} // namespace crowd::model
