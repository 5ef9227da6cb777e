// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QObject>
#include <glm/vec3.hpp>

#include "widgets/state/EditorState.h"

class QAbstractButton;
class QWidget;

namespace crowd::widgets {

/// Makes a button ask for a point in the picture, as EditorState::choosePoint(): it stays pressed
/// until the point is there, and pressed again lets it be. `taken` is not called when the button
/// is gone by then. Main thread, as all of this.
void makePointButton(QAbstractButton& button, EditorState& state, EditorState::PointTaken taken);
/// The same for somebody, as EditorState::choosePerson().
void makePersonButton(QAbstractButton& button, EditorState& state, EditorState::PersonTaken taken);

/// Marks a point in the picture while a widget is seen. A child of that widget.
class PointMark : public QObject
{
    Q_OBJECT

public:
    using Point = std::function<glm::vec3()>; ///< metres, world frame

    PointMark(QWidget& shownWith, EditorState& state, Point point);
    ~PointMark() override;
    /// After the point has changed.
    void refresh();
    bool eventFilter(QObject* widget, QEvent* event) override;

private:
    QWidget& m_shownWith;
    EditorState& m_state;
    Point m_point;
};

} // namespace crowd::widgets
