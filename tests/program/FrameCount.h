// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "widgets/viewport/PictureSurface.h"

namespace crowd::testing {

/// Counts how often a picture is drawn. What only lies over it is drawn without.
class FrameCount : public QObject
{
public:
    explicit FrameCount(widgets::PictureSurface& picture)
    {
        connect(&picture, &widgets::PictureSurface::pictureDrawn, this, [this] { ++m_frames; });
        // Queued: what the picture's own answer to it shows is there then.
        connect(
            &picture, &widgets::PictureSurface::pictureShown, this,
            [this] { m_isShown = m_frames > 0; }, Qt::QueuedConnection);
    }

    [[nodiscard]] int frames() const { return m_frames; }
    /// Some picture has come into the window.
    [[nodiscard]] bool isShown() const { return m_isShown; }

private:
    int m_frames = 0;
    bool m_isShown = false;
};

} // namespace crowd::testing
