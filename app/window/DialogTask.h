// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>
#include <QtWidgets/QProgressDialog>

#include "widgets/tasks/BackgroundTask.h"

namespace crowd::app {

/// Work in the background that the artist waits for: a progress dialog appears after a moment and
/// can cancel it. Neither the dialog nor the result comes in the middle of a stroke, which a dialog
/// would cut off and another edit would collide with. Main thread.
class DialogTask : public QObject
{
    Q_OBJECT

public:
    /// `isFree`: results may be handed over and dialogs may be shown now.
    DialogTask(QWidget* window, std::function<bool()> isFree);
    ~DialogTask() override;

    [[nodiscard]] bool isRunning() const { return m_task.isRunning(); }

    /// As of BackgroundTask.
    template<class Work, class Finished>
    void start(const QString& title, Work work, Finished finished)
    {
        showSoon(title);
        m_task.start(std::move(work), [this, finished = std::move(finished)](auto value) {
            close();
            finished(std::move(value));
        });
    }

Q_SIGNALS:
    void ended(); ///< finished or cancelled; the next piece may start

private:
    void showSoon(const QString& title);
    void showWhenFree();
    void follow(const QString& what, float fraction);
    void end();
    void close(); ///< the dialog
    void giveKeysBack();

    QWidget* m_window;
    std::function<bool()> m_isFree;
    QTimer m_patience;                   ///< until the dialog comes
    QProgressDialog* m_dialog = nullptr; ///< child of the window, while running
    bool m_hasKeys = false;              ///< a dialog, since the keys were given back
    widgets::BackgroundTask m_task;
};

} // namespace crowd::app
