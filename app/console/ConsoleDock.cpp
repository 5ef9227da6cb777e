// SPDX-License-Identifier: MIT
#include "app/console/ConsoleDock.h"

#include <QtCore/QDir>
#include <QtCore/QSettings>
#include <QtGui/QFontDatabase>
#include <QtGui/QTextDocumentFragment>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QVBoxLayout>

#include "widgets/theme/Icons.h"

namespace crowd::app {

namespace {

const QString kFolderKey = QStringLiteral("console/folder");
constexpr int kFetchMs = 60;
constexpr int kMostLines = 5000;

QToolButton* makeButton(const char* icon, const QString& tip, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIcon(widgets::iconNamed(icon));
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    return button;
}

} // namespace

ConsoleDock::ConsoleDock(Interpreter& interpreter, Recorder& recorder, QWidget* parent)
    : DockBase(tr("Python Console"), "console", parent), m_interpreter(interpreter),
      m_recorder(recorder)
{
    auto* content = new QWidget(this);
    QWidget* typed = makeTypedHalf(content);
    m_recorded = new RecordPanel(recorder, content);
    m_recorded->hide();
    auto* halves = new QSplitter(Qt::Horizontal, content);
    halves->setChildrenCollapsible(false);
    halves->addWidget(typed);
    halves->addWidget(m_recorded);
    auto* layout = new QHBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(makeButtons());
    layout->addWidget(halves, 1);
    setWidget(content);
    m_greeting =
        tr("The open scene is \"scene\", everything else is in \"crowdbrush\". Return runs, "
           "Shift+Return starts another line, Tab completes, up and down go through what was "
           "typed before.") +
        QLatin1Char('\n');
    write(m_greeting, echoColor());
    connectParts();
    m_timer.start(kFetchMs);
    setBusy(false);
}

/// What was printed stays as it was, but for the greeting.
void ConsoleDock::takeOver(DockBase& before)
{
    const auto& old = static_cast<const ConsoleDock&>(before);
    QTextCursor printed(old.m_output->document());
    const bool isGreeted = old.m_output->toPlainText().startsWith(old.m_greeting);
    printed.setPosition(isGreeted ? static_cast<int>(old.m_greeting.size()) : 0);
    printed.movePosition(QTextCursor::End, QTextCursor::KeepAnchor);
    if (!isGreeted) {
        m_output->clear();
    }
    QTextCursor end(m_output->document());
    end.movePosition(QTextCursor::End);
    end.insertFragment(printed.selection());
    m_input->takeOver(*old.m_input);
    m_recorded->takeOver(*old.m_recorded);
    DockBase::takeOver(before);
}

/// What is printed, and the line to type in below it.
QWidget* ConsoleDock::makeTypedHalf(QWidget* parent)
{
    auto* typed = new QWidget(parent);
    makeOutput(typed);
    m_prompt = new QLabel(QStringLiteral(">>>"), typed);
    m_prompt->setFont(m_output->font());
    m_prompt->setContentsMargins(0, 6, 0, 0);
    m_input = new ConsoleInput(typed);
    auto* line = new QHBoxLayout;
    line->addWidget(m_prompt, 0, Qt::AlignTop);
    line->addWidget(m_input, 1);
    auto* column = new QVBoxLayout(typed);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_output, 1);
    column->addLayout(line);
    return typed;
}

void ConsoleDock::makeOutput(QWidget* parent)
{
    m_output = new QPlainTextEdit(parent);
    m_output->setObjectName(QStringLiteral("consoleOutput"));
    m_output->setReadOnly(true);
    m_output->setMaximumBlockCount(kMostLines);
    m_output->setUndoRedoEnabled(false);
    m_output->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_output->setWordWrapMode(QTextOption::WrapAnywhere);
    m_output->setFrameShape(QFrame::NoFrame);
    QScrollBar* bar = m_output->verticalScrollBar();
    connect(bar, &QScrollBar::actionTriggered, this,
            [this, bar] { m_isFollowing = bar->sliderPosition() >= bar->maximum(); });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar] {
        if (m_isFollowing) {
            bar->setValue(bar->maximum());
        }
    });
}

void ConsoleDock::connectParts()
{
    connect(m_input, &ConsoleInput::submitted, this, &ConsoleDock::submit);
    connect(m_input, &ConsoleInput::completionRequested, &m_interpreter, &Interpreter::complete);
    connect(&m_interpreter, &Interpreter::completed, m_input, &ConsoleInput::offer);
    connect(&m_interpreter, &Interpreter::started, this, [this] { setBusy(true); });
    connect(&m_interpreter, &Interpreter::finished, this, &ConsoleDock::finish);
    connect(m_recorded, &RecordPanel::failed, this,
            [this](const QString& message) { write(message + QLatin1Char('\n'), errorColor()); });
    connect(m_recorded, &RecordPanel::saved, this, [this](const QString& path) {
        write(tr("Saved as %1").arg(path) + QLatin1Char('\n'), echoColor());
    });
    connect(&m_timer, &QTimer::timeout, this, &ConsoleDock::showOutput);
}

