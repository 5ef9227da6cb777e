// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

struct CollectedEntries
{
    std::vector<TemplateEntry> templates; ///< those whose path changed
    std::vector<StageEntry> stages;
};

/// Copies every asset that is not built in, with the files it refers to, into `folder`/assets/NAME/
/// and returns the entries with their new paths. Fails, having changed nothing in the scene, at the
/// first file that cannot be copied.
[[nodiscard]] Result<CollectedEntries> collectAssets(const Scene& scene, const QString& folder);

} // namespace crowd::model
