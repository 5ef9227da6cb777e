// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QStringList>
#include <QtWidgets/QPlainTextEdit>

class QCompleter;

namespace crowd::app {

/// Where scripts are typed: Return runs, Shift+Return starts another line, up and down go through
/// what was typed before (remembered between runs of the program), Tab completes names and indents.
class ConsoleInput : public QPlainTextEdit
{
    Q_OBJECT

public:
    explicit ConsoleInput(QWidget* parent = nullptr);

    /// What is being typed there goes on here.
    void takeOver(const ConsoleInput& before);
    /// The lines were complete: they go to the history.
    void accept();
    /// They go on: a new line, indented.
    void continueBlock();
    /// Candidates for `text`, which was asked for.
    void offer(const QString& text, const QStringList& candidates);

Q_SIGNALS:
    void submitted(const QString& source);
    void completionRequested(const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString wordBeforeCursor() const;
    void replaceWord(const QString& word, const QString& by);
    void browse(int step);
    void fitHeight();

    QCompleter* m_completer; ///< child
    QString m_completed;     ///< the word that the candidates are for
    QStringList m_history;   ///< oldest first
    qsizetype m_place = 0;   ///< in the history; its size: a new one
    QString m_draft;         ///< what was being typed before browsing
};

} // namespace crowd::app
