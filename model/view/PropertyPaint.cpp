// SPDX-License-Identifier: MIT
#include "model/view/PropertyPaint.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "model/base/Parallel.h"
#include "model/population/FootCells.h"

namespace crowd::model {

namespace {

using Kind = PropertyClass::Kind;

constexpr std::uint32_t kNoneColor = 0x8A8D91;
constexpr std::uint32_t kSeveralColor = 0xF4F4F4;
/// Told apart at a glance, also by most who see few colours (after Okabe and Ito, 2008).
constexpr std::array<std::uint32_t, 8> kPalette{0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442,
                                                0x0072B2, 0xD55E00, 0xCC79A7, 0x7A5AA6};
/// From low to high: even steps of "viridis" (Smith and van der Walt, 2015).
constexpr std::array<std::uint32_t, 6> kRamp{0x440154, 0x414487, 0x2A788E,
                                             0x22A884, 0x7AD151, 0xFDE725};
/// From room to walk freely to a crush.
constexpr std::array<std::uint32_t, kDensityLevels.size() + 1> kCrowding{
    0x3B6FB6, 0x5DB3C5, 0x7FC97F, 0xF2D64B, 0xF08C3A, 0xD7301F};

/// Hue 0..1.
std::uint32_t colorOfHue(double hue, double saturation, double value)
{
    std::uint32_t color = 0;
    for (const double shift : {5.0, 3.0, 1.0}) {
        const double k = std::fmod(shift + hue * 6.0, 6.0);
        const double part = value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
        color = color << 8U | static_cast<std::uint32_t>(std::lround(part * 255.0));
    }
    return color;
}

/// However many there are.
std::uint32_t colorOfNumber(std::size_t number)
{
    if (number < kPalette.size()) {
        return kPalette[number];
    }
    const double turn = static_cast<double>(number) * std::numbers::phi;
    return colorOfHue(turn - std::floor(turn), 0.55, number % 2 == 0 ? 0.95 : 0.7);
}

std::uint32_t colorOf(const PaintColor& color)
{
    return static_cast<std::uint32_t>(color[0]) << 16U |
           static_cast<std::uint32_t>(color[1]) << 8U | color[2];
}

/// Puts rows into classes.
class Sorting
{
public:
    explicit Sorting(std::size_t rows) { paint.classOfRow.resize(rows); }

    std::uint16_t add(PropertyClass each)
    {
        paint.classes.push_back(std::move(each));
        return static_cast<std::uint16_t>(paint.classes.size() - 1);
    }
    /// Those of a value, by the class that a table has for it or that `make` makes.
    template<class T, class Make>
    void byValue(std::span<const T> values, std::map<T, std::uint16_t> known, const Make& make)
    {
        for (std::size_t row = 0; row < values.size(); ++row) {
            auto found = known.find(values[row]);
            if (found == known.end()) {
                found = known.emplace(values[row], add(make(values[row]))).first;
            }
            paint.classOfRow[row] = found->second;
        }
    }
    /// By ranges between ascending ends; values that are no numbers are in none.
    void byRange(std::span<const double> values, std::span<const double> ends,
                 std::span<const std::uint32_t> colors, std::string_view unit)
    {
        paint.unit = unit;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const double low = i == 0 ? 0.0 : ends[i - 1];
            const double high = i < ends.size() ? ends[i] : std::numeric_limits<double>::infinity();
            add({.kind = Kind::Range, .low = low, .high = high, .color = colors[i]});
        }
        const std::uint16_t none = add({.color = kNoneColor});
        for (std::size_t row = 0; row < values.size(); ++row) {
            const auto place = std::ranges::upper_bound(ends, values[row]) - ends.begin();
            const auto last = static_cast<std::ptrdiff_t>(colors.size()) - 1;
            paint.classOfRow[row] = std::isfinite(values[row])
                                        ? static_cast<std::uint16_t>(std::min(place, last))
                                        : none;
        }
    }
    /// Classes without anybody go, the one of none comes last.
    [[nodiscard]] PropertyPaint finish() &&
    {
        for (const std::uint16_t each : paint.classOfRow) {
            ++paint.classes[each].people;
        }
        std::vector<std::uint16_t> order;
        for (std::size_t i = 0; i < paint.classes.size(); ++i) {
            if (paint.classes[i].people > 0) {
                order.push_back(static_cast<std::uint16_t>(i));
            }
        }
        std::stable_partition(order.begin(), order.end(), [this](std::uint16_t i) {
            return paint.classes[i].kind != Kind::None;
        });
        std::vector<PropertyClass> kept;
        std::vector<std::uint16_t> places(paint.classes.size());
        for (const std::uint16_t each : order) {
            places[each] = static_cast<std::uint16_t>(kept.size());
            kept.push_back(std::move(paint.classes[each]));
        }
        for (std::uint16_t& each : paint.classOfRow) {
            each = places[each];
        }
        paint.classes = std::move(kept);
        return std::move(paint);
    }

