// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtWidgets/QProgressDialog>

namespace crowd::app {

/// One piece of long work on a thread of its own, with a progress dialog that appears after a
/// moment and can cancel it. The result is handed over on the main thread; nothing is when the work
/// was cancelled, or when the owner dies first (the thread is then asked to stop and waited for).
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    /// Returns false when the work is to stop. Any thread.
    using Progress = std::function<bool(const QString& what, float fraction)>;

    explicit BackgroundTask(QWidget* window);
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
                    if (end()) {
                        finished(std::move(*value));
                    }
                    Q_EMIT ended();
                },
                Qt::QueuedConnection);
        });
    }

Q_SIGNALS:
    void ended(); ///< finished or cancelled; the next piece may start

private:
    void begin(const QString& title);
    [[nodiscard]] bool end(); ///< false when it was cancelled
    bool report(const QString& what, float fraction);

    QWidget* m_window;
    QProgressDialog* m_dialog = nullptr; ///< child of the window, while running
    std::thread m_thread;
    std::atomic<bool> m_isCancelled{false};
};

} // namespace crowd::app
