// SPDX-License-Identifier: MIT
#include "render/crowd/StaticRecords.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/base/Parallel.h"
#include "render/crowd/HeldColumns.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr std::size_t kBlocksPerChunk = 8;
constexpr std::uint8_t kNewPlacement = 1;
constexpr std::uint8_t kNewAppearance = 2;

float seatHeight(std::span<const WorldSeat> seats, SeatId id)
{
    const auto found = std::ranges::lower_bound(seats, id, {}, &WorldSeat::id);
    return found != seats.end() && found->id == id ? found->seat.height : 0.0F;
}

template<class Record>
bool isSame(const Record& a, const Record& b)
{
    using Words = std::array<std::uint32_t, sizeof(Record) / sizeof(std::uint32_t)>;
    return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

void append(std::vector<RowRange>& ranges, std::size_t row)
{
    if (!ranges.empty()) {
        RowRange& last = ranges.back();
        if (row - (last.first + last.count) <= StaticRecords::kJoinedGap) {
            last.count = row + 1 - last.first;
            return;
        }
    }
    ranges.push_back({row, 1});
}

} // namespace

std::uint32_t radiusAndModes(float radius, std::uint16_t replacedSlots)
{
    constexpr std::uint32_t kModes = 0xFFU;
    return (std::bit_cast<std::uint32_t>(radius) & ~kModes) | (replacedSlots & kModes);
}

void StaticRecords::update(const Request& request)
{
    const Population& population = request.frame.population;
    const std::span<const std::uint64_t> versions = population.blockVersions();
    if (request.seatsVersion != m_seatsVersion || request.templatesVersion != m_templatesVersion) {
        m_blockVersions.clear();
        m_seatsVersion = request.seatsVersion;
        m_templatesVersion = request.templatesVersion;
        m_entryOfId.assign(std::size_t{1} << 16U, -1);
        for (std::size_t i = 0; i < request.frame.templates->size(); ++i) {
            m_entryOfId[(*request.frame.templates)[i].id] = static_cast<std::int32_t>(i);
        }
    }
    m_placements.resize(population.size());
    m_appearances.resize(population.size());
    m_lifts.resize(population.size());
    m_changes.resize(population.size());
    m_knownRows = std::min(m_knownRows, population.size());
    m_changedBlocks.clear();
    for (std::size_t block = 0; block < versions.size(); ++block) {
        // Stamps are unique in the process: equal ones mean equal rows, older or newer.
        if (block >= m_blockVersions.size() || m_blockVersions[block] != versions[block]) {
            m_changedBlocks.push_back(static_cast<std::uint32_t>(block));
        }
    }
    m_blockVersions.assign(versions.begin(), versions.end());
    m_blockReplaces.resize(versions.size());
    parallelFor(m_changedBlocks.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            compute(request, m_changedBlocks[i]);
        }
    });
    m_replacesColours = std::ranges::any_of(m_blockReplaces, [](auto any) { return any != 0; });
    listChanges(population.size());
}

void StaticRecords::listChanges(std::size_t rows)
{
    m_newPlacements.clear();
    m_newAppearances.clear();
    for (const std::size_t block : m_changedBlocks) {
        const std::size_t end = std::min((block + 1) * Population::kBlockRows, rows);
        for (std::size_t row = block * Population::kBlockRows; row < end; ++row) {
            if ((m_changes[row] & kNewPlacement) != 0) {
                append(m_newPlacements, row);
            }
            if ((m_changes[row] & kNewAppearance) != 0) {
                append(m_newAppearances, row);
            }
        }
    }
    m_knownRows = rows;
}

void StaticRecords::store(std::size_t row, const PlacementRecord& placement,
                          const AppearanceRecord& look)
{
    const bool isKnown = row < m_knownRows;
    const bool isMoved = !isKnown || !isSame(m_placements[row], placement);
    const bool isRestyled = !isKnown || !isSame(m_appearances[row], look);
    m_changes[row] = static_cast<std::uint8_t>((isMoved ? kNewPlacement : 0) |
                                               (isRestyled ? kNewAppearance : 0));
    m_placements[row] = placement;
    m_appearances[row] = look;
}

void StaticRecords::compute(const Request& request, std::size_t block)
{
    const Population& rows = request.frame.population;
    const HeldValues<kHeldInPlacement> placements(rows);
    const HeldValues<kHeldInAppearance> appearances(rows);
    const std::size_t end = std::min((block + 1) * Population::kBlockRows, rows.size());
    std::uint16_t replaced = 0;
    for (std::size_t row = block * Population::kBlockRows; row < end; ++row) {
        replaced |= rows.column(columns::tintReplaces)[row];
        const std::int32_t entry = m_entryOfId[rows.column(columns::templateId)[row]];
        PlacementRecord placement;
        placements.copyTo(placement, row);
        float radius = 0.0F;
        if (entry >= 0) {
            const RecordTemplate& asset = request.templates[static_cast<std::size_t>(entry)];
            const SeatId seat = rows.column(columns::seat)[row];
            if (seat != kNoSeat && !asset.clipOfName.empty()) {
                const std::size_t clip = std::min<std::size_t>(rows.column(columns::clip)[row],
                                                               asset.clipOfName.size() - 1);
                placement.lift = seatLift(*asset.clipOfName[clip], seatHeight(request.seats, seat),
                                          placement.height);
            }
            radius = asset.shadowRadius * placement.girth;
        }
        const float heading = rows.column(columns::heading)[row];
        m_lifts[row] = placement.lift;
        placement.position =
            rows.column(columns::position)[row] + glm::vec3(0.0F, placement.lift, 0.0F);
        placement.cosHeading = std::cos(heading);
        placement.sinHeading = std::sin(heading);
        AppearanceRecord look;
        appearances.copyTo(look, row);
        look.radiusAndModes = radiusAndModes(radius, rows.column(columns::tintReplaces)[row]);
        store(row, placement, look);
    }
    m_blockReplaces[block] = replaced != 0 ? 1 : 0;
}

} // namespace crowd::render
