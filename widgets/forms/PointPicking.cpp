// SPDX-License-Identifier: MIT
#include "widgets/forms/PointPicking.h"

#include <utility>

#include <QtCore/QEvent>
#include <QtCore/QPointer>
#include <QtWidgets/QAbstractButton>

namespace crowd::widgets {

namespace {

/// `ask` is called when it is pressed.
template<typename Ask>
void makeAskingButton(QAbstractButton& button, EditorState& state, Picking kind, const Ask& ask)
{
    button.setCheckable(true);
    QObject::connect(&button, &QAbstractButton::clicked, &button,
                     [&button, &state, ask](bool isPressed) {
                         if (!isPressed) {
                             state.setPicking(Picking::None);
                             return;
                         }
                         ask();
                         button.setChecked(true);
                     });
    QObject::connect(&state, &EditorState::pickingChanged, &button,
                     [&button, kind](Picking picking) {
                         if (picking != kind) {
                             button.setChecked(false);
                         }
                     });
}

/// Calls it while the button is there.
template<typename Taken>
auto whileThere(QAbstractButton& button, Taken taken)
{
    return [pressed = QPointer(&button), taken = std::move(taken)](const auto& what) {
        if (pressed) {
            taken(what);
        }
    };
}

} // namespace

void makePointButton(QAbstractButton& button, EditorState& state, EditorState::PointTaken taken)
{
    makeAskingButton(
        button, state, Picking::Place,
        [&state, taken = whileThere(button, std::move(taken))] { state.choosePoint(taken); });
}

void makePersonButton(QAbstractButton& button, EditorState& state, EditorState::PersonTaken taken)
{
    makeAskingButton(
        button, state, Picking::Person,
        [&state, taken = whileThere(button, std::move(taken))] { state.choosePerson(taken); });
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
