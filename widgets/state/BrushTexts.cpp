// SPDX-License-Identifier: MIT
#include "widgets/state/BrushTexts.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include "model/view/PropertyPaint.h"

namespace crowd::widgets {

using model::BrushSelection;

namespace {

struct BrushTextsContext
{
    Q_DECLARE_TR_FUNCTIONS(BrushTexts)
};

} // namespace

QString toolName(ToolId id)
{
    return QCoreApplication::translate("Tools", toolInfo(id).name);
}

QString fieldText(const char* text)
{
    return *text != '\0' ? QCoreApplication::translate("Fields", text) : QString();
}

QString selectionName(BrushSelection selection)
{
    return fieldText(model::kSelections[static_cast<std::size_t>(selection)].label);
}

QString mainNumberName(const model::MainNumber& number)
{
    return BrushTextsContext::tr(number.label);
}

QString mainNumberText(const model::BrushSettings& settings)
{
    const model::MainNumber number = settings.mainNumber();
    return BrushTextsContext::tr(number.format)
        .arg(QLocale().toString(number.value, 'f', number.decimals));
}

QString brushSizeText(const model::BrushSettings& settings)
{
    return settings.addsPlaces()
               ? mainNumberText(settings)
               : QCoreApplication::translate("crowd::widgets::ToolController", "Brush size: %1 px")
                     .arg(qRound(settings.radiusPixels));
}

QString placeRoleName(model::PlaceRole role)
{
    return fieldText(model::kPlaceRoles[static_cast<std::size_t>(role)].label);
}

QStringList placeRoleNames()
{
    QStringList names;
    for (int role = 0; role <= static_cast<int>(model::PlaceRole::Preferred); ++role) {
        names << placeRoleName(static_cast<model::PlaceRole>(role));
    }
    return names;
}

QString placeRoleTip(model::PlaceRole role)
{
    return fieldText(model::kPlaceRoles[static_cast<std::size_t>(role)].tip);
}

QColor tagColor(const model::Scene& scene, int bit)
{
    return QColor::fromRgb(model::tagColor(scene, bit));
}

QString tagText(const model::Scene& scene, int bit)
{
    const auto named = std::ranges::find(scene.tags, bit, &model::TagName::bit);
    return named != scene.tags.end() && !named->name.empty()
               ? QString::fromStdString(named->name)
               : BrushTextsContext::tr("Tag %1").arg(bit + 1);
}

} // namespace crowd::widgets
