// SPDX-License-Identifier: MIT
#include "model/project/UserFolder.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStandardPaths>

namespace crowd::model {

QString userFolder()
{
    if (!QCoreApplication::organizationName().isEmpty()) {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    }
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/%1/%1").arg(QLatin1String(kProgramName));
}

} // namespace crowd::model
