// SPDX-License-Identifier: MIT
#include "model/brush/CreationEffect.h"

#include <glm/geometric.hpp>

#include "model/brush/NewPeople.h"
#include "model/brush/Operator.h"

namespace crowd::model {

std::vector<Spot> spotsOfDab(CreationSite& site, const BrushSettings& settings, std::uint64_t seed,
                             const Dab& dab)
{
    const ScreenArea circle = ScreenArea::circle(dab.pixels(), dabRadius(settings, dab));
    std::vector<Spot> spots;
    const auto keep = [&spots](const std::optional<Spot>& spot) {
        if (spot) {
            spots.push_back(*spot);
        }
    };
    switch (settings.selection) {
    case BrushSelection::Point:
    case BrushSelection::Rectangle:
    case BrushSelection::Lasso:
        keep(site.at(dab.pixels(), std::nullopt));
        break;
    case BrushSelection::Spray:
        for (int k = 0; k < dab.points; ++k) {
            keep(site.at(sprayPoint(settings, seed, dab, k), circle));
        }
        break;
    case BrushSelection::AllInCircle:
        spots = site.fill(circle, false);
        break;
    }
    return spots;
}

CreationEffect::CreationEffect(StrokeContext& ground)
    : m_ground(ground), m_site(ground.edit->scene(), ground.context, ground.settings, ground.seed)
{
}

void CreationEffect::create(std::span<const Spot> spots, std::optional<float> strokeHeading)
{
    const Group* group =
        m_ground.edit->scene().findGroup(m_ground.settings.as<CreateSettings>().group);
    if (group != nullptr && (group->isHidden || group->isLocked)) {
        m_reason = StrokeReason::GroupLocked;
        return;
    }
    NewPeople people = peopleFor(m_ground.edit->scene(), m_ground.context.view, m_ground.settings,
                                 spots, strokeHeading);
    m_reason = people.reason != StrokeReason::None ? people.reason : m_site.reason();
    if (!people.rows.ids.empty()) {
        m_created += static_cast<int>(people.rows.ids.size());
        (void)m_ground.edit->addIndividuals(std::move(people.rows));
    }
}

/// A hand that clicks moves a little: what it planted is one.
bool CreationEffect::isOfTheClick(const Dab& dab)
{
    constexpr double kClickPixels = 8.0;
    if (m_ground.settings.selection != BrushSelection::Point) {
        return false;
    }
    if (!m_press) {
        m_press = dab.pixels();
        return false;
    }
    return m_created == 1 && glm::distance(dab.pixels(), *m_press) < kClickPixels;
}

void CreationEffect::apply(std::span<const StrokeDab> dabs)
{
    for (const StrokeDab& dab : dabs) {
        if (!m_ground.context.goesOn(static_cast<std::size_t>(&dab - dabs.data()), dabs.size())) {
            return;
        }
        if (!isOfTheClick(dab.dab)) {
            create(spotsOfDab(m_site, m_ground.settings, m_ground.seed, dab.dab), dab.heading);
        }
    }
}

void CreationEffect::reevaluate(const StrokeLine& line, double /*shownSeconds*/)
{
    m_ground.edit->rollback();
    m_site.reset();
    m_created = 0;
    create(m_site.fill(wholeArea(m_ground, line), true),
           headingOfLine(m_ground.context.view, m_ground.context.stage, line));
}

} // namespace crowd::model
