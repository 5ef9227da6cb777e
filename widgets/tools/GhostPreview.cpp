// SPDX-License-Identifier: MIT
#include "widgets/tools/GhostPreview.h"

#include <algorithm>
#include <span>

#include "model/brush/Stroke.h"

namespace crowd::widgets {

using namespace model;

namespace {

float liftOf(std::span<const WorldSeat> seats, SeatId id, const Clip& clip, float height)
{
    const auto found =
        std::lower_bound(seats.begin(), seats.end(), id,
                         [](const WorldSeat& seat, SeatId wanted) { return seat.id < wanted; });
    const bool isSeated = found != seats.end() && found->id == id;
    return isSeated ? seatLift(clip, found->seat.height, height) : 0.0F;
}

template<class Rows>
render::Ghost ghostFrom(const Scene& scene, std::span<const WorldSeat> seats, const Rows& rows,
                        std::size_t row, double seconds)
{
    render::Ghost ghost;
    const TemplateEntry* entry = scene.findTemplate(rows.column(columns::templateId)[row]);
    if (entry == nullptr || !entry->asset) {
        return ghost;
    }
    const std::uint16_t clipName = rows.column(columns::clip)[row];
    const int clip = clipName < entry->clipNames.size()
                         ? entry->asset->clipIndex(entry->clipNames[clipName])
                         : -1;
    ghost.asset = entry->asset;
    ghost.clip = clip < 0 ? entry->asset->defaultClip : clip;
    const Clip& shown = entry->asset->clips[static_cast<std::size_t>(ghost.clip)];
    ghost.position = rows.column(columns::position)[row];
    ghost.headingRadians = rows.column(columns::heading)[row];
    ghost.height = rows.column(columns::height)[row];
    ghost.girth = rows.column(columns::girth)[row];
    ghost.phase = shownPhase(shown, rows.column(columns::phase)[row],
                             rows.column(columns::playbackSpeed)[row], seconds);
    ghost.lift = liftOf(seats, rows.column(columns::seat)[row], shown, ghost.height);
    for (int slot = 0; slot < kMaxTintSlots; ++slot) {
        ghost.tints[static_cast<std::size_t>(slot)] = rows.column(columns::tint(slot))[row];
    }
    ghost.materialChoices = rows.column(columns::materialChoices)[row];
    ghost.parts = rows.column(columns::parts)[row];
    return ghost;
}

} // namespace

render::Ghost ghostOf(const Scene& scene, std::span<const WorldSeat> seats,
                      const Population& people, std::size_t row, double seconds)
{
    return ghostFrom(scene, seats, people, row, seconds);
}

std::vector<render::Ghost> ghostsAt(const ToolContext& context, const BrushSettings& settings,
                                    std::uint64_t seed, const ToolInput& at)
{
    const IndividualRows rows = previewGhosts(
        context.state.document(), context.queries.hoverContext(), settings, seed, at.pointer);
    std::vector<render::Ghost> ghosts;
    for (std::size_t row = 0; row < rows.ids.size(); ++row) {
        ghosts.push_back(ghostFrom(context.state.scene(), context.queries.seats(), rows, row,
                                   at.pointer.shownSeconds));
    }
    return ghosts;
}

} // namespace crowd::widgets
