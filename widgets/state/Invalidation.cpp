// SPDX-License-Identifier: MIT
#include "widgets/state/Invalidation.h"

#include <algorithm>
#include <variant>

#include "model/population/Properties.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

bool isOfMotion(model::PropertyAspect aspect, const model::Scene& scene)
{
    using model::PropertyAspect;
    switch (aspect) {
    case PropertyAspect::Animation:
    case PropertyAspect::Walking:
    case PropertyAspect::Template:
    case PropertyAspect::Place:
    case PropertyAspect::Group: // they walk together
        return true;
    case PropertyAspect::Features:
    case PropertyAspect::Tags:
        return !scene.rules.empty();
    case PropertyAspect::Colours:
    case PropertyAspect::Materials:
    case PropertyAspect::Size: // seen at all times; a body's width counts from now on
        break;
    }
    return false;
}

/// Who asks for it.
bool isOfMotion(const model::SceneChange& change, const model::Scene& scene)
{
    if (isOneOf<model::StatesChanged>(change)) {
        return !scene.rules.empty() || !scene.timeline.empty();
    }
    if (isOneOf<model::FeaturesChanged>(change)) {
        return !scene.rules.empty();
    }
    return isOneOf<model::IndividualsAdded, model::IndividualsRemoved, model::PathsChanged,
                   model::RulesChanged, model::RelationsChanged, model::RelationKindsChanged,
                   model::GroupsChanged>(change);
}

/// Nothing happens there, or the same happens.
bool doesSame(const model::Mark& a, const model::Mark& b)
{
    model::Mark renamed = a;
    renamed.name = b.name;
    return renamed == b;
}

} // namespace

bool changesMotion(const model::SceneChange& change, const model::Scene& scene)
{
    const auto* changed = std::get_if<model::ColumnsChanged>(&change);
    return isOfMotion(change, scene) ||
           (changed != nullptr &&
            std::ranges::any_of(model::properties(), [&](const model::PropertyInfo& property) {
                return changed->columns.contains(property.id) &&
                       isOfMotion(property.traits.aspect, scene);
            }));
}

std::optional<double> firstDifference(const model::Timeline& before, const model::Timeline& after,
                                      double since)
{
    std::optional<double> first;
    const auto note = [&first, since](const model::Mark& mark) {
        if (model::isForPeople(mark.kind) && mark.seconds >= since) {
            first = std::min(first.value_or(mark.seconds), mark.seconds);
        }
    };
    const auto noteOthers = [&note](const model::Timeline& some, const model::Timeline& others) {
        for (const model::Mark& mark : some) { // both ascending by id
            const auto same = std::ranges::lower_bound(others, mark.id, {}, &model::Mark::id);
            if (same == others.end() || same->id != mark.id || !doesSame(mark, *same)) {
                note(mark);
            }
        }
    };
    noteOthers(before, after);
    noteOthers(after, before);
    return first;
}

} // namespace crowd::widgets
