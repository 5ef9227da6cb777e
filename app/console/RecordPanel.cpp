// SPDX-License-Identifier: MIT
#include "app/console/RecordPanel.h"

#include <QtCore/QDir>
#include <QtCore/QSettings>
#include <QtGui/QClipboard>
#include <QtGui/QFontDatabase>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/theme/Icons.h"

namespace crowd::app {

namespace {

const QString kScriptFolderKey = QStringLiteral("console/folder");
constexpr qsizetype kMostShown = 4000; ///< characters of a step

QToolButton* makeButton(const char* icon, const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIcon(widgets::iconNamed(icon));
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setToolTip(tip);
    return button;
}

} // namespace

RecordPanel::RecordPanel(Recorder& recorder, QWidget* parent)
    : QWidget(parent), m_recorder(recorder), m_title(new QLabel(this)),
      m_text(new QPlainTextEdit(this)),
      m_copy(makeButton("copy", tr("Copy"), tr("Copy the whole script"), this)),
      m_save(makeButton("save", tr("Save…"),
                        tr("Save the script, with the scene that it starts from"), this))
{
    m_text->setObjectName(QStringLiteral("recordedScript"));
    m_text->setReadOnly(true);
    m_text->setUndoRedoEnabled(false);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setPlaceholderText(tr("What you do by hand appears here as Python."));
    m_title->setTextFormat(Qt::RichText);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(4, 0, 0, 0);
    head->addWidget(m_title, 1);
    head->addWidget(m_copy);
    head->addWidget(m_save);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(m_text, 1);
    connect(m_copy, &QToolButton::clicked, this, &RecordPanel::copy);
    connect(m_save, &QToolButton::clicked, this, &RecordPanel::save);
    connect(&recorder, &Recorder::started, m_text, &QPlainTextEdit::clear);
    connect(&recorder, &Recorder::started, this, &RecordPanel::refresh);
    connect(&recorder, &Recorder::added, this, &RecordPanel::append);
    connect(&recorder, &Recorder::recordingChanged, this, &RecordPanel::refresh);
    refresh();
}

void RecordPanel::takeOver(const RecordPanel& before)
{
    m_text->setPlainText(before.m_text->toPlainText());
    setVisible(!before.isHidden());
}

void RecordPanel::refresh()
{
    m_title->setText(m_recorder.isRecording()
                         ? QStringLiteral("<span style=\"color:#e0503a\">●</span> <b>%1</b>")
                               .arg(tr("Recording").toHtmlEscaped())
                         : QStringLiteral("<b>%1</b>").arg(tr("Recorded script").toHtmlEscaped()));
    m_copy->setEnabled(!m_recorder.isEmpty());
    m_save->setEnabled(!m_recorder.isEmpty());
}

void RecordPanel::append(const QString& text)
{
    QString shown = text;
    if (shown.size() > kMostShown) {
        shown = tr("%1\n# … %2 more characters of this step are copied and saved …\n")
                    .arg(text.left(kMostShown))
                    .arg(QLocale().toString(text.size() - kMostShown));
    }
    QTextCursor cursor(m_text->document());
    cursor.movePosition(QTextCursor::End);
    cursor.insertText(shown);
    m_text->moveCursor(QTextCursor::End);
    m_text->moveCursor(QTextCursor::StartOfLine);
    refresh();
}

void RecordPanel::copy()
{
    QGuiApplication::clipboard()->setText(QString::fromStdString(m_recorder.script()));
}

void RecordPanel::save()
{
    QSettings settings;
    const QString folder = settings.value(kScriptFolderKey, QDir::homePath()).toString();
    QString path = QFileDialog::getSaveFileName(this, tr("Save Recorded Script"),
                                                QDir(folder).filePath(tr("recorded.py")),
                                                tr("Python scripts (*.py)"));
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += QStringLiteral(".py");
    }
    settings.setValue(kScriptFolderKey, QFileInfo(path).absolutePath());
    if (const auto done = m_recorder.save(path); !done) {
        Q_EMIT failed(model::translated(done.error()));
        return;
    }
    Q_EMIT saved(path);
}

} // namespace crowd::app
