// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtGui/QMouseEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>

#include "app/window/MainWindow.h"
#include "tests/model/ProjectText.h"
#include "tests/program/FrameCount.h"

namespace crowd::testing {

/// The whole editor with a scene file, and a hand with a mouse over its picture.
class Editor
{
public:
    Editor()
    {
        for (QDockWidget* dock : window.docks()) {
            dock->hide(); // a small picture is a quick one
        }
        window.viewport().setFixedSize(540, 360); // whatever size the window had before
        window.resize(560, 460);
        window.show();
        window.activateWindow();
        (void)QTest::qWaitForWindowActive(&window); // shortcuts go to the active one
        state().transport().setPlaying(false);
    }
    [[nodiscard]] bool open(const QString& path)
    {
        QSignalSpy opened(&window.files(), &app::FileController::sceneOpened);
        window.files().openPath(path);
        if (opened.isEmpty() && !opened.wait(60000)) {
            return false;
        }
        state().transport().setPlaying(false);
        state().transport().rewind();
        return QTest::qWaitFor([this] { return isLoaded() && frames.isShown(); }, 60000);
    }
    [[nodiscard]] bool isLoaded()
    {
        const model::Scene& scene = window.document().scene();
        const auto has = [](const auto& entry) { return entry.asset != nullptr; };
        return std::all_of(scene.templates.begin(), scene.templates.end(), has) &&
               std::all_of(scene.stages.begin(), scene.stages.end(), has);
    }
    [[nodiscard]] widgets::EditorState& state() { return window.state(); }
    [[nodiscard]] widgets::ViewportWidget& view() { return window.viewport(); }
    [[nodiscard]] std::size_t people() { return window.document().scene().population.size(); }
    [[nodiscard]] std::string bytes() { return projectText(window.document().scene()); }
    /// Of the scene at rest, everything baked (which takes long under the sanitizers), without any
    /// brush in it; null if it did not come to rest.
    [[nodiscard]] QImage picture()
    {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&view(), &leave);
        int still = 0;
        for (int tries = 0; still < 2 && tries < 1800; ++tries) {
            const int before = frames.frames();
            QTest::qWait(50);
            const bool isAtRest = view().isAtRest() && frames.frames() == before &&
                                  state().keyframes().progress().pendingClips == 0;
            still = isAtRest ? still + 1 : 0;
        }
        return still < 2 ? QImage() : view().grabPicture();
    }
    void press(QPoint at) { send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton); }
    void release(QPoint at) { send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton); }
    void drag(QPoint from, QPoint to)
    {
        press(from);
        for (int step = 1; step <= 24; ++step) {
            send(QEvent::MouseMove, from + (to - from) * step / 24, Qt::NoButton, Qt::LeftButton);
        }
        release(to);
    }

    app::MainWindow window;
    FrameCount frames{window.viewport()};

private:
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons)
    {
        QMouseEvent event(type, at, view().mapToGlobal(at), button, buttons, Qt::NoModifier);
        event.setTimestamp(m_milliseconds += 25);
        QApplication::sendEvent(&view(), &event);
    }

    quint64 m_milliseconds = 1;
};

inline QString copyOfTheatre(const QTemporaryDir& folder)
{
    const QString path = folder.filePath(QStringLiteral("audience.crowd"));
    QFile::copy(QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd"), path);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    return path;
}

} // namespace crowd::testing
