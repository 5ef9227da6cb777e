// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

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
        /// What can be typed, where that is more than the bar has.
        double least = 0.0;
        double most = 0.0;
    };

    ValueSlider(const QString& label, const Range& range, QWidget* parent);

    [[nodiscard]] double value() const { return m_value; }
    void setValue(double value); ///< without signal
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void valueEdited(double value);
    void held(bool isHeld); ///< the mouse drags it, and no longer

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QString number() const;
    [[nodiscard]] double share() const;
    [[nodiscard]] double valueAt(double share) const;
    void edit(double value);
    void editBeyond(double value);
    void type();

    QString m_label;
    Range m_range;
    double m_value = 0.0;
    QPointF m_pressAt;
    double m_pressValue = 0.0;
    double m_pressShare = 0.0;
};

/// The bar that sliders are drawn as: filled between two shares (0..1) of its width.
void drawValueBar(const QWidget& slider, double from, double to, const QString& label,
                  const QString& number);

/// A field over the whole slider to type into, until Return or until the focus goes elsewhere;
/// `typed` gets the text. No second one while there is one.
void typeOverBar(QWidget& slider, const QString& text,
                 const std::function<void(const QString&)>& typed);
/// Closes that field without taking what was typed; false: there is none.
bool dismissTyping(QWidget& slider);
/// In the language of the user or, with a point or comma before decimals, of everybody.
[[nodiscard]] std::optional<double> typedNumber(const QString& text);
/// Says that what was typed is no number.
void refuseTyped(QWidget& slider, const QString& text);

/// How values lie on a bar.
[[nodiscard]] double barShareOf(const ValueSlider::Range& range, double value);
[[nodiscard]] double barValueAt(const ValueSlider::Range& range, double share);
/// Rounded to what is shown and kept inside the range.
[[nodiscard]] double barValue(const ValueSlider::Range& range, double value);

} // namespace crowd::widgets
