// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "app/window/NumberedActions.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// The scene's cameras under the number keys: 1 to 9 go to a camera, with Ctrl the present view is
/// kept as that camera (an undoable edit). Their actions are in the registry as "camera-N" and
/// "camera-keep-N". Main thread only; state and registry outlive it.
class CameraBookmarks : public QObject
{
    Q_OBJECT

public:
    CameraBookmarks(widgets::EditorState& state, widgets::ActionRegistry& actions, QObject* parent);

    /// Fills two menus whenever they are shown: all cameras by name, and those that the present
    /// view can be kept as.
    void attach(QMenu* goTo, QMenu* keep) { m_numbered.attach(goTo, keep); }

private:
    [[nodiscard]] QStringList names() const;
    void goTo(std::size_t index);
    void keepAs(std::size_t index);

    widgets::EditorState& m_state;
    NumberedActions m_numbered;
};

/// The keys as they come.
[[nodiscard]] const NumberedKeys& cameraKeyTable();

} // namespace crowd::app
