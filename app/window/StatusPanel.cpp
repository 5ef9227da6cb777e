// SPDX-License-Identifier: MIT
#include "app/window/StatusPanel.h"

#include <algorithm>

#include <QtCore/QEvent>
#include <QtCore/QLocale>
#include <QtGui/QGuiApplication>
#include <QtGui/QPainter>
#include <QtWidgets/QApplication>
#include <QtWidgets/QStyleOption>

namespace crowd::app {

namespace {

constexpr int kRemarkMs = 6000;
constexpr int kRemarkMargin = 6;  ///< logical pixels
constexpr double kSlowPace = 0.9; ///< below, it is said

} // namespace

void ElidedLabel::setFullText(const QString& text)
{
    m_full = text;
    setToolTip(text);
    elide();
}

QSize ElidedLabel::sizeHint() const
{
    const QMargins margins = contentsMargins();
    return {fontMetrics().horizontalAdvance(m_full) + margins.left() + margins.right(),
            QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    elide();
}

void ElidedLabel::elide()
{
    setText(fontMetrics().elidedText(m_full, Qt::ElideRight, contentsRect().width()));
}

StatusPanel::StatusPanel(widgets::EditorState& state, QWidget* parent)
    : QStatusBar(parent), m_state(state), m_hint(new ElidedLabel(this)), m_counts(new QLabel(this)),
      m_frame(new QLabel(this))
{
    m_hint->setTextFormat(Qt::PlainText);
    for (QLabel* label : {static_cast<QLabel*>(m_hint), m_counts, m_frame}) {
        label->setContentsMargins(8, 0, 8, 0);
    }
    m_counts->setObjectName(QStringLiteral("statusCounts"));
    m_frame->setObjectName(QStringLiteral("statusFrame"));
    addWidget(m_hint, 1);
    addPermanentWidget(m_counts);
    addPermanentWidget(m_frame);
    connect(&state, &widgets::EditorState::hintChanged, m_hint, &ElidedLabel::setFullText);
    connect(&state, &widgets::EditorState::statusMessage, this, [this](const QString& text) {
        m_remark = text;
        showMessage(text, kRemarkMs);
    });
    connectSession(state.session());
    connect(this, &QStatusBar::messageChanged, this, &QWidget::setToolTip);
    connect(&state.ground(), &widgets::GroundFinder::waiting, this, &StatusPanel::showWaiting);
    connect(&state.ground(), &widgets::GroundFinder::findingChanged, this,
            &StatusPanel::showFinding);
    connect(&state, &widgets::EditorState::viewOptionsChanged, this, &StatusPanel::showFinding);
    connect(&state, &widgets::EditorState::toolChanged, this, [this] { clearMessage(); });
    connect(&state.document(), &model::SceneDocument::changed, this, &StatusPanel::refreshCounts);
    connect(&state.selection(), &widgets::Selection::changed, this, &StatusPanel::refreshCounts);
    connect(&state.session(), &widgets::SessionControl::stateChanged, this,
            &StatusPanel::refreshCounts); // back where the scene has them
    m_hint->setFullText(state.hint());
    refreshCounts();
}

/// What happens to the run is said.
void StatusPanel::connectSession(const widgets::SessionControl& session)
{
    connect(&session, &widgets::SessionControl::takenFrom, this, [this](double seconds) {
        showMessage(
            tr("What came after %1 s is played anew").arg(QLocale().toString(seconds, 'f', 1)),
            kRemarkMs);
    });
    connect(&session, &widgets::SessionControl::takenOutOf, this,
            [this](const QString& take, double seconds) {
                showMessage(tr("Played on out of \"%1\" from %2 s; the take stays as it is")
                                .arg(take, QLocale().toString(seconds, 'f', 1)),
                            kRemarkMs);
            });
    connect(&session, &widgets::SessionControl::rangeEnded, this, [this] {
        showMessage(tr("The play range of the timeline ends here. A click on its ruler with Shift "
                       "held: all time is played."),
                    kRemarkMs);
    });
    connect(&session, &widgets::SessionControl::takeRefused, this, [this] {
        showMessage(tr("Too much was edited since it was started: this happens at the latest "
                       "moment. Stop and play to go back to any moment again."),
                    kRemarkMs);
    });
}

void StatusPanel::showUntilBack(const QString& text)
{
    m_remark = text;
    m_untilBack = text;
    showMessage(text);
    qApp->installEventFilter(this);
}

bool StatusPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) {
        qApp->removeEventFilter(this);
        if (currentMessage() == m_untilBack) {
            showMessage(m_untilBack, kRemarkMs);
        }
        m_untilBack.clear();
    }
    return QStatusBar::eventFilter(watched, event);
}

