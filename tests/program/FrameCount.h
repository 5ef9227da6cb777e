// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QEvent>
#include <QtCore/QObject>
#include <QtWidgets/QWidget>

namespace crowd::testing {

/// Counts how often a picture is drawn. What only lies over it is drawn without.
class FrameCount : public QObject
{
public:
    explicit FrameCount(QWidget& picture) { picture.installEventFilter(this); }

    [[nodiscard]] int frames() const { return m_frames; }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        m_frames += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }

private:
    int m_frames = 0;
};

} // namespace crowd::testing
