// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>
#include <QtWidgets/QProgressDialog>

namespace crowd::app {

/// One piece of long work on a thread of its own, with a progress dialog that appears after a
/// moment and can cancel it. The result is handed over on the main thread, as soon as the window is
/// free to take it: never in the middle of a stroke, which a dialog would cut off and another edit
/// would collide with. Nothing is handed over when the work was cancelled, or when the owner dies
/// first (the thread is then asked to stop and waited for).
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    /// Returns false when the work is to stop. Any thread.
    using Progress = std::function<bool(const QString& what, float fraction)>;

    /// `isFree`: results may be handed over and dialogs may be shown now. Main thread.
    BackgroundTask(QWidget* window, std::function<bool()> isFree);
    ~BackgroundTask() override;

    [[nodiscard]] bool isRunning() const { return m_thread.joinable(); }

    /// `work` runs on the thread and returns a value; `finished` gets it on the main thread. One
    /// piece of work at a time.
    template<class Work, class Finished>
    void start(const QString& title, Work work, Finished finished)
    {
        begin(title);
        m_thread = std::thread([this, work = std::move(work), finished = std::move(finished)] {
            using Value = decltype(work(Progress()));
            auto value = std::make_shared<Value>(work(
                [this](const QString& what, float fraction) { return report(what, fraction); }));
            QMetaObject::invokeMethod(
                this,
                [this, value, finished] {
                    m_handOver = [value, finished] { finished(std::move(*value)); };
                    handOver();
                },
                Qt::QueuedConnection);
        });
    }

Q_SIGNALS:
    void ended(); ///< finished or cancelled; the next piece may start

private:
    void begin(const QString& title);
    void showProgress();      ///< as soon as the window is free
    void handOver();          ///< as soon as the window is free
    [[nodiscard]] bool end(); ///< false when it was cancelled
    void giveKeysBack();
    bool report(const QString& what, float fraction);

    QWidget* m_window;
    std::function<bool()> m_isFree;
    std::function<void()> m_handOver;    ///< what waits to be handed over
    QTimer m_patience;                   ///< until the dialog comes
    QTimer m_look;                       ///< whether the window is free by now
    QProgressDialog* m_dialog = nullptr; ///< child of the window, while running
    std::thread m_thread;
    std::atomic<bool> m_isCancelled{false};
};

} // namespace crowd::app
