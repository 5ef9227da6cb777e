// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "model/brush/changes/Animation.h"
#include "model/brush/changes/Clone.h"
#include "model/brush/changes/Colour.h"
#include "model/brush/changes/Create.h"
#include "model/brush/changes/Delete.h"
#include "model/brush/changes/Event.h"
#include "model/brush/changes/Feature.h"
#include "model/brush/changes/Group.h"
#include "model/brush/changes/Material.h"
#include "model/brush/changes/Orientation.h"
#include "model/brush/changes/Parts.h"
#include "model/brush/changes/Place.h"
#include "model/brush/changes/Push.h"
#include "model/brush/changes/Relation.h"
#include "model/brush/changes/Restore.h"
#include "model/brush/changes/Retake.h"
#include "model/brush/changes/Scale.h"
#include "model/brush/changes/Script.h"
#include "model/brush/changes/Shuffle.h"
#include "model/brush/changes/Smooth.h"
#include "model/brush/changes/Style.h"
#include "model/brush/changes/Tag.h"
#include "model/brush/changes/Template.h"
#include "model/brush/changes/Time.h"
#include "model/brush/changes/Walk.h"

/// The one list of brushes: name, settings. New ones come last, since the numbers of the others key
/// seeds and are known to scripts; BrushInfo::order says where they are shown.
#define CROWD_BRUSHES(BRUSH)                                                                       \
    BRUSH(Create, CreateSettings)                                                                  \
    BRUSH(Delete, DeleteSettings)                                                                  \
    BRUSH(Colour, ColourSettings)                                                                  \
    BRUSH(Orientation, OrientationSettings)                                                        \
    BRUSH(Animation, AnimationSettings)                                                            \
    BRUSH(Walk, WalkSettings)                                                                      \
    BRUSH(Tag, TagSettings)                                                                        \
    BRUSH(Untag, UntagSettings)                                                                    \
    BRUSH(Event, EventSettings)                                                                    \
    BRUSH(Path, PathSettings)                                                                      \
    BRUSH(Environment, EnvironmentSettings)                                                        \
    BRUSH(Script, ScriptSettings)                                                                  \
    BRUSH(Style, StyleSettings)                                                                    \
    BRUSH(Scale, ScaleSettings)                                                                    \
    BRUSH(Material, MaterialSettings)                                                              \
    BRUSH(Group, GroupSettings)                                                                    \
    BRUSH(Template, TemplateSettings)                                                              \
    BRUSH(Shuffle, ShuffleSettings)                                                                \
    BRUSH(Restore, RestoreSettings)                                                                \
    BRUSH(Time, TimeSettings)                                                                      \
    BRUSH(Clone, CloneSettings)                                                                    \
    BRUSH(Smooth, SmoothSettings)                                                                  \
    BRUSH(Push, PushSettings)                                                                      \
    BRUSH(Parts, PartsSettings)                                                                    \
    BRUSH(Feature, FeatureSettings)                                                                \
    BRUSH(Outfit, OutfitSettings)                                                                  \
    BRUSH(Relation, RelationSettings)                                                              \
    BRUSH(Retake, RetakeSettings)

namespace crowd::model {

#define CROWD_BRUSH_NAME(name, settings) name,
enum class BrushKind : std::uint8_t { CROWD_BRUSHES(CROWD_BRUSH_NAME) };
#undef CROWD_BRUSH_NAME

namespace detail {
struct NoBrush;
template<class First, class... Settings>
struct VariantBehind
{
    using type = std::variant<Settings...>;
};
} // namespace detail

/// What a brush does and is set to; the alternative's index is its BrushKind.
#define CROWD_BRUSH_SETTINGS(name, settings) , settings
using BrushChange =
    detail::VariantBehind<detail::NoBrush CROWD_BRUSHES(CROWD_BRUSH_SETTINGS)>::type;
#undef CROWD_BRUSH_SETTINGS

inline constexpr std::size_t kBrushCount = std::variant_size_v<BrushChange>;

} // namespace crowd::model
