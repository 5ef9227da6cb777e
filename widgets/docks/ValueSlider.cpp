// SPDX-License-Identifier: MIT
#include "widgets/docks/ValueSlider.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QLocale>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QLineEdit>

namespace crowd::widgets {

namespace {

constexpr double kCurve = 2.5;
constexpr double kFine = 0.1;
constexpr int kPadding = 8;

} // namespace

ValueSlider::ValueSlider(const QString& label, const Range& range, QWidget* parent)
    : QWidget(parent), m_label(label), m_range(range), m_value(range.low)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::SizeHorCursor);
    setAccessibleName(label);
}

void ValueSlider::setRange(const QString& label, const Range& range)
{
    m_label = label;
    m_range = range;
    setAccessibleName(label);
    update();
}

QSize ValueSlider::sizeHint() const
{
    return {180, fontMetrics().height() + 10};
}

QSize ValueSlider::minimumSizeHint() const
{
    return {90, fontMetrics().height() + 10};
}

double ValueSlider::share() const
{
    const double linear =
        std::clamp((m_value - m_range.low) / (m_range.high - m_range.low), 0.0, 1.0);
    return m_range.isCurved ? std::pow(linear, 1.0 / kCurve) : linear;
}

double ValueSlider::valueAt(double share) const
{
    const double linear = std::clamp(share, 0.0, 1.0);
    return m_range.low +
           (m_range.high - m_range.low) * (m_range.isCurved ? std::pow(linear, kCurve) : linear);
}

void ValueSlider::setValue(double value)
{
    m_value = value;
    update();
}

void ValueSlider::edit(double value)
{
    const double unit = std::pow(10.0, m_range.decimals);
    const double rounded = std::clamp(std::round(value * unit) / unit, m_range.low, m_range.high);
    if (rounded != m_value) {
        setValue(rounded);
        Q_EMIT valueEdited(rounded);
    }
}

void ValueSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid), 1.0));
    painter.setBrush(palette().base());
    painter.drawRoundedRect(frame, 3.0, 3.0);
    QColor bar = palette().color(QPalette::Highlight);
    bar.setAlphaF(isEnabled() ? 0.38F : 0.12F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(bar);
    QRectF filled = frame.adjusted(1, 1, -1, -1);
    filled.setWidth(filled.width() * share());
    painter.drawRoundedRect(filled, 2.0, 2.0);
    const auto group = isEnabled() ? QPalette::Active : QPalette::Disabled;
    painter.setPen(palette().color(group, QPalette::Text));
    const QRect inner = rect().adjusted(kPadding, 0, -kPadding, 0);
    const QString number = QLocale().toString(m_value, 'f', m_range.decimals) + m_range.suffix;
    painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, number);
    const int room = inner.width() - fontMetrics().horizontalAdvance(number) - kPadding;
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_label, Qt::ElideRight, room));
}

void ValueSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_pressAt = event->position();
    const bool isFine = event->modifiers().testFlag(Qt::ShiftModifier);
    m_pressShare = isFine ? share() : event->position().x() / width();
    edit(valueAt(m_pressShare));
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        return;
    }
    const double rate = event->modifiers().testFlag(Qt::ShiftModifier) ? kFine : 1.0;
    edit(valueAt(m_pressShare + rate * (event->position().x() - m_pressAt.x()) / width()));
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent*)
{
    type();
}

void ValueSlider::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus()) {
        event->ignore(); // the panel scrolls
        return;
    }
    edit(m_value + (event->angleDelta().y() > 0 ? m_range.step : -m_range.step));
}

void ValueSlider::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        edit(m_value - m_range.step);
        break;
    case Qt::Key_Right:
    case Qt::Key_Up:
        edit(m_value + m_range.step);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        type();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void ValueSlider::type()
{
    auto* line = new QLineEdit(QLocale().toString(m_value, 'f', m_range.decimals), this);
    line->setGeometry(rect());
    line->setAlignment(Qt::AlignRight);
    line->selectAll();
    line->show();
    line->setFocus();
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
        bool isNumber = false;
        const double typed = QLocale().toDouble(line->text(), &isNumber);
        if (isNumber) {
            edit(typed);
        }
        line->deleteLater();
    });
}

} // namespace crowd::widgets
