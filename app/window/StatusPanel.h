// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QLabel>
#include <QtWidgets/QStatusBar>

#include "widgets/state/EditorState.h"
#include "widgets/viewport/FrameStatistics.h"

namespace crowd::app {

/// The status bar: what the active tool's keys do, passing remarks, how many people there are and
/// how long a picture takes.
class StatusPanel : public QStatusBar
{
    Q_OBJECT

public:
    StatusPanel(widgets::EditorState& state, QWidget* parent);

    void setStatistics(const widgets::FrameStatistics& statistics);
    [[nodiscard]] QString remark() const { return m_remark; } ///< the last one

private:
    void refreshCounts();

    widgets::EditorState& m_state;
    QLabel* m_hint;
    QLabel* m_counts;
    QLabel* m_frame;
    QString m_remark;
};

} // namespace crowd::app
