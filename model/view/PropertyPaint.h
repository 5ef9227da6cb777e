// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <QtCore/QtGlobal>

#include "model/base/Result.h"
#include "model/population/Properties.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"

/// People in colours that say what they have: of which template, group or mood they are, how fast
/// they walk, how close they stand. Colours sRGB, 0xRRGGBB. Any thread.
namespace crowd::model {

/// What people can be coloured by, apart from properties that are numbers and from features.
/// `label` is a literal in the translation context "Properties".
struct ShownProperty
{
    const char* key; ///< on the command line, in scripts and in settings
    const char* label;
};

inline constexpr std::array kShownProperties{
    ShownProperty{"template", QT_TRANSLATE_NOOP("Properties", "Template")},
    ShownProperty{"group", QT_TRANSLATE_NOOP("Properties", "Group")},
    ShownProperty{"tag", QT_TRANSLATE_NOOP("Properties", "Tag")},
    ShownProperty{"clip", QT_TRANSLATE_NOOP("Properties", "Animation")},
    ShownProperty{"height", QT_TRANSLATE_NOOP("Properties", "Height")},
    ShownProperty{"density", QT_TRANSLATE_NOOP("Properties", "Density")}};
/// Before the name of a kind of features: "feature:emotion".
inline constexpr std::string_view kFeatureProperty = "feature:";

/// A property that is a number and has a name, by its key; null: there is none. 0 of one whose zero
/// means something else counts as none.
[[nodiscard]] const PropertyInfo* numberProperty(std::string_view key);
/// All keys that a scene knows: the table's, those of numbers, then one per kind of features.
[[nodiscard]] std::vector<std::string> propertyKeys(const Scene& scene);
/// The error lists what there is.
[[nodiscard]] Result<void> checkProperty(const Scene& scene, std::string_view key);

/// Those who have the same, or nearly.
struct PropertyClass
{
    enum class Kind : std::uint8_t {
        Named,   ///< `name` says it: a template, group, clip or value of a feature
        Tag,     ///< `number`
        Unnamed, ///< a number that no group is there for: `number`
        Range,   ///< low <= value < high, in `unit`
        Several, ///< tags
        None
    };
    Kind kind = Kind::None;
    std::string name{};
    std::uint32_t number = 0; ///< tags count from 0
    double low = 0.0;
    double high = 0.0; ///< infinite: no upper end
    std::uint32_t color = 0;
    std::size_t people = 0; ///< at least one
};

struct PropertyPaint
{
    std::string_view unit;              ///< of ranges: "m", "/m²"; empty: none
    std::vector<PropertyClass> classes; ///< in the order of the scene, ranges ascending, None last
    std::vector<std::uint16_t> classOfRow;
};

/// Metres around each within which density counts, himself included.
inline constexpr float kDensityReach = 2.0F;
/// Upper ends of the levels of service A to E for people who walk, per square metre, after Fruin,
/// Pedestrian Planning and Design, 1971; F has none.
inline constexpr std::array kDensityLevels{0.31, 0.43, 0.72, 1.08, 2.17};

/// A key that the scene does not know counts as "template". `people` is who is seen, at the moment
/// that is seen; names are the scene's.
[[nodiscard]] PropertyPaint paintBy(const Scene& scene, const Population& people,
                                    std::string_view key);
/// The same frame with the colour of each in his first tint, as the look "property" draws it.
[[nodiscard]] CrowdFramePtr paintedFrame(const CrowdFrame& frame, const PropertyPaint& paint);
/// Both at once, for a picture without a legend.
[[nodiscard]] CrowdFramePtr framePaintedBy(const Scene& scene, const CrowdFrame& frame,
                                           std::string_view key);
/// As the artist set it, else one of a circle of hues. `bit` counts from 0.
[[nodiscard]] std::uint32_t tagColor(const Scene& scene, int bit);
/// Who is in a class, ascending.
[[nodiscard]] std::vector<IndividualId> peopleIn(const PropertyPaint& paint, std::size_t each,
                                                 const Population& people);

} // namespace crowd::model
