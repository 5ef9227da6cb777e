// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

namespace crowd::model {

/// Built-in assets are written "builtin:templates/man.glb".
[[nodiscard]] bool isBuiltin(const std::string& assetPath);

/// Folder of the built-in content: CROWDBRUSH_RESOURCES when set, else found from the program's
/// folder (the build tree's ../../resources, an installation's ../share/crowdbrush). Empty: none
/// found.
[[nodiscard]] QString builtinFolder();
/// Says where the program lies when it is not the running executable: a module in another one.
/// Called once, before anything else.
void setProgramFolder(const QString& folder);

/// The file behind an asset path as entries hold it. Empty for a built-in one that leads out of the
/// built-in folder.
[[nodiscard]] QString assetFile(const std::string& assetPath);

/// As written in a project file in `folder`: relative to it, with '/', unless built in or on
/// another root.
[[nodiscard]] std::string storedAssetPath(const std::string& assetPath, const QString& folder);

/// The reverse: absolute, or "builtin:…" unchanged.
[[nodiscard]] std::string absoluteAssetPath(const std::string& storedPath, const QString& folder);

} // namespace crowd::model
