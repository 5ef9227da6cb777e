// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <QtCore/QObject>
#include <QtCore/QStringList>

#include "app/console/OutputBuffer.h"
#include "app/console/ScriptGate.h"
#include "app/python/ScriptStroke.h"
#include "model/pick/StageRays.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

enum class ScriptOutcome : std::uint8_t {
    Done,
    More,  ///< the lines are not complete yet
    Failed ///< raised, cancelled, or does not compile; the output says so
};

/// Python beside the window, with the open document as `scene`: one thread that runs one script at
/// a time and reaches the document through a gate. Started when it is first asked for anything. All
/// functions: main thread. One in a process.
class Interpreter : public QObject
{
    Q_OBJECT

public:
    explicit Interpreter(widgets::EditorState& state, QObject* parent = nullptr);
    ~Interpreter() override;

    void run(const QString& source);   ///< typed lines
    void runFile(const QString& path); ///< as __main__
    /// A stroke of a script brush: Python takes its dabs until there are no more. False: something
    /// else runs.
    [[nodiscard]] bool paint(const model::ScriptSettings& brush, const ScriptStrokeLinkPtr& dabs);
    /// What the last one raised; empty: nothing, or it was cancelled.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    void complete(const QString& text);
    [[nodiscard]] bool isRunning() const { return m_isRunning; }
    /// Raises KeyboardInterrupt in the script, also while it sleeps.
    void cancel();
    /// Cancels this script again and again, for it may just begin to wait, and says how that ended.
    void stop(const std::function<void(bool hasStopped)>& ended);
    /// Cancels and waits a moment, without events; nothing runs afterwards. False: the script does
    /// not stop.
    [[nodiscard]] bool shutDown();
    [[nodiscard]] OutputBuffer& output() { return m_output; }

Q_SIGNALS:
    void started();
    void finished(crowd::app::ScriptOutcome outcome);
    /// A script brought a brush along.
    void brushRegistered(const crowd::widgets::ScriptBrush& brush);
    void completed(const QString& text, const QStringList& candidates);

private:
    struct Python;
    using Job = std::function<void(Python&)>;

    void start();
    void push(Job job);
    void begin(std::function<std::string(Python&)> script);
    void serve();
    [[nodiscard]] std::optional<Job> nextJob(); ///< waits for it; none: the thread is to end
    [[nodiscard]] bool mayBegin();

    widgets::EditorState& m_state;
    ScriptGate m_gate;
    model::StageRays m_stage;
    OutputBuffer m_output;
    std::thread m_thread;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Job> m_jobs;
    QString m_problem;
    bool m_isEnding = false;          ///< the thread is to end
    bool m_hasEnded = false;          ///< it has
    bool m_isRunning = false;         ///< main thread's view
    int m_runs = 0;                   ///< scripts begun; the number of the one that runs
    std::atomic<int> m_cancelled = 0; ///< the number of the last one that was told to stop
};

} // namespace crowd::app
