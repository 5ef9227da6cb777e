// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

/// Features as files of their own, so that projects share them.
namespace crowd::model {

inline constexpr const char* kFeatureFileEnding = "features";

[[nodiscard]] Result<void> writeFeatureFile(const FeatureKinds& kinds, const QString& path);
/// Errors name the file and the place in it.
[[nodiscard]] Result<FeatureKinds> readFeatureFile(const QString& path);

/// The scene's kinds with others: one of the same name gets their values, where those of the same
/// name replace its own and keep the id; others get ids of the scene. Limits to templates, which
/// are of the scene that they come from, are dropped. An error where there is no room.
[[nodiscard]] Result<FeatureKinds> withKinds(const Scene& scene, const FeatureKinds& others);

} // namespace crowd::model
