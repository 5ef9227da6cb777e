// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QSlider>

#include "widgets/state/Scrub.h"

namespace crowd::app {

/// What has been played so far, and what of it is shown: a drag shows any moment of it again, to
/// and fro. Out of use at the beginning. While it is held time stands; it plays on after that if it
/// played. Main thread; the state outlives it.
class TimeSlider : public QSlider
{
    Q_OBJECT

public:
    TimeSlider(widgets::EditorState& state, QWidget* parent);

protected:
    void mousePressEvent(QMouseEvent* event) override; ///< jumps to where it was pressed
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void refresh();
    void seek(int x); ///< logical pixels

    widgets::EditorState& m_state;
    widgets::Scrub m_scrub;
};

} // namespace crowd::app
