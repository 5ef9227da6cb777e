// SPDX-License-Identifier: MIT
#include "widgets/forms/RangeSlider.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QLocale>
#include <QtCore/QRegularExpression>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>

namespace crowd::widgets {

namespace {

constexpr double kGripPixels = 14.0; ///< so near to an end the end is meant

} // namespace

RangeSlider::RangeSlider(const QString& label, const ValueSlider::Range& range, QWidget* parent)
    : QWidget(parent), m_label(label), m_range(range)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::SizeHorCursor);
    setAccessibleName(label);
}

void RangeSlider::setValue(const model::ValueRange& value)
{
    m_value = value;
    update();
}

QSize RangeSlider::sizeHint() const
{
    return {180, fontMetrics().height() + 10};
}

QSize RangeSlider::minimumSizeHint() const
{
    return {90, fontMetrics().height() + 10};
}

double RangeSlider::shareOf(float value) const
{
    return barShareOf(m_range, static_cast<double>(value));
}

QString RangeSlider::numbers() const
{
    const auto text = [this](float value) {
        return QLocale().toString(static_cast<double>(value), 'f', m_range.decimals);
    };
    const QString low = text(m_value.low);
    return m_value.low == m_value.high
               ? low + m_range.suffix
               : low + QStringLiteral(" – ") + text(m_value.high) + m_range.suffix;
}

void RangeSlider::paintEvent(QPaintEvent*)
{
    // An empty range is still seen.
    const double from = std::min(shareOf(m_value.low), 1.0 - 3.0 / width());
    drawValueBar(*this, from, std::max(shareOf(m_value.high), from + 3.0 / width()), m_label,
                 numbers());
}

RangeSlider::Grip RangeSlider::gripAt(double share) const
{
    const double low = shareOf(m_value.low);
    const double high = shareOf(m_value.high);
    const double near = kGripPixels / width();
    const bool isInside = share > low + near && share < high - near;
    if (isInside) {
        return Grip::Both;
    }
    if (low == high) {
        return share < low ? Grip::Low : Grip::High;
    }
    return std::abs(share - low) < std::abs(share - high) ? Grip::Low : Grip::High;
}

void RangeSlider::edit(double low, double high)
{
    const model::ValueRange edited{static_cast<float>(barValue(m_range, low)),
                                   static_cast<float>(barValue(m_range, high))};
    if (!(edited == m_value)) {
        setValue(edited);
        Q_EMIT valueEdited(edited);
    }
}

void RangeSlider::dragTo(double share)
{
    if (m_grip == Grip::Low) {
        const double low = barValueAt(m_range, share);
        edit(low, std::max(low, static_cast<double>(m_value.high)));
    } else if (m_grip == Grip::High) {
        const double high = barValueAt(m_range, share);
        edit(std::min(high, static_cast<double>(m_value.low)), high);
    } else {
        const double width = static_cast<double>(m_pressValue.high - m_pressValue.low);
        const double way = barValueAt(m_range, share) - barValueAt(m_range, m_pressShare);
        const double low = std::clamp(static_cast<double>(m_pressValue.low) + way, m_range.low,
                                      std::max(m_range.low, m_range.high - width));
        edit(low, low + width);
    }
}

void RangeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_pressShare = event->position().x() / width();
    m_pressValue = m_value;
    m_grip = gripAt(m_pressShare);
    dragTo(m_pressShare);
}

void RangeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        dragTo(event->position().x() / width());
    }
}

void RangeSlider::mouseDoubleClickEvent(QMouseEvent*)
{
    // Its first click was meant for nothing else.
    edit(static_cast<double>(m_pressValue.low), static_cast<double>(m_pressValue.high));
    type();
}

void RangeSlider::keyPressEvent(QKeyEvent* event)
{
    const double step =
        event->key() == Qt::Key_Left || event->key() == Qt::Key_Down ? -m_range.step : m_range.step;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        edit(static_cast<double>(m_value.low) + step,
             std::max(static_cast<double>(m_value.low) + step, static_cast<double>(m_value.high)));
        break;
    case Qt::Key_Down:
    case Qt::Key_Up:
        edit(std::min(static_cast<double>(m_value.low), static_cast<double>(m_value.high) + step),
             static_cast<double>(m_value.high) + step);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        type();
        break;
    case Qt::Key_Escape:
        if (dismissTyping(*this)) {
            break;
        }
        [[fallthrough]];
    default:
        QWidget::keyPressEvent(event);
    }
}

void RangeSlider::type()
{
    const auto text = [this](float value) {
        return QLocale().toString(static_cast<double>(value), 'f', m_range.decimals);
    };
    typeOverBar(*this, text(m_value.low) + QLatin1Char(' ') + text(m_value.high),
                [this](const QString& typed) {
                    static const QRegularExpression kGap(
                        QStringLiteral("[\\s–;]+|(?<=\\d)-(?=[\\d.,])"));
                    const QStringList pieces = typed.split(kGap, Qt::SkipEmptyParts);
                    const auto low = pieces.isEmpty() ? std::nullopt : typedNumber(pieces.front());
                    const auto high = pieces.isEmpty() ? std::nullopt : typedNumber(pieces.back());
                    if (low && high) {
                        edit(std::min(*low, *high), std::max(*low, *high));
                    } else {
                        refuseTyped(*this, typed);
                    }
                });
}

} // namespace crowd::widgets
