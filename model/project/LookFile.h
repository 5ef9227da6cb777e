// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

/// Looks as files of their own, so that projects share them.
namespace crowd::model {

inline constexpr const char* kLookFileEnding = "looks";

[[nodiscard]] Result<void> writeLookFile(const Looks& looks, const QString& path);
/// Errors name the file and the place in it.
[[nodiscard]] Result<Looks> readLookFile(const QString& path);
/// A scene's looks with others: one of the same name is replaced and keeps its id, others get ids
/// of their own behind them. An error where there is no room.
[[nodiscard]] Result<Looks> withLooks(Scene scene, const Looks& others);

} // namespace crowd::model
