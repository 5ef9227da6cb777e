// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtGui/QCursor>
#include <QtGui/QPixmap>

#include "widgets/tools/ToolPicture.h"

class QPainter;

namespace crowd::widgets {

/// A line's dark border and the line itself, so that it is seen on any ground.
inline constexpr QRgb kOverlayDark = 0xAA000000U;
inline constexpr QRgb kOverlayLight = 0xEBFFFFFFU;

/// The area of a brush: its circle, or the cross of one that takes a point.
void paintBrushArea(QPainter& painter, const ToolPicture& picture);
/// The brush's symbol on a plate beside the cursor, on the side where `area` has room.
void paintBrushSymbol(QPainter& painter, const ToolPicture& picture, const QPixmap& symbol,
                      const QRectF& area);
[[nodiscard]] QPixmap brushSymbol(ToolId tool, double devicePixelRatio);

/// The brush as a cursor of the window system, which moves with the hand however slow the pictures
/// are. Made anew only when the brush changed.
class BrushCursor
{
public:
    /// Nothing where there is no brush, or one too large for a cursor.
    [[nodiscard]] std::optional<QCursor> cursorFor(const ToolPicture& picture,
                                                   double devicePixelRatio);

    static constexpr double kLargestRadius = 300.0; ///< logical pixels; 1.5 MB once a size

private:
    double m_radius = -1.0;
    double m_ratio = 0.0;
    std::optional<ToolId> m_tool;
    QCursor m_cursor;
};

} // namespace crowd::widgets
