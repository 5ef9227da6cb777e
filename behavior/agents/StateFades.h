// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/scene/CrowdFrame.h"
#include "model/states/ChangeOver.h"

namespace crowd::behavior {

/// When people begin to change over, seconds of the transport, and how long each takes.
struct FadeTimes
{
    std::vector<model::IndividualId> ids; ///< ascending
    std::vector<double> begins;           ///< one each
    std::vector<std::uint8_t> areWhole;   ///< one each: of another template, nothing lies between
    double seconds = 0.0;
    double end = 0.0; ///< all of them have arrived

    /// 0..1 of what somebody is becoming.
    [[nodiscard]] float shareAt(std::size_t person, double now) const
    {
        const double since = now - begins[person];
        if (since <= 0.0 || since >= seconds) {
            return since < 0.0 ? 0.0F : since >= seconds ? 1.0F : 0.0F;
        }
        const auto share = static_cast<float>(since / seconds);
        return areWhole[person] == 0 ? share : share < 0.5F ? 0.0F : 1.0F;
    }
};

/// What people come from, in one column. Clip, phase and playback speed go together, with the clip.
struct FadeColumn
{
    model::ColumnId column = model::ColumnId::Clip;
    std::shared_ptr<const FadeTimes> times;
    std::vector<std::byte> bytes; ///< one value each
    std::vector<float> phases;    ///< of clips: one each, as the columns count
    std::vector<float> rates;
};

using FadeColumns = std::vector<std::shared_ptr<const FadeColumn>>;

/// People who change over from how they were seen to how they are: what they are is elsewhere, only
/// what they come from is here. One thread; what is published may be read on any.
class StateFades
{
public:
    /// From `before` to `after`, as people are seen at this time of the transport, the same ones.
    /// What was seen of earlier changes over is part of `before`; they have been forgotten.
    /// `delays`: of change.ids, see model::delaysOf().
    void begin(const model::ChangeOver& change, std::span<const float> delays,
               const model::Population& before, const model::Population& after, double seconds);
    /// These people are seen as they are, in these columns: another change over begins.
    void forget(const model::ChangeOver& change);
    /// Whoever has another value now than before an edit is seen with it.
    void forgetEdited(const model::Population& before, const model::Population& now);
    /// Those that are over by then are forgotten.
    void end(double seconds);
    /// Null: nobody changes over.
    [[nodiscard]] const std::shared_ptr<const FadeColumns>& shown() const { return m_shown; }

private:
    void add(FadeColumn column);

    std::shared_ptr<const FadeColumns> m_shown;
};

/// Puts people between the two in a frame at frame.seconds. `isBusy`: those rows of the frame whose
/// clip comes from something else that they do.
void applyFades(const FadeColumns& fades, const std::vector<bool>& isBusy,
                model::CrowdFrame& frame);

} // namespace crowd::behavior
