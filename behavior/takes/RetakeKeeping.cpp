// SPDX-License-Identifier: MIT
#include "behavior/takes/RetakeKeeping.h"

#include <utility>

#include "behavior/session/SceneMotion.h"
#include "behavior/takes/Retake.h"

namespace crowd::behavior {

namespace {

constexpr double kSimulated = 0.7; ///< of the work; the rest is writing

TakeProgress partOf(const TakeProgress& progress, double from, double length)
{
    if (!progress) {
        return {};
    }
    return [&progress, from, length](double share) { return progress(from + length * share); };
}

} // namespace

model::Result<KeptRetake> keepRetake(const model::Scene& scene, const model::Take& take,
                                     const std::shared_ptr<MotionCache>& motion,
                                     const RetakeOrder& order,
                                     const std::shared_ptr<const WalkSurface>& surface,
                                     const QString& folder, const TakeProgress& progress)
{
    const RetakeWish wish{order.people, order.begin, order.end,
                          order.isDifferent ? model::freeTakeId(scene.takes) : 0,
                          take.areEditsOn ? take.edits : std::vector<model::HandEdit>()};
    model::Message problem; // where nothing can be walked on people walk on open ground
    const auto ground = surface ? surface : surfaceOf(scene, problem);
    const auto made = retake(scene, motion, wish, ground, partOf(progress, 0.0, kSimulated));
    if (!made) {
        return made.error();
    }
    auto written =
        writeTake(*made.value().motion, folder, partOf(progress, kSimulated, 1.0 - kSimulated));
    if (!written) {
        return written.error();
    }
    KeptRetake kept{std::move(written).value(), made.value().people, made.value().furthestFromHome};
    kept.take.edits = take.edits;
    kept.take.areEditsOn = take.areEditsOn;
    return kept;
}

} // namespace crowd::behavior
