// SPDX-License-Identifier: MIT
#include "widgets/tools/BrushTool.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>

#include "model/base/Random.h"
#include "widgets/commands/GroupCommands.h"
#include "widgets/state/BrushStart.h"
#include "widgets/tools/BrushDrags.h"
#include "widgets/tools/Candidates.h"
#include "widgets/tools/GhostPreview.h"

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSelection;
using model::BrushSettings;

namespace {

struct BrushToolText
{
    Q_DECLARE_TR_FUNCTIONS(BrushTool)
};

QString whatItDoes(BrushKind kind)
{
    const model::BrushType& type = model::brushType(kind);
    const QString hint = QCoreApplication::translate("BrushTool", type.info.hint);
    const bool saysAll =
        type.take == nullptr || std::string_view(type.info.hint).find("Ctrl") != std::string::npos;
    return saysAll ? hint : BrushToolText::tr("%1 · Ctrl+click: take it from somebody").arg(hint);
}

/// What a stroke is painted with that begins now. Ctrl takes relations away.
BrushSettings pressedSettings(const BrushSettings& settings, Qt::MouseButton button,
                              Qt::KeyboardModifiers modifiers, const EditorState& state)
{
    BrushSettings pressed = settingsForButton(settings, button, state.viewOptions().buttons);
    if (auto* relation = pressed.find<model::RelationSettings>()) {
        relation->erases |= modifiers.testFlag(Qt::ControlModifier);
    }
    if (pressed.mask.onlySelected) {
        const auto selected = state.selection().ids();
        pressed.mask.selected.assign(selected.begin(), selected.end());
    }
    return pressed;
}

} // namespace

BrushTool::BrushTool(const ToolContext& context, BrushKind kind) : m_context(context), m_kind(kind)
{
}

const BrushSettings& BrushTool::settings() const
{
    return m_context.state.brush(m_kind);
}

std::uint64_t BrushTool::nextSeed() const
{
    return model::hashKeys(m_context.state.scene().seed, static_cast<std::uint64_t>(m_kind),
                           m_strokes);
}

QString BrushTool::hint() const
{
    if (const auto pick = pickFor(Qt::NoModifier)) {
        return pickText(*pick);
    }
    const QString general =
        m_context.state.viewOptions().buttons == ButtonMapping::Paper
            ? BrushToolText::tr("Left: point · Middle: circle · Right: rectangle · "
                                "Alt or Space and drag: navigate · [ ]: size")
            : BrushToolText::tr(
                  "Right button: brushes · Alt or Space and drag: navigate · [ ]: size");
    return BrushToolText::tr("%1 · %2").arg(whatItDoes(m_kind), general);
}

std::optional<PickKind> BrushTool::pickFor(Qt::KeyboardModifiers modifiers) const
{
    switch (m_context.state.picking()) {
    case Picking::Colour:
        return PickKind::Colour;
    case Picking::Point:
        return PickKind::Point;
    case Picking::Place: // whatever the tool is
    case Picking::Person:
    case Picking::None:
        break;
    }
    return modifiers == Qt::ControlModifier ? pickOfBrush(m_kind) : std::nullopt;
}

/// Then a click chooses whom to clone, as it does with Ctrl.
bool BrushTool::isSourceMissing() const
{
    const auto* clone = settings().find<model::CloneSettings>();
    return clone != nullptr &&
           m_context.state.scene().population.rowOf(clone->source) == model::Population::npos;
}

void BrushTool::showTarget(ToolPicture& picture) const
{
    const model::HeadingSettings* heading = settings().heading();
    const auto* create = settings().find<model::CreateSettings>();
    const bool isUsed = heading != nullptr && (create == nullptr || !create->seats.isOn);
    if (isUsed && heading->mode == model::HeadingMode::TowardsPoint) {
        if (const auto pixel = m_context.queries.view().project(heading->towardsPoint)) {
            picture.target = QPointF(pixel->x, pixel->y);
        }
    }
}

