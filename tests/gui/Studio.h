// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtGui/QImage>
#include <QtGui/QMouseEvent>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QVBoxLayout>

#include "tests/model/ProjectText.h"
#include "tests/program/FrameCount.h"
#include "tests/widgets/SmallTheatre.h"
#include "widgets/viewport/ViewportWidget.h"

namespace crowd::testing {

/// A window with the picture and a line edit, over the small theatre; the clock stands.
class Studio
{
public:
    explicit Studio(const model::Scene& scene = smallTheatre()) : state(document)
    {
        state.transport().setPlaying(false);
        setQuality(widgets::PictureQuality::Fast);
        document.replaceScene(scene, {});
        edit = new QLineEdit(&window);
        view = new widgets::ViewportWidget(state, &window);
        view->setFixedSize(320, 240);
        frames = std::make_unique<FrameCount>(*view);
        layout = new QVBoxLayout(&window);
        layout->addWidget(edit);
        layout->addWidget(view);
        window.show();
        window.activateWindow();
    }
    [[nodiscard]] bool isReady()
    {
        return QTest::qWaitForWindowActive(&window) &&
               QTest::qWaitFor([this] { return frames->isShown(); });
    }
    void setQuality(widgets::PictureQuality quality)
    {
        widgets::ViewOptions options = state.viewOptions();
        options.quality = quality;
        state.setViewOptions(options);
    }
    /// Until nothing wants to be drawn any more.
    void settle()
    {
        for (int still = 0, tries = 0; still < 2 && tries < 100; ++tries) {
            const int before = frames->frames();
            QTest::qWait(60);
            still = frames->frames() == before ? still + 1 : 0;
        }
    }
    [[nodiscard]] QImage picture()
    {
        QEvent leave(QEvent::Leave); // no brush in the picture
        QApplication::sendEvent(view, &leave);
        settle();
        return view->grabPicture();
    }
    [[nodiscard]] std::string bytes() const { return projectText(document.scene()); }
    [[nodiscard]] std::size_t people() const { return document.scene().population.size(); }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {})
    {
        send(QEvent::MouseButtonPress, from, button, button, modifiers);
        for (int step = 1; step <= 12; ++step) {
            send(QEvent::MouseMove, from + (to - from) * step / 12, Qt::NoButton, button,
                 modifiers);
        }
        send(QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
    }
    /// With time stamps of its own: a steady hand, however slow the machine.
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons,
              Qt::KeyboardModifiers modifiers = {})
    {
        if (type == QEvent::MouseButtonPress) {
            view->setFocus(Qt::MouseFocusReason);
        }
        QMouseEvent event(type, at, view->mapToGlobal(at), button, buttons, modifiers);
        event.setTimestamp(m_milliseconds += 25);
        QApplication::sendEvent(view, &event);
    }

    model::SceneDocument document;
    widgets::EditorState state;
    QWidget window;
    QLineEdit* edit;
    widgets::ViewportWidget* view;
    std::unique_ptr<FrameCount> frames; ///< of the view
    QVBoxLayout* layout;

private:
    quint64 m_milliseconds = 1;
};

} // namespace crowd::testing
