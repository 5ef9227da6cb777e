// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QFrame>

#include "widgets/state/EditorState.h"

namespace crowd::app {

/// The first lines for somebody who has never painted a crowd, at the foot of the picture. Goes
/// for good with the first edits or when it is closed; the settings remember that. Hidden while
/// another brush is in hand than the one it tells of. A child of the picture; the state outlives
/// it.
class WelcomeHint : public QFrame
{
    Q_OBJECT

public:
    /// Shows a hint over the picture unless it has been seen.
    static void showOnce(QWidget* picture, const widgets::EditorState& state);

protected:
    bool eventFilter(QObject* picture, QEvent* event) override;

private:
    WelcomeHint(QWidget* picture, const widgets::EditorState& state);
    void place();
    void dismiss();
};

} // namespace crowd::app
