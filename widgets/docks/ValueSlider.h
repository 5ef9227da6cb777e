// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

class QLineEdit;

namespace crowd::widgets {

/// A number as a bar with its name and value written in it: drag to change, Shift drags finely, the
/// wheel steps, a double click or Return types.
class ValueSlider : public QWidget
{
    Q_OBJECT

public:
    struct Range
    {
        double low = 0.0;
        double high = 1.0;
        double step = 0.01;
        int decimals = 2;
        QString suffix;
        bool isCurved = false; ///< small values get more of the bar
    };

    ValueSlider(const QString& label, const Range& range, QWidget* parent);

    [[nodiscard]] double value() const { return m_value; }
    void setValue(double value); ///< without signal
    void setRange(const QString& label, const Range& range);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void valueEdited(double value);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] double share() const;
    [[nodiscard]] double valueAt(double share) const;
    void edit(double value);
    void type();

    QString m_label;
    Range m_range;
    double m_value = 0.0;
    QPointF m_pressAt;
    double m_pressShare = 0.0;
};

} // namespace crowd::widgets
