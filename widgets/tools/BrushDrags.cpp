// SPDX-License-Identifier: MIT
#include "widgets/tools/BrushDrags.h"

#include <algorithm>

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSelection;
using model::BrushSettings;

namespace {

struct BrushDragsText
{
    Q_DECLARE_TR_FUNCTIONS(BrushTool)
};

} // namespace

QPolygonF closed(QPolygonF way)
{
    if (!way.isEmpty()) {
        way << way.front();
    }
    return way;
}

QString affectedText(BrushKind kind, int count)
{
    return QCoreApplication::translate("BrushTool", model::brushType(kind).info.done, nullptr,
                                       count);
}

PressedWay::Work PressedWay::moved(const ToolInput& input)
{
    m_current = input;
    m_way << input.position();
    if (!m_settings.isReevaluated()) {
        return Work::Paint;
    }
    return m_settings.selection == BrushSelection::Lasso ? Work::Pass : Work::None;
}

PressedWay::Work PressedWay::rested(const ToolInput& resting, const glm::ivec2& painted)
{
    m_current = resting;
    const bool isResting = painted == resting.pointer.grid;
    return isResting && m_settings.isReevaluated() ? Work::None : Work::Paint;
}

void PressedWay::show(ToolPicture& picture, int affected) const
{
    showBrush(m_settings, m_current.position(), m_current.pointer.pressure, picture);
    if (m_settings.selection == BrushSelection::Rectangle) {
        picture.rectangle = QRectF(m_press.position(), m_current.position()).normalized();
    }
    if (m_settings.selection == BrushSelection::Lasso) {
        picture.outlines.push_back(closed(m_way));
    }
    const auto* relation = m_settings.find<model::RelationSettings>();
    if (relation != nullptr && relation->how == model::RelationHow::FromTo &&
        !m_settings.hasWholeArea()) {
        picture.arrow = QLineF(m_press.position(), m_current.position());
    }
    if (m_settings.isReevaluated() && m_settings.followsLine()) {
        picture.gradient = QLineF(m_press.position(), m_current.position());
    }
    if (m_settings.isReevaluated() || m_settings.kind() == BrushKind::Create ||
        m_settings.kind() == BrushKind::Script || m_settings.kind() == BrushKind::Retake) {
        picture.label = BrushDragsText::tr("%n characters", nullptr, affected);
    }
}

namespace {

/// From a lasso to a lasso: the first one says from whom, the next one to whom.
void rememberSources(EditorState& state, BrushKind kind, const model::StrokeOutcome& outcome)
{
    BrushSettings brush = state.brush(kind);
    const auto* relation = brush.find<model::RelationSettings>();
    const bool isChosen = outcome.reason == model::StrokeReason::SourcesChosen;
    const bool isUsed = outcome.isCommitted && relation != nullptr && !relation->sources.empty();
    if (!isChosen && !isUsed) {
        return;
    }
    brush.as<model::RelationSettings>().sources.assign(outcome.chosen.begin(),
                                                       outcome.chosen.end());
    state.setBrush(brush);
    state.selection().set(outcome.chosen);
}

} // namespace

StrokeDrag::StrokeDrag(const ToolContext& context, const BrushSettings& settings,
                       std::uint64_t seed, const ToolInput& press)
    : m_context(context),
      m_stroke(model::Stroke::begin(context.state.document(), context.queries.brushContext(),
                                    settings, seed, press.pointer)),
      m_way(settings, press)
{
    const auto selected = context.state.selection().ids();
    m_selectedBefore.assign(selected.begin(), selected.end());
    showGathered();
}

void StrokeDrag::paint()
{
    if (m_stroke) {
        m_stroke->move(m_way.pointer());
        showGathered();
    }
}

/// Who will be meant is selected, so that one sees it, and can go on with them.
void StrokeDrag::showGathered()
{
    if (m_stroke && m_stroke->settings().kind() == BrushKind::Retake) {
        const auto gathered = m_stroke->gathered();
        m_context.state.selection().set(
            gathered.empty() ? std::span<const model::IndividualId>(m_selectedBefore) : gathered);
    }
}

void StrokeDrag::update(const ToolInput& input)
{
    const PressedWay::Work work = m_way.moved(input);
    if (work == PressedWay::Work::Paint) {
        paint();
    } else if (work == PressedWay::Work::Pass && m_stroke) {
        m_stroke->pass(input.pointer);
    }
}

