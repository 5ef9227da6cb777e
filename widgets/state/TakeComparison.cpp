// SPDX-License-Identifier: MIT
#include "widgets/state/TakeComparison.h"

#include <algorithm>
#include <vector>

#include "behavior/takes/EditedTake.h"
#include "widgets/state/TakeShelf.h"

namespace crowd::widgets {

namespace {

constexpr std::size_t kMostMoments = 400;

model::CrowdFrame seenAt(behavior::EditedTake& take, const model::CrowdFrame& frame, double seconds)
{
    model::CrowdFrame seen = frame;
    seen.seconds = seconds;
    const auto [before, after] = take.around(seconds);
    if (before) {
        behavior::applyPose(*before, *after, seen);
    }
    return seen;
}

} // namespace

model::Result<TakeComparison> compareTakes(const model::Take& shown, const model::Take& other,
                                           const model::Scene& scene,
                                           const model::CrowdFrame& frame,
                                           const std::function<bool(double share)>& goesOn)
{
    auto one = behavior::EditedTake::open(shown, scene);
    auto two = behavior::EditedTake::open(other, scene);
    if (!one || !two) {
        return one ? two.error() : one.error();
    }
    const double begin = std::max(shown.begin, other.begin);
    const double end = std::min(shown.end, other.end);
    if (end <= begin) {
        return model::Error{QT_TRANSLATE_NOOP("Messages",
                                              "The takes \"%1\" and \"%2\" have no time "
                                              "in common."),
                            shown.name, other.name};
    }
    const auto steps = static_cast<std::size_t>((end - begin) * scene.stepsPerSecond) + 1;
    const std::size_t moments = std::min(steps, kMostMoments);
    TakeComparison comparison;
    comparison.people = frame.population.size();
    std::vector<char> isElsewhere(comparison.people, 0);
    for (std::size_t i = 0; i <= moments; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(moments);
        const double seconds = begin + (end - begin) * share;
        const TakeDifference found = differenceOf(seenAt(*one.value(), frame, seconds),
                                                  seenAt(*two.value(), frame, seconds));
        if (comparison.elsewhere == 0 && !found.rows.empty()) {
            comparison.apartFrom = seconds;
        }
        comparison.missing = std::max(comparison.missing, found.absent.size() + found.extra);
        for (const std::size_t row : found.rows) {
            comparison.elsewhere += isElsewhere[row] == 0 ? 1U : 0U;
            isElsewhere[row] = 1;
        }
        if (found.most > comparison.most) {
            comparison.most = found.most;
            comparison.mostAt = seconds;
        }
        if (!goesOn(share)) {
            break;
        }
    }
    return comparison;
}

} // namespace crowd::widgets
