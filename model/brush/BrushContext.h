// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "model/bake/KeyframeStore.h"
#include "model/base/KeepGoing.h"
#include "model/brush/BrushSettings.h"
#include "model/pick/StageRays.h"
#include "model/pick/WalkableGround.h"
#include "model/scene/CrowdFrame.h"
#include "model/view/View.h"

namespace crowd::model {

class ScriptChange;

/// What a stroke looks through: the view it is painted in, and what answers questions about it.
/// The referenced objects outlive the stroke; the stage is up to date with the scene.
struct BrushContext
{
    View view;
    KeyframeStore& keyframes;
    const StageRays& stage;
    /// Puts people where a running session has them; empty: they are where the scene says.
    std::function<void(CrowdFrame&)> pose{};
    /// Tells a running session; empty: there is none. Ids ascend.
    std::function<void(const EventSettings&, std::span<const IndividualId>)> sendEvent{};
    /// Lets people do a part of the take that is shown again; empty: none is shown. False: another
    /// take is being made still. Ids ascend.
    std::function<bool(const RetakeSettings&, std::span<const IndividualId>)> retake{};
    /// Where people can walk; asked only by brushes that create there alone. Empty: anywhere.
    WalkableGroundSource ground{};
    ScriptChange* script = nullptr; ///< what brushes of kind Script do; for those alone
    /// Asked between dabs, with the share of those of one move. What is done after it said no is of
    /// no account: the stroke is to be cancelled.
    KeepGoing keepGoing{};

    [[nodiscard]] bool goesOn(std::size_t done, std::size_t all) const
    {
        return !keepGoing || keepGoing(static_cast<double>(done) / static_cast<double>(all));
    }
};

} // namespace crowd::model
