// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Told before each asset; false stops (the scene then keeps the assets loaded so far, and the
/// others say that loading was cancelled). fraction is 0..1 of all.
using LoadProgress = std::function<bool(const std::string& what, float fraction)>;

/// Loads the assets that entries of the scene lack. One that cannot be had stays null with the
/// reason in its entry's `problem`; the scene is otherwise intact and saves without loss.
void loadAssets(Scene& scene, const LoadProgress& progress = {});

/// For each entry the first one that comes of the same file by the same settings: itself, where
/// there is none before it. What is loaded for that one serves all.
[[nodiscard]] std::vector<std::size_t> firstAlike(const std::vector<TemplateEntry>& entries);

/// Loads one entry's asset: the asset, or why it is not there. Any thread.
[[nodiscard]] Result<TemplatePtr> loadTemplateAsset(const TemplateEntry& entry,
                                                    const LoadProgress& progress = {});
[[nodiscard]] Result<StagePtr> loadStageAsset(const StageEntry& entry,
                                              const LoadProgress& progress = {});

/// A project file with its assets.
[[nodiscard]] Result<Scene> loadScene(const QString& path, const LoadProgress& progress = {});

/// Gives an entry its asset. The entry's clip names stay what the clip column indexes: the asset's
/// clips are put into that order (one that vanished is replaced by the default clip), new ones are
/// appended to both.
void attachAsset(TemplateEntry& entry, TemplatePtr asset);

/// Every built-in template, by name, ids from 1. Assets are not loaded.
[[nodiscard]] std::vector<TemplateEntry> builtinCast();

/// A scene without people: built-in templates that suit it, cameras, and for the theatre the
/// built-in theatre as stage. Assets are not loaded.
[[nodiscard]] Scene newEmptyGround();
[[nodiscard]] Scene newEmptyTheatre();

} // namespace crowd::model
