// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "model/base/Result.h"

namespace crowd::model {

/// In the language of the window, for whatever shows it there; any thread.
[[nodiscard]] inline QString translated(const Message& message)
{
    return QString::fromStdString(message.in(
        [](const char* id) { return QCoreApplication::translate("Messages", id).toStdString(); }));
}

[[nodiscard]] inline QString translated(const Error& error)
{
    return translated(error.said);
}

} // namespace crowd::model
