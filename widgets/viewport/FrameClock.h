// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QTimer>

namespace crowd::widgets {

/// The beat of the picture: at most 60 a second, only while somebody wants it, and never so close
/// together that input has to wait behind slow frames.
class FrameClock : public QObject
{
    Q_OBJECT

public:
    explicit FrameClock(QObject* parent = nullptr);

    /// While running, beat() comes again and again. Starting anew begins with a step of 0.
    void setRunning(bool isRunning);
    [[nodiscard]] bool isRunning() const { return m_isRunning; }
    /// A picture took this long: the next beat leaves room for input.
    void noteFrameTime(double milliseconds) { m_lastFrameMs = milliseconds; }

Q_SIGNALS:
    void beat(double elapsedSeconds);

private:
    void fire();
    void schedule();

    QTimer m_timer;
    QElapsedTimer m_sinceBeat;
    double m_lastFrameMs = 0.0;
    bool m_isRunning = false;
};

} // namespace crowd::widgets
