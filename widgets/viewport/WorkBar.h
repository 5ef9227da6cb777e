// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QFrame>

class QLabel;
class QProgressBar;
class QToolButton;

namespace crowd::widgets {

/// What is going on behind the picture. Empty text: nothing.
struct WorkStatus
{
    QString text;
    double done = -1.0; ///< 0..1; below 0: there is no telling
    QString button;     ///< what the button says; empty: no button
    QString buttonTip;
    friend bool operator==(const WorkStatus&, const WorkStatus&) = default;
};

/// A plate at the foot of the picture that tells of work in the background and offers to stop it.
/// A child of the viewport, which places it.
class WorkBar : public QFrame
{
    Q_OBJECT

public:
    explicit WorkBar(QWidget* parent);

    void setStatus(const WorkStatus& status);
    [[nodiscard]] const WorkStatus& status() const { return m_status; }
    /// At the middle of the lower border of the parent.
    void place();

Q_SIGNALS:
    void buttonPressed();

private:
    void present(const WorkStatus& status);

    WorkStatus m_status;
    bool m_isChanging = false;
    // Children of this widget.
    QLabel* m_text;
    QProgressBar* m_bar;
    QToolButton* m_button;
};

} // namespace crowd::widgets