/// A remark for which there is no room ends in an ellipsis; the tool tip has all.
void StatusPanel::paintEvent(QPaintEvent* event)
{
    if (currentMessage().isEmpty()) {
        QStatusBar::paintEvent(event);
        return;
    }
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    const int end = m_counts->isVisible() ? m_counts->x() : width();
    const QRect room = rect().adjusted(kRemarkMargin, 0, end - width() - kRemarkMargin, 0);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(room, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                     fontMetrics().elidedText(currentMessage(), Qt::ElideRight, room.width()));
}

void StatusPanel::showWaiting(bool isWaiting)
{
    if (!isWaiting) {
        QGuiApplication::restoreOverrideCursor();
        clearMessage();
        return;
    }
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    showMessage(tr("Finding out where characters can walk…"));
    repaint();
}

void StatusPanel::showFinding()
{
    const bool isAwaited = m_state.viewOptions().showWalkable && m_state.ground().isFinding();
    if (isAwaited) {
        showMessage(tr("Finding out where characters can walk…"));
    } else if (m_saysFinding) {
        clearMessage();
    }
    m_saysFinding = isAwaited;
}

void StatusPanel::refreshCounts()
{
    const std::size_t gone = m_state.session().goneCount();
    const std::size_t all = m_state.scene().population.size();
    QStringList parts{tr("%n characters", nullptr, static_cast<int>(all - std::min(gone, all)))};
    if (const auto* take = model::findTake(m_state.scene().takes, m_state.session().take())) {
        parts.prepend(tr("as in \"%1\"").arg(QString::fromStdString(take->name)));
    }
    if (gone > 0) {
        parts << tr("%n have left", nullptr, static_cast<int>(gone));
    }
    if (m_statistics.render.individuals > 0) {
        parts << tr("%n in view", nullptr, static_cast<int>(m_statistics.render.visible));
    }
    if (!m_state.selection().isEmpty()) {
        parts << tr("%n selected", nullptr, static_cast<int>(m_state.selection().size()));
    }
    m_counts->setText(parts.join(QStringLiteral(" · ")));
}

void StatusPanel::refreshFrame()
{
    const QLocale locale;
    const QString frameMs = locale.toString(m_statistics.frameMs, 'f', 1);
    const auto rate = qRound(m_statistics.framesPerSecond);
    QStringList parts{rate > 0 ? tr("%1 ms · %2 fps").arg(frameMs).arg(rate)
                               : tr("%1 ms").arg(frameMs)};
    QStringList tips{
        tr("Time of one picture: %1 triangles in %2 draws")
            .arg(locale.toString(static_cast<qlonglong>(m_statistics.render.triangles)),
                 locale.toString(static_cast<qlonglong>(m_statistics.render.draws))),
        tr("Memory of the graphics card: %1")
            .arg(locale.formattedDataSize(m_statistics.render.cardBytes))};
    const widgets::Transport& transport = m_state.transport();
    if (transport.isPlaying() && transport.pace() < kSlowPace) {
        parts.prepend(
            tr("plays at × %1")
                .arg(locale.toString(transport.pace() * transport.state().speed, 'f', 2)));
        tips << tr("This machine cannot compute what the crowd does as fast as it is to play.");
    }
    m_frame->setText(parts.join(QStringLiteral(" · ")));
    m_frame->setToolTip(tips.join(u'\n'));
}

void StatusPanel::setStatistics(const widgets::FrameStatistics& statistics)
{
    m_statistics = statistics;
    refreshCounts();
    refreshFrame();
}

} // namespace crowd::app
