// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include <QtCore/QObject>

namespace crowd::app {

/// How a script's thread reaches what belongs to the main thread: work is handed over, done there
/// between two events, and waited for. After close() nothing is done any more.
class ScriptGate : public QObject
{
    Q_OBJECT

public:
    explicit ScriptGate(QObject* parent = nullptr);

    /// From any other thread, one or several; false: the gate is closed and nothing was done.
    [[nodiscard]] bool run(const std::function<void()>& work);
    /// Main thread. Whoever waits is let go.
    void close();

protected:
    bool event(QEvent* event) override;

private:
    std::mutex m_entrance; ///< one at a time
    std::mutex m_mutex;
    std::condition_variable m_done;
    const std::function<void()>* m_work = nullptr;
    bool m_isClosed = false;
};

} // namespace crowd::app
