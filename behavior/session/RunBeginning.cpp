// SPDX-License-Identifier: MIT
#include "behavior/session/RunBeginning.h"

#include <tuple>

#include "behavior/session/MotionReader.h"

namespace crowd::behavior {

namespace {

/// Steps from the first on that are earlier than a time.
void giveSteps(const StepsAround& around, double first, double end, const StepSink& sink)
{
    auto [pose, next] = around(first);
    while (pose && pose->seconds < end) {
        const bool isLast = pose == next;
        if (!sink(pose) || isLast) {
            return;
        }
        std::tie(pose, next) = around(next->seconds);
    }
}

} // namespace

std::optional<RunBeginning> beginningIn(const StepsAround& around, double first, double seconds)
{
    const SessionPosePtr now = around(seconds).first;
    if (!now) {
        return std::nullopt;
    }
    RunBeginning beginning{now, now, {}};
    // A little earlier is the step before.
    constexpr double kLess = 1e-6;
    if (const SessionPosePtr before = around(now->seconds - kLess).first;
        before && before->seconds < now->seconds) {
        beginning.before = before;
    }
    beginning.earlier = [around, first, end = now->seconds](const StepSink& sink) {
        giveSteps(around, first, end, sink);
    };
    return beginning;
}

EarlierSteps stepsBefore(const std::shared_ptr<MotionCache>& run, double end)
{
    return [run, end](const StepSink& sink) {
        MotionReader reader(run);
        giveSteps([&reader](double at) { return reader.around(at); }, run->extent().first, end,
                  sink);
    };
}

std::optional<RunBeginning> beginningIn(const std::shared_ptr<MotionCache>& run, double seconds)
{
    const auto reader = std::make_shared<MotionReader>(run);
    return beginningIn([reader](double at) { return reader->around(at); }, run->extent().first,
                       seconds);
}

} // namespace crowd::behavior
