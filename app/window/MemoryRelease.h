// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "model/bake/KeyframeStore.h"

namespace crowd::app {

/// Gives memory back to the system some time after a scene was left: by then nobody holds its
/// templates any more. Main thread.
class MemoryRelease : public QObject
{
    Q_OBJECT

public:
    /// The store outlives it.
    MemoryRelease(model::KeyframeStore& keyframes, QObject* parent);

    /// Another scene is open.
    void plan();

private:
    void release();

    model::KeyframeStore& m_keyframes;
    QTimer m_timer;
};

} // namespace crowd::app
