// SPDX-License-Identifier: MIT
#include "render/crowd/EarlierRows.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include <epoxy/gl.h>

#include "render/crowd/PlanLook.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kGone = -1e4F; ///< metres up: below it are those who have left the scene

/// Of all rows of a frame; of those who are drawn nowhere they are empty.
struct FrameRecords
{
    std::vector<EarlierRecord> rows;
    bool areKeyframesMissing = false;
};

FrameRecords recordsOf(const RenderInput& input, const StaticRecords& records,
                       std::span<const PlanTemplate> templates)
{
    const CrowdFrame& frame = *input.frame;
    const std::size_t count = frame.population.size();
    const PlanLook look({frame,
                         templates,
                         records.lifts(),
                         input.view,
                         1.0F,
                         LevelThresholds::fullDetail(),
                         {},
                         0,
                         true});
    std::vector<std::uint8_t> levels(count, CrowdPlan::kNoLevel);
    const std::vector<std::uint8_t> flags(count, 0);
    PlanSeen seen;
    seen.instances.resize(count);
    seen.keys.resize(count);
    look.rows(0, count, levels, flags, seen);
    FrameRecords made{std::vector<EarlierRecord>(count), seen.isMissing};
    for (const Instance& shown : std::span(seen.instances).first(seen.count)) {
        const std::size_t row = shown.rowAndFlags & Instance::kRowMask;
        made.rows[row] = {records.placements()[row], shown.keyframeA, shown.keyframeB, shown.boxes,
                          shown.blend};
    }
    return made;
}

/// Who was there before as he was; both by ascending ids.
void takeOver(const CrowdFrame& before, std::span<const EarlierRecord> then, const CrowdFrame& now,
              std::span<EarlierRecord> rows)
{
    const auto idsBefore = before.population.ids();
    const auto ids = now.population.ids();
    const auto templatesBefore = before.population.column(columns::templateId);
    const auto templates = now.population.column(columns::templateId);
    std::size_t old = 0;
    for (std::size_t row = 0; row < ids.size(); ++row) {
        while (old < idsBefore.size() && idsBefore[old] < ids[row]) {
            ++old;
        }
        const bool wasThere = old < idsBefore.size() && idsBefore[old] == ids[row] &&
                              templatesBefore[old] == templates[row] &&
                              then[old].placement.position.y > kGone;
        if (wasThere) {
            rows[row] = then[old];
        }
    }
}

} // namespace

EarlierRows::EarlierRows() : m_records(GL_RGBA32UI) {}

void EarlierRows::update(const RenderInput& input, CrowdGpu& crowd)
{
    FrameRecords now = recordsOf(input, crowd.records(), crowd.templates());
    RenderInput before = input;
    before.frame = input.earlier->frame;
    if (before.frame && crowd.useAlso(before)) {
        m_before.update({*before.frame, crowd.recordTemplates(), input.seats, input.seatsVersion,
                         crowd.templatesVersion()});
        FrameRecords then = recordsOf(before, m_before, crowd.templates());
        if (then.areKeyframesMissing) {
            input.keyframes.waitForAll();
            (void)crowd.useAlso(before);
            then = recordsOf(before, m_before, crowd.templates());
        }
        takeOver(*before.frame, then.rows, *input.frame, now.rows);
    }
    const auto bytes = std::as_bytes(std::span<const EarlierRecord>(now.rows));
    m_records.reserve(std::max(bytes.size(), sizeof(EarlierRecord)));
    m_records.write(0, bytes);
}

} // namespace crowd::render
