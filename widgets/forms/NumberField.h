// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtWidgets/QLineEdit>

namespace crowd::widgets {

/// A number that several individuals may not share: then it shows "mixed" until one is typed.
class NumberField : public QLineEdit
{
    Q_OBJECT

public:
    NumberField(double low, double high, int decimals, QWidget* parent);

    void setValue(std::optional<double> value); ///< none: mixed; without signal
    void setZeroText(const QString& text);      ///< stands there instead of 0

Q_SIGNALS:
    void valueEdited(double value);

private:
    void finish();

    double m_low;
    double m_high;
    int m_decimals;
    std::optional<double> m_value;
    QString m_zeroText;
};

} // namespace crowd::widgets
