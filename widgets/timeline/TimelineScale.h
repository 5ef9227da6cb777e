// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

namespace crowd::widgets {

/// Which time is where along a ruler. Seconds of the clock, logical pixels from its left end.
class TimelineScale
{
public:
    /// 0: times are shown as seconds.
    void setFrameRate(int perSecond) { m_frameRate = perSecond; }
    [[nodiscard]] int frameRate() const { return m_frameRate; }

    [[nodiscard]] double x(double seconds) const { return (seconds - m_first) * m_perSecond; }
    [[nodiscard]] double seconds(double x) const { return m_first + x / m_perSecond; }
    [[nodiscard]] double first() const { return m_first; }
    [[nodiscard]] double pixels(double seconds) const { return seconds * m_perSecond; }
    /// The nearest whole frame, or hundredth of a second; none before 0.
    [[nodiscard]] double caught(double seconds) const;
    [[nodiscard]] QString text(double seconds) const;
    /// Between two lines of the ruler that are not too near to each other to be read.
    [[nodiscard]] double lineSeconds() const;

    /// By that factor, with the time at a place staying there.
    void zoom(double factor, double atX);
    void move(double pixels);
    /// From 0 to there, and some room after it.
    void fit(double seconds, double width);
    /// So that a time is seen.
    void reveal(double seconds, double width);

private:
    double m_first = 0.0;
    double m_perSecond = 30.0; ///< pixels
    int m_frameRate = 0;
};

} // namespace crowd::widgets
