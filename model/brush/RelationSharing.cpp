// SPDX-License-Identifier: MIT
#include "model/brush/RelationSharing.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "model/brush/ColumnWriting.h"
#include "model/brush/FeatureBrush.h"
#include "model/brush/SlotChoice.h"
#include "model/features/FeatureWriting.h"

namespace crowd::model {

namespace {

/// From whom each of those who share gets it.
using Sources = std::map<IndividualId, IndividualId>;

Sources sourcesOf(const ChangeRequest& request, std::span<const IndividualId> painted,
                  bool RelationKind::*shares)
{
    const Scene& scene = request.edit.scene();
    Sources sources;
    if (scene.relations.isEmpty()) {
        return sources;
    }
    for (const IndividualId id : painted) {
        for (const RelationLink& link : scene.relations.of(id)) {
            const RelationKind* kind = findRelation(scene.relationKinds, link.kind);
            const bool isMeant = kind != nullptr && kind->*shares &&
                                 (kind->isMutual || link.isOut) &&
                                 !std::ranges::binary_search(request.ids, link.other);
            if (isMeant && scene.isTouchable(scene.population.rowOf(link.other))) {
                sources.try_emplace(link.other, id);
            }
        }
    }
    return sources;
}

std::vector<IndividualId> shareFeature(const ChangeRequest& request, const Sources& sources,
                                       const std::string& kindName)
{
    const Scene& scene = request.edit.scene();
    const FeatureKind* kind = findKind(scene.features, kindName);
    if (kind == nullptr) {
        return {};
    }
    const auto borne = scene.population.column(columns::feature(kind->id));
    std::vector<IndividualId> ids;
    std::vector<FeatureId> wanted;
    for (const auto& [id, source] : sources) {
        ids.push_back(id);
        wanted.push_back(borne[scene.population.rowOf(source)]);
    }
    return setFeature(request.edit, *kind, ids, wanted, request.seed);
}

std::vector<IndividualId> shareColours(const ChangeRequest& request, const Sources& sources)
{
    const Scene& scene = request.edit.scene();
    const Population& people = scene.population;
    const auto& settings = request.settings.as<ColourSettings>();
    const auto templates = people.column(columns::templateId);
    const auto replaced = people.column(columns::tintReplaces);
    std::array<ColumnChange<Tint>, kMaxTintSlots> changes;
    ColumnChange<std::uint16_t> modeChange;
    for (const auto& [id, source] : sources) {
        const std::size_t row = people.rowOf(id);
        const std::size_t from = people.rowOf(source);
        const TemplateEntry* his = scene.findTemplate(templates[row]);
        const TemplateEntry* theirs = scene.findTemplate(templates[from]);
        if (his == nullptr || theirs == nullptr || !his->asset || !theirs->asset) {
            continue;
        }
        const ColourSlots meant(*theirs->asset, settings);
        std::uint16_t modes = replaced[row];
        const auto& given = theirs->asset->slots;
        for (std::size_t slot = 0; slot < std::min<std::size_t>(given.size(), kMaxTintSlots);
             ++slot) {
            const auto same = std::ranges::find(his->asset->slots, given[slot].name, &Slot::name);
            const auto index = static_cast<std::size_t>(same - his->asset->slots.begin());
            if (!meant.contains(given[slot]) || same == his->asset->slots.end() ||
                index >= kMaxTintSlots) {
                continue;
            }
            const auto bit = static_cast<std::uint16_t>(1U << index);
            const bool replaces = (replaced[from] >> slot & 1U) != 0;
            modes = static_cast<std::uint16_t>(replaces ? modes | bit : modes & ~bit);
            changes[index].set(id, people.column(columns::tint(static_cast<int>(index)))[row],
                               people.column(columns::tint(static_cast<int>(slot)))[from]);
        }
        modeChange.set(id, replaced[row], modes);
    }
    std::vector<IndividualId> changed;
    for (std::size_t index = 0; index < changes.size(); ++index) {
        changes[index].apply(request.edit, columns::tint(static_cast<int>(index)), changed);
    }
    modeChange.apply(request.edit, columns::tintReplaces, changed);
    return changed;
}

} // namespace

void shareWithRelated(const ChangeRequest& request, std::vector<IndividualId>& changed)
{
    const BrushSettings& brush = request.settings;
    std::vector<IndividualId> others;
    if (const FeatureSettings* feature = featureSettings(brush)) {
        const Sources sources = sourcesOf(request, changed, &RelationKind::sharesFeatures);
        others = sources.empty() ? others : shareFeature(request, sources, feature->kind);
    } else if (brush.kind() == BrushKind::Colour) {
        const Sources sources = sourcesOf(request, changed, &RelationKind::sharesColors);
        others = sources.empty() ? others : shareColours(request, sources);
    }
    std::vector<IndividualId> all;
    std::ranges::set_union(changed, others, std::back_inserter(all));
    changed = std::move(all);
}

} // namespace crowd::model
