// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/scene/CrowdFrame.h"
#include "render/RenderInput.h"

namespace crowd::render {

/// Where an individual stands: two RGBA32F texels.
struct PlacementRecord
{
    glm::vec3 position{0.0F}; ///< metres, lifted onto the seat
    float cosHeading = 1.0F;
    float sinHeading = 0.0F;
    float height = 1.0F;
    float girth = 1.0F;
    float lift = 0.0F;
};
static_assert(sizeof(PlacementRecord) == 32);

/// How it looks: three RGBA32UI texels.
struct AppearanceRecord
{
    std::array<model::Tint, 8> tints{};
    model::MaterialChoices choices{};
    std::uint32_t parts = 0;
    float shadowRadius = 0.0F; ///< metres
};
static_assert(sizeof(AppearanceRecord) == 48);

/// What the static records need of a template entry.
struct RecordTemplate
{
    std::vector<const model::Clip*> clipOfName; ///< as TemplateEntry::clipNames; never empty
    float shadowRadius = 0.0F;                  ///< at girth 1
};

/// The part of each individual that only editing changes, kept from frame to frame; tells which
/// blocks of Population::kBlockRows rows differ from those of the last frame, so that only they are
/// computed and uploaded. No GL.
class StaticRecords
{
public:
    struct Request
    {
        const model::CrowdFrame& frame;
        std::span<const RecordTemplate> templates; ///< one per frame template entry
        std::span<const model::WorldSeat> seats;   ///< ascending by id
        std::uint64_t seatsVersion = 0;
        std::uint64_t templatesVersion = 0; ///< changes with `templates`
    };
    /// Brings the records up to date and lists the blocks that changed.
    void update(const Request& request);
    /// The next update() lists every block.
    void forget();

    [[nodiscard]] std::span<const std::uint32_t> changedBlocks() const { return m_changed; }
    [[nodiscard]] std::span<const PlacementRecord> placements() const { return m_placements; }
    [[nodiscard]] std::span<const AppearanceRecord> appearances() const { return m_appearances; }
    /// Metres each row is lifted.
    [[nodiscard]] std::span<const float> lifts() const { return m_lifts; }

private:
    void compute(const Request& request, std::size_t block);

    std::vector<std::uint64_t> m_blockVersions;
    std::uint64_t m_seatsVersion = 0;
    std::uint64_t m_templatesVersion = 0;
    std::vector<std::uint32_t> m_changed;
    std::vector<std::int32_t> m_entryOfId;
    std::vector<PlacementRecord> m_placements;
    std::vector<AppearanceRecord> m_appearances;
    std::vector<float> m_lifts;
};

} // namespace crowd::render
