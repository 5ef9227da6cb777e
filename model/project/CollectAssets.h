// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

struct CollectedEntries
{
    std::vector<TemplateEntry> templates; ///< those whose path changed
    std::vector<StageEntry> stages;
    QStringList leftBehind; ///< files that could not come along because they are missing
};

/// Copies every asset that is not built in, with the files it refers to, into `folder`/assets/NAME/
/// and returns the entries with their new paths. What lies below `folder`/assets already stays
/// there; files of the same name from different folders get folders of their own (NAME-2, …).
/// Fails, having changed nothing in the scene, at the first file that cannot be copied; files there
/// are replaced whole or not at all.
[[nodiscard]] Result<CollectedEntries> collectAssets(const Scene& scene, const QString& folder);

} // namespace crowd::model
