// SPDX-License-Identifier: MIT
#include "widgets/forms/NumberBox.h"

namespace crowd::widgets {

QValidator::State NumberBox::validate(QString& text, int& position) const
{
    const QChar point = locale().decimalPoint().front();
    for (qsizetype i = 1; i < text.size(); ++i) {
        const bool isPoint = text[i] == QLatin1Char('.') || text[i] == QLatin1Char(',');
        if (isPoint && text[i - 1].isDigit()) {
            text[i] = point;
        }
    }
    return QDoubleSpinBox::validate(text, position);
}

} // namespace crowd::widgets
