// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QtCore/QRectF>

namespace crowd::widgets {

/// A label that wants to stand above a point of the picture; in logical pixels.
struct LabelWish
{
    QPointF at;
    QSizeF size;
    bool isImportant = false; ///< goes first and is never left out
};

/// Where labels go so that none covers another: above their points, else stacked further up, else
/// below; none where there is no room or whose point lies out of sight. Kept between the sides of
/// `area` and clear of `taken`. One entry a wish.
[[nodiscard]] std::vector<std::optional<QRectF>>
layOutLabels(std::span<const LabelWish> wishes, const QRectF& area, std::vector<QRectF> taken = {});

} // namespace crowd::widgets
