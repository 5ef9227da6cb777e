// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>

#include "model/project/Autosave.h"

namespace crowd::testing {

/// Makes this process's autosave of a document look like one whose process is gone; its new path.
inline QString leaveBehind(const QString& projectPath, int crash = 0)
{
    const QString own = model::autosavePath(projectPath);
    const QString id = QString::number(QCoreApplication::applicationPid());
    QString left = own;
    left.replace(QRegularExpression(QStringLiteral("\\.%1-[0-9]+\\.").arg(id)),
                 QStringLiteral(".%1-1.").arg(9'000'000 + crash)); // ids are never that high
    return left != own && QFile::rename(own, left) ? left : QString();
}

} // namespace crowd::testing
