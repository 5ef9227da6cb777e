// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

/// Names for processes, to be part of the names of files that only they write.
namespace crowd::model {

/// Process ids come again, but not with the same start: both make the name.
[[nodiscard]] QString ownProcessName();
/// Whether the process of that name on this machine still works; one that was ended and is only
/// not yet cleared away does not.
[[nodiscard]] bool isProcessAlive(const QString& name);

} // namespace crowd::model
