// SPDX-License-Identifier: MIT
#include "widgets/viewport/LabelLayout.h"

#include <algorithm>
#include <array>

namespace crowd::widgets {

namespace {

constexpr double kAbove = 22.0; ///< from the point to the label's middle
constexpr double kGap = 2.0;
constexpr double kSideMargin = 4.0;
constexpr double kBeyond = 40.0; ///< how far outside of the picture a point still has a label
constexpr std::array kStackSteps{0, 1, 2, 3, 4, -1, -2}; ///< up; past the point downwards

QRectF plateAt(const LabelWish& wish, int step, const QRectF& area)
{
    const double height = wish.size.height() + kGap;
    const double up = step >= 0 ? kAbove + step * height : -kAbove + (step + 1) * height;
    QRectF plate(QPointF(), wish.size);
    plate.moveCenter(wish.at - QPointF(0.0, up));
    const double left = area.left() + kSideMargin;
    plate.moveLeft(
        std::clamp(plate.left(), left, std::max(left, area.right() - plate.width() - kSideMargin)));
    return plate;
}

} // namespace

std::vector<std::optional<QRectF>> layOutLabels(std::span<const LabelWish> wishes,
                                                const QRectF& area, std::vector<QRectF> taken)
{
    std::vector<std::optional<QRectF>> plates(wishes.size());
    const QRectF seen = area.adjusted(-kBeyond, -kBeyond, kBeyond, kBeyond);
    const auto isFree = [&taken](const QRectF& plate) {
        return std::ranges::none_of(
            taken, [&plate](const QRectF& other) { return other.intersects(plate); });
    };
    for (const bool isTurnOfImportant : {true, false}) {
        for (std::size_t i = 0; i < wishes.size(); ++i) {
            if (wishes[i].isImportant != isTurnOfImportant || !seen.contains(wishes[i].at)) {
                continue;
            }
            for (const int step : kStackSteps) {
                const QRectF plate = plateAt(wishes[i], step, area);
                if (isFree(plate)) {
                    plates[i] = plate;
                    break;
                }
            }
            if (!plates[i] && isTurnOfImportant) {
                plates[i] = plateAt(wishes[i], 0, area);
            }
            if (plates[i]) {
                taken.push_back(*plates[i]);
            }
        }
    }
    return plates;
}

} // namespace crowd::widgets
