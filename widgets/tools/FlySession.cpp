// SPDX-License-Identifier: MIT
#include "widgets/tools/FlySession.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include "widgets/commands/CameraMoves.h"

namespace crowd::widgets {

namespace {

constexpr double kFlightRadiansPerPixel = 0.0035;
constexpr double kSlowestFlight = 0.2; ///< metres a second
constexpr double kFastestFlight = 200.0;
constexpr double kLongestFlightStep = 0.1;

struct FlyKey
{
    int key;
    glm::vec3 direction; ///< right, up, forward
};

const std::array<FlyKey, 6> kFlyKeys{{{Qt::Key_W, {0.0F, 0.0F, 1.0F}},
                                      {Qt::Key_S, {0.0F, 0.0F, -1.0F}},
                                      {Qt::Key_D, {1.0F, 0.0F, 0.0F}},
                                      {Qt::Key_A, {-1.0F, 0.0F, 0.0F}},
                                      {Qt::Key_E, {0.0F, 1.0F, 0.0F}},
                                      {Qt::Key_Q, {0.0F, -1.0F, 0.0F}}}};

} // namespace

FlySession::FlySession(const ToolContext& context, Hold hold, const ToolInput& start)
    : m_context(context), m_hold(hold), m_before(context.state.viewCamera()),
      m_last(start.position())
{
}

void FlySession::update(const ToolInput& input)
{
    const QPointF way = input.position() - m_last;
    m_last = input.position();
    m_modifiers = input.modifiers;
    if (!way.isNull()) {
        m_context.state.setCamera(turned(m_context.state.camera(),
                                         static_cast<float>(-way.x() * kFlightRadiansPerPixel),
                                         static_cast<float>(-way.y() * kFlightRadiansPerPixel)));
    }
}

glm::vec3 FlySession::direction() const
{
    glm::vec3 sum(0.0F);
    for (const FlyKey& fly : kFlyKeys) {
        if (m_keys.contains(fly.key)) {
            sum += fly.direction;
        }
    }
    return glm::length(sum) > 0.0F ? glm::normalize(sum) : sum;
}

void FlySession::tick(const ToolInput& /*resting*/, double elapsedSeconds)
{
    const glm::vec3 way = direction();
    if (way == glm::vec3(0.0F)) {
        return;
    }
    double speed = m_metresPerSecond;
    speed *= m_modifiers.testFlag(Qt::ShiftModifier) ? 4.0 : 1.0;
    speed *= m_modifiers.testFlag(Qt::ControlModifier) ? 0.25 : 1.0;
    const double metres = speed * std::min(elapsedSeconds, kLongestFlightStep);
    m_context.state.setCamera(flown(m_context.state.camera(), way * static_cast<float>(metres)));
}

void FlySession::release(const ToolInput& /*input*/) {}

void FlySession::cancel()
{
    m_context.state.setCamera(m_before.camera, m_before.name);
}

bool FlySession::key(const KeyInput& input, bool isDown)
{
    m_modifiers = input.modifiers;
    const bool isFlyKey = std::any_of(kFlyKeys.begin(), kFlyKeys.end(),
                                      [&](const FlyKey& fly) { return fly.key == input.key; });
    if (isFlyKey && isDown) {
        m_keys.insert(input.key);
    } else if (isFlyKey) {
        m_keys.erase(input.key);
    }
    return isFlyKey;
}

bool FlySession::wheel(const WheelInput& input)
{
    m_metresPerSecond = std::clamp(m_metresPerSecond * std::pow(1.25, input.notches),
                                   kSlowestFlight, kFastestFlight);
    return true;
}

void FlySession::show(ToolPicture& picture) const
{
    picture.cursor = Qt::BlankCursor;
    const QString text =
        isHandsFree()
            ? QCoreApplication::translate("FlySession",
                                          "Flying at %1 m/s – W A S D, Q and E, wheel for the "
                                          "speed, click to land, Escape to go back")
            : QCoreApplication::translate("FlySession",
                                          "Flying at %1 m/s – W A S D, Q and E, wheel for the "
                                          "speed, release to land, Escape to go back");
    picture.mode = text.arg(QLocale().toString(m_metresPerSecond, 'f', 1));
}

} // namespace crowd::widgets
