// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

#include "model/base/Color.h"

/// The columns of a population. To add one: a ColumnId and a key here, and a row in Properties.cpp;
/// all else follows from that table.
namespace crowd::model {

/// Stable name of an individual within its scene; never reused while the scene lives. 0 is nobody.
using IndividualId = std::uint32_t;
/// Stable name of a template entry within its scene. 0 is none.
using TemplateId = std::uint16_t;
/// A seat: stage entry id in the upper 8 bits, index in that stage's seats in the lower 24.
using SeatId = std::uint32_t;
inline constexpr SeatId kNoSeat = 0xFFFFFFFFU;

enum class ColumnId : std::uint8_t {
    Template,
    Position,
    Heading,
    Height,
    Girth,
    Tint0,
    Tint1,
    Tint2,
    Tint3,
    Tint4,
    Tint5,
    Tint6,
    Tint7,
    MaterialChoices,
    Parts,
    Clip,
    Phase,
    PlaybackSpeed,
    Seat,
    Tags,
    Group,
    Seed,
    Path,
    WalkSpeed,
    WalkStyle,
    TintReplaces,
    Feature1,
    Feature2,
    Feature3,
    Feature4,
    Feature5,
    Feature6,
    Feature7,
    Feature8,
    Count
};
inline constexpr std::size_t kColumnCount = static_cast<std::size_t>(ColumnId::Count);

/// How a column's values are written to text (project file, scripts).
enum class ColumnType : std::uint8_t { Float, Vec3, UInt16, UInt32, UInt64, Tint, Bytes8 };

/// Stable name of a value of a feature within its scene, over all kinds. 0 is none.
using FeatureId = std::uint16_t;
/// Kinds of features that a scene may have, each with a column of its own.
inline constexpr std::uint8_t kMostFeatureKinds = 8;

/// Index of the chosen MaterialChoice for each of the first 8 slots.
using MaterialChoices = std::array<std::uint8_t, 8>;

struct ColumnInfo
{
    std::string_view name; ///< as in project files and scripts
    ColumnType type;
    std::size_t stride; ///< bytes a row
};

/// From the table of properties, see Properties.h.
[[nodiscard]] const ColumnInfo& columnInfo(ColumnId column);

/// Typed name of a column: population.column(columns::position) is a span of glm::vec3.
template<class T>
struct ColumnKey
{
    ColumnId id;
};

namespace columns {
inline constexpr ColumnKey<TemplateId> templateId{ColumnId::Template};
inline constexpr ColumnKey<glm::vec3> position{ColumnId::Position}; ///< metres, foot point
inline constexpr ColumnKey<float> heading{ColumnId::Heading}; ///< radians, 0 = +Z, grows to +X
inline constexpr ColumnKey<float> height{ColumnId::Height};   ///< scale of Y
inline constexpr ColumnKey<float> girth{ColumnId::Girth};     ///< scale of X and Z
inline constexpr ColumnKey<MaterialChoices> materialChoices{ColumnId::MaterialChoices};
inline constexpr ColumnKey<std::uint32_t> parts{ColumnId::Parts}; ///< bit i shows part i
inline constexpr ColumnKey<std::uint16_t> clip{
    ColumnId::Clip};                                      ///< index in TemplateEntry::clipNames
inline constexpr ColumnKey<float> phase{ColumnId::Phase}; ///< 0..1 of the clip at time 0
inline constexpr ColumnKey<float> playbackSpeed{ColumnId::PlaybackSpeed}; ///< 1 = as authored
inline constexpr ColumnKey<SeatId> seat{ColumnId::Seat};
inline constexpr ColumnKey<std::uint64_t> tags{ColumnId::Tags};
inline constexpr ColumnKey<std::uint32_t> group{ColumnId::Group};
inline constexpr ColumnKey<std::uint32_t> seed{ColumnId::Seed};
inline constexpr ColumnKey<std::uint32_t> path{ColumnId::Path};   ///< PathId followed, 0: none
inline constexpr ColumnKey<float> walkSpeed{ColumnId::WalkSpeed}; ///< desired, m/s; 0: the usual
/// Clip to walk with, as the clip column counts, plus 1; 0: the one that fits the speed.
inline constexpr ColumnKey<std::uint16_t> walkStyle{ColumnId::WalkStyle};
/// Bit i: the tint of slot i is the colour itself, whatever the material's; else it multiplies it.
inline constexpr ColumnKey<std::uint16_t> tintReplaces{ColumnId::TintReplaces};
/// Tint of slot 0..7.
[[nodiscard]] constexpr ColumnKey<Tint> tint(int slot)
{
    return {static_cast<ColumnId>(static_cast<int>(ColumnId::Tint0) + slot)};
}
/// Which value of a kind of feature somebody bears; kinds count from 1 to kMostFeatureKinds.
[[nodiscard]] constexpr ColumnKey<FeatureId> feature(std::uint8_t kind)
{
    return {static_cast<ColumnId>(static_cast<int>(ColumnId::Feature1) + kind - 1)};
}
} // namespace columns

} // namespace crowd::model
