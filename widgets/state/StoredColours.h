// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QStringList>
#include <QtGui/QColor>

/// Colours that are kept over restarts, under keys of the settings.
namespace crowd::widgets {

/// Painted with lately, the last one first.
inline constexpr const char* kRecentColours = "colours/recent";

/// `otherwise`: names of those that there are while nothing is kept.
[[nodiscard]] std::vector<QColor> storedColours(const char* key, const QStringList& otherwise = {});
void storeColours(const char* key, const std::vector<QColor>& colors);

} // namespace crowd::widgets
