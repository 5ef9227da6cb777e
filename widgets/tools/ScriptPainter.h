// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/brush/BrushContext.h"
#include "model/brush/BrushSettings.h"
#include "model/brush/PointerInput.h"

namespace crowd::widgets {

/// Paints with brushes that scripts bring along: whoever runs scripts provides it. One stroke at a
/// time. What takes long goes on after the release; the status bar says how it ended. Main thread.
class ScriptPainter
{
public:
    virtual ~ScriptPainter() = default;

    /// False: not now; the status bar says why.
    [[nodiscard]] virtual bool begin(const model::BrushContext& context,
                                     const model::BrushSettings& settings, std::uint64_t seed,
                                     const model::PointerInput& press) = 0;
    virtual void move(const model::PointerInput& input) = 0;
    /// The pointer passed here on its way, as of model::Stroke.
    virtual void pass(const model::PointerInput& input) = 0;
    virtual void release() = 0;
    /// Takes everything back, also after the release.
    virtual void cancel() = 0;
    /// Between begin and the end of all work.
    [[nodiscard]] virtual bool isPainting() const = 0;
    /// Individuals under the stroke so far.
    [[nodiscard]] virtual int affected() const = 0;
};

} // namespace crowd::widgets