DragSessionPtr BrushTool::press(const ToolInput& input)
{
    const ButtonMapping mapping = m_context.state.viewOptions().buttons;
    const bool isPaintButton =
        input.button == Qt::LeftButton ||
        (mapping == ButtonMapping::Paper &&
         (input.button == Qt::MiddleButton || input.button == Qt::RightButton));
    if (!isPaintButton || m_context.state.document().isEditOpen()) {
        return nullptr;
    }
    if (const auto pick = pickFor(input.modifiers); pick && input.button == Qt::LeftButton) {
        return std::make_unique<PickDrag>(m_context, m_kind, *pick, input);
    }
    if (input.modifiers.testFlag(Qt::ShiftModifier) && settings().hasCircle()) {
        return std::make_unique<ResizeDrag>(m_context, m_kind, input);
    }
    if (isSourceMissing()) {
        return std::make_unique<PickDrag>(m_context, m_kind, PickKind::Person, input);
    }
    if (m_kind == BrushKind::Group) {
        makeFirstGroup(m_context.state);
    }
    const std::uint64_t seed = nextSeed();
    ++m_strokes;
    if (m_kind == BrushKind::Script) {
        return scriptStroke(seed, input);
    }
    return std::make_unique<StrokeDrag>(
        m_context, pressedSettings(settings(), input.button, input.modifiers, m_context.state),
        seed, input);
}

DragSessionPtr BrushTool::scriptStroke(std::uint64_t seed, const ToolInput& input)
{
    EditorState& state = m_context.state;
    ScriptPainter* painter = state.scriptPainter();
    if (painter == nullptr || state.scriptBrushes().empty()) {
        state.refuse(
            BrushToolText::tr("No script brush is there yet: a script brings one along with "
                              "crowdbrush.register_brush."));
        return nullptr;
    }
    const BrushSettings chosen = pressedSettings(settings(), input.button, input.modifiers, state);
    if (!painter->begin(m_context.queries.brushContext(), chosen, seed, input.pointer)) {
        return nullptr;
    }
    return std::make_unique<ScriptStrokeDrag>(*painter, chosen, input);
}

void BrushTool::hover(const ToolInput& input, ToolPicture& picture) const
{
    showTarget(picture);
    if (const auto pick = pickFor(input.modifiers)) {
        picture.cursor = Qt::CrossCursor;
        picture.mode = m_context.state.picking() == Picking::None ? QString() : pickText(*pick);
        return;
    }
    showBrush(settings(), input.position(), 1.0, picture);
    picture.label = missingOf(m_context.state, m_kind);
    if (isSourceMissing()) {
        picture.cursor = Qt::CrossCursor;
    }
}

void BrushTool::preview(const ToolInput& input, ToolPicture& picture) const
{
    picture.ghosts.clear();
    picture.candidates.clear();
    if (pickFor(input.modifiers) || m_context.state.document().isEditOpen()) {
        return;
    }
    if (m_kind == BrushKind::Create) {
        picture.ghosts = ghostsAt(m_context, settings(), nextSeed(), input);
    } else if (worksOnPeople(m_kind)) {
        const BrushSettings pressed =
            pressedSettings(settings(), Qt::LeftButton, input.modifiers, m_context.state);
        picture.candidates = candidatesAt(m_context, pressed, input);
    }
}

BrushSettings settingsForButton(const BrushSettings& settings, Qt::MouseButton button,
                                ButtonMapping mapping)
{
    BrushSettings result = settings;
    if (mapping == ButtonMapping::Paper) {
        if (button == Qt::LeftButton) {
            result.selection = BrushSelection::Point;
        } else if (button == Qt::RightButton) {
            result.selection = BrushSelection::Rectangle;
        } else if (!settings.hasCircle()) {
            result.selection = BrushSelection::Spray;
        }
    }
    return result;
}

BrushSettings resizedBySteps(const BrushSettings& settings, double steps, bool isFine)
{
    const double share = isFine ? 0.03 : 0.12;
    if (settings.addsPlaces()) {
        return settings.withMainNumber(settings.mainNumber().value * (1.0 + share * steps));
    }
    const double pixels = std::max(1.0, std::round(settings.radiusPixels * share));
    return settings.resized(static_cast<float>(pixels * steps));
}

BrushSettings steppedMainNumber(const BrushSettings& settings, int steps)
{
    const model::MainNumber number = settings.mainNumber();
    return settings.withMainNumber(number.value + number.step * steps);
}

} // namespace crowd::widgets
