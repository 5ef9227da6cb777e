// SPDX-License-Identifier: MIT
#include "app/console/StrokePainter.h"

#include <algorithm>

#include "widgets/tools/BrushDrags.h"

namespace crowd::app {

namespace {

constexpr int kProgressMs = 100;
constexpr int kSoonMs = 250; ///< what is done by then needs no progress

} // namespace

StrokePainter::StrokePainter(Interpreter& interpreter, widgets::EditorState& state, QObject* parent)
    : QObject(parent), m_interpreter(interpreter), m_state(state)
{
    state.setScriptPainter(this);
    connect(&interpreter, &Interpreter::finished, this, &StrokePainter::finish);
    connect(&state.document(), &model::SceneDocument::editInterrupted, this,
            &StrokePainter::cancel);
    connect(&m_timer, &QTimer::timeout, this, &StrokePainter::showProgress);
}

StrokePainter::~StrokePainter()
{
    m_state.setScriptPainter(nullptr);
}

bool StrokePainter::begin(const model::BrushContext& context, const model::BrushSettings& settings,
                          std::uint64_t seed, const model::PointerInput& press)
{
    const auto link = std::make_shared<ScriptStrokeLink>();
    if (isPainting() || !m_interpreter.paint(settings.as<model::ScriptSettings>(), link)) {
        m_state.showStatus(tr("A script is running: wait for it, or stop it in the console."));
        return false;
    }
    m_link = link;
    m_name = QString::fromStdString(settings.as<model::ScriptSettings>().brush);
    m_released.invalidate();
    model::BrushContext own = context;
    own.script = link.get();
    m_stroke = model::Stroke::begin(m_state.document(), own, settings, seed, press);
    if (!m_stroke) {
        link->abandon();
        return false;
    }
    m_timer.start(kProgressMs);
    return true;
}

void StrokePainter::move(const model::PointerInput& input)
{
    if (m_stroke) {
        m_stroke->move(input);
    }
}

void StrokePainter::pass(const model::PointerInput& input)
{
    if (m_stroke) {
        m_stroke->pass(input);
    }
}

void StrokePainter::release()
{
    if (m_stroke) {
        m_stroke->settle();
        m_link->close();
        m_released.start();
    }
}

void StrokePainter::takeBack()
{
    m_link->abandon();
    if (m_stroke) {
        m_stroke->cancel();
        m_stroke.reset();
    }
}

void StrokePainter::cancel()
{
    if (isPainting()) {
        m_interpreter.cancel(); // first: else what it waits for would end before it hears of this
        takeBack();
    }
}

int StrokePainter::affected() const
{
    return m_stroke ? m_stroke->affected() : 0;
}

void StrokePainter::finish(ScriptOutcome outcome)
{
    if (!isPainting()) {
        return;
    }
    m_timer.stop();
    m_state.setLongWork({});
    const bool wasTakenBack = !m_stroke;
    if (outcome != ScriptOutcome::Done || wasTakenBack) {
        takeBack();
        m_state.showStatus(m_interpreter.problem().isEmpty() || wasTakenBack
                               ? tr("The stroke was taken back.")
                               : tr("%1 stopped: %2").arg(m_name, m_interpreter.problem()));
    } else {
        const model::StrokeOutcome result = m_stroke->finish();
        m_stroke.reset();
        if (result.isCommitted) {
            m_state.noteStroke(model::BrushKind::Script);
        }
        m_state.showStatus(result.isCommitted
                               ? widgets::affectedText(model::BrushKind::Script, result.affected)
                               : result.message);
    }
    m_link.reset();
}

void StrokePainter::showProgress()
{
    if (!m_stroke || !m_released.isValid() || m_released.elapsed() < kSoonMs) {
        return;
    }
    constexpr int kParts = 1000;
    const ScriptStrokeLink::Progress progress = m_link->progress();
    const int all = progress.taken + progress.waiting;
    const double done = std::max(0.0, progress.taken - 1 + progress.share);
    m_state.setLongWork({tr("%1 is at work").arg(m_name), static_cast<int>(done * kParts),
                         std::max(1, all) * kParts, true});
}

} // namespace crowd::app
