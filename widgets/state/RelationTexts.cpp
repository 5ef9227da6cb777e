// SPDX-License-Identifier: MIT
#include "widgets/state/RelationTexts.h"

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

QString relationText(const std::string& name)
{
    return QCoreApplication::translate("Relations", name.c_str());
}

} // namespace crowd::widgets
