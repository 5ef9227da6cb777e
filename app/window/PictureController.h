// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "app/window/DialogTask.h"
#include "widgets/viewport/ViewportWidget.h"

namespace crowd::app {

class PictureDialog;

/// File > Save Picture: the view as it is at this moment, without marks and handles, in a size of
/// its own, drawn in the background. Main thread only.
class PictureController : public QObject
{
    Q_OBJECT

public:
    PictureController(widgets::EditorState& state, QWidget* window);

    /// Asks for size and file, then draws. `view`: the picture in the window, physical pixels.
    void save(glm::ivec2 view);
    [[nodiscard]] bool isBusy() const { return m_task.isRunning(); }

private:
    void draw(const QString& path, const PictureDialog& chosen);

    widgets::EditorState& m_state;
    QWidget* m_window;
    DialogTask m_task;
};

} // namespace crowd::app
