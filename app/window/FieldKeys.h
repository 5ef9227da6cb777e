// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

class QWidget;

namespace crowd::app {

/// Return and Escape end what is typed into a field of a panel, and then the keys are the picture's
/// again: the next letter chooses a brush instead of becoming part of a name. Return is the field's
/// even where it is a shortcut. Owned by the window. Main thread only.
class FieldKeys : public QObject
{
    Q_OBJECT

public:
    /// `picture` gets the keys; both outlive this.
    FieldKeys(QWidget& window, QWidget& picture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isOfPanel(const QWidget& field) const;
    void giveBack(QWidget* list);

    QWidget& m_window;
    QWidget& m_picture;
};

} // namespace crowd::app
