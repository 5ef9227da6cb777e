// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QTimer>

class QWidget;

namespace crowd::app {

/// While a dialog is open, keys are the dialog's. Where dialogs follow each other quickly, some
/// window managers leave the keyboard with the window behind: what is typed then is kept from the
/// window, and the dialog asks for the keyboard again. Owned by the window. Main thread only.
class ModalKeys : public QObject
{
    Q_OBJECT

public:
    explicit ModalKeys(QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Whether it is the window itself or within it, and no dialog's.
    [[nodiscard]] bool isOfWindow(const QObject* receiver) const;
    void claim();

    QWidget& m_window;
    QTimer m_look; ///< some time after a dialog came: who has the keyboard
};

} // namespace crowd::app
