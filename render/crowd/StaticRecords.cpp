// SPDX-License-Identifier: MIT
#include "render/crowd/StaticRecords.h"

#include <algorithm>
#include <cmath>

#include "model/base/Parallel.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr std::size_t kBlocksPerChunk = 8;

float seatHeight(std::span<const WorldSeat> seats, SeatId id)
{
    const auto found = std::ranges::lower_bound(seats, id, {}, &WorldSeat::id);
    return found != seats.end() && found->id == id ? found->seat.height : 0.0F;
}

} // namespace

void StaticRecords::forget()
{
    m_blockVersions.clear();
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
    m_changed.clear();
    for (std::size_t block = 0; block < versions.size(); ++block) {
        // Stamps are unique in the process: equal ones mean equal rows, older or newer.
        if (block >= m_blockVersions.size() || m_blockVersions[block] != versions[block]) {
            m_changed.push_back(static_cast<std::uint32_t>(block));
        }
    }
    m_blockVersions.assign(versions.begin(), versions.end());
    parallelFor(m_changed.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            compute(request, m_changed[i]);
        }
    });
}

void StaticRecords::compute(const Request& request, std::size_t block)
{
    const Population& rows = request.frame.population;
    std::array<std::span<const Tint>, kMaxTintSlots> tints;
    for (int slot = 0; slot < kMaxTintSlots; ++slot) {
        tints[static_cast<std::size_t>(slot)] = rows.column(columns::tint(slot));
    }
    const std::size_t end = std::min((block + 1) * Population::kBlockRows, rows.size());
    for (std::size_t row = block * Population::kBlockRows; row < end; ++row) {
        const std::int32_t entry = m_entryOfId[rows.column(columns::templateId)[row]];
        float lift = 0.0F;
        float radius = 0.0F;
        const float height = rows.column(columns::height)[row];
        const float girth = rows.column(columns::girth)[row];
        if (entry >= 0) {
            const RecordTemplate& asset = request.templates[static_cast<std::size_t>(entry)];
            const SeatId seat = rows.column(columns::seat)[row];
            if (seat != kNoSeat && !asset.clipOfName.empty()) {
                const std::size_t clip = std::min<std::size_t>(rows.column(columns::clip)[row],
                                                               asset.clipOfName.size() - 1);
                lift = seatLift(*asset.clipOfName[clip], seatHeight(request.seats, seat), height);
            }
            radius = asset.shadowRadius * girth;
        }
        const float heading = rows.column(columns::heading)[row];
        m_lifts[row] = lift;
        m_placements[row] = {rows.column(columns::position)[row] + glm::vec3(0.0F, lift, 0.0F),
                             std::cos(heading),
                             std::sin(heading),
                             height,
                             girth,
                             lift};
        AppearanceRecord& look = m_appearances[row];
        for (std::size_t slot = 0; slot < tints.size(); ++slot) {
            look.tints[slot] = tints[slot][row];
        }
        look.choices = rows.column(columns::materialChoices)[row];
        look.parts = rows.column(columns::parts)[row];
        look.shadowRadius = radius;
    }
}

} // namespace crowd::render
