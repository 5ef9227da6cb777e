// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QStringList>

/// The scenes opened or saved last, newest first, kept in the settings (shared by all editors).
namespace crowd::app {

inline constexpr int kMaxRecentFiles = 10;

[[nodiscard]] QStringList recentFiles(); ///< absolute paths
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);
void clearRecentFiles();

} // namespace crowd::app
