// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QProxyStyle>

namespace crowd::widgets {

/// Fusion, with check boxes and radio buttons that can be told from their ground in the dark and
/// are filled with the accent when they are on, and tabs that leave their names room in a narrow
/// panel.
class CrowdStyle : public QProxyStyle
{
    Q_OBJECT

public:
    CrowdStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option = nullptr,
                    const QWidget* widget = nullptr) const override;
};

} // namespace crowd::widgets