QWidget* ConsoleDock::makeButtons()
{
    auto* buttons = new QWidget(this);
    auto* layout = new QVBoxLayout(buttons);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* run = makeButton("script-run", tr("Run a script file"), buttons);
    m_cancel = makeButton("script-cancel", tr("Stop the script that runs"), buttons);
    m_cancel->setObjectName(QStringLiteral("consoleCancel"));
    m_record = makeButton("record", tr("Record what is done by hand as a script"), buttons);
    m_record->setObjectName(QStringLiteral("consoleRecord"));
    m_record->setCheckable(true);
    auto* clear = makeButton("delete", tr("Clear what was printed"), buttons);
    connect(run, &QToolButton::clicked, this, &ConsoleDock::runScript);
    connect(m_cancel, &QToolButton::clicked, &m_interpreter, &Interpreter::cancel);
    connect(clear, &QToolButton::clicked, this, &ConsoleDock::clearOutput);
    connect(m_record, &QToolButton::clicked, this, &ConsoleDock::setRecording);
    m_record->setChecked(m_recorder.isRecording());
    connect(&m_recorder, &Recorder::recordingChanged, m_record, &QToolButton::setChecked);
    for (QToolButton* each : {run, m_cancel, m_record, clear}) {
        layout->addWidget(each);
    }
    layout->addStretch(1);
    return buttons;
}

void ConsoleDock::runScript()
{
    QSettings settings;
    const QString folder = settings.value(kFolderKey, QDir::homePath()).toString();
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Run Script"), folder, tr("Python scripts (*.py)"));
    if (!path.isEmpty()) {
        settings.setValue(kFolderKey, QFileInfo(path).absolutePath());
        runFile(path);
    }
}

void ConsoleDock::runFile(const QString& path)
{
    reveal();
    if (m_interpreter.isRunning()) {
        write(tr("Another script is running: wait for it or stop it first.") + QLatin1Char('\n'),
              errorColor());
        return;
    }
    write(tr("Running %1").arg(path) + QLatin1Char('\n'), echoColor());
    m_submitted.clear();
    m_interpreter.runFile(path);
}

void ConsoleDock::clearOutput()
{
    m_output->clear();
}

void ConsoleDock::setRecording(bool isOn)
{
    if (isOn) {
        m_recorded->show();
        show();
        raise();
    }
    m_recorder.setRecording(isOn);
}

void ConsoleDock::reveal()
{
    show();
    raise();
    m_input->setFocus();
}

bool ConsoleDock::mayClose()
{
    if (!m_interpreter.isRunning() || m_isGivenUp) {
        return true;
    }
    if (!m_isStopping) {
        m_isStopping = true;
        m_interpreter.stop([this](bool hasStopped) {
            m_isStopping = false;
            if (hasStopped) {
                Q_EMIT readyToClose();
            } else {
                askToClose();
            }
        });
    }
    return false;
}

void ConsoleDock::askToClose()
{
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Script"),
                                tr("The script that runs does not stop. Close all the same? What "
                                   "it was doing is lost."),
                                QMessageBox::Close | QMessageBox::Cancel, this);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this](int answer) {
        if (answer == QMessageBox::Close) {
            m_isGivenUp = m_interpreter.isRunning();
            Q_EMIT readyToClose();
        }
    });
    box->open();
}

void ConsoleDock::submit(const QString& source)
{
    if (m_interpreter.isRunning()) {
        return;
    }
    m_submitted = source;
    m_isFollowing = true;
    m_interpreter.run(source);
}

void ConsoleDock::finish(ScriptOutcome outcome)
{
    m_isGivenUp = false;
    setBusy(false);
    if (outcome == ScriptOutcome::More && !m_submitted.isEmpty()) {
        m_input->continueBlock();
        return;
    }
    if (!m_submitted.isEmpty()) {
        echo(m_submitted, QStringLiteral(">>> "), QStringLiteral("... "));
        m_input->accept();
        m_submitted.clear();
    }
    showOutput();
}

void ConsoleDock::echo(const QString& source, const QString& first, const QString& others)
{
    QString text;
    for (const QString& line : source.trimmed().split(QLatin1Char('\n'))) {
        text += (text.isEmpty() ? first : others) + line + QLatin1Char('\n');
    }
    write(text, echoColor());
}

void ConsoleDock::setBusy(bool isBusy)
{
    m_cancel->setEnabled(isBusy);
    m_input->setReadOnly(isBusy);
    m_prompt->setEnabled(!isBusy);
}

/// A script's own echo comes first, so output waits for it until the lines are known to be whole;
/// what takes long is shown as it comes.
void ConsoleDock::showOutput()
{
    for (const OutputPiece& piece : m_interpreter.output().take()) {
        if (!m_submitted.isEmpty()) {
            echo(m_submitted, QStringLiteral(">>> "), QStringLiteral("... "));
            m_input->accept();
            m_submitted.clear();
        }
        write(piece.text,
              piece.kind == OutputKind::Error ? errorColor() : palette().color(QPalette::Text));
    }
}

void ConsoleDock::write(const QString& text, const QColor& color)
{
    QTextCursor cursor(m_output->document());
    cursor.movePosition(QTextCursor::End);
    QTextCharFormat format;
    format.setForeground(color);
    cursor.insertText(text, format);
}

QColor ConsoleDock::errorColor() const
{
    return palette().color(QPalette::Base).lightness() < 128 ? QColor(255, 138, 120)
                                                             : QColor(178, 36, 24);
}

QColor ConsoleDock::echoColor() const
{
    return palette().color(QPalette::Disabled, QPalette::Text);
}

/// What was printed in the colours of the other theme could not be read any more.
void ConsoleDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_output != nullptr) {
        QTextCursor all(m_output->document());
        all.select(QTextCursor::Document);
        QTextCharFormat format;
        format.setForeground(palette().color(QPalette::Text));
        all.mergeCharFormat(format);
    }
}

} // namespace crowd::app
