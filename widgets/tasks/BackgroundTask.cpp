// SPDX-License-Identifier: MIT
#include "widgets/tasks/BackgroundTask.h"

#include <condition_variable>
#include <mutex>
#include <thread>

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtCore/QThread>

namespace crowd::widgets {

namespace {

constexpr int kBusyLookMs = 30;

} // namespace

/// Until it is over, the next piece of work waits.
class BackgroundTask::Turn
{
public:
    void end()
    {
        const std::scoped_lock lock(m_mutex);
        m_isOver = true;
        m_over.notify_all();
    }
    void wait()
    {
        std::unique_lock lock(m_mutex);
        m_over.wait(lock, [this] { return m_isOver; });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_over;
    bool m_isOver = false;
};

/// One piece of work and its thread. It outlives the task that has abandoned it.
class BackgroundTask::Job : public QObject
{
public:
    Job(BackgroundTask& task, Run run, std::shared_ptr<Turn> before, std::shared_ptr<Turn> turn)
        : QObject(&task), m_task(&task),
          m_thread([this, run = std::move(run), before = std::move(before),
                    turn = std::move(turn)](const std::stop_token& stop) mutable {
              if (before) {
                  before->wait();
              }
              if (!stop.stop_requested()) {
                  run({stop, [this](const QString& what, float part) { show(what, part); }});
              }
              run = {}; // what it holds is free before anybody hears of the end
              turn->end();
              const std::scoped_lock lock(m_mutex);
              post(kEnd);
          })
    {
    }

    /// Waits for the end; the task has nothing to do with it from then on.
    void join()
    {
        m_thread.join();
        m_task = nullptr;
        deleteLater();
    }
    /// The task has nothing to do with it from now on.
    void abandon()
    {
        m_task = nullptr;
        m_thread.request_stop();
        setParent(QCoreApplication::instance());
        if (m_isOver) {
            deleteLater();
        } else if (parent() == nullptr) {
            delete this; // nobody else would wait for it
        }
    }

private:
    /// The work's thread. Only the latest is passed on: they may come faster than they are shown.
    void show(const QString& what, float fraction)
    {
        const std::scoped_lock lock(m_mutex);
        m_what = what;
        m_fraction = fraction;
        if (!std::exchange(m_isShowing, true)) {
            post(kProgress);
        }
    }
    /// To the owner's thread. Called under the mutex, which the owner takes before it looks at the
    /// event: a sanitizer does not see what Qt itself guards its events with.
    void post(QEvent::Type what) { QCoreApplication::postEvent(this, new QEvent(what)); }
    bool event(QEvent* event) override
    {
        {
            const std::scoped_lock lock(m_mutex);
        }
        if (event->type() == kProgress) {
            passOn();
        } else if (event->type() == kEnd) {
            end();
        } else {
            return QObject::event(event);
        }
        return true;
    }
    void passOn()
    {
        std::unique_lock lock(m_mutex);
        m_isShowing = false;
        const QString what = m_what;
        const float fraction = m_fraction;
        lock.unlock();
        if (m_task != nullptr) {
            Q_EMIT m_task->progressed(what, fraction);
        }
    }
    void end()
    {
        m_isOver = true;
        if (m_task != nullptr) {
            m_task->handOverWhenFree();
        } else {
            deleteLater();
        }
    }

    static constexpr auto kProgress = QEvent::User;
    static constexpr auto kEnd = static_cast<QEvent::Type>(QEvent::User + 1);

    BackgroundTask* m_task; ///< null: abandoned
    bool m_isOver = false;
    std::mutex m_mutex; ///< of what follows
    QString m_what;
    float m_fraction = 0.0F;
    bool m_isShowing = false;
    std::jthread m_thread; ///< last: ends first
};

BackgroundTask::BackgroundTask(std::function<bool()> isFree, QObject* parent)
    : QObject(parent), m_isFree(std::move(isFree))
{
    m_look.setSingleShot(true);
    m_look.setInterval(kBusyLookMs);
    connect(&m_look, &QTimer::timeout, this, &BackgroundTask::handOverWhenFree);
}

BackgroundTask::~BackgroundTask()
{
    if (m_job != nullptr) {
        m_job->abandon();
    }
}

void BackgroundTask::begin(Run run, std::function<void()> finished)
{
    Q_ASSERT(!isRunning());
    Q_ASSERT(QThread::currentThread() == thread());
    m_finished = std::move(finished);
    std::shared_ptr<Turn> before = std::exchange(m_turn, std::make_shared<Turn>());
    m_job = new Job(*this, std::move(run), std::move(before), m_turn);
}

void BackgroundTask::cancel()
{
    if (Job* const job = std::exchange(m_job, nullptr)) {
        m_look.stop();
        m_finished = {};
        job->abandon();
        Q_EMIT ended();
    }
}

void BackgroundTask::wait()
{
    if (m_job != nullptr) {
        handOver();
    }
}

void BackgroundTask::handOverWhenFree()
{
    if (m_isFree && !m_isFree()) {
        m_look.start();
    } else {
        handOver();
    }
}

/// The next piece may be started by who gets this one.
void BackgroundTask::handOver()
{
    m_look.stop();
    Job* const job = std::exchange(m_job, nullptr);
    job->join();
    const std::function<void()> finished = std::exchange(m_finished, {});
    finished();
    Q_EMIT ended();
}

} // namespace crowd::widgets
