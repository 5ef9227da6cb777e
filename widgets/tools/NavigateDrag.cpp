// SPDX-License-Identifier: MIT
#include "widgets/tools/NavigateDrag.h"

#include <cmath>

#include <QtCore/QCoreApplication>

#include "widgets/commands/CameraMoves.h"
#include "widgets/tools/FlySession.h"

namespace crowd::widgets {

namespace {

constexpr double kRadiansPerPixel = 0.006;
constexpr double kDollyPerPixel = 0.006; ///< natural logarithm of the distance
constexpr double kDollyPerNotch = 0.84;
constexpr double kWheelSeconds = 0.16;
constexpr double kSameGestureSeconds = 0.5;
constexpr float kAboveGround = 0.1F; ///< metres

/// An orbit that begins above the ground stays above it: from below there is nothing to paint.
model::Camera orbitedAboveGround(const model::Camera& camera, const glm::vec3& around, float yaw,
                                 float pitch)
{
    const model::Camera whole = orbited(camera, around, yaw, pitch);
    const bool goesUnder =
        camera.position.y >= kAboveGround && whole.position.y < kAboveGround && around.y > -1.0F;
    return goesUnder ? orbited(camera, around, yaw, 0.0F) : whole;
}

} // namespace

NavigateDrag::NavigateDrag(const ToolContext& context, Navigation kind, const ToolInput& press)
    : m_context(context), m_kind(kind), m_before(context.state.viewCamera()),
      m_anchor(context.queries.pointUnder(press.pointer.pixels(), press.pointer.shownSeconds)),
      m_last(press.position())
{
}

void NavigateDrag::update(const ToolInput& input)
{
    EditorState& state = m_context.state;
    const QPointF way = input.position() - m_last;
    if (way.isNull()) {
        return;
    }
    m_last = input.position();
    const model::Camera& camera = state.camera();
    switch (m_kind) {
    case Navigation::Orbit:
        state.setCamera(orbitedAboveGround(camera, m_anchor,
                                           static_cast<float>(-way.x() * kRadiansPerPixel),
                                           static_cast<float>(-way.y() * kRadiansPerPixel)));
        break;
    case Navigation::Pan:
        state.setCamera(panned(camera, state.viewSize(), glm::vec2(way.x(), way.y()),
                               depthOf(camera, m_anchor)));
        break;
    case Navigation::Dolly:
        state.setCamera(
            dollied(camera, m_anchor, static_cast<float>(std::exp(way.y() * kDollyPerPixel))));
        break;
    }
}

void NavigateDrag::release(const ToolInput& input)
{
    update(input);
}

void NavigateDrag::cancel()
{
    m_context.state.setCamera(m_before.camera, m_before.name);
}

void NavigateDrag::show(ToolPicture& picture) const
{
    switch (m_kind) {
    case Navigation::Orbit:
        picture.cursor = Qt::ClosedHandCursor;
        break;
    case Navigation::Pan:
        picture.cursor = Qt::SizeAllCursor;
        break;
    case Navigation::Dolly:
        picture.cursor = Qt::SizeVerCursor;
        break;
    }
}

Navigation navigationFor(Qt::KeyboardModifiers modifiers)
{
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        return Navigation::Pan;
    }
    return modifiers.testFlag(Qt::ControlModifier) ? Navigation::Dolly : Navigation::Orbit;
}

void WheelDolly::turn(const ToolContext& context, const WheelInput& input)
{
    EditorState& state = context.state;
    const QPointF at = input.at.position();
    const double now = input.at.pointer.timeSeconds;
    // One gesture keeps its point: the picture moves under the cursor meanwhile.
    if (at != m_at || now - m_seconds > kSameGestureSeconds || now < m_seconds) {
        m_anchor =
            context.queries.pointUnder(input.at.pointer.pixels(), input.at.pointer.shownSeconds);
    }
    m_at = at;
    m_seconds = now;
    const auto factor = static_cast<float>(std::pow(kDollyPerNotch, input.notches));
    state.moveCameraTo(dollied(state.cameraTarget(), m_anchor, factor), {}, kWheelSeconds);
}

QString NavigateTool::hint() const
{
    return QCoreApplication::translate(
        "NavigateTool", "Drag: orbit · Shift: pan · Ctrl: nearer, farther · Wheel: towards the "
                        "cursor · Right button or Shift+F: fly with WASD · F: show the selection");
}

DragSessionPtr NavigateTool::press(const ToolInput& input)
{
    switch (input.button) {
    case Qt::LeftButton:
        return std::make_unique<NavigateDrag>(m_context, navigationFor(input.modifiers), input);
    case Qt::MiddleButton:
        return std::make_unique<NavigateDrag>(m_context, Navigation::Pan, input);
    case Qt::RightButton:
        return std::make_unique<FlySession>(m_context, FlySession::Hold::Button, input);
    default:
        return nullptr;
    }
}

void NavigateTool::hover(const ToolInput& /*input*/, ToolPicture& picture) const
{
    picture.cursor = Qt::OpenHandCursor;
}

} // namespace crowd::widgets
