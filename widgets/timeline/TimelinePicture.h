// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include <QtGui/QPalette>

#include "behavior/rules/FiringLog.h"
#include "model/scene/Scene.h"
#include "widgets/commands/TimelineCommands.h"
#include "widgets/timeline/TimelineLanes.h"
#include "widgets/timeline/TimelineScale.h"

class QPainter;

namespace crowd::widgets {

/// What a timeline shows at one moment. Refers to what it is given; seconds of the clock.
struct TimelineShown
{
    const model::Scene& scene;
    const TimelineScale& scale;
    const model::Timeline& ordered; ///< its marks, in the order in which they happen
    const MarkIds& chosen;
    const MarkIds& flawed;                               ///< that do not do what they say
    std::function<double(const model::Mark&)> secondsOf; ///< also while one is dragged
    model::PlayRange range;
    double playedFrom = 0.0;
    double playedTo = 0.0;
    double now = 0.0;
    bool isAnybodySelected = false;
    std::span<const behavior::RuleFired> fired{}; ///< for the selected, ascending
    TimelineLayout layout;
    QPalette palette;
};

/// Half of the width and height of a mark, logical pixels.
inline constexpr int kMarkHalf = 6;

/// In which what a rule did is shown.
[[nodiscard]] QColor colorOfRule(model::RuleId rule);

void drawTimeline(QPainter& painter, const TimelineShown& shown);

} // namespace crowd::widgets
