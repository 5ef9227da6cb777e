// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "model/brush/CreationSite.h"
#include "model/brush/StrokeEffect.h"

namespace crowd::model {

/// Where the dab of a creation brush puts people.
[[nodiscard]] std::vector<Spot> spotsOfDab(CreationSite& site, const BrushSettings& settings,
                                           std::uint64_t seed, const Dab& dab);

/// Creates people.
class CreationEffect : public StrokeEffect
{
public:
    explicit CreationEffect(StrokeContext& ground);
    void apply(std::span<const StrokeDab> dabs) override;
    void reevaluate(const StrokeLine& line, double shownSeconds) override;
    [[nodiscard]] int affected() const override { return m_created; }
    [[nodiscard]] StrokeReason reason() const override { return m_reason; }

private:
    void create(std::span<const Spot> spots, std::optional<float> strokeHeading);
    [[nodiscard]] bool isOfTheClick(const Dab& dab);

    StrokeContext& m_ground;
    CreationSite m_site;
    std::optional<glm::dvec2> m_press; ///< of a stroke of points
    int m_created = 0;
    StrokeReason m_reason = StrokeReason::None;
};

} // namespace crowd::model
