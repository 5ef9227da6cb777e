// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <QtCore/QtGlobal>

#include "model/describe/FieldMeta.h"
#include "model/population/Columns.h"

/// What there is to know of each property of an individual, said once. Storage, undo, project
/// files, scripts with their checks and manual, the panel of a character and Keep Pose follow from
/// this table. What the GPU holds of a property is a table of `render`.
namespace crowd::model {

/// How operators spread a value, and which control edits it.
enum class PropertyKind : std::uint8_t {
    Number,
    Angle, ///< radians
    Colour,
    Choice,   ///< one of a list of the individual's template
    Set,      ///< bits
    Reference ///< the id of something in the scene
};

/// What lies between two values where a change takes time.
enum class PropertyBlend : std::uint8_t {
    Step, ///< nothing: it changes at once
    Linear,
    Turn,  ///< angles, the shorter way round
    Cycle, ///< as Turn, but one round is 0..1
    Colour ///< each channel on its own
};

/// Who may write a property of somebody who is in the scene. Bits.
enum PropertyWriter : std::uint8_t {
    kWrittenByBrush = 1,
    kWrittenByPanel = 2, ///< of a character; numbers get a row there
    kWrittenByScript = 4,
    kWrittenByRule = 8,     ///< Keep Pose takes it where a rule has set it
    kWrittenBySession = 16, ///< as people go about: Keep Pose takes what is shown
    kWrittenByHand = kWrittenByBrush | kWrittenByPanel | kWrittenByScript
};

/// What properties are about, where an artist chooses several at once, as for what a state holds.
enum class PropertyAspect : std::uint8_t {
    Colours,
    Materials,
    Animation,
    Size,
    Walking,
    Features,
    Tags,
    Template,
    Place,
    Group
};

struct PropertyAspectInfo
{
    PropertyAspect aspect;
    const char* key;   ///< in preferences
    const char* label; ///< to be translated in the context "Fields"
    /// Who and where people are: left out unless it is asked for.
    bool isWhoOrWhere = false;
};

/// In the order in which they are shown, which is that of PropertyAspect.
[[nodiscard]] std::span<const PropertyAspectInfo> propertyAspects();

struct PropertyTraits
{
    PropertyKind kind = PropertyKind::Number;
    PropertyBlend blend = PropertyBlend::Linear;
    std::uint8_t writers = kWrittenByHand; ///< PropertyWriter
    /// What a stored number is, English, as messages of scripts say it: "in metres".
    const char* meaning = "a number";
    /// What the history says of a change in the panel; translation context "Fields".
    const char* change = QT_TRANSLATE_NOOP("Fields", "Change character");
    /// Whoever is created without it gets what the template, the seat or the number suggests.
    bool isSuggested = false;
    PropertyAspect aspect = PropertyAspect::Animation;
};

/// Legal ranges are those of floating-point properties, of each component, and do not depend on the
/// scene; whole numbers may have every value of their type.
struct PropertyInfo
{
    static constexpr std::size_t kMostBytes = 16; ///< of one value

    ColumnId id;
    ColumnInfo column;
    FieldMeta meta;
    PropertyTraits traits;
    std::array<std::byte, kMostBytes> initial; ///< the first column.stride bytes: the default

    [[nodiscard]] constexpr bool isWrittenBy(PropertyWriter writer) const
    {
        return (traits.writers & writer) != 0;
    }
};

/// All of them, in the order of ColumnId.
[[nodiscard]] std::span<const PropertyInfo> properties();
[[nodiscard]] const PropertyInfo& propertyInfo(ColumnId column);
/// By its name in files and scripts; null: there is none.
[[nodiscard]] const PropertyInfo* findProperty(std::string_view key);

} // namespace crowd::model
