// SPDX-License-Identifier: MIT
#include "widgets/state/CameraDirector.h"

#include <algorithm>

#include "widgets/state/EditorState.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/ShownLook.h"

namespace crowd::widgets {

CameraDirector::CameraDirector(EditorState& state) : m_state(state) {}

void CameraDirector::begin()
{
    connect(&m_state.document(), &model::SceneDocument::changed, this, &CameraDirector::follow);
    connect(&m_state.transport(), &Transport::timeChanged, this, &CameraDirector::direct);
    connect(&m_state, &EditorState::viewCameraChanged, this, &CameraDirector::followView);
    connect(&m_state.session().recorder(), &MarkRecorder::changed, this,
            &CameraDirector::followRecorder);
    m_track = model::CameraTrack(m_state.scene());
    m_seen = m_state.camera();
}

void CameraDirector::forget()
{
    m_track = {};
    m_lookedThrough.clear();
}

void CameraDirector::takeScene()
{
    m_track = model::CameraTrack(m_state.scene());
    setOn(true);
}

void CameraDirector::setOn(bool isOn)
{
    if (isOn != m_isOn) {
        m_isOn = isOn;
        Q_EMIT changed(isOn);
    }
    direct();
}

void CameraDirector::follow(const model::SceneChange& change)
{
    if (!isOneOf<model::TimelineChanged, model::CamerasChanged, model::PathsChanged>(change)) {
        return;
    }
    // The first mark does not take the view away from who has just made it: time has to go on.
    const bool wasDirecting = m_track.hasMoves();
    m_track = model::CameraTrack(m_state.scene());
    if (wasDirecting) {
        direct();
    }
}

void CameraDirector::followView()
{
    const model::Camera going = m_state.cameraTarget(); // where it is to be in a moment
    const bool hasMoved = going != m_seen;
    m_seen = going;
    if (m_isDirecting || !hasMoved || !m_isOn || !m_track.hasMoves()) {
        return;
    }
    setOn(false);
    m_state.showStatus(
        tr("The view is yours: the timeline does not move it any more. View > Follow "
           "the Timeline gives it back."));
}

/// What was recorded is what the view has shown: it goes along again.
void CameraDirector::followRecorder(bool isRecording)
{
    const bool isThere = m_track.hasMoves() &&
                         m_track.at(m_state.transport().seconds()).camera == m_state.cameraTarget();
    if (!isRecording && isThere) {
        setOn(true);
    }
}

void CameraDirector::direct()
{
    preview(m_state.transport().seconds());
}

void CameraDirector::preview(double seconds)
{
    if (!m_isOn || !m_track.hasMoves()) {
        return;
    }
    const model::DirectedCamera now = m_track.at(seconds);
    m_isDirecting = true;
    m_state.setCamera(now.camera, QString::fromStdString(now.name));
    const auto& cameras = m_state.scene().cameras;
    const auto reached = std::ranges::find(cameras, now.name, &model::NamedCamera::name);
    if (reached != cameras.end() && now.name != m_lookedThrough) {
        m_lookedThrough = now.name;
        showLookOf(m_state, *reached);
    }
    m_isDirecting = false;
}

} // namespace crowd::widgets
