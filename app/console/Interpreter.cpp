// SPDX-License-Identifier: MIT
#include "app/console/Interpreter.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <pthread.h>

// Python's headers before Qt's would do as well: QT_NO_KEYWORDS keeps them apart.
#include "app/python/Binding.h"
#include "app/python/EmbeddedPython.h"
#include "app/python/OutsidePython.h"
#include "app/python/PythonBrush.h"
#include "widgets/state/SceneChanges.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QTimer>

namespace crowd::app {

namespace {

/// Interrupts the script's thread; Python turns it into KeyboardInterrupt (see console.py).
constexpr int kStopSignal = SIGUSR1;
constexpr auto kPatience = std::chrono::milliseconds(3000);
constexpr auto kBetweenCancels = std::chrono::milliseconds(100);

void ignoreStopSignal()
{
    // Until Python handles it: one that comes too early or too late must not end the program.
    std::signal(kStopSignal, SIG_IGN);
}

QString sourceOfConsole()
{
    QFile file(QStringLiteral(":/console/console.py"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

widgets::ScriptField fieldOf(const py::tuple& said)
{
    widgets::ScriptField field;
    field.name = said[0].cast<std::string>();
    const QString label =
        QString::fromStdString(field.name).replace(QLatin1Char('_'), QLatin1Char(' '));
    field.label = (label.left(1).toUpper() + label.mid(1)).toStdString();
    field.low = said[2].cast<double>();
    field.high = said[3].cast<double>();
    field.step = said[4].cast<double>();
    field.decimals = said[5].cast<int>();
    for (const py::handle& choice : said[6]) {
        field.choices.push_back(choice.cast<std::string>());
    }
    return field;
}

/// What brushes.py tells of a brush, on its way to the main thread.
py::cpp_function brushListener(Interpreter& owner)
{
    return [&owner](const std::string& name, const std::string& tip, const PythonBrush& area,
                    const py::list& fields) {
        widgets::ScriptBrush brush;
        brush.tip = QString::fromStdString(tip);
        brush.settings = area.settings();
        brush.settings.as<model::ScriptSettings>().brush = name;
        std::vector<widgets::ScriptField> said;
        auto& script = brush.settings.as<model::ScriptSettings>();
        for (const py::handle& each : fields) {
            const auto field = each.cast<py::tuple>();
            said.push_back(fieldOf(field));
            script.values.push_back(
                {said.back().name, field[1].cast<decltype(model::ScriptValue::value)>()});
        }
        brush.fields = widgets::describeScriptFields(std::move(said), script.values);
        QMetaObject::invokeMethod(
            &owner, [&owner, brush] { Q_EMIT owner.brushRegistered(brush); }, Qt::QueuedConnection);
    };
}

/// What lives on the interpreter's thread, under Python's lock.
struct Interpreter::Python
{
    explicit Python(Interpreter& owner);

    [[nodiscard]] std::string call(const char* function, const std::string& argument);
    [[nodiscard]] std::string paint(const model::ScriptSettings& brush,
                                    const ScriptStrokeLinkPtr& dabs);

    EmbeddedPython python{false};
    ScenePtr scene;     ///< the open document
    py::object console; ///< null when it could not be made; the output says why
};

Interpreter::Python::Python(Interpreter& owner)
{
    const auto writer = [&owner](OutputKind kind) {
        return py::cpp_function([&owner, kind](const py::bytes& text) {
            owner.m_output.write(QString::fromStdString(std::string(text)), kind);
        });
    };
    ScriptHost host{&owner.m_state.document(), &owner.m_state.keyframes(), &owner.m_stage,
                    [&owner](const std::function<void()>& work) {
                        if (!outsidePython([&] { return owner.m_gate.run(work); })) {
                            throw ScriptError("The editor is closing.");
                        }
                    },
                    [&owner](const ScriptEvent& event) {
                        widgets::SessionControl& session = owner.m_state.session();
                        if (session.isRunning()) {
                            session.send({.name = event.name, .payload = event.number}, event.ids);
                        }
                        return session.isRunning();
                    }};
    try {
        const char* const name = "crowdbrush/console.py";
        const py::module_ builtins = py::module_::import("builtins");
        py::dict names;
        names["__file__"] = name; // tracebacks leave out what is ours
        builtins.attr("exec")(
            builtins.attr("compile")(sourceOfConsole().toStdString(), name, "exec"), names);
        scene = std::make_shared<ScriptScene>(host);
        console = names["Console"](writer(OutputKind::Text), writer(OutputKind::Error), scene,
                                   brushListener(owner));
    } catch (const py::error_already_set& problem) {
        owner.m_output.write(QString::fromUtf8(problem.what()) + QLatin1Char('\n'),
                             OutputKind::Error);
    }
}

std::string Interpreter::Python::paint(const model::ScriptSettings& brush,
                                       const ScriptStrokeLinkPtr& dabs)
{
    try {
        if (!console) {
            return "failed";
        }
        py::dict values;
        for (const model::ScriptValue& each : brush.values) {
            values[py::str(each.name)] = each.value;
        }
        const py::cpp_function paintWith([this, dabs](const py::object& made) {
            scene->joinStroke(dabs);
            try {
                paintDabs(scene, *dabs, made);
            } catch (...) {
                scene->leaveStroke();
                throw;
            }
            scene->leaveStroke();
        });
        return console.attr("paint")(brush.brush, values, paintWith).cast<std::string>();
    } catch (const py::error_already_set&) {
        return "failed"; // cancelled at the very end
    }
}

std::string Interpreter::Python::call(const char* function, const std::string& argument)
{
    try {
        return console ? console.attr(function)(argument).cast<std::string>() : "failed";
    } catch (const py::error_already_set&) {
        return "failed"; // cancelled at the very end
    }
}

Interpreter::Interpreter(widgets::EditorState& state, QObject* parent)
    : QObject(parent), m_state(state)
{
    connect(this, &Interpreter::brushRegistered, &state, &widgets::EditorState::putScriptBrush);
    connect(&state.document(), &model::SceneDocument::changed, this, [this](const auto& change) {
        if (widgets::isOneOf<model::SceneReplaced>(change)) {
            m_stage.setStages({}); // the old scene's memory is wanted back
        }
    });
    qRegisterMetaType<crowd::app::ScriptOutcome>();
}

Interpreter::~Interpreter()
{
    if (!shutDown()) {
        // It runs on and on in code of somebody else's: better no tidy end than none at all. Files
        // were saved before; whoever started the program hears that it did not end as it should.
        std::fputs("crowdbrush: a script did not stop; the program was ended around it.\n", stderr);
        std::_Exit(EXIT_FAILURE);
    }
}

void Interpreter::start()
{
    if (!m_thread.joinable()) {
        ignoreStopSignal();
        m_thread = std::thread([this] { serve(); });
    }
}

void Interpreter::push(Job job)
{
    start();
    const std::lock_guard lock(m_mutex);
    m_jobs.push_back(std::move(job));
    m_wake.notify_one();
}

bool Interpreter::mayBegin()
{
    if (m_isRunning) {
        return false;
    }
    if (m_state.document().isEditOpen()) {
        m_output.write(tr("Finish or cancel the stroke first.") + QLatin1Char('\n'),
                       OutputKind::Error);
        Q_EMIT finished(ScriptOutcome::Failed);
        return false;
    }
    return true;
}

void Interpreter::begin(std::function<std::string(Python&)> script)
{
    if (!mayBegin()) {
        return;
    }
    m_isRunning = true;
    ++m_runs;
    Q_EMIT started();
    push([this, run = m_runs, script = std::move(script)](Python& python) {
        if (m_cancelled == run) {
            PyErr_SetInterruptEx(kStopSignal); // its signal may have come while nothing ran
        }
        const std::string result = script(python);
        const ScriptOutcome outcome = result == "done"   ? ScriptOutcome::Done
                                      : result == "more" ? ScriptOutcome::More
                                                         : ScriptOutcome::Failed;
        constexpr std::string_view kFailed = "failed:";
        const QString problem = result.starts_with(kFailed)
                                    ? QString::fromStdString(result.substr(kFailed.size()))
                                    : QString();
        QMetaObject::invokeMethod(
            this,
            [this, outcome, problem] {
                m_isRunning = false;
                m_problem = problem;
                Q_EMIT finished(outcome);
            },
            Qt::QueuedConnection);
    });
}

void Interpreter::run(const QString& source)
{
    begin([text = source.toStdString()](Python& python) { return python.call("run", text); });
}

void Interpreter::runFile(const QString& path)
{
    begin([text = path.toStdString()](Python& python) { return python.call("run_file", text); });
}

bool Interpreter::paint(const model::ScriptSettings& brush, const ScriptStrokeLinkPtr& dabs)
{
    if (m_isRunning || m_state.document().isEditOpen()) {
        return false;
    }
    begin([brush, dabs](Python& python) { return python.paint(brush, dabs); });
    return true;
}

void Interpreter::complete(const QString& text)
{
    if (m_isRunning) {
        return;
    }
    push([this, text](Python& python) {
        QStringList candidates;
        try {
            if (python.console) {
                const py::list found = python.console.attr("complete")(text.toStdString());
                for (const py::handle& each : found) {
                    candidates << QString::fromStdString(each.cast<std::string>());
                }
            }
        } catch (const py::error_already_set&) {
            candidates.clear();
        }
        QMetaObject::invokeMethod(
            this, [this, text, candidates] { Q_EMIT completed(text, candidates); },
            Qt::QueuedConnection);
    });
}

void Interpreter::cancel()
{
    if (m_isRunning && m_thread.joinable()) {
        m_cancelled = m_runs;
        pthread_kill(m_thread.native_handle(), kStopSignal);
    }
}

void Interpreter::stop(const std::function<void(bool hasStopped)>& ended)
{
    auto* again = new QTimer(this);
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    connect(again, &QTimer::timeout, this, [this, again, deadline, ended, run = m_runs] {
        const bool isRunning = m_isRunning && m_runs == run; // the next one is nobody's business
        if (isRunning && std::chrono::steady_clock::now() < deadline) {
            cancel();
            return;
        }
        again->deleteLater();
        again->stop();
        ended(!isRunning);
    });
    cancel();
    again->start(kBetweenCancels);
}

std::optional<Interpreter::Job> Interpreter::nextJob()
{
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return !m_jobs.empty() || m_isEnding; });
    if (m_isEnding) {
        return std::nullopt;
    }
    Job job = std::move(m_jobs.front());
    m_jobs.pop_front();
    return job;
}

void Interpreter::serve()
{
    {
        Python python(*this);
        while (true) {
            const std::optional<Job> job = outsidePython([this] { return nextJob(); });
            if (!job) {
                break;
            }
            if (PyErr_CheckSignals() != 0) {
                PyErr_Clear(); // a cancel that came too late for the one before
            }
            (*job)(python);
        }
        ignoreStopSignal();
    }
    const std::lock_guard lock(m_mutex);
    m_hasEnded = true;
    m_wake.notify_all();
}

bool Interpreter::shutDown()
{
    if (!m_thread.joinable()) {
        return true;
    }
    m_gate.close();
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    std::unique_lock lock(m_mutex);
    m_isEnding = true;
    m_jobs.clear();
    m_wake.notify_all();
    while (!m_wake.wait_for(lock, kBetweenCancels, [this] { return m_hasEnded; })) {
        if (std::chrono::steady_clock::now() > deadline) {
            return false;
        }
        lock.unlock();
        cancel();
        lock.lock();
    }
    lock.unlock();
    m_thread.join();
    return true;
}

} // namespace crowd::app
