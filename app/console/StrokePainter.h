// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include "app/console/Interpreter.h"
#include "model/brush/Stroke.h"
#include "widgets/tools/ScriptPainter.h"

namespace crowd::app {

/// Strokes of script brushes in the window: the picture selects, Python changes on its own thread,
/// and what it does belongs to the stroke's edit. Slow ones go on after the release, with progress;
/// what they raise takes the stroke back. Main thread; interpreter and state outlive it.
class StrokePainter : public QObject, public widgets::ScriptPainter
{
    Q_OBJECT

public:
    StrokePainter(Interpreter& interpreter, widgets::EditorState& state, QObject* parent);
    ~StrokePainter() override;

    [[nodiscard]] bool begin(const model::BrushContext& context,
                             const model::BrushSettings& settings, std::uint64_t seed,
                             const model::PointerInput& press) override;
    void move(const model::PointerInput& input) override;
    void pass(const model::PointerInput& input) override;
    void release() override;
    void cancel() override;
    [[nodiscard]] bool isPainting() const override { return m_link != nullptr; }
    [[nodiscard]] int affected() const override;

private:
    void takeBack();
    void finish(ScriptOutcome outcome);
    void showProgress();

    Interpreter& m_interpreter;
    widgets::EditorState& m_state;
    ScriptStrokeLinkPtr m_link;              ///< null: nothing is painted
    std::unique_ptr<model::Stroke> m_stroke; ///< null after it was taken back
    QString m_name;
    QTimer m_timer;
    QElapsedTimer m_released; ///< invalid while the button is held
};

} // namespace crowd::app
