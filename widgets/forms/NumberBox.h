// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDoubleSpinBox>

namespace crowd::widgets {

/// A field for a number with arrows. A point and a comma are both what the language has before
/// decimals, whichever the keyboard gives. Main thread only.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr) : QDoubleSpinBox(parent) {}

    QValidator::State validate(QString& text, int& position) const override;
};

} // namespace crowd::widgets
