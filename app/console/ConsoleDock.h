// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>

#include "app/console/ConsoleInput.h"
#include "app/console/Interpreter.h"
#include "app/console/RecordPanel.h"
#include "widgets/docks/DockBase.h"

namespace crowd::app {

/// Python in a panel: what scripts print, in the order it came, errors in colour; below it the line
/// to type in. The open document is `scene`. The interpreter outlives the panel.
class ConsoleDock : public widgets::DockBase
{
    Q_OBJECT

public:
    ConsoleDock(Interpreter& interpreter, Recorder& recorder, QWidget* parent);

    void takeOver(DockBase& before) override;
    /// Asks for a file and runs it.
    void runScript();
    void runFile(const QString& path);
    void clearOutput();
    /// The script that is recorded stands beside the console, also after the end.
    void setRecording(bool isOn);
    /// Whether no script runs, or the artist lets go of the one that does. Else it is stopped, and
    /// readyToClose() comes when that has worked; if not, the artist is asked.
    [[nodiscard]] bool mayClose();
    /// To see and to type in.
    void reveal();

Q_SIGNALS:
    void readyToClose();

protected:
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeTypedHalf(QWidget* parent);
    void makeOutput(QWidget* parent);
    [[nodiscard]] QWidget* makeButtons();
    void connectParts();
    void submit(const QString& source);
    void finish(ScriptOutcome outcome);
    void askToClose();
    void write(const QString& text, const QColor& color);
    void echo(const QString& source, const QString& first, const QString& others);
    void showOutput();
    void setBusy(bool isBusy);
    [[nodiscard]] QColor errorColor() const;
    [[nodiscard]] QColor echoColor() const;

    Interpreter& m_interpreter;
    Recorder& m_recorder;
    QPlainTextEdit* m_output; ///< child
    ConsoleInput* m_input;    ///< child
    QLabel* m_prompt;         ///< child
    QToolButton* m_cancel;    ///< child
    QToolButton* m_record;    ///< child
    RecordPanel* m_recorded;  ///< child
    QTimer m_timer;           ///< fetches output while a script runs
    QString m_submitted;
    QString m_greeting; ///< the first line that was written
    bool m_isStopping = false;
    bool m_isGivenUp = false;  ///< the artist closes around the script
    bool m_isFollowing = true; ///< the end of the output stays in sight
};

} // namespace crowd::app
