// SPDX-License-Identifier: MIT
#include "widgets/state/FeatureTexts.h"

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

QString featureText(const std::string& name)
{
    return QCoreApplication::translate("Features", name.c_str());
}

std::vector<model::NamedFeature> featureEntries(const model::Scene& scene)
{
    std::vector<model::NamedFeature> entries = model::allFeatures(scene.features);
    for (model::NamedFeature& each : entries) {
        each.name = QStringLiteral("%1 (%2)")
                        .arg(featureText(each.name), featureText(each.kind))
                        .toStdString();
    }
    return entries;
}

} // namespace crowd::widgets
