// SPDX-License-Identifier: MIT
#include "widgets/timeline/TimelineScale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/scene/Timeline.h"

namespace crowd::widgets {

namespace {

constexpr double kLeastLine = 70.0; ///< pixels
constexpr double kLeastPerSecond = 0.002;
constexpr double kMostPerSecond = 2000.0;
constexpr double kLeastSeconds = 30.0; ///< of what is fitted
constexpr double kRoom = 1.08;
constexpr double kHundredths = 100.0;

} // namespace

double TimelineScale::caught(double seconds) const
{
    const double rate = m_frameRate > 0 ? m_frameRate : kHundredths;
    return std::clamp(std::round(seconds * rate) / rate, 0.0, model::kLatestMark);
}

QString TimelineScale::text(double seconds) const
{
    if (m_frameRate > 0) {
        return QString::number(std::llround(seconds * m_frameRate));
    }
    const double line = lineSeconds();
    const int decimals = line >= 1.0 ? 0 : line >= 0.1 ? 1 : 2;
    const auto minutes = static_cast<int>(std::floor((seconds + line / 1000.0) / 60.0));
    const double rest = std::max(0.0, seconds - 60.0 * minutes);
    if (minutes == 0) {
        return QString::number(rest, 'f', decimals);
    }
    return QStringLiteral("%1:%2").arg(minutes).arg(rest, decimals == 0 ? 2 : 3 + decimals, 'f',
                                                    decimals, QLatin1Char('0'));
}

double TimelineScale::lineSeconds() const
{
    if (m_frameRate > 0) {
        constexpr std::array kFrames{1, 2, 5, 10};
        for (const int frames : kFrames) {
            const double line = static_cast<double>(frames) / m_frameRate;
            if (pixels(line) >= kLeastLine) {
                return line;
            }
        }
    }
    constexpr std::array kLines{0.01, 0.05, 0.1,  0.2,  0.5,   1.0,   2.0,   5.0,
                                10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0};
    for (const double line : kLines) {
        const bool isWhole = m_frameRate == 0 || line >= 1.0;
        if (isWhole && pixels(line) >= kLeastLine) {
            return line;
        }
    }
    double hours = 3600.0;
    while (pixels(hours) < kLeastLine) {
        hours *= 2.0;
    }
    return hours;
}

void TimelineScale::zoom(double factor, double atX)
{
    const double at = seconds(atX);
    m_perSecond = std::clamp(m_perSecond * factor, kLeastPerSecond, kMostPerSecond);
    m_first = std::clamp(at - atX / m_perSecond, 0.0, model::kLatestMark);
}

void TimelineScale::move(double pixels)
{
    m_first = std::clamp(m_first + pixels / m_perSecond, 0.0, model::kLatestMark);
}

void TimelineScale::fit(double seconds, double width)
{
    m_first = 0.0;
    m_perSecond = std::clamp(std::max(width, 1.0) / (std::max(seconds, kLeastSeconds) * kRoom),
                             kLeastPerSecond, kMostPerSecond);
}

void TimelineScale::reveal(double seconds, double width)
{
    const double at = x(seconds);
    if (at < 0.0 || at > width) {
        m_first = std::max(0.0, seconds - width / m_perSecond / 10.0);
    }
}

} // namespace crowd::widgets
