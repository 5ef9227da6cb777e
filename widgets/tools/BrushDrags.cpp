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

StrokeDrag::StrokeDrag(const ToolContext& context, const BrushSettings& settings,
                       std::uint64_t seed, const ToolInput& press)
    : m_context(context),
      m_stroke(model::Stroke::begin(context.state.document(), context.queries.brushContext(),
                                    settings, seed, press.pointer)),
      m_press(press), m_current(press), m_way{press.position()}
{
}

void StrokeDrag::paint()
{
    if (m_stroke) {
        m_stroke->move(m_current.pointer);
    }
}

void StrokeDrag::update(const ToolInput& input)
{
    m_current = input;
    if (!m_stroke) {
        return;
    }
    m_way << input.position();
    // What is evaluated anew from press to here need not be for places that no picture shows.
    if (!m_stroke->settings().isReevaluated()) {
        paint();
    } else if (m_stroke->settings().selection == BrushSelection::Lasso) {
        m_stroke->pass(input.pointer);
    }
}

void StrokeDrag::tick(const ToolInput& resting, double /*elapsedSeconds*/)
{
    const bool isResting = m_stroke && m_stroke->current().grid == resting.pointer.grid;
    m_current = resting;
    if (!isResting || !m_stroke->settings().isReevaluated()) {
        paint();
    }
}

void StrokeDrag::release(const ToolInput& input)
{
    m_current = input;
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
    m_context.state.showStatus(outcome.isCommitted || outcome.isSent
                                   ? affectedText(kind, outcome.affected)
                                   : outcome.message);
}

void StrokeDrag::cancel()
{
    if (m_stroke) {
        m_stroke->cancel();
        m_stroke.reset();
        m_context.state.showStatus(BrushDragsText::tr("The stroke was taken back."));
    }
}

void StrokeDrag::show(ToolPicture& picture) const
{
    if (!m_stroke) {
        return;
    }
    const BrushSettings& settings = m_stroke->settings();
    showBrush(settings, m_current.position(), m_current.pointer.pressure, picture);
    if (settings.selection == BrushSelection::Rectangle) {
        picture.rectangle = QRectF(m_press.position(), m_current.position()).normalized();
    }
    if (settings.selection == BrushSelection::Lasso) {
        picture.outlines.push_back(closed(m_way));
    }
    if (settings.isReevaluated() && settings.followsLine()) {
        picture.gradient = QLineF(m_press.position(), m_current.position());
    }
    if (settings.isReevaluated() || settings.kind() == BrushKind::Create) {
        picture.label = BrushDragsText::tr("%n characters", nullptr, m_stroke->affected());
    }
}

ScriptStrokeDrag::ScriptStrokeDrag(const ToolContext& context, ScriptPainter& painter,
                                   const ToolInput& press)
    : m_painter(painter), m_settings(context.state.brush(BrushKind::Script)), m_press(press),
      m_current(press)
{
}

ScriptStrokeDrag::~ScriptStrokeDrag()
{
    cancel();
}

void ScriptStrokeDrag::update(const ToolInput& input)
{
    m_current = input;
    if (!m_isOver) {
        m_painter.move(input.pointer);
    }
}

void ScriptStrokeDrag::tick(const ToolInput& resting, double /*elapsedSeconds*/)
{
    update(resting);
}

void ScriptStrokeDrag::release(const ToolInput& input)
{
    update(input);
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
    showBrush(m_settings, m_current.position(), m_current.pointer.pressure, picture);
    if (m_settings.selection == BrushSelection::Rectangle) {
        picture.rectangle = QRectF(m_press.position(), m_current.position()).normalized();
    }
    picture.label = BrushDragsText::tr("%n characters", nullptr, m_painter.affected());
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
