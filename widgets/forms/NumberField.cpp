// SPDX-License-Identifier: MIT
#include "widgets/forms/NumberField.h"

#include <algorithm>

#include "widgets/forms/ValueSlider.h"

#include <QtCore/QLocale>

namespace crowd::widgets {

NumberField::NumberField(double low, double high, int decimals, QWidget* parent)
    : QLineEdit(parent), m_low(low), m_high(high), m_decimals(decimals)
{
    setPlaceholderText(tr("mixed"));
    setMinimumWidth(44);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::finish);
}

void NumberField::setValue(std::optional<double> value)
{
    m_value = value;
    if (!hasFocus() || !isModified()) {
        const bool isZero = value && *value == 0.0 && !m_zeroText.isEmpty();
        setPlaceholderText(isZero ? m_zeroText : tr("mixed"));
        setText(value && !isZero ? QLocale().toString(*value, 'f', m_decimals) : QString());
    }
}

void NumberField::setZeroText(const QString& text)
{
    m_zeroText = text;
    setValue(m_value);
}

void NumberField::finish()
{
    if (!isModified()) {
        return;
    }
    setModified(false);
    const std::optional<double> number = typedNumber(text());
    if (!number) {
        refuseTyped(*this, text());
        setValue(m_value);
        return;
    }
    const double typed = std::clamp(*number, m_low, m_high);
    setValue(typed);
    Q_EMIT valueEdited(typed);
}

} // namespace crowd::widgets
