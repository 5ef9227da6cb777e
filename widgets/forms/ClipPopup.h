// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QRect>
#include <QtCore/QTimer>
#include <QtWidgets/QFrame>

#include "model/template/Template.h"

class QLabel;

namespace crowd::widgets {

class ClipMix;
class EditorState;
class TemplatePreview;

/// Somebody who plays the clip that the mouse is on in a list of clips, beside the list: who is
/// selected, if he has it, else the first of the scene's templates that does. It is made when it is
/// first wanted and goes with the list. Main thread.
class ClipPopup : public QFrame
{
    Q_OBJECT

public:
    /// From now on for this list, its parent.
    static void attach(ClipMix& mix, EditorState& state);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    ClipPopup(ClipMix& mix, EditorState& state);
    void want(const std::string& clip, const QRect& name);
    void present();
    void placeBeside(const QRect& name);

    EditorState& m_state;
    ClipMix& m_mix;
    TemplatePreview* m_preview;
    QLabel* m_name;
    QTimer m_wait;  ///< a mouse that passes shows nothing
    QTimer m_leave; ///< from one name to the next it stays
    std::string m_clip;
    QRect m_place;
};

} // namespace crowd::widgets
