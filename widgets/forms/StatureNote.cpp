// SPDX-License-Identifier: MIT
#include "widgets/forms/StatureNote.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// Templates whose heights differ more than people do are told apart by name.
constexpr float kUnlike = 2.0F;

struct Stature
{
    const model::TemplateEntry* entry = nullptr;
    float metres = 0.0F;
};

/// The lowest and the highest of those that come to the scene; none if there are none.
std::optional<std::pair<Stature, Stature>> extremes(const model::FieldContext& context)
{
    std::optional<std::pair<Stature, Stature>> found;
    if (context.scene == nullptr) {
        return found;
    }
    for (const model::TemplateEntry& entry : context.scene->templates) {
        if (!entry.asset || !isCreated(context.brush, entry.id) || !(entry.asset->height > 0.0F)) {
            continue;
        }
        const Stature each{&entry, entry.asset->height};
        if (!found) {
            found.emplace(each, each);
        }
        found->first = each.metres < found->first.metres ? each : found->first;
        found->second = each.metres > found->second.metres ? each : found->second;
    }
    return found;
}

QString metres(float value)
{
    return QLocale().toString(static_cast<double>(value), 'f', 2);
}

} // namespace

QString statureText(const model::FieldContext& context, const model::ValueRange& share)
{
    const auto found = extremes(context);
    if (!found) {
        return {};
    }
    const auto& [low, high] = *found;
    const QString from = metres(low.metres * std::min(share.low, share.high));
    const QString to = metres(high.metres * std::max(share.low, share.high));
    if (high.metres > kUnlike * low.metres) {
        return StatureText::tr("%1 from %2 m\n%3 to %4 m")
            .arg(QString::fromStdString(low.entry->name), from,
                 QString::fromStdString(high.entry->name), to);
    }
    return from == to ? StatureText::tr("%1 m tall").arg(from)
                      : StatureText::tr("%1 to %2 m tall").arg(from, to);
}

void addStatureNote(FieldForm& form, const FieldForm::Bound& bound)
{
    auto* note = new QLabel(&form);
    note->setObjectName(QStringLiteral("stature"));
    note->setEnabled(false);
    note->setAlignment(Qt::AlignRight);
    note->setWordWrap(true); // names may be long
    note->setMinimumWidth(1);
    const auto text = [&form, bound] {
        return statureText(form.context(), form.valueOf<model::ValueRange>(bound));
    };
    form.bind(
        note, [note, text] { note->setText(text()); },
        [bound, text] { return (!bound.isShown || bound.isShown()) && !text().isEmpty(); });
}

} // namespace crowd::widgets
