// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtWidgets/QWidget>

#include "widgets/commands/TimelineCommands.h"
#include "widgets/state/Scrub.h"
#include "widgets/timeline/SelectedFirings.h"
#include "widgets/timeline/TimelineLanes.h"
#include "widgets/timeline/TimelineScale.h"

class QMenu;

namespace crowd::widgets {

/// The timeline as a picture: a ruler, what of it has been played, the moment that is shown, a lane
/// of marks for each kind, and when rules fired for the selected. A drag on the ruler shows any
/// moment that has been played, with Shift it says which part of time is played; marks are chosen,
/// dragged, copied (Ctrl), removed, and made by a double click. Main thread; the state outlives it.
class TimelineView : public QWidget
{
    Q_OBJECT

public:
    TimelineView(EditorState& state, QWidget* parent);

    [[nodiscard]] const MarkIds& chosen() const { return m_chosen; }
    void choose(MarkIds marks);
    /// Frames a second that times are shown and caught by; 0: seconds, and hundredths of them.
    void setFrameRate(int perSecond);
    [[nodiscard]] int frameRate() const { return m_scale.frameRate(); }
    /// All marks and all that has been played are seen.
    void showAll();

    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Where a mark is drawn; outside of the widget where it is not seen.
    [[nodiscard]] QPoint placeOf(const model::Mark& mark) const;
    /// Where a moment is on the ruler.
    [[nodiscard]] QPoint placeOf(double seconds) const;

Q_SIGNALS:
    void chosenChanged();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drag
    {
        QPoint from;
        double seconds = 0.0; ///< that the chosen ones are moved by
        bool isMoving = false;
        bool isCopy = false;
    };

    struct RangeDrag
    {
        double fixed = 0.0; ///< seconds
        double moving = 0.0;
        QPoint from;
        /// By a handle: until it is moved it is a click like any other.
        bool isHeldStill = false;
    };

    [[nodiscard]] TimelineLayout layout() const { return {size()}; }
    void hover(const QPoint& at);
    [[nodiscard]] std::optional<double> handleAt(const QPoint& at) const;
    bool beginRangeDrag(const QPoint& at, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] model::PlayRange shownRange() const; ///< also while it is dragged
    void addRangeActions(QMenu& menu, double seconds);
    void followScene();
    void chooseNew(const MarkIds& known);
    [[nodiscard]] const model::Mark* diamondAt(const QPoint& at) const;
    [[nodiscard]] const model::Mark* markThrough(const QPoint& at) const;
    void fitAtFirst();
    void followTime(double seconds);
    /// Somebody is about to click, or drags: what is shown stays where it is.
    [[nodiscard]] bool isAimedAt() const;
    void beginDrag(const model::Mark& mark, const QMouseEvent& event);
    void endDrag();
    void endRangeDrag();
    void showTimeAt(int x);
    /// Nothing of what is being dragged changes. False: nothing is.
    bool giveUpDrags();
    [[nodiscard]] double earliestChosen() const;
    void removeChosen();
    [[nodiscard]] bool takesKey(const QKeyEvent& event) const;
    void copyChosen();
    void pasteCopied();
    [[nodiscard]] const model::Mark* markAt(const QPoint& at) const;  ///< null: there is none
    [[nodiscard]] double shownSeconds(const model::Mark& mark) const; ///< while it is dragged

    EditorState& m_state;
    TimelineScale m_scale;
    model::Timeline m_ordered; ///< the scene's, in the order in which they happen
    MarkIds m_chosen;
    MarkIds m_copied; ///< to be pasted; some may be gone
    MarkIds m_flawed; ///< that do not do what they say
    std::optional<Drag> m_drag;
    std::optional<RangeDrag> m_rangeDrag;
    Scrub m_scrub;
    SelectedFirings m_fired;
    QElapsedTimer m_sinceAimed; ///< the mouse has moved over it; invalid: it is elsewhere
    bool m_isToFit = true;      ///< all of it, once the widget has its size
};

} // namespace crowd::widgets
