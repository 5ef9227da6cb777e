// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QLabel>

#include "model/scene/Take.h"
#include "widgets/state/EditorState.h"
#include "widgets/state/TakeComparison.h"
#include "widgets/tasks/BackgroundTask.h"

namespace crowd::widgets {

/// How the take that is shown and the one that is seen as ghosts differ from their beginnings to
/// their ends, found in the background. Hidden where there are no two. Main thread; the state
/// outlives it.
class TakeFigures : public QLabel
{
    Q_OBJECT

public:
    TakeFigures(EditorState& state, QWidget* parent);

    /// Another take is shown, or one of them has been edited.
    void refresh();

private:
    [[nodiscard]] std::vector<model::Take> takes() const;
    void begin();
    [[nodiscard]] QString textOf(const TakeComparison& found) const;

    EditorState& m_state;
    BackgroundTask m_task;
    std::vector<model::Take> m_compared; ///< the one that is shown, the other; none: nothing is
};

/// "0:07", "12:30"
[[nodiscard]] QString takeClockText(double seconds);

} // namespace crowd::widgets
