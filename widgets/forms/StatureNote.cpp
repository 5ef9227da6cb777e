// SPDX-License-Identifier: MIT
#include "widgets/forms/StatureNote.h"

#include <algorithm>
#include <limits>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtWidgets/QLabel>

#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"

namespace crowd::widgets {

namespace {

struct StatureText
{
    Q_DECLARE_TR_FUNCTIONS(StatureNote)
};

bool isCreated(const model::BrushSettings* brush, model::TemplateId id)
{
    if (brush == nullptr || brush->kind() != model::BrushKind::Create) {
        return true;
    }
    const auto& mix = brush->as<model::CreateSettings>().mix;
    return std::ranges::any_of(mix, [id](const model::TemplateWeight& each) {
        return each.id == id && each.weight > 0.0F;
    });
}

QString metres(float value)
{
    return QLocale().toString(static_cast<double>(value), 'f', 2);
}

} // namespace

QString statureText(const model::FieldContext& context, const model::ValueRange& share)
{
    float low = std::numeric_limits<float>::infinity();
    float high = 0.0F;
    if (context.scene != nullptr) {
        for (const model::TemplateEntry& entry : context.scene->templates) {
            if (entry.asset && isCreated(context.brush, entry.id)) {
                low = std::min(low, entry.asset->height);
                high = std::max(high, entry.asset->height);
            }
        }
    }
    if (!(low > 0.0F && low <= high)) {
        return {};
    }
    const QString from = metres(low * std::min(share.low, share.high));
    const QString to = metres(high * std::max(share.low, share.high));
    return from == to ? StatureText::tr("%1 m tall").arg(from)
                      : StatureText::tr("%1 to %2 m tall").arg(from, to);
}

void addStatureNote(FieldForm& form, const FieldForm::Bound& bound)
{
    auto* note = new QLabel(&form);
    note->setObjectName(QStringLiteral("stature"));
    note->setEnabled(false);
    note->setAlignment(Qt::AlignRight);
    const auto text = [&form, bound] {
        return statureText(form.context(), form.valueOf<model::ValueRange>(bound));
    };
    form.bind(
        note, [note, text] { note->setText(text()); },
        [bound, text] { return (!bound.isShown || bound.isShown()) && !text().isEmpty(); });
}

} // namespace crowd::widgets