    PropertyPaint paint;
};

struct Subject
{
    const Scene& scene;
    const Population& people;
};

PropertyClass nobodys(std::uint64_t /*value*/)
{
    return {.color = kNoneColor};
}

void sortByTemplate(Sorting& sorting, const Subject& of)
{
    std::map<TemplateId, std::uint16_t> known;
    for (std::size_t i = 0; i < of.scene.templates.size(); ++i) {
        const TemplateEntry& entry = of.scene.templates[i];
        known[entry.id] =
            sorting.add({.kind = Kind::Named, .name = entry.name, .color = colorOfNumber(i)});
    }
    sorting.byValue(of.people.column(columns::templateId), std::move(known), &nobodys);
}

void sortByGroup(Sorting& sorting, const Subject& of)
{
    std::map<GroupId, std::uint16_t> known;
    for (const Group& group : of.scene.groups) {
        known[group.id] =
            sorting.add({.kind = Kind::Named, .name = group.name, .color = colorOf(group.color)});
    }
    sorting.byValue(of.people.column(columns::group), std::move(known), [](GroupId id) {
        return id == 0
                   ? nobodys(id)
                   : PropertyClass{.kind = Kind::Unnamed, .number = id, .color = colorOfNumber(id)};
    });
}

void sortByTag(Sorting& sorting, const Subject& of)
{
    std::map<std::uint64_t, std::uint16_t> known;
    const auto tags = of.people.column(columns::tags);
    for (int bit = 0; bit < 64; ++bit) {
        known[std::uint64_t{1} << static_cast<unsigned>(bit)] =
            sorting.add({.kind = Kind::Tag,
                         .number = static_cast<std::uint32_t>(bit),
                         .color = tagColor(of.scene, bit)});
    }
    known[0] = sorting.add(nobodys(0));
    const std::uint16_t several = sorting.add({.kind = Kind::Several, .color = kSeveralColor});
    for (const std::uint64_t each : tags) {
        known.try_emplace(each, several);
    }
    sorting.byValue(tags, std::move(known), &nobodys);
}

/// Clips of different templates that are called the same are the same. Colours follow the scene's
/// order, so that they stay while people change what they play.
void sortByClip(Sorting& sorting, const Subject& of)
{
    std::map<std::string, std::uint16_t> known;
    std::map<TemplateId, const TemplateEntry*> entries;
    for (const TemplateEntry& entry : of.scene.templates) {
        entries[entry.id] = &entry;
        for (const std::string& name : entry.clipNames) {
            if (!known.contains(name)) {
                known[name] = sorting.add(
                    {.kind = Kind::Named, .name = name, .color = colorOfNumber(known.size())});
            }
        }
    }
    const std::uint16_t none = sorting.add(nobodys(0));
    const auto templates = of.people.column(columns::templateId);
    const auto clips = of.people.column(columns::clip);
    for (std::size_t row = 0; row < of.people.size(); ++row) {
        const auto entry = entries.find(templates[row]);
        const bool isThere = entry != entries.end() && clips[row] < entry->second->clipNames.size();
        sorting.paint.classOfRow[row] =
            isThere ? known[entry->second->clipNames[clips[row]]] : none;
    }
}

void sortByFeature(Sorting& sorting, const Subject& of, const FeatureKind& kind)
{
    std::map<FeatureId, std::uint16_t> known;
    for (std::size_t i = 0; i < kind.values.size(); ++i) {
        const FeatureValue& value = kind.values[i];
        known[value.id] =
            sorting.add({.kind = Kind::Named, .name = value.name, .color = colorOfNumber(i)});
    }
    sorting.byValue(of.people.column(columns::feature(kind.id)), std::move(known), &nobodys);
}

/// In even steps from the least to the most.
void sortEvenly(Sorting& sorting, std::span<const double> values, std::string_view unit)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double each : values) {
        low = std::isfinite(each) ? std::min(low, each) : low;
        high = std::isfinite(each) ? std::max(high, each) : high;
    }
    const bool isOne = !(high - low > 1e-6 * std::max(1.0, std::abs(high)));
    const std::size_t steps = isOne ? 1 : kRamp.size();
    std::vector<double> ends;
    for (std::size_t i = 1; i < steps; ++i) {
        ends.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(steps));
    }
    const std::span<const std::uint32_t> ramp(kRamp);
    sorting.byRange(values, ends, isOne ? ramp.subspan(ramp.size() / 2, 1) : ramp, unit);
    if (std::isfinite(low)) {
        sorting.paint.classes.front().low = low;
        sorting.paint.classes[steps - 1].high = high;
    }
}

