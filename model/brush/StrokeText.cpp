// SPDX-License-Identifier: MIT
#include "model/brush/StrokeText.h"

#include <QtCore/QCoreApplication>

#include "model/brush/Stroke.h"

namespace crowd::model {

namespace {

/// Home of the texts for translators.
struct Brushes
{
    Q_DECLARE_TR_FUNCTIONS(Brushes)
};

} // namespace

QString strokeText(const BrushSettings& settings, int affected)
{
    const QString text = QCoreApplication::translate(
        "Brushes", brushType(settings.kind()).info.undo, nullptr, affected);
    const auto* script = settings.find<ScriptSettings>();
    return script != nullptr ? text.arg(QString::fromStdString(script->brush)) : text;
}

QString moveText(int affected)
{
    return Brushes::tr("Move %n character(s)", nullptr, affected);
}

QString reasonText(StrokeReason reason, BrushKind kind)
{
    switch (reason) {
    case StrokeReason::None:
    case StrokeReason::Cancelled:
        return {};
    case StrokeReason::NobodyUnderBrush:
        return Brushes::tr("Nobody under the brush");
    case StrokeReason::NoFreeSeat:
        return Brushes::tr("No free seat under the brush");
    case StrokeReason::NoChosenSeat:
        return Brushes::tr("No free seat of the chosen rows and wedges under the brush");
    case StrokeReason::NoTemplateChosen:
        return Brushes::tr("Choose a template to create first");
    case StrokeReason::TemplateNotLoaded:
        return Brushes::tr("The chosen template is not loaded");
    case StrokeReason::TooSteep:
        return Brushes::tr("Too steep to stand on");
    case StrokeReason::NotWalkable:
        return Brushes::tr("Nobody can walk there: choose “Anywhere” in the brush settings to "
                           "create characters there all the same");
    case StrokeReason::NothingUnderBrush:
        return Brushes::tr("Nothing to stand on under the brush");
    case StrokeReason::TooNearToOthers:
        return Brushes::tr("Others are nearer than the minimal distance");
    case StrokeReason::AreaTooFar:
        return Brushes::tr("The area is too large for this density: zoom in or lower the density");
    case StrokeReason::TooFewInArea:
        return Brushes::tr("The area is too small for anybody at this density");
    case StrokeReason::ShareTooSmall:
        return Brushes::tr("So small a share of them is nobody");
    case StrokeReason::Unchanged:
        return QCoreApplication::translate("Brushes", brushType(kind).info.unchanged);
    case StrokeReason::NoSuchSlot:
        return Brushes::tr("None of them has the chosen slot");
    case StrokeReason::NoSession:
        return Brushes::tr(
            "Nothing runs that could hear an event: give the scene rules, or characters "
            "a path, and press Play");
    case StrokeReason::NoSuchClip:
        return Brushes::tr("None of them has a chosen clip");
    case StrokeReason::NothingChosen:
        return Brushes::tr("The brush is set to change nothing");
    case StrokeReason::ScriptChangedNothing:
        return Brushes::tr("The script brush changed nothing");
    case StrokeReason::NoDirection:
        return Brushes::tr("Drag to show the direction");
    }
    return {};
}

} // namespace crowd::model
