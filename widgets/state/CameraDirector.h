// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QObject>

#include "model/scene/SceneChange.h"
#include "model/view/CameraTrack.h"

namespace crowd::widgets {

class EditorState;

/// Moves the view's camera as the timeline says, while it is on and the timeline moves a camera at
/// all. Who moves the view otherwise takes it off; it is on again with the next scene. Main thread;
/// the state outlives it.
class CameraDirector : public QObject
{
    Q_OBJECT

public:
    explicit CameraDirector(EditorState& state);

    /// On: the view is at once where the timeline has it.
    void setOn(bool isOn);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    [[nodiscard]] const model::CameraTrack& track() const { return m_track; }
    /// Shows the camera of another moment than that of the clock, until time goes on.
    void preview(double seconds);
    /// Connects to a state that is complete by now.
    void begin();
    /// The scene is being replaced: what the timeline was like means nothing any more.
    void forget();
    /// Another scene is there, and the view is where that begins.
    void takeScene();

Q_SIGNALS:
    void changed(bool isOn);

private:
    void follow(const model::SceneChange& change);
    void followView();
    void followRecorder(bool isRecording);
    void direct();

    EditorState& m_state;
    model::CameraTrack m_track;
    model::Camera m_seen;        ///< where the view was going at the last event
    std::string m_lookedThrough; ///< the camera whose look the view has taken on
    bool m_isOn = true;
    bool m_isDirecting = false;
};

} // namespace crowd::widgets
