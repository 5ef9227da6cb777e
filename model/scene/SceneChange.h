// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "model/population/ColumnSet.h"

/// What SceneDocument::changed() reports: small typed events, said after the fact.
namespace crowd::model {

struct IndividualsAdded
{
    std::vector<IndividualId> ids; ///< ascending
};
struct IndividualsRemoved
{
    std::vector<IndividualId> ids; ///< ascending
};
struct ColumnsChanged
{
    std::vector<IndividualId> ids; ///< ascending
    ColumnSet columns;
};
struct TemplatesChanged
{
};
struct StagesChanged
{
};
struct CamerasChanged
{
};
struct LightingChanged
{
};
/// The lights that stand in it.
struct LightsChanged
{
};
/// Looks that belong to it.
struct LooksChanged
{
};
/// Places or paths.
struct PathsChanged
{
};
struct GroupsChanged
{
};
/// Rules or the names of tags.
struct RulesChanged
{
};
/// Kept states of people.
struct StatesChanged
{
};
/// What there is of kinds and values of features.
struct FeaturesChanged
{
};
/// What there is of kinds of relations.
struct RelationKindsChanged
{
};
/// Who is related to whom.
struct RelationsChanged
{
};
/// What happens when.
struct TimelineChanged
{
};
/// Kept runs, or which of them is shown.
struct TakesChanged
{
};
/// Another scene altogether: forget everything.
struct SceneReplaced
{
};

using SceneChange = std::variant<IndividualsAdded, IndividualsRemoved, ColumnsChanged,
                                 TemplatesChanged, StagesChanged, CamerasChanged, LightingChanged,
                                 LightsChanged, LooksChanged, PathsChanged, GroupsChanged,
                                 RulesChanged, StatesChanged, FeaturesChanged, RelationKindsChanged,
                                 RelationsChanged, TimelineChanged, TakesChanged, SceneReplaced>;

} // namespace crowd::model