void sortByHeight(Sorting& sorting, const Subject& of)
{
    std::map<TemplateId, double> metres;
    for (const TemplateEntry& entry : of.scene.templates) {
        metres[entry.id] = entry.asset ? static_cast<double>(entry.asset->height)
                                       : std::numeric_limits<double>::quiet_NaN();
    }
    const auto templates = of.people.column(columns::templateId);
    const auto heights = of.people.column(columns::height);
    std::vector<double> values(of.people.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < values.size(); ++row) {
        const auto found = metres.find(templates[row]);
        if (found != metres.end()) {
            values[row] = found->second * static_cast<double>(heights[row]);
        }
    }
    sortEvenly(sorting, values, "m");
}

void sortByNumber(Sorting& sorting, const Subject& of, const PropertyInfo& property)
{
    const bool isZeroNone = *property.meta.zero != '\0';
    std::vector<double> values;
    values.reserve(of.people.size());
    for (const float each : of.people.column(ColumnKey<float>{property.id})) {
        values.push_back(isZeroNone && each == 0.0F ? std::numeric_limits<double>::quiet_NaN()
                                                    : static_cast<double>(each));
    }
    sortEvenly(sorting, values, {});
}

void sortByDensity(Sorting& sorting, const Subject& of)
{
    constexpr std::size_t kRowsPerChunk = 256;
    constexpr double kArea = std::numbers::pi * kDensityReach * kDensityReach;
    const FootCells cells(of.people.column(columns::position), kDensityReach);
    std::vector<double> values(of.people.size());
    parallelFor(values.size(), kRowsPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            std::size_t near = 0;
            cells.forEachNear(row, [&near](std::uint32_t /*other*/) { ++near; });
            values[row] = static_cast<double>(near) / kArea;
        }
    });
    sorting.byRange(values, kDensityLevels, kCrowding, "/m²");
}

const FeatureKind* featureOf(const Scene& scene, std::string_view key)
{
    return key.starts_with(kFeatureProperty)
               ? findKind(scene.features, key.substr(kFeatureProperty.size()))
               : nullptr;
}

} // namespace

