// SPDX-License-Identifier: MIT
#include "widgets/viewport/RelationArcs.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "widgets/state/RelationTexts.h"

namespace crowd::widgets {

namespace {

constexpr std::size_t kMostArcs = 20'000;
constexpr std::size_t kFewArcs = 2'000; ///< so many are drawn finely
constexpr int kFineSegments = 14;
constexpr int kCoarseSegments = 6;
constexpr float kUnknownHeight = 1.7F; ///< metres, of who has no template
constexpr float kAboveHead = 0.12F;    ///< metres
constexpr float kRise = 0.22F;         ///< of the distance, above the heads
constexpr float kLeastRise = 0.25F;    ///< metres
constexpr float kWeakPixels = 1.2F;    ///< width of a strength of 0
constexpr float kStrongPixels = 3.0F;
constexpr float kHeadPixels = 11.0F; ///< of an arrow
constexpr float kHeadShare = 0.12F;  ///< of the arc
constexpr float kAlpha = 0.95F;
constexpr float kClearArcs = 60.0F; ///< so many are not seen through
constexpr float kLeastFade = 0.3F;

/// Where a head is, by the template's height; who sits is lower.
class HeadPlaces
{
public:
    HeadPlaces(const model::Scene& scene, const model::Population& people)
        : m_scene(scene), m_positions(people.column(model::columns::position)),
          m_heights(people.column(model::columns::height)),
          m_templates(people.column(model::columns::templateId)),
          m_seats(people.column(model::columns::seat))
    {
    }
    [[nodiscard]] glm::vec3 of(std::size_t row) const
    {
        const model::TemplateEntry* entry = m_scene.findTemplate(m_templates[row]);
        const float body = entry != nullptr && entry->asset ? entry->asset->height : kUnknownHeight;
        const float share = m_seats[row] == model::kNoSeat ? 1.0F : kSeatedShare;
        return m_positions[row] + glm::vec3(0.0F, body * m_heights[row] * share + kAboveHead, 0.0F);
    }

private:
    static constexpr float kSeatedShare = 0.78F; ///< of the height

    const model::Scene& m_scene;
    std::span<const glm::vec3> m_positions;
    std::span<const float> m_heights;
    std::span<const model::TemplateId> m_templates;
    std::span<const model::SeatId> m_seats;
};

glm::vec4 arcColor(const model::PaintColor& color, float alpha)
{
    return {static_cast<float>(color[0]) / 255.0F, static_cast<float>(color[1]) / 255.0F,
            static_cast<float>(color[2]) / 255.0F, alpha};
}

/// The more there are, the more is seen through each: people are not hidden by them.
float alphaOf(std::size_t arcs)
{
    const float fade = std::sqrt(kClearArcs / std::max(kClearArcs, static_cast<float>(arcs)));
    return kAlpha * std::max(kLeastFade, fade);
}

} // namespace

void RelationArcs::gather(const EditorState& state, const model::CrowdFrame& frame)
{
    const model::Scene& scene = state.scene();
    const model::Population& people = frame.population;
    const auto groups = people.column(model::columns::group);
    const HeadPlaces heads(scene, people);
    const auto selected = state.selection().ids();
    const bool isOfSelected = !selected.empty() && state.tool() != ToolId::BrushRelation;
    const auto add = [&](model::IndividualId id) {
        const std::size_t row = people.rowOf(id);
        if (row == model::Population::npos || model::isAmong(frame.hiddenGroups, groups[row])) {
            return;
        }
        for (const model::RelationLink& link : scene.relations.of(id)) {
            const std::size_t other = people.rowOf(link.other);
            const bool isSaidThere =
                isOfSelected && !link.isOut && std::ranges::binary_search(selected, link.other);
            if (other == model::Population::npos || (!link.isOut && !isOfSelected) || isSaidThere ||
                model::isAmong(frame.hiddenGroups, groups[other]) || m_arcs.size() >= kMostArcs) {
                continue;
            }
            const std::size_t from = link.isOut ? row : other;
            const std::size_t to = link.isOut ? other : row;
            m_arcs.push_back({heads.of(from), heads.of(to),
                              findRelation(scene.relationKinds, link.kind), link.strength});
        }
    };
    std::ranges::for_each(isOfSelected ? selected : people.ids(), add);
}

void RelationArcs::make(const EditorState& state, const model::CrowdFrame& frame)
{
    m_arcs.clear();
    m_lines.clear();
    m_legend.clear();
    if (state.scene().relations.isEmpty() || !state.showsRelations()) {
        return;
    }
    gather(state, frame);
    const int segments = m_arcs.size() > kFewArcs ? kCoarseSegments : kFineSegments;
    m_lines.reserve(m_arcs.size() * static_cast<std::size_t>(segments + 1));
    for (const Arc& arc : m_arcs) {
        if (arc.kind != nullptr) {
            draw(arc, segments);
        }
    }
    for (const model::RelationKind& kind : state.scene().relationKinds) {
        const auto isOfKind = [&kind](const Arc& arc) { return arc.kind == &kind; };
        if (std::ranges::any_of(m_arcs, isOfKind)) {
            m_legend.push_back(
                {relationText(kind.name), QColor(kind.color[0], kind.color[1], kind.color[2])});
        }
    }
}

void RelationArcs::draw(const Arc& arc, int segments)
{
    const float rise = std::max(kLeastRise, kRise * glm::distance(arc.from, arc.to));
    const auto at = [&](float share) {
        const float bow = 4.0F * share * (1.0F - share);
        return glm::mix(arc.from, arc.to, share) + glm::vec3(0.0F, rise * bow, 0.0F);
    };
    const glm::vec4 color = arcColor(arc.kind->color, alphaOf(m_arcs.size()));
    const float width = glm::mix(kWeakPixels, kStrongPixels, arc.strength);
    const float end = arc.kind->isMutual ? 1.0F : 1.0F - kHeadShare;
    for (int i = 0; i < segments; ++i) {
        const float from = end * static_cast<float>(i) / static_cast<float>(segments);
        const float to = end * static_cast<float>(i + 1) / static_cast<float>(segments);
        m_lines.push_back({at(from), at(to), color, width, width});
    }
    if (!arc.kind->isMutual) {
        m_lines.push_back({at(end), at(1.0F), color, kHeadPixels, 0.0F});
    }
}

} // namespace crowd::widgets
