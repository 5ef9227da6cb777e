// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include <glm/vec2.hpp>

#include "app/window/DialogTask.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

class MovieDialog;

/// File > Make Movie: what has been played, or the scene from its beginning, as a moving picture or
/// numbered pictures of the view or of a camera, drawn in the background. Main thread only.
class MovieController : public QObject
{
    Q_OBJECT

public:
    MovieController(widgets::EditorState& state, QWidget* window);

    /// Asks for what and for a file, then draws. `view`: the picture in the window, physical
    /// pixels.
    void make(glm::ivec2 view);
    [[nodiscard]] bool isBusy() const { return m_task.isRunning(); }

Q_SIGNALS:
    /// A movie is there, or its pictures are.
    void ended(const QString& said);

private:
    void draw(const QString& path, const MovieDialog& chosen);
    /// False: neither those that are missing nor all.
    [[nodiscard]] bool askOfThose(int there, bool& areKept);

    widgets::EditorState& m_state;
    QWidget* m_window;
    DialogTask m_task;
};

} // namespace crowd::app
