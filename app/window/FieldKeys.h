// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

class QDockWidget;
class QMouseEvent;

namespace crowd::app {

/// Return and Escape end what is typed into a field of a panel, and then the keys are the picture's
/// again: the next letter chooses a brush instead of becoming part of a name. So do they when the
/// field goes out of sight, as with the tab of its panel. Return is the field's even where it is a
/// shortcut. What is typed at a field that is off goes nowhere. Owned by the window. Main thread
/// only.
class FieldKeys : public QObject
{
    Q_OBJECT

public:
    /// `picture` gets the keys; both outlive this.
    FieldKeys(QWidget& window, QWidget& picture);

Q_SIGNALS:
    /// Somebody types at a field that takes nothing now.
    void typedAtNothing();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// The window's own, floating or not; null: the field is of none.
    [[nodiscard]] QDockWidget* panelOf(QWidget& field) const;
    void giveBack(QWidget* list);
    void notePress(QWidget& pressed, const QMouseEvent& event);
    void follow(QWidget* before, QWidget* now);
    void takeFromHidden(QWidget& before);
    void noteSeen(bool isSeen);
    [[nodiscard]] bool endTyping(QWidget& field, QEvent& event);
    [[nodiscard]] bool passOver(QEvent& event);

    QWidget& m_window;
    QWidget& m_picture;
    QPointer<QWidget> m_pressed; ///< of those that got the press, the innermost
    quint64 m_pressTime = 0;
    bool m_isAtOffField = false; ///< since the last press, and until the hand leaves it
};

} // namespace crowd::app
