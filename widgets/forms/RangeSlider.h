// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"
#include "widgets/forms/ValueSlider.h"

namespace crowd::widgets {

/// Two numbers that belong together, as one bar filled from the low to the high one: drag either
/// end, drag the middle to move both, double click or Return to type them ("0.9 1.1").
class RangeSlider : public QWidget
{
    Q_OBJECT

public:
    RangeSlider(const QString& label, const ValueSlider::Range& range, QWidget* parent);

    [[nodiscard]] const model::ValueRange& value() const { return m_value; }
    void setValue(const model::ValueRange& value); ///< without signal
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void valueEdited(const crowd::model::ValueRange& value);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Grip { Low, High, Both };
    [[nodiscard]] double shareOf(float value) const;
    [[nodiscard]] QString numbers() const;
    [[nodiscard]] Grip gripAt(double share) const;
    void dragTo(double share);
    void edit(double low, double high);
    void type();

    QString m_label;
    ValueSlider::Range m_range;
    model::ValueRange m_value;
    Grip m_grip = Grip::High;
    double m_pressShare = 0.0;
    model::ValueRange m_pressValue;
};

} // namespace crowd::widgets
