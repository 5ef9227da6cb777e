// SPDX-License-Identifier: MIT
#include "widgets/docks/PointPicking.h"

#include <utility>

#include <QtCore/QEvent>
#include <QtCore/QPointer>
#include <QtWidgets/QAbstractButton>

namespace crowd::widgets {

void makePointButton(QAbstractButton& button, EditorState& state, EditorState::PointTaken taken)
{
    button.setCheckable(true);
    const auto takenHere = [pressed = QPointer(&button),
                            taken = std::move(taken)](const glm::vec3& metres) {
        if (pressed) {
            taken(metres);
        }
    };
    QObject::connect(&button, &QAbstractButton::clicked, &button,
                     [&button, &state, takenHere](bool isPressed) {
                         if (!isPressed) {
                             state.setPicking(Picking::None);
                             return;
                         }
                         state.choosePoint(takenHere);
                         button.setChecked(true);
                     });
    QObject::connect(&state, &EditorState::pickingChanged, &button, [&button](Picking picking) {
        if (picking != Picking::Place) {
            button.setChecked(false);
        }
    });
}

PointMark::PointMark(QWidget& shownWith, EditorState& state, Point point)
    : QObject(&shownWith), m_shownWith(shownWith), m_state(state), m_point(std::move(point))
{
    shownWith.installEventFilter(this);
}

PointMark::~PointMark()
{
    m_state.markPoint(this, {});
}

void PointMark::refresh()
{
    if (m_shownWith.isVisible() && m_shownWith.isEnabled()) {
        m_state.markPoint(this, m_point());
    }
}

bool PointMark::eventFilter(QObject* widget, QEvent* event)
{
    const bool isChange = event->type() == QEvent::Show || event->type() == QEvent::EnabledChange;
    if (event->type() == QEvent::Hide || (isChange && !m_shownWith.isEnabled())) {
        m_state.markPoint(this, {});
    } else if (isChange) {
        refresh();
    }
    return QObject::eventFilter(widget, event);
}

} // namespace crowd::widgets
