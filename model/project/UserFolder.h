// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

namespace crowd::model {

/// What the program calls itself and whom it is of: its folders and settings are named so.
inline constexpr const char* kProgramName = "Crowdbrush";

/// Where the editor keeps what is the user's own. Scripts find the same, whatever program Python
/// is, as long as that program does not call itself something else.
[[nodiscard]] QString userFolder();

} // namespace crowd::model
