// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// A distribution drawn by hand: drag over the bins; a double click makes all equal again.
class CurveEditor : public QWidget
{
    Q_OBJECT

public:
    explicit CurveEditor(QWidget* parent);

    [[nodiscard]] const model::DistributionCurve& curve() const { return m_curve; }
    void setCurve(const model::DistributionCurve& curve);
    [[nodiscard]] QSize sizeHint() const override { return {180, 48}; }

Q_SIGNALS:
    void edited();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    void drawTo(const QPointF& point);
    [[nodiscard]] int binAt(double x) const;

    model::DistributionCurve m_curve;
    int m_lastBin = 0;
    float m_lastWeight = 0.0F;
};

} // namespace crowd::widgets
