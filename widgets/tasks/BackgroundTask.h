// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>

namespace crowd::widgets {

/// What work in the background sees of whoever asked for it. The work's thread; copies share.
class TaskReport
{
public:
    using Show = std::function<void(const QString& what, float fraction)>;

    TaskReport(std::stop_token stop, Show show) : m_stop(std::move(stop)), m_show(std::move(show))
    {
    }

    /// How far it is, 0..1. False: the work is to stop, nobody waits for it.
    bool operator()(const QString& what, float fraction) const
    {
        m_show(what, fraction);
        return !m_stop.stop_requested();
    }
    [[nodiscard]] const std::stop_token& stop() const { return m_stop; }

private:
    std::stop_token m_stop;
    Show m_show;
};

/// One piece of long work at a time, on a thread of its own. Its result is handed over on the main
/// thread as soon as whoever owns the task is free to take it. What is cancelled, by a call or by
/// the owner's end, is never handed over; nobody waits for it: it ends by itself, and the program
/// waits for it only before it ends. The next piece begins when the cancelled one has ended: never
/// two at work. So work refers to nothing of its owner. Main thread only.
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    /// `isFree`: results may be handed over now; none: at any time.
    explicit BackgroundTask(std::function<bool()> isFree = {}, QObject* parent = nullptr);
    ~BackgroundTask() override;

    /// From the start until the result is handed over, or until it is cancelled.
    [[nodiscard]] bool isRunning() const { return m_job != nullptr; }

    /// `work` runs on the thread with a TaskReport and returns a value, which `finished` gets.
    template<class Work, class Finished>
    void start(Work work, Finished finished)
    {
        using Value = std::invoke_result_t<Work&, const TaskReport&>;
        auto value = std::make_shared<std::optional<Value>>();
        begin([value,
               work = std::move(work)](const TaskReport& report) { value->emplace(work(report)); },
              [value, finished = std::move(finished)] { finished(std::move(**value)); });
    }
    /// At once, whatever the work is in the middle of. Nothing where nothing runs.
    void cancel();
    /// Waits for the work and hands it over now, free or not. Nothing where nothing runs.
    void wait();

Q_SIGNALS:
    void progressed(const QString& what, float fraction);
    void ended(); ///< handed over or cancelled; the next piece may start

private:
    using Run = std::function<void(const TaskReport&)>;
    class Job;
    class Turn;

    void begin(Run run, std::function<void()> finished);
    void handOverWhenFree();
    void handOver();

    std::function<bool()> m_isFree;
    std::function<void()> m_finished; ///< of the work that runs
    Job* m_job = nullptr;             ///< child, while it runs; of the program, once cancelled
    std::shared_ptr<Turn> m_turn;     ///< of the work that was started last
    QTimer m_look;                    ///< whether the owner is free by now
};

} // namespace crowd::widgets
