// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QProxyStyle>

#include "widgets/theme/FieldWheel.h"

namespace crowd::widgets {

/// Fusion, with check boxes and radio buttons that can be told from their ground in the dark and
/// are filled with the accent when they are on, tabs that leave their names room in a narrow panel,
/// and fields that the mouse wheel does not change in passing.
class CrowdStyle : public QProxyStyle
{
    Q_OBJECT

public:
    CrowdStyle();

    using QProxyStyle::polish;
    using QProxyStyle::unpolish;
    void polish(QWidget* widget) override;
    void unpolish(QWidget* widget) override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option = nullptr,
                    const QWidget* widget = nullptr) const override;

private:
    FieldWheel m_wheel;
};

} // namespace crowd::widgets
