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
    switch (settings.kind) {
    case BrushKind::Create:
        return Brushes::tr("Create %n character(s)", nullptr, affected);
    case BrushKind::Delete:
        return Brushes::tr("Delete %n character(s)", nullptr, affected);
    case BrushKind::Colour:
        return Brushes::tr("Colour %n character(s)", nullptr, affected);
    case BrushKind::Orientation:
        return Brushes::tr("Turn %n character(s)", nullptr, affected);
    case BrushKind::Animation:
        return Brushes::tr("Animate %n character(s)", nullptr, affected);
    case BrushKind::Walk:
        return Brushes::tr("Set the walk of %n character(s)", nullptr, affected);
    case BrushKind::Style:
        return Brushes::tr("Set how %n character(s) walk", nullptr, affected);
    case BrushKind::Tag:
        return Brushes::tr("Tag %n character(s)", nullptr, affected);
    case BrushKind::Untag:
        return Brushes::tr("Untag %n character(s)", nullptr, affected);
    case BrushKind::Event:
        return Brushes::tr("Event reached %n character(s)", nullptr, affected);
    case BrushKind::Path:
    case BrushKind::Environment:
        break;
    case BrushKind::Script:
        return Brushes::tr("%1: %n character(s)", nullptr, affected)
            .arg(QString::fromStdString(settings.script.brush));
    }
    return {};
}

QString moveText(int affected)
{
    return Brushes::tr("Move %n character(s)", nullptr, affected);
}

QString reasonText(StrokeReason reason)
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
    case StrokeReason::AlreadyThisColour:
        return Brushes::tr("All of them already have this colour");
    case StrokeReason::NoSuchSlot:
        return Brushes::tr("None of them has the chosen slot");
    case StrokeReason::AlreadyThisHeading:
        return Brushes::tr("All of them already face this way");
    case StrokeReason::AlreadyThisAnimation:
        return Brushes::tr("All of them already move like this");
    case StrokeReason::AlreadyThisWalk:
        return Brushes::tr("All of them already walk like this");
    case StrokeReason::AlreadyThisTag:
        return Brushes::tr("All of them already have this tag");
    case StrokeReason::WithoutThisTag:
        return Brushes::tr("None of them has this tag");
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
