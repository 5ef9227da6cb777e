// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QColor>
#include <QtGui/QImage>
#include <QtWidgets/QWidget>

namespace crowd::widgets {

/// Saturation and value in a square, hue in a bar beside it.
class ColourSquare : public QWidget
{
    Q_OBJECT

public:
    explicit ColourSquare(QWidget* parent);

    void setColor(const QColor& color); ///< without signal
    [[nodiscard]] QColor color() const;
    [[nodiscard]] QSize sizeHint() const override { return {220, 104}; }

Q_SIGNALS:
    void colorPicked(const QColor& color);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] QRect squareRect() const;
    [[nodiscard]] QRect hueRect() const;
    void pick(const QPoint& point);

    double m_hue = 0.0;
    double m_saturation = 0.0;
    double m_value = 0.0;
    bool m_isOnHue = false;
};

} // namespace crowd::widgets
