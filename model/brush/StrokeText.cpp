// SPDX-License-Identifier: MIT
#include "model/brush/StrokeText.h"

#include <algorithm>
#include <iterator>

#include <QtCore/QCoreApplication>

#include "model/brush/Stroke.h"

namespace crowd::model {

namespace {

/// Home of the texts for translators.
struct Brushes
{
    Q_DECLARE_TR_FUNCTIONS(Brushes)
};

struct ReasonText
{
    StrokeReason reason;
    const char* text; ///< in English
};

/// Those that are said in the same words for each brush.
constexpr ReasonText kReasons[] = {
    {StrokeReason::NobodyUnderBrush, QT_TRANSLATE_NOOP("Brushes", "Nobody under the brush")},
    {StrokeReason::NoFreeSeat, QT_TRANSLATE_NOOP("Brushes", "No free seat under the brush")},
    {StrokeReason::NoChosenSeat,
     QT_TRANSLATE_NOOP("Brushes", "No free seat of the chosen rows and wedges under the brush")},
    {StrokeReason::NoTemplateChosen,
     QT_TRANSLATE_NOOP("Brushes", "Choose a template to create first")},
    {StrokeReason::TemplateNotLoaded,
     QT_TRANSLATE_NOOP("Brushes", "The chosen template is not loaded")},
    {StrokeReason::TooSteep, QT_TRANSLATE_NOOP("Brushes", "Too steep to stand on")},
    {StrokeReason::NotWalkable,
     QT_TRANSLATE_NOOP("Brushes",
                       "Nobody gets there on foot: raise “Highest step” (Environment, Where "
                       "characters can walk), or choose “Anywhere” in the brush settings")},
    {StrokeReason::TooSteepToWalk,
     QT_TRANSLATE_NOOP("Brushes",
                       "Too steep to walk: raise “Steepest slope” (Environment, Where characters "
                       "can walk), or choose “Anywhere” in the brush settings")},
    {StrokeReason::TooLowToWalk,
     QT_TRANSLATE_NOOP("Brushes",
                       "Too low to walk under: lower “Body height” (Environment, Where characters "
                       "can walk), or choose “Anywhere” in the brush settings")},
    {StrokeReason::TooNarrowToWalk,
     QT_TRANSLATE_NOOP("Brushes",
                       "Too near to a wall or an edge: lower “Body radius” (Environment, Where "
                       "characters can walk), or choose “Anywhere” in the brush settings")},
    {StrokeReason::ForbiddenGround,
     QT_TRANSLATE_NOOP("Brushes", "An obstacle or forbidden ground: choose “Anywhere” in the brush "
                                  "settings to create there all the same")},
    {StrokeReason::NothingUnderBrush,
     QT_TRANSLATE_NOOP("Brushes", "Nothing to stand on under the brush")},
    {StrokeReason::TooNearToOthers,
     QT_TRANSLATE_NOOP("Brushes", "Others are nearer than the minimal distance")},
    {StrokeReason::AreaTooFar,
     QT_TRANSLATE_NOOP("Brushes",
                       "The area is too large for this density: zoom in or lower the density")},
    {StrokeReason::TooFewInArea,
     QT_TRANSLATE_NOOP("Brushes", "The area is too small for anybody at this density")},
    {StrokeReason::ShareTooSmall,
     QT_TRANSLATE_NOOP("Brushes", "So small a share of them is nobody")},
    {StrokeReason::NoSuchSlot, QT_TRANSLATE_NOOP("Brushes", "None of them has the chosen slot")},
    {StrokeReason::NoSuchMaterial,
     QT_TRANSLATE_NOOP("Brushes", "None of them has the chosen material")},
    {StrokeReason::NoSession,
     QT_TRANSLATE_NOOP("Brushes",
                       "Nothing runs that could hear an event: give the scene rules, or characters "
                       "a path, and press Play")},
    {StrokeReason::NoSuchClip, QT_TRANSLATE_NOOP("Brushes", "None of them has a chosen clip")},
    {StrokeReason::NothingChosen,
     QT_TRANSLATE_NOOP("Brushes", "The brush is set to change nothing")},
    {StrokeReason::ScriptChangedNothing,
     QT_TRANSLATE_NOOP("Brushes", "The script brush changed nothing")},
    {StrokeReason::NoDirection, QT_TRANSLATE_NOOP("Brushes", "Drag to show the direction")},
    {StrokeReason::Masked,
     QT_TRANSLATE_NOOP("Brushes", "The mask of the brush leaves all of them out")},
    {StrokeReason::NoSuchRelation,
     QT_TRANSLATE_NOOP("Brushes", "The scene has no relation of that name: choose another one")},
    {StrokeReason::NobodyElse, QT_TRANSLATE_NOOP("Brushes", "Drag on to whom they are related")},
    {StrokeReason::NothingToErase,
     QT_TRANSLATE_NOOP("Brushes", "None of them has such a relation")},
    {StrokeReason::TooManyAtOnce,
     QT_TRANSLATE_NOOP("Brushes", "Those are too many relations at once: take fewer characters")},
    {StrokeReason::SourcesChosen,
     QT_TRANSLATE_NOOP("Brushes", "Now draw around those to whom they are related (Esc: no)")},
    {StrokeReason::GroupLocked,
     QT_TRANSLATE_NOOP("Brushes", "The group is locked or hidden: the Groups panel shows it")},
    {StrokeReason::NobodyChosen,
     QT_TRANSLATE_NOOP("Brushes", "Ctrl+click somebody to choose first")},
    {StrokeReason::NoSuchFeature,
     QT_TRANSLATE_NOOP("Brushes", "The scene has no such feature: choose another kind or value")},
    {StrokeReason::NoSuchPart, QT_TRANSLATE_NOOP("Brushes", "None of them has the chosen part")},
    {StrokeReason::OnlySeated,
     QT_TRANSLATE_NOOP("Brushes", "All of them sit: who sits keeps the seat")},
    {StrokeReason::NoState,
     QT_TRANSLATE_NOOP("Brushes", "Choose a state in the brush's settings first")},
    {StrokeReason::NoTake,
     QT_TRANSLATE_NOOP("Brushes", "No take is shown: keep what was played, then choose it in the "
                                  "Takes panel")},
    {StrokeReason::TakeBusy,
     QT_TRANSLATE_NOOP("Brushes", "Another take is still being made: wait for it")},
};

constexpr auto kLast = StrokeReason::TakeBusy;
constexpr std::size_t kSilent = 3; ///< None, Cancelled and Unchanged, which each brush says itself
static_assert(std::size(kReasons) + kSilent == static_cast<std::size_t>(kLast) + 1);

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

StrokeReason reasonOf(WalkRefusal refusal)
{
    switch (refusal) {
    case WalkRefusal::None:
        return StrokeReason::None;
    case WalkRefusal::Steep:
        return StrokeReason::TooSteepToWalk;
    case WalkRefusal::Low:
        return StrokeReason::TooLowToWalk;
    case WalkRefusal::Narrow:
        return StrokeReason::TooNarrowToWalk;
    case WalkRefusal::Unlinked:
        return StrokeReason::NotWalkable;
    }
    return StrokeReason::NotWalkable;
}

QString reasonText(StrokeReason reason, BrushKind kind)
{
    if (reason == StrokeReason::Unchanged) {
        return QCoreApplication::translate("Brushes", brushType(kind).info.unchanged);
    }
    const auto* found = std::ranges::find(kReasons, reason, &ReasonText::reason);
    return found == std::end(kReasons) ? QString()
                                       : QCoreApplication::translate("Brushes", found->text);
}

} // namespace crowd::model
