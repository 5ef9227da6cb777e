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
    /// Metres, and in the lowest bits the slots whose tint replaces the colour: too little to see.
    std::uint32_t radiusAndModes = 0;
};
static_assert(sizeof(AppearanceRecord) == 48);

[[nodiscard]] std::uint32_t radiusAndModes(float radius, std::uint16_t replacedSlots);

/// What the static records need of a template entry.
struct RecordTemplate
{
    std::vector<const model::Clip*> clipOfName; ///< as TemplateEntry::clipNames; never empty
    float shadowRadius = 0.0F;                  ///< at girth 1
};

/// Rows that are uploaded with one call.
struct RowRange
{
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// The part of each individual that only editing changes, kept from frame to frame. Blocks of
/// Population::kBlockRows rows whose stamps differ from those of the last frame are computed; of
/// them, the rows whose records came out different are listed for upload. No GL.
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
    /// Brings the records up to date and lists the rows that changed.
    void update(const Request& request);

    /// Ascending, apart from each other. Up to kJoinedGap unchanged rows between changed ones are
    /// taken along: a call costs more than they do.
    [[nodiscard]] std::span<const RowRange> changedPlacements() const { return m_newPlacements; }
    [[nodiscard]] std::span<const RowRange> changedAppearances() const { return m_newAppearances; }
    static constexpr std::size_t kJoinedGap = 4;
    [[nodiscard]] std::span<const PlacementRecord> placements() const { return m_placements; }
    [[nodiscard]] std::span<const AppearanceRecord> appearances() const { return m_appearances; }
    /// Whether anybody's tint replaces a colour.
    [[nodiscard]] bool replacesColours() const { return m_replacesColours; }
    /// Metres each row is lifted.
    [[nodiscard]] std::span<const float> lifts() const { return m_lifts; }

private:
    void compute(const Request& request, std::size_t block);
    void store(std::size_t row, const PlacementRecord& placement, const AppearanceRecord& look);
    void listChanges(std::size_t rows);

    std::vector<std::uint64_t> m_blockVersions;
    std::vector<std::uint8_t> m_blockReplaces; ///< per block, whether a tint there replaces
    bool m_replacesColours = false;
    std::size_t m_knownRows = 0; ///< at the front: what was listed before
    std::uint64_t m_seatsVersion = 0;
    std::uint64_t m_templatesVersion = 0;
    std::vector<std::uint32_t> m_changedBlocks;
    std::vector<std::uint8_t> m_changes; ///< per row of changed blocks, what is new of it
    std::vector<RowRange> m_newPlacements;
    std::vector<RowRange> m_newAppearances;
    std::vector<std::int32_t> m_entryOfId;
    std::vector<PlacementRecord> m_placements;
    std::vector<AppearanceRecord> m_appearances;
    std::vector<float> m_lifts;
};

} // namespace crowd::render
