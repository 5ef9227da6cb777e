// SPDX-License-Identifier: MIT
#include "app/window/StatusPanel.h"

#include <QtCore/QLocale>

namespace crowd::app {

namespace {

constexpr int kRemarkMs = 6000;

} // namespace

StatusPanel::StatusPanel(widgets::EditorState& state, QWidget* parent)
    : QStatusBar(parent), m_state(state), m_hint(new QLabel(this)), m_counts(new QLabel(this)),
      m_frame(new QLabel(this))
{
    m_hint->setMinimumWidth(50); // gives way before the window is forced wider
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setContentsMargins(8, 0, 8, 0);
    for (QLabel* label : {m_counts, m_frame}) {
        label->setContentsMargins(8, 0, 8, 0);
    }
    addWidget(m_hint, 1);
    addPermanentWidget(m_counts);
    addPermanentWidget(m_frame);
    connect(&state, &widgets::EditorState::hintChanged, m_hint, &QLabel::setText);
    connect(&state, &widgets::EditorState::statusMessage, this, [this](const QString& text) {
        m_remark = text;
        showMessage(text, kRemarkMs);
    });
    connect(&state.document(), &model::SceneDocument::changed, this, &StatusPanel::refreshCounts);
    connect(&state.selection(), &widgets::Selection::changed, this, &StatusPanel::refreshCounts);
    m_hint->setText(state.hint());
    refreshCounts();
}

void StatusPanel::refreshCounts()
{
    QString text = tr("%n people", nullptr, static_cast<int>(m_state.scene().population.size()));
    if (!m_state.selection().isEmpty()) {
        text += QStringLiteral(" · ") +
                tr("%n selected", nullptr, static_cast<int>(m_state.selection().size()));
    }
    m_counts->setText(text);
}

void StatusPanel::setStatistics(const widgets::FrameStatistics& statistics)
{
    const QLocale locale;
    m_frame->setText(
        tr("%1 ms · %2 triangles")
            .arg(locale.toString(statistics.frameMs, 'f', 1),
                 locale.toString(static_cast<qlonglong>(statistics.render.triangles))));
    m_frame->setToolTip(tr("Time of one picture, and what was drawn in it: %1 of %2 people")
                            .arg(statistics.render.visible)
                            .arg(statistics.render.individuals));
}

} // namespace crowd::app
