// SPDX-License-Identifier: MIT
#include "model/brush/SelectionEffect.h"

#include <algorithm>

#include "model/base/Random.h"
#include "model/brush/PropertyChange.h"

namespace crowd::model {

namespace {

/// A stroke of more selects anew when it is laid again.
constexpr std::size_t kMostKept = 4'000'000;

} // namespace

SelectionEffect::SelectionEffect(StrokeContext& ground)
    : m_ground(ground), m_mask(ground.document.scene(), ground.settings.mask),
      m_picker(ground.context.keyframes, ground.context.stage), m_frame(ground.document.frame(0.0)),
      m_isTouched(m_frame->population.size(), 0), m_isChanged(m_frame->population.size(), 0)
{
    if (ground.settings.kind() == BrushKind::Relation) {
        m_relations.emplace(ground.settings, ground.seed);
    }
}

void SelectionEffect::showTime(double seconds)
{
    if (m_frame->seconds != seconds || (m_ground.context.pose && !m_shown)) {
        CrowdFrame at = *m_frame;
        at.seconds = seconds;
        m_frame = std::make_shared<const CrowdFrame>(at);
        if (m_ground.context.pose) {
            m_ground.context.pose(at);
            m_shown = std::make_shared<const CrowdFrame>(std::move(at));
        }
    }
    m_picker.update(m_shown ? m_shown : m_frame, m_ground.seats, m_ground.context.view);
}

/// Those whom a session has elsewhere are found where they are seen.
void SelectionEffect::followMoves()
{
    if (!m_shown) {
        CrowdFrame moved = *m_frame;
        moved.population = m_ground.edit->scene().population;
        m_frame = std::make_shared<const CrowdFrame>(std::move(moved));
        m_picker.update(m_frame, m_ground.seats, m_ground.context.view);
    }
}

std::vector<IndividualId> SelectionEffect::selected(const Dab& dab) const
{
    const BrushSettings& settings = m_ground.settings;
    const AreaMode mode = settings.through ? AreaMode::Through : AreaMode::Visible;
    if (settings.selection == BrushSelection::AllInCircle) {
        return m_picker.individualsInArea(
            ScreenArea::circle(dab.pixels(), dabRadius(settings, dab)), mode);
    }
    std::vector<IndividualId> ids;
    const bool isSpray = settings.selection == BrushSelection::Spray;
    for (int k = 0; k < (isSpray ? dab.points : 1); ++k) {
        const glm::dvec2 point =
            isSpray ? sprayPoint(settings, m_ground.seed, dab, k) : dab.pixels();
        if (settings.through) {
            for (const IndividualHit& hit : m_picker.individualsThrough(point)) {
                ids.push_back(hit.id);
            }
        } else if (const auto hit = m_picker.individualAt(point)) {
            ids.push_back(hit->id);
        }
    }
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

std::vector<IndividualId>
SelectionEffect::remembered(const std::function<std::vector<IndividualId>()>& select)
{
    std::vector<IndividualId> ids;
    const RecordedStroke* before = m_ground.before;
    if (before == nullptr) {
        ids = select();
    } else if (m_selections < before->selected.size()) {
        ids = before->selected[m_selections];
        const Population& now = m_ground.edit->scene().population; // dabs before may have removed
        std::erase_if(ids, [this, &now](IndividualId id) {
            return m_frame->population.rowOf(id) == Population::npos ||
                   now.rowOf(id) == Population::npos;
        });
    }
    ++m_selections;
    m_selected += ids.size();
    if (m_selected <= kMostKept) {
        m_ground.selected.push_back(ids);
    } else {
        m_ground.selected.clear();
    }
    return ids;
}

std::vector<IndividualId> SelectionEffect::unmasked(std::vector<IndividualId> ids)
{
    using Verdict = StrokeMask::Verdict;
    const Population& people = m_frame->population;
    std::erase_if(ids, [&](IndividualId id) {
        const Verdict verdict = m_mask.verdict(people.rowOf(id));
        if (verdict != Verdict::Meant && m_reason == StrokeReason::NobodyUnderBrush) {
            m_reason =
                verdict == Verdict::Locked ? StrokeReason::GroupLocked : StrokeReason::Masked;
        }
        return verdict != Verdict::Meant;
    });
    return ids;
}

std::vector<IndividualId> SelectionEffect::untouched(std::vector<IndividualId> ids)
{
    const Population& people = m_frame->population;
    std::erase_if(ids, [&](IndividualId id) {
        char& isTouched = m_isTouched[people.rowOf(id)];
        const bool wasTouched = isTouched != 0;
        isTouched = 1;
        return wasTouched && !m_ground.settings.buildUp;
    });
    return ids;
}

void SelectionEffect::count(std::span<const IndividualId> changed)
{
    for (const IndividualId id : changed) {
        char& isChanged = m_isChanged[m_frame->population.rowOf(id)];
        m_affected += isChanged == 0 ? 1 : 0;
        isChanged = 1;
    }
}

void SelectionEffect::change(std::span<const IndividualId> ids, const StrokeLine& line,
                             std::uint64_t seed, std::optional<float> heading)
{
    if (m_ground.settings.kind() == BrushKind::Event) {
        send(ids);
        return;
    }
    if (m_ground.settings.kind() == BrushKind::Retake) {
        gather(ids);
        return;
    }
    const ChangeRequest request{*m_ground.edit,
                                m_ground.settings,
                                m_ground.context.view,
                                seed,
                                line,
                                heading,
                                ids,
                                m_shown ? &m_shown->population : nullptr,
                                &m_ground.context.stage};
    ScriptChange* script = m_ground.context.script;
    const ChangeResult result = m_ground.settings.kind() != BrushKind::Script
                                    ? changeProperties(request)
                                : script != nullptr ? script->change(request)
                                                    : ChangeResult{{}, StrokeReason::NothingChosen};
    count(result.changed);
    m_reason = result.reason;
}

void SelectionEffect::relate(std::span<const IndividualId> ids)
{
    m_relations->add(*m_ground.edit, m_shown ? m_shown->population : m_frame->population, ids);
}

/// Anew: a stroke from one to another may have gone on to somebody else.
void SelectionEffect::settleRelations()
{
    m_relations->settle(*m_ground.edit);
    std::ranges::fill(m_isChanged, 0);
    m_affected = 0;
    count(m_relations->changed());
    const bool isMasked = m_reason == StrokeReason::Masked || m_reason == StrokeReason::GroupLocked;
    if (m_relations->reason() != StrokeReason::NobodyUnderBrush || !isMasked) {
        m_reason = m_relations->reason();
    }
}

void SelectionEffect::send(std::span<const IndividualId> ids)
{
    if (!m_ground.context.sendEvent) {
        m_reason = StrokeReason::NoSession;
        return;
    }
    m_ground.context.sendEvent(m_ground.settings.as<EventSettings>(), ids);
    count(ids);
}

void SelectionEffect::gather(std::span<const IndividualId> ids)
{
    if (!m_ground.context.retake) {
        m_reason = StrokeReason::NoTake;
        return;
    }
    std::vector<IndividualId> all;
    std::ranges::set_union(m_ground.gathered, ids, std::back_inserter(all));
    m_ground.gathered = std::move(all);
    m_affected = static_cast<int>(m_ground.gathered.size());
}

void SelectionEffect::retake()
{
    const auto& settings = m_ground.settings.as<RetakeSettings>();
    if (!m_ground.gathered.empty() && !m_ground.context.retake(settings, m_ground.gathered)) {
        m_reason = StrokeReason::TakeBusy;
        m_affected = 0;
    }
}

std::vector<IndividualId> SelectionEffect::thinned(std::vector<IndividualId> ids)
{
    const BrushSettings& settings = m_ground.settings;
    if (settings.takesShare()) {
        const double share = settings.as<DeleteSettings>().percent / 100.0;
        std::erase_if(ids, [&](IndividualId id) {
            return randomUnit(hashKeys(m_ground.seed, id), DrawPurpose::DeleteShare) >= share;
        });
    }
    if (ids.empty()) {
        m_reason = StrokeReason::ShareTooSmall;
    }
    return ids;
}

void SelectionEffect::remove(std::vector<IndividualId> ids)
{
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end()); // told dabs may repeat them
    m_ground.edit->removeIndividuals(ids);
    count(ids);
}

void SelectionEffect::apply(std::span<const StrokeDab> dabs)
{
    const BrushSettings& settings = m_ground.settings;
    std::vector<IndividualId> gone;
    for (const StrokeDab& dab : dabs) {
        if (!m_ground.context.goesOn(static_cast<std::size_t>(&dab - dabs.data()), dabs.size())) {
            return;
        }
        showTime(dab.dab.shownSeconds);
        const bool isMoving = brushType(settings.kind()).info.movesPeople;
        if (isMoving) {
            followMoves();
        }
        std::vector<IndividualId> ids = remembered([&] { return selected(dab.dab); });
        if (m_relations) {
            relate(unmasked(std::move(ids)));
            continue;
        }
        const bool isBeforeAnyWay = isMoving && dab.heading && dab.dab.index == 0;
        ids = isBeforeAnyWay ? std::vector<IndividualId>() : untouched(unmasked(std::move(ids)));
        if (ids.empty()) {
            continue;
        }
        if (settings.kind() == BrushKind::Delete) {
            ids = thinned(std::move(ids));
            m_picker.exclude(ids);
            gone.insert(gone.end(), ids.begin(), ids.end());
        } else if (settings.isReevaluated()) {
            std::vector<IndividualId> all;
            std::ranges::set_union(m_touched, ids, std::back_inserter(all));
            m_touched = std::move(all);
        } else {
            const std::uint64_t seed =
                settings.buildUp ? hashKeys(m_ground.seed, dab.dab.index) : m_ground.seed;
            change(ids, {dab.dab.pixels(), dab.dab.pixels()}, seed, dab.heading);
        }
    }
    remove(std::move(gone));
    if (m_relations && !settings.hasWholeArea()) {
        settleRelations();
    }
}

/// Events and scripts are not run again and again: they reach whom the area holds in the end.
void SelectionEffect::end(const StrokeLine& line)
{
    if (m_ground.settings.kind() == BrushKind::Retake) {
        retake();
        return;
    }
    if (!m_ground.settings.isReevaluated() || m_touched.empty()) {
        return;
    }
    if (m_ground.settings.kind() == BrushKind::Event) {
        send(m_touched);
    }
    if (m_ground.settings.kind() == BrushKind::Script) {
        m_affected = 0;
        change(m_touched, line, m_ground.seed,
               headingOfLine(m_ground.context.view, m_ground.context.stage, line));
    }
}

void SelectionEffect::reevaluate(const StrokeLine& line, double shownSeconds)
{
    const BrushSettings& settings = m_ground.settings;
    m_ground.edit->rollback();
    std::ranges::fill(m_isChanged, 0);
    m_affected = 0;
    m_ground.gathered.clear();
    m_reason = StrokeReason::NobodyUnderBrush;
    if (settings.hasWholeArea()) {
        showTime(shownSeconds);
        m_selections = 0;
        m_selected = 0;
        m_ground.selected.clear();
        const AreaMode mode = settings.through ? AreaMode::Through : AreaMode::Visible;
        m_touched = unmasked(remembered(
            [&] { return m_picker.individualsInArea(wholeArea(m_ground, line), mode); }));
    }
    if (m_relations) {
        m_relations->restart();
        relate(m_touched);
        settleRelations();
        return;
    }
    if (m_touched.empty()) {
        return;
    }
    if (settings.kind() == BrushKind::Event) {
        return; // sent once, at the end
    }
    if (settings.kind() == BrushKind::Delete) {
        remove(thinned(m_touched));
    } else if (settings.kind() == BrushKind::Script) {
        m_affected = static_cast<int>(m_touched.size());
    } else {
        change(m_touched, line, m_ground.seed,
               headingOfLine(m_ground.context.view, m_ground.context.stage, line));
    }
}

} // namespace crowd::model
