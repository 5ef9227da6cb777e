// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/brush/BrushSettings.h"
#include "model/brush/Operator.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneEdit.h"

/// The third step of a brush: writing values of the selected individuals through the open edit.
namespace crowd::model {

/// What a change may depend on besides the individual.
struct ChangeTools;
class StageRays;

struct ChangeRequest
{
    using Tools = ChangeTools; ///< what changes are made of: see ColumnWriting.h
    SceneEdit& edit;
    const BrushSettings& settings;
    const View& view;
    std::uint64_t seed = 0; ///< of the stroke; with the dab mixed in where dabs build up
    StrokeLine line;        ///< press to current: gradients
    std::optional<float> strokeHeading;
    std::span<const IndividualId> ids; ///< ascending, all present
    const Population* shown = nullptr; ///< where they are seen; null: where the scene says
    const StageRays* stage = nullptr;  ///< what people stand on; null: nothing is known of it
};

struct ChangeResult
{
    std::vector<IndividualId> changed; ///< ascending: those with a value that is another one now
    StrokeReason reason = StrokeReason::None; ///< why nobody changed
};

/// The third step of a brush that a script brings along. It may do its work later, as long as it is
/// done before the stroke finishes; then it says that all of them changed.
class ScriptChange
{
public:
    virtual ~ScriptChange() = default;
    [[nodiscard]] virtual ChangeResult change(const ChangeRequest& request) = 0;
};

/// Of the settings' kind: colour, orientation, animation, walk, tag or untag.
[[nodiscard]] ChangeResult changeProperties(const ChangeRequest& request);

} // namespace crowd::model
