// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QLabel>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QToolButton>

#include "app/record/Recorder.h"

namespace crowd::app {

/// The script that is being recorded, as it grows; to copy and to save. Very long steps are shown
/// in part, and copied and saved whole.
class RecordPanel : public QWidget
{
    Q_OBJECT

public:
    RecordPanel(Recorder& recorder, QWidget* parent);

    /// Shows what was shown there.
    void takeOver(const RecordPanel& before);

Q_SIGNALS:
    void failed(const QString& message);
    void saved(const QString& path);

private:
    void refresh();
    void append(const QString& text);
    void copy();
    void save();

    Recorder& m_recorder;
    QLabel* m_title;        ///< child
    QPlainTextEdit* m_text; ///< child
    QToolButton* m_copy;    ///< child
    QToolButton* m_save;    ///< child
};

} // namespace crowd::app