void StrokeDrag::tick(const ToolInput& resting, double /*elapsedSeconds*/)
{
    if (m_stroke && m_way.rested(resting, m_stroke->current().grid) == PressedWay::Work::Paint) {
        paint();
    }
}

void StrokeDrag::release(const ToolInput& input)
{
    m_way.ended(input);
    paint();
    if (!m_stroke) {
        return;
    }
    const BrushKind kind = m_stroke->settings().kind();
    const model::StrokeOutcome outcome = m_stroke->finish();
    m_stroke.reset();
    if (outcome.isCommitted) {
        m_context.state.noteStroke(kind);
    }
    rememberSources(m_context.state, kind, outcome);
    if (outcome.isCommitted || outcome.isSent) {
        m_context.state.showStatus(affectedText(kind, outcome.affected));
    } else if (outcome.reason == model::StrokeReason::SourcesChosen) {
        m_context.state.showStatus(outcome.message); // half way
    } else {
        m_context.state.refuse(outcome.message);
    }
}

void StrokeDrag::cancel()
{
    if (m_stroke) {
        m_stroke->cancel();
        if (m_stroke->settings().kind() == BrushKind::Retake) {
            m_context.state.selection().set(m_selectedBefore);
        }
        m_stroke.reset();
        m_context.state.showStatus(BrushDragsText::tr("The stroke was taken back."));
    }
}

void StrokeDrag::show(ToolPicture& picture) const
{
    if (m_stroke) {
        m_way.show(picture, m_stroke->affected());
    }
}

ScriptStrokeDrag::ScriptStrokeDrag(ScriptPainter& painter, const BrushSettings& settings,
                                   const ToolInput& press)
    : m_painter(painter), m_way(settings, press), m_painted(press.pointer.grid)
{
}

ScriptStrokeDrag::~ScriptStrokeDrag()
{
    cancel();
}

void ScriptStrokeDrag::paint()
{
    if (!m_isOver) {
        m_painted = m_way.pointer().grid;
        m_painter.move(m_way.pointer());
    }
}

void ScriptStrokeDrag::update(const ToolInput& input)
{
    const PressedWay::Work work = m_way.moved(input);
    if (work == PressedWay::Work::Paint) {
        paint();
    } else if (work == PressedWay::Work::Pass && !m_isOver) {
        m_painter.pass(input.pointer);
    }
}

void ScriptStrokeDrag::tick(const ToolInput& resting, double /*elapsedSeconds*/)
{
    if (m_way.rested(resting, m_painted) == PressedWay::Work::Paint) {
        paint();
    }
}

void ScriptStrokeDrag::release(const ToolInput& input)
{
    m_way.ended(input);
    paint();
    if (!m_isOver) {
        m_isOver = true;
        m_painter.release();
    }
}

void ScriptStrokeDrag::cancel()
{
    if (!m_isOver) {
        m_isOver = true;
        m_painter.cancel();
    }
}

void ScriptStrokeDrag::show(ToolPicture& picture) const
{
    m_way.show(picture, m_painter.affected());
}

ResizeDrag::ResizeDrag(const ToolContext& context, BrushKind kind, const ToolInput& press)
    : m_context(context), m_before(context.state.brush(kind)), m_press(press.position())
{
}

void ResizeDrag::update(const ToolInput& input)
{
    const double way = input.position().x() - m_press.x();
    m_context.state.setBrush(m_before.resized(static_cast<float>(way)));
}

void ResizeDrag::release(const ToolInput& input)
{
    update(input);
}

void ResizeDrag::cancel()
{
    m_context.state.setBrush(m_before);
}

void ResizeDrag::show(ToolPicture& picture) const
{
    const BrushSettings& settings = m_context.state.brush(m_before.kind());
    showBrush(settings, m_press, 1.0, picture);
    picture.cursor = Qt::SizeHorCursor;
    picture.label = BrushDragsText::tr("%1 px").arg(qRound(settings.radiusPixels));
}

void showBrush(const BrushSettings& settings, const QPointF& at, double pressure,
               ToolPicture& picture)
{
    picture.cursor = Qt::CrossCursor;
    picture.symbol = toolOf(settings.kind());
    picture.symbolAt = at;
    if (settings.hasCircle()) {
        const double share = settings.pressureSize ? pressure : 1.0;
        picture.circle = CircleOutline{at, std::max(1.0, settings.radiusPixels * share)};
    } else {
        picture.crosshair = at;
    }
}

} // namespace crowd::widgets
