// SPDX-License-Identifier: MIT
#include "widgets/docks/TakeFigures.h"

#include <cmath>
#include <utility>

#include <QtCore/QLocale>

#include "model/base/Translated.h"

namespace crowd::widgets {

QString takeClockText(double seconds)
{
    const auto whole = static_cast<qint64>(std::floor(seconds));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

TakeFigures::TakeFigures(EditorState& state, QWidget* parent) : QLabel(parent), m_state(state)
{
    setObjectName(QStringLiteral("takeFigures"));
    setWordWrap(true);
    hide();
    connect(&m_task, &BackgroundTask::progressed, this, [this](const QString&, float share) {
        setText(tr("The whole takes are being compared: %1 %").arg(std::lround(100.0F * share)));
    });
}

/// None where there are no two to compare.
std::vector<model::Take> TakeFigures::takes() const
{
    const model::Takes& all = m_state.scene().takes;
    const model::Take* shown = model::findTake(all, m_state.session().take());
    const model::Take* ghost = model::findTake(all, m_state.takes().ghost());
    if (shown == nullptr || ghost == nullptr || shown == ghost) {
        return {};
    }
    return {*shown, *ghost};
}

void TakeFigures::refresh()
{
    std::vector<model::Take> wanted = takes();
    if (wanted == m_compared) {
        return;
    }
    m_task.cancel();
    m_compared = std::move(wanted);
    setVisible(!m_compared.empty());
    clear();
    if (!m_compared.empty()) {
        begin();
    }
}

void TakeFigures::begin()
{
    m_task.start(
        [shown = m_compared[0], other = m_compared[1], scene = m_state.scene(),
         frame = m_state.document().frame(0.0)](const TaskReport& report) {
            return compareTakes(shown, other, scene, *frame, [&report](double share) {
                return report(QString(), static_cast<float>(share));
            });
        },
        [this](const model::Result<TakeComparison>& found) {
            setText(found ? textOf(found.value()) : model::translated(found.error().said));
        });
}

QString TakeFigures::textOf(const TakeComparison& found) const
{
    const QString name = QString::fromStdString(m_compared[1].name);
    const auto count = static_cast<int>(found.missing);
    const QString missing =
        count == 0 ? QString()
                   : QLatin1Char(' ') +
                         tr("Up to %n character(s) are there in one of them only.", nullptr, count);
    if (found.elsewhere == 0) {
        return tr("In the whole take everybody is as in \"%1\".").arg(name) + missing;
    }
    return tr("In the whole take %1 of %2 are elsewhere than in \"%3\" at some time: from %4 on, "
              "%5 m at most, at %6.")
               .arg(found.elsewhere)
               .arg(found.people)
               .arg(name, takeClockText(found.apartFrom),
                    QLocale().toString(static_cast<double>(found.most), 'f', 2),
                    takeClockText(found.mostAt)) +
           missing;
}

} // namespace crowd::widgets
