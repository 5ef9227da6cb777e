// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "widgets/state/EditorState.h"

namespace crowd::app {

/// What the artist has set the brushes to, remembered between runs. What names a thing of one scene
/// (templates of the mix, slot, path, tag, point to face, ranks and wedges) is not: it means
/// nothing in the next scene. Main thread only.
class BrushMemory : public QObject
{
    Q_OBJECT

public:
    /// Sets the brushes as they were left; from then on follows them.
    BrushMemory(widgets::EditorState& state, QObject* parent);

    void save() const;
    /// All brushes as in a new installation, but for what names a thing of the scene.
    void reset();

private:
    void restore();

    widgets::EditorState& m_state;
    QTimer m_later; ///< a drag on a slider is one change
};

} // namespace crowd::app
