// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

namespace crowd::widgets {

/// A kind of relation: those that are ready-made in the artist's language.
[[nodiscard]] QString relationText(const std::string& name);

} // namespace crowd::widgets
