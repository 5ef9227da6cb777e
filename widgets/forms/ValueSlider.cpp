// SPDX-License-Identifier: MIT
#include "widgets/forms/ValueSlider.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QLocale>
#include <QtCore/QRegularExpression>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolTip>

namespace crowd::widgets {

namespace {

constexpr double kCurve = 2.5;
constexpr double kFine = 0.1;
constexpr int kPadding = 8;

} // namespace

double barShareOf(const ValueSlider::Range& range, double value)
{
    const double linear = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
    return range.isCurved ? std::pow(linear, 1.0 / kCurve) : linear;
}

double barValueAt(const ValueSlider::Range& range, double share)
{
    const double linear = std::clamp(share, 0.0, 1.0);
    return range.low +
           (range.high - range.low) * (range.isCurved ? std::pow(linear, kCurve) : linear);
}

double barValue(const ValueSlider::Range& range, double value)
{
    const double unit = std::pow(10.0, range.decimals);
    return std::clamp(std::round(value * unit) / unit, range.low, range.high);
}

void drawValueBar(const QWidget& slider, double from, double to, const QString& label,
                  const QString& number)
{
    QPainter painter(const_cast<QWidget*>(&slider));
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& palette = slider.palette();
    const QRectF frame = QRectF(slider.rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(
        QPen(palette.color(slider.hasFocus() ? QPalette::Highlight : QPalette::Mid), 1.0));
    painter.setBrush(palette.base());
    painter.drawRoundedRect(frame, 3.0, 3.0);
    QColor bar = palette.color(QPalette::Highlight);
    bar.setAlphaF(slider.isEnabled() ? 0.38F : 0.12F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(bar);
    QRectF filled = frame.adjusted(1, 1, -1, -1);
    const double width = filled.width();
    filled.setRight(filled.left() + width * to);
    filled.setLeft(filled.left() + width * from);
    painter.drawRoundedRect(filled, 2.0, 2.0);
    const auto group = slider.isEnabled() ? QPalette::Active : QPalette::Disabled;
    painter.setPen(palette.color(group, QPalette::Text));
    const QRect inner = slider.rect().adjusted(kPadding, 0, -kPadding, 0);
    painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, number);
    const QFontMetrics metrics = slider.fontMetrics();
    const int room = inner.width() - metrics.horizontalAdvance(number) - kPadding;
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(label, Qt::ElideRight, room));
}

void typeOverBar(QWidget& slider, const QString& text,
                 const std::function<void(const QString&)>& typed)
{
    if (slider.findChild<QLineEdit*>() != nullptr) {
        return; // the Return that ends typing comes on to the slider
    }
    auto* line = new QLineEdit(text, &slider);
    line->setGeometry(slider.rect());
    line->setAlignment(Qt::AlignRight);
    line->selectAll();
    line->show();
    line->setFocus();
    QObject::connect(line, &QLineEdit::editingFinished, &slider, [line, typed] {
        line->blockSignals(true); // losing the focus finishes once more
        typed(line->text());
        line->deleteLater();
    });
}

bool dismissTyping(QWidget& slider)
{
    auto* line = slider.findChild<QLineEdit*>();
    if (line == nullptr) {
        return false;
    }
    line->blockSignals(true);
    line->deleteLater();
    slider.setFocus();
    return true;
}

std::optional<double> typedNumber(const QString& text)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::RejectGroupSeparator); // "1.500" is one and a half
    bool isNumber = false;
    double number = locale.toDouble(text.trimmed(), &isNumber);
    if (!isNumber) { // a point and a comma are understood everywhere, but not "1,000" as one
        static const QRegularExpression kComma(QStringLiteral("(?<=\\d),(?!\\d{3}$)"));
        number = text.trimmed().replace(kComma, QStringLiteral(".")).toDouble(&isNumber);
    }
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

void refuseTyped(QWidget& slider, const QString& text)
{
    if (!text.trimmed().isEmpty()) {
        QToolTip::showText(
            slider.mapToGlobal(QPoint(0, slider.height())),
            ValueSlider::tr("“%1” is no number: the value stays as it was.").arg(text), &slider);
    }
}

ValueSlider::ValueSlider(const QString& label, const Range& range, QWidget* parent)
    : QWidget(parent), m_label(label), m_range(range), m_value(range.low)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::SizeHorCursor);
    setAccessibleName(label);
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
    return barShareOf(m_range, m_value);
}

double ValueSlider::valueAt(double share) const
{
    return barValueAt(m_range, share);
}

QString ValueSlider::number() const
{
    const double smallest = 0.5 * std::pow(10.0, -m_range.decimals);
    const double value = std::abs(m_value) < smallest ? 0.0 : m_value; // no "-0.0"
    return QLocale().toString(value, 'f', m_range.decimals) + m_range.suffix;
}

void ValueSlider::setValue(double value)
{
    m_value = value;
    update();
}

void ValueSlider::edit(double value)
{
    const double rounded = barValue(m_range, value);
    if (rounded != m_value) {
        setValue(rounded);
        Q_EMIT valueEdited(rounded);
    }
}

/// As typed: also where the bar does not reach.
void ValueSlider::editBeyond(double value)
{
    Range typed = m_range;
    typed.low = std::min(m_range.low, m_range.least);
    typed.high = std::max(m_range.high, m_range.most);
    const double rounded = barValue(typed, value);
    if (rounded != m_value) {
        setValue(rounded);
        Q_EMIT valueEdited(rounded);
    }
}

void ValueSlider::paintEvent(QPaintEvent*)
{
    drawValueBar(*this, 0.0, share(), m_label, number());
}

void ValueSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_pressAt = event->position();
    m_pressValue = m_value;
    const bool isFine = event->modifiers().testFlag(Qt::ShiftModifier);
    m_pressShare = isFine ? share() : event->position().x() / width();
    Q_EMIT held(true);
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

void ValueSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        Q_EMIT held(false);
    }
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent*)
{
    edit(m_pressValue); // its first click was meant for nothing else
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
    case Qt::Key_Escape:
        if (dismissTyping(*this)) {
            break;
        }
        [[fallthrough]];
    default:
        QWidget::keyPressEvent(event);
    }
}

void ValueSlider::type()
{
    typeOverBar(*this, QLocale().toString(m_value, 'f', m_range.decimals),
                [this](const QString& text) {
                    if (const auto number = typedNumber(text)) {
                        editBeyond(*number);
                    } else {
                        refuseTyped(*this, text);
                    }
                });
}

} // namespace crowd::widgets