std::uint32_t tagColor(const Scene& scene, int bit)
{
    constexpr int kHueStep = 67; // degrees: those of neighbouring numbers are far apart
    constexpr double kSaturation = 200.0 / 255.0;
    constexpr double kValue = 230.0 / 255.0;
    const auto named = std::ranges::find(scene.tags, bit, &TagName::bit);
    return named != scene.tags.end()
               ? colorOf(named->color)
               : colorOfHue(bit * kHueStep % 360 / 360.0, kSaturation, kValue);
}

const PropertyInfo* numberProperty(std::string_view key)
{
    const PropertyInfo* found = findProperty(key);
    const bool isNumber = found != nullptr && found->traits.kind == PropertyKind::Number &&
                          found->column.type == ColumnType::Float && *found->meta.label != '\0';
    return isNumber ? found : nullptr;
}

std::vector<std::string> propertyKeys(const Scene& scene)
{
    std::vector<std::string> keys;
    keys.reserve(kShownProperties.size() + scene.features.size());
    for (const ShownProperty& each : kShownProperties) {
        keys.emplace_back(each.key);
    }
    for (const PropertyInfo& info : properties()) {
        const std::string_view key = info.column.name;
        if (numberProperty(key) != nullptr && std::ranges::find(keys, key) == keys.end()) {
            keys.emplace_back(key);
        }
    }
    for (const FeatureKind& kind : scene.features) {
        keys.push_back(std::string(kFeatureProperty) + kind.name);
    }
    return keys;
}

Result<void> checkProperty(const Scene& scene, std::string_view key)
{
    const auto keys = propertyKeys(scene);
    if (std::ranges::find(keys, key) != keys.end()) {
        return {};
    }
    std::string all;
    for (const std::string& each : keys) {
        all += (all.empty() ? "" : ", ") + each;
    }
    return Error(QT_TRANSLATE_NOOP("Messages", "People cannot be coloured by “%1”. There are: %2."),
                 std::string(key), all);
}

PropertyPaint paintBy(const Scene& scene, const Population& people, std::string_view key)
{
    using Sort = void (*)(Sorting&, const Subject&);
    static const std::map<std::string_view, Sort> kSorts{{"group", &sortByGroup},
                                                         {"tag", &sortByTag},
                                                         {"clip", &sortByClip},
                                                         {"height", &sortByHeight},
                                                         {"density", &sortByDensity}};
    Sorting sorting(people.size());
    const Subject subject{scene, people};
    if (const FeatureKind* kind = featureOf(scene, key)) {
        sortByFeature(sorting, subject, *kind);
        return std::move(sorting).finish();
    }
    const auto found = kSorts.find(key);
    const PropertyInfo* number = numberProperty(key);
    if (found == kSorts.end() && number != nullptr) {
        sortByNumber(sorting, subject, *number);
    } else {
        (found != kSorts.end() ? found->second : &sortByTemplate)(sorting, subject);
    }
    return std::move(sorting).finish();
}

CrowdFramePtr paintedFrame(const CrowdFrame& frame, const PropertyPaint& paint)
{
    auto painted = std::make_shared<CrowdFrame>(frame);
    const auto tints = painted->population.edit(columns::tint(0));
    for (std::size_t row = 0; row < std::min(tints.size(), paint.classOfRow.size()); ++row) {
        const std::uint32_t color = paint.classes[paint.classOfRow[row]].color;
        tints[row] = {static_cast<std::uint8_t>(color >> 16U),
                      static_cast<std::uint8_t>(color >> 8U), static_cast<std::uint8_t>(color),
                      255};
    }
    return painted;
}

CrowdFramePtr framePaintedBy(const Scene& scene, const CrowdFrame& frame, std::string_view key)
{
    return paintedFrame(frame, paintBy(scene, frame.population, key));
}

std::vector<IndividualId> peopleIn(const PropertyPaint& paint, std::size_t each,
                                   const Population& people)
{
    std::vector<IndividualId> ids;
    for (std::size_t row = 0; row < std::min(people.size(), paint.classOfRow.size()); ++row) {
        if (paint.classOfRow[row] == each) {
            ids.push_back(people.ids()[row]);
        }
    }
    return ids;
}

} // namespace crowd::model
