// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

namespace crowd::widgets {

/// What a transport shows at one moment.
struct TransportState
{
    bool isPlaying = true; ///< the editor opens with life in the crowd
    double seconds = 0.0;  ///< scene time, 0 at the start, never negative
    double speed = 1.0;    ///< seconds of scene time a second, 0.05..8
};

/// The one clock of the scene that is shown. It has no timer: the viewport's frame clock advances
/// it, so that what is drawn and what is painted on share a moment. Main thread only.
class Transport : public QObject
{
    Q_OBJECT

public:
    explicit Transport(QObject* parent = nullptr);

    [[nodiscard]] const TransportState& state() const { return m_state; }
    [[nodiscard]] bool isPlaying() const { return m_state.isPlaying; }
    [[nodiscard]] double seconds() const { return m_state.seconds; }

    void setPlaying(bool isPlaying);
    void toggle() { setPlaying(!m_state.isPlaying); }
    /// Back to the start; goes on playing if it played.
    void rewind() { setSeconds(0.0); }
    void setSeconds(double seconds);
    void setSpeed(double speed);

    /// Real time that has passed since the last frame, in seconds: slow pictures are fewer, and
    /// time runs as ever. Steps longer than two seconds (the window was hidden, a dialog stood in
    /// the way) count as that much. Time waits at the limit.
    void advance(double realSeconds, double notBeyond = 1e300);

    /// The share of what its speed asks for that it runs at, over the last second; less than 1
    /// where it waits at the limit.
    [[nodiscard]] double pace() const { return m_pace; }

Q_SIGNALS:
    /// Playing, speed, or a jump in time: not sent for the steady flow of advance().
    void stateChanged(const crowd::widgets::TransportState& state);
    /// The time is another one, for whatever reason.
    void timeChanged(double seconds);

private:
    TransportState m_state;
    double m_pace = 1.0;
};

} // namespace crowd::widgets
