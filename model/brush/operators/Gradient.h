// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>

#include "model/brush/operators/OperatorRequest.h"
#include "model/view/View.h"

namespace crowd::model {

/// From the lowest value at the press to the highest where the pointer is, by the place on screen.
struct GradientOperator
{
    static constexpr OperatorInfo kInfo{
        .key = "GRADIENT", .label = QT_TRANSLATE_NOOP("Fields", "Gradient"), .followsLine = true};

    [[nodiscard]] static OperatorResult evaluate(const OperatorRequest& request)
    {
        OperatorResult result;
        result.shares.reserve(request.ids.size());
        for (const glm::vec3& position : request.positions) {
            const auto foot = request.view.project(position);
            result.shares.push_back(foot ? shareOfLine(request.line, {foot->x, foot->y}) : 0.0);
        }
        return result;
    }

private:
    /// Of the way from press to current at which a point lies, 0..1; 0 for a line without length.
    [[nodiscard]] static double shareOfLine(const StrokeLine& line, glm::dvec2 point)
    {
        const glm::dvec2 way = line.to - line.from;
        const double length = glm::dot(way, way);
        return length > 0.0 ? std::clamp(glm::dot(point - line.from, way) / length, 0.0, 1.0) : 0.0;
    }
};

} // namespace crowd::model
