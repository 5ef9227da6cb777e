// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QLabel>
#include <QtWidgets/QStatusBar>

#include "widgets/state/EditorState.h"
#include "widgets/viewport/FrameStatistics.h"

namespace crowd::app {

/// One line of text that ends in an ellipsis where there is no room for it; the tool tip has all.
class ElidedLabel : public QLabel
{
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent) : QLabel(parent) {}

    void setFullText(const QString& text);
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        return {60, QLabel::sizeHint().height()};
    }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void elide();

    QString m_full;
};

/// The status bar: what the active tool's keys do, passing remarks, how many people there are, are
/// in the picture and are selected, and how long a picture takes.
class StatusPanel : public QStatusBar
{
    Q_OBJECT

public:
    StatusPanel(widgets::EditorState& state, QWidget* parent);

    void setStatistics(const widgets::FrameStatistics& statistics);
    [[nodiscard]] QString remark() const { return m_remark; } ///< the last one
    /// Of what took long: stays until somebody presses a key or a button in the program again, and
    /// as long as any remark after that.
    void showUntilBack(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void connectSession(const widgets::SessionControl& session);
    /// Nothing else is drawn while the window waits.
    void showWaiting(bool isWaiting);
    /// What is to be coloured may take a while to be found.
    void showFinding();
    void refreshCounts();
    void refreshFrame();

    widgets::EditorState& m_state;
    widgets::FrameStatistics m_statistics;
    ElidedLabel* m_hint;
    QLabel* m_counts;
    QLabel* m_frame;
    QString m_remark;
    QString m_untilBack; ///< empty: nothing of the kind is shown
    bool m_saysFinding = false;
};

} // namespace crowd::app
