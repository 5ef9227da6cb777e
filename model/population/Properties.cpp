// SPDX-License-Identifier: MIT
#include "model/population/Properties.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>
#include <type_traits>

#include "model/scene/Path.h"

namespace crowd::model {

namespace {

constexpr double kFarthest = 1e6; ///< metres, from the middle of the scene
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

constexpr std::uint8_t kByRulesToo = kWrittenByHand | kWrittenByRule;
constexpr std::uint8_t kBySessionToo = kWrittenByHand | kWrittenBySession;
constexpr std::uint8_t kInPanelAndScript = kWrittenByPanel | kWrittenByScript;

template<class T>
constexpr ColumnType columnType()
{
    if constexpr (std::is_same_v<T, float>) {
        return ColumnType::Float;
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
        return ColumnType::Vec3;
    } else if constexpr (std::is_same_v<T, Tint>) {
        return ColumnType::Tint;
    } else if constexpr (std::is_same_v<T, MaterialChoices>) {
        return ColumnType::Bytes8;
    } else if constexpr (sizeof(T) == sizeof(std::uint16_t)) {
        return ColumnType::UInt16;
    } else if constexpr (sizeof(T) == sizeof(std::uint32_t)) {
        return ColumnType::UInt32;
    } else {
        static_assert(std::is_same_v<T, std::uint64_t>);
        return ColumnType::UInt64;
    }
}

/// A property with the default 0.
template<class T>
constexpr PropertyInfo property(ColumnKey<T> key, const FieldMeta& meta,
                                const PropertyTraits& traits)
{
    static_assert(sizeof(T) <= PropertyInfo::kMostBytes);
    PropertyInfo info{key.id, {meta.key, columnType<T>(), sizeof(T)}, meta, traits, {}};
    if constexpr (std::is_unsigned_v<T>) {
        info.meta.high = static_cast<double>(std::numeric_limits<T>::max());
        info.meta.decimals = 0;
        info.meta.step = 1.0;
    }
    return info;
}

template<class T>
constexpr PropertyInfo property(ColumnKey<T> key, const T& initial, const FieldMeta& meta,
                                const PropertyTraits& traits)
{
    PropertyInfo info = property(key, meta, traits);
    std::ranges::copy(std::bit_cast<std::array<std::byte, sizeof(T)>>(initial),
                      info.initial.begin());
    return info;
}

constexpr PropertyInfo tint(int slot, const char* key)
{
    return property(columns::tint(slot), Tint{},
                    {.key = key, .doc = "of one slot: red, green, blue (sRGB), strength"},
                    {.kind = PropertyKind::Colour,
                     .blend = PropertyBlend::Colour,
                     .writers = kByRulesToo,
                     .aspect = PropertyAspect::Colours});
}

constexpr PropertyInfo feature(std::uint8_t kind, const char* key)
{
    return property(columns::feature(kind),
                    {.key = key,
                     .doc = "the id of a value of the feature whose id that is; 0: none",
                     .role = FieldRole::Feature},
                    {.kind = PropertyKind::Reference,
                     .blend = PropertyBlend::Step,
                     .writers = kWrittenByBrush | kWrittenByScript | kWrittenByRule,
                     .aspect = PropertyAspect::Features});
}

constexpr FieldMeta scaleOf(const char* key, const char* label, FieldRole role = FieldRole::Plain)
{
    return {.key = key,
            .label = label,
            .doc = "a scale",
            .low = 0.01,
            .high = 100.0,
            .sliderLow = 0.1,
            .sliderHigh = 10.0,
            .decimals = 3,
            .role = role};
}

constexpr std::array<PropertyInfo, kColumnCount> kProperties{
    property(columns::templateId,
             {.key = "template",
              .label = QT_TRANSLATE_NOOP("Fields", "Template"),
              .doc = "the id of a template, or a `Template`",
              .role = FieldRole::Template},
             {.kind = PropertyKind::Reference,
              .blend = PropertyBlend::Step,
              .writers = kInPanelAndScript,
              .isSuggested = true,
              .aspect = PropertyAspect::Template}),
    property(columns::position,
             {.key = "position",
              .label = QT_TRANSLATE_NOOP("Fields", "Position"),
              .doc = "metres, world frame, Y up: the foot point",
              .low = -kFarthest,
              .high = kFarthest,
              .sliderLow = -1e5,
              .sliderHigh = 1e5,
              .role = FieldRole::Point},
             {.writers = kBySessionToo,
              .meaning = "in metres",
              .isSuggested = true,
              .aspect = PropertyAspect::Place}),
    property(columns::heading,
             {.key = "heading",
              .label = QT_TRANSLATE_NOOP("Fields", "Heading"),
              .doc = "radians, 0 faces +Z, grows towards +X",
              .unit = "°",
              .low = -1e6,
              .high = 1e6,
              .sliderLow = -36000.0,
              .sliderHigh = 36000.0,
              .step = 1.0,
              .decimals = 1,
              .shownScale = kDegreesPerRadian,
              .role = FieldRole::Angle},
             {.kind = PropertyKind::Angle,
              .blend = PropertyBlend::Turn,
              .writers = kBySessionToo,
              .meaning = "in radians",
              .isSuggested = true,
              .aspect = PropertyAspect::Place}),
    property(columns::height, 1.0F,
             scaleOf("height", QT_TRANSLATE_NOOP("Fields", "Height"), FieldRole::Stature),
             {.writers = kByRulesToo, .meaning = "a scale", .aspect = PropertyAspect::Size}),
    property(columns::girth, 1.0F, scaleOf("girth", QT_TRANSLATE_NOOP("Fields", "Girth")),
             {.meaning = "a scale", .aspect = PropertyAspect::Size}),
    tint(0, "tint0"),
    tint(1, "tint1"),
    tint(2, "tint2"),
    tint(3, "tint3"),
    tint(4, "tint4"),
    tint(5, "tint5"),
    tint(6, "tint6"),
    tint(7, "tint7"),
    property(columns::materialChoices, {.key = "choices", .doc = "the material of each slot"},
             {.kind = PropertyKind::Choice,
              .blend = PropertyBlend::Step,
              .writers = kInPanelAndScript,
              .aspect = PropertyAspect::Materials}),
    property(columns::parts, std::uint32_t{0xFFFFFFFFU},
             {.key = "parts", .doc = "bit i shows part i of the template"},
             {.kind = PropertyKind::Set,
              .blend = PropertyBlend::Step,
              .writers = kInPanelAndScript,
              .isSuggested = true,
              .aspect = PropertyAspect::Materials}),
    property(columns::clip,
             {.key = "clip",
              .label = QT_TRANSLATE_NOOP("Fields", "Clip"),
              .doc = "counts in `Template.clip_names`; names are taken too",
              .role = FieldRole::Clip},
             {.kind = PropertyKind::Choice,
              .blend = PropertyBlend::Step,
              .writers = kByRulesToo,
              .isSuggested = true,
              .aspect = PropertyAspect::Animation}),
    property(columns::phase,
             {.key = "phase",
              .label = QT_TRANSLATE_NOOP("Fields", "Phase"),
              .doc = "of the clip at time 0",
              .step = 0.01,
              .decimals = 3},
             {.blend = PropertyBlend::Cycle,
              .writers = kByRulesToo,
              .meaning = "a phase",
              .aspect = PropertyAspect::Animation}),
    property(columns::playbackSpeed, 1.0F,
             {.key = "speed",
              .label = QT_TRANSLATE_NOOP("Fields", "Speed"),
              .doc = "of playback; 1: as authored",
              .low = -100.0,
              .high = 100.0,
              .sliderLow = 0.0,
              .sliderHigh = 20.0},
             {.writers = kByRulesToo,
              .meaning = "a playback speed",
              .aspect = PropertyAspect::Animation}),
    property(columns::seat, kNoSeat,
             {.key = "seat",
              .label = QT_TRANSLATE_NOOP("Fields", "Seat"),
              .doc = "one of `scene.seats[\"id\"]`; 0xFFFFFFFF: none"},
             {.kind = PropertyKind::Reference,
              .blend = PropertyBlend::Step,
              .writers = kInPanelAndScript | kWrittenBySession,
              .aspect = PropertyAspect::Place}),
    property(columns::tags,
             {.key = "tags",
              .label = QT_TRANSLATE_NOOP("Fields", "Tags"),
              .doc = "bits",
              .role = FieldRole::Tag},
             {.kind = PropertyKind::Set,
              .blend = PropertyBlend::Step,
              .writers = kByRulesToo,
              .aspect = PropertyAspect::Tags}),
    property(columns::group,
             {.key = "group",
              .label = QT_TRANSLATE_NOOP("Fields", "Group"),
              .doc = "a number that those who belong together share"},
             {.blend = PropertyBlend::Step,
              .writers = kInPanelAndScript,
              .change = QT_TRANSLATE_NOOP("Fields", "Change group"),
              .aspect = PropertyAspect::Group}),
    property(columns::seed, {.key = "seed", .doc = "what is drawn for them depends on it"},
             {.blend = PropertyBlend::Step,
              .writers = kWrittenByScript,
              .isSuggested = true,
              .aspect = PropertyAspect::Template}),
    property(columns::path,
             {.key = "path",
              .doc = "the id of a path in `scene.environment`; 0: none",
              .role = FieldRole::Path},
             {.kind = PropertyKind::Reference,
              .blend = PropertyBlend::Step,
              .writers = kWrittenByBrush | kWrittenByScript,
              .aspect = PropertyAspect::Walking}),
    property(columns::walkSpeed,
             {.key = "walkSpeed",
              .label = QT_TRANSLATE_NOOP("Fields", "Walking speed"),
              .tip = QT_TRANSLATE_NOOP("Fields", "Metres per second; 0: the usual speed"),
              .doc = "m/s; 0: the usual one",
              .high = static_cast<double>(kMaxWalkingSpeed),
              .zero = QT_TRANSLATE_NOOP("Fields", "usual")},
             {.meaning = "in m/s", .aspect = PropertyAspect::Walking}),
    property(columns::walkStyle,
             {.key = "walkStyle",
              .doc = "the clip to walk with, counted from 1 in `Template.clip_names`; 0: the one "
                     "that fits the speed",
              .role = FieldRole::WalkingClips},
             {.kind = PropertyKind::Choice,
              .blend = PropertyBlend::Step,
              .writers = kWrittenByBrush | kWrittenByScript,
              .aspect = PropertyAspect::Walking}),
    property(columns::tintReplaces,
             {.key = "tintReplaces",
              .doc = "bit i: the tint of slot i is the colour itself; else it multiplies the "
                     "material's"},
             {.kind = PropertyKind::Set,
              .blend = PropertyBlend::Step,
              .aspect = PropertyAspect::Colours}),
    feature(1, "feature1"),
    feature(2, "feature2"),
    feature(3, "feature3"),
    feature(4, "feature4"),
    feature(5, "feature5"),
    feature(6, "feature6"),
    feature(7, "feature7"),
    feature(8, "feature8"),
};

/// An entry that was forgotten has no key; one in another's place has another's id.
constexpr bool isEveryPropertyAtItsPlace()
{
    for (std::size_t c = 0; c < kProperties.size(); ++c) {
        const PropertyInfo& info = kProperties[c];
        if (info.id != static_cast<ColumnId>(c) || info.column.name.empty() ||
            info.meta.low > info.meta.high) {
            return false;
        }
        for (std::size_t other = 0; other < c; ++other) {
            if (kProperties[other].column.name == info.column.name) {
                return false;
            }
        }
    }
    return true;
}
static_assert(isEveryPropertyAtItsPlace(),
              "Each ColumnId has one row in this table, in the order of the enumeration.");

} // namespace

std::span<const PropertyAspectInfo> propertyAspects()
{
    static constexpr PropertyAspectInfo kAspects[] = {
        {PropertyAspect::Colours, "colours", QT_TRANSLATE_NOOP("Fields", "Colours")},
        {PropertyAspect::Materials, "materials",
         QT_TRANSLATE_NOOP("Fields", "Materials and parts")},
        {PropertyAspect::Animation, "animation", QT_TRANSLATE_NOOP("Fields", "Animation")},
        {PropertyAspect::Size, "size", QT_TRANSLATE_NOOP("Fields", "Size")},
        {PropertyAspect::Walking, "walking", QT_TRANSLATE_NOOP("Fields", "Walking")},
        {PropertyAspect::Features, "features", QT_TRANSLATE_NOOP("Fields", "Features")},
        {PropertyAspect::Tags, "tags", QT_TRANSLATE_NOOP("Fields", "Tags")},
        {PropertyAspect::Template, "template", QT_TRANSLATE_NOOP("Fields", "Template"), true},
        {PropertyAspect::Place, "place", QT_TRANSLATE_NOOP("Fields", "Place and heading"), true},
        {PropertyAspect::Group, "group", QT_TRANSLATE_NOOP("Fields", "Group"), true},
    };
    return kAspects;
}

std::span<const PropertyInfo> properties()
{
    return kProperties;
}

const PropertyInfo& propertyInfo(ColumnId column)
{
    return kProperties[static_cast<std::size_t>(column)];
}

const ColumnInfo& columnInfo(ColumnId column)
{
    return propertyInfo(column).column;
}

const PropertyInfo* findProperty(std::string_view key)
{
    const auto found = std::ranges::find(kProperties, key,
                                         [](const PropertyInfo& info) { return info.column.name; });
    return found == kProperties.end() ? nullptr : &*found;
}

} // namespace crowd::model
