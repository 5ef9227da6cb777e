// SPDX-License-Identifier: MIT
#include "widgets/state/RelationTexts.h"

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

QString relationText(const std::string& name)
{
    return QCoreApplication::translate("Relations", name.c_str());
}

model::RelationKinds relationEntries(const model::Scene& scene)
{
    model::RelationKinds entries = scene.relationKinds;
    for (model::RelationKind& each : entries) {
        each.name = relationText(each.name).toStdString();
    }
    return entries;
}

} // namespace crowd::widgets
