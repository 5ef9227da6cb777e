// SPDX-License-Identifier: MIT
#include "app/console/ConsoleInput.h"

#include <algorithm>

#include <QtCore/QRegularExpression>
#include <QtCore/QSettings>
#include <QtCore/QStringListModel>
#include <QtGui/QFontDatabase>
#include <QtGui/QKeyEvent>
#include <QtGui/QTextBlock>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QCompleter>
#include <QtWidgets/QScrollBar>

namespace crowd::app {

namespace {

const QString kHistoryKey = QStringLiteral("console/history");
const QString kIndent = QStringLiteral("    ");
constexpr qsizetype kLongestHistory = 300;
constexpr int kMostInputLines = 8;

} // namespace

ConsoleInput::ConsoleInput(QWidget* parent)
    : QPlainTextEdit(parent), m_completer(new QCompleter(this)),
      m_history(QSettings().value(kHistoryKey).toStringList()), m_place(m_history.size())
{
    setObjectName(QStringLiteral("consoleInput"));
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setPlaceholderText(tr("Python, for example:  len(scene)"));
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_completer->setModel(new QStringListModel(m_completer));
    m_completer->setWidget(this);
    m_completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    connect(m_completer, QOverload<const QString&>::of(&QCompleter::activated), this,
            [this](const QString& chosen) { replaceWord(m_completed, chosen); });
    connect(this, &QPlainTextEdit::textChanged, this, &ConsoleInput::fitHeight);
    fitHeight();
}

void ConsoleInput::takeOver(const ConsoleInput& before)
{
    setPlainText(before.toPlainText());
    moveCursor(QTextCursor::End);
    m_history = before.m_history;
    m_place = before.m_place;
    m_draft = before.m_draft;
}

void ConsoleInput::fitHeight()
{
    const int lines = std::clamp(document()->blockCount(), 1, kMostInputLines);
    const int margins =
        2 * frameWidth() + qRound(2 * document()->documentMargin()) + contentsMargins().top();
    setFixedHeight(lines * fontMetrics().lineSpacing() + margins);
}

void ConsoleInput::changeEvent(QEvent* event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        fitHeight();
    }
}

void ConsoleInput::accept()
{
    const QString text = toPlainText().trimmed();
    if (!text.isEmpty()) {
        m_history.removeAll(text);
        m_history << text;
        m_history = m_history.mid(std::max<qsizetype>(0, m_history.size() - kLongestHistory));
        QSettings().setValue(kHistoryKey, m_history);
    }
    m_place = m_history.size();
    clear();
}

void ConsoleInput::continueBlock()
{
    const QString line = textCursor().block().text();
    static const QRegularExpression leading(QStringLiteral("^[ ]*"));
    QString indent = leading.match(line).captured();
    if (line.trimmed().endsWith(QLatin1Char(':'))) {
        indent += kIndent;
    }
    moveCursor(QTextCursor::End);
    insertPlainText(QLatin1Char('\n') + indent);
}

QString ConsoleInput::wordBeforeCursor() const
{
    const QString before = textCursor().block().text().left(textCursor().positionInBlock());
    static const QRegularExpression word(QStringLiteral("[\\w.]+$"));
    return word.match(before).captured();
}

void ConsoleInput::replaceWord(const QString& word, const QString& by)
{
    QTextCursor cursor = textCursor();
    cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, static_cast<int>(word.size()));
    if (cursor.selectedText() == word) {
        cursor.insertText(by);
    }
}

void ConsoleInput::offer(const QString& text, const QStringList& candidates)
{
    if (candidates.isEmpty() || wordBeforeCursor() != text) {
        return;
    }
    if (candidates.size() == 1) {
        replaceWord(text, candidates.front());
        return;
    }
    m_completed = text;
    static_cast<QStringListModel*>(m_completer->model())->setStringList(candidates);
    QRect place = cursorRect();
    place.setWidth(m_completer->popup()->sizeHintForColumn(0) +
                   m_completer->popup()->verticalScrollBar()->sizeHint().width() + 8);
    m_completer->complete(place);
}

void ConsoleInput::browse(int step)
{
    const qsizetype place = std::clamp<qsizetype>(m_place + step, 0, m_history.size());
    if (place == m_place) {
        return;
    }
    if (m_place == m_history.size()) {
        m_draft = toPlainText();
    }
    m_place = place;
    setPlainText(place == m_history.size() ? m_draft : m_history[place]);
    moveCursor(QTextCursor::End);
}

void ConsoleInput::keyPressEvent(QKeyEvent* event)
{
    if (m_completer->popup()->isVisible() &&
        (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ||
         event->key() == Qt::Key_Escape || event->key() == Qt::Key_Tab)) {
        event->ignore(); // the list's own
        return;
    }
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QTextCursor cursor = textCursor();
    if (isReturn && (event->modifiers() & Qt::ShiftModifier) == 0) {
        if (!toPlainText().trimmed().isEmpty()) {
            Q_EMIT submitted(toPlainText());
        }
    } else if (event->key() == Qt::Key_Up && cursor.blockNumber() == 0) {
        browse(-1);
    } else if (event->key() == Qt::Key_Down &&
               cursor.blockNumber() == document()->blockCount() - 1) {
        browse(1);
    } else if (event->key() == Qt::Key_Tab) {
        const QString word = wordBeforeCursor();
        word.isEmpty() ? insertPlainText(kIndent) : Q_EMIT completionRequested(word);
    } else {
        QPlainTextEdit::keyPressEvent(event);
    }
}

} // namespace crowd::app
