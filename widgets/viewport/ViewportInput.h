// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "widgets/tools/ToolController.h"

class QEvent;
class QInputEvent;
class QKeyEvent;
class QSinglePointEvent;
class QTabletEvent;
class QWheelEvent;
class QWidget;

namespace crowd::widgets {

/// The translation of the window system's events over the picture into tool input, and nothing
/// else. Watches all events of the program, since keys that a list with the focus would take are
/// the brush's while the pointer is over the picture. The picture and the tools outlive it. Main
/// thread only.
class ViewportInput : public QObject
{
    Q_OBJECT

public:
    ViewportInput(QWidget& picture, ToolController& tools);

    /// The time that the picture on the screen shows, seconds of the transport: what a hand aims
    /// at.
    void setShownSeconds(double seconds) { m_shownSeconds = seconds; }
    /// The last input, as it is now that nothing has moved since.
    [[nodiscard]] ToolInput resting() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Whether the event ends here.
    bool takeEvent(QEvent& event);
    void move(const QSinglePointEvent& event);
    void takeTablet(QTabletEvent& event);
    void beginPenStroke(double pressure);
    void turnWheel(QWheelEvent& event);
    bool claimKey(QKeyEvent& event);
    bool pressKey(const QKeyEvent& event);
    bool takeFromList(const QObject& watched, QKeyEvent& event);
    bool playFromPanel(const QObject& watched, const QKeyEvent& event);
    void takeKeys();
    void keepPointerInside(const ToolInput& input);
    [[nodiscard]] ToolInput inputOf(const QSinglePointEvent& event, double pressure);

    QWidget& m_picture;
    ToolController& m_tools;
    ToolInput m_lastInput;
    QElapsedTimer m_sinceInput;
    double m_shownSeconds = 0.0;
    /// A pen that has just touched the tablet: how hard, its next sample says.
    std::optional<ToolInput> m_penPress;
    QTimer m_penWait; ///< for that sample
};

} // namespace crowd::widgets
