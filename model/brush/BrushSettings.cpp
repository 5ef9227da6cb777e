// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

#include <algorithm>
#include <cmath>

#include "model/brush/ColumnWriting.h"
#include "model/brush/PropertyChange.h"

namespace crowd::model {

namespace {

template<class Settings>
bool doesOperatorFollowLine(const BrushSettings& brush)
{
    if constexpr (requires { Settings::kHasOperator; }) {
        return Settings::kHasOperator && operatorInfo(brush.op).followsLine;
    } else {
        return operatorInfo(brush.op).followsLine;
    }
}

/// Those of a kind that say nothing of their own have one number in common: the spray's rate.
template<class Settings>
BrushType typeOf()
{
    BrushType type{Settings::kInfo,
                   fieldsOf<Settings>(),
                   typeid(Settings),
                   [] { return BrushChange(Settings()); },
                   [](BrushSettings& brush) { brush.selection = BrushSelection::AllInCircle; },
                   nullptr,
                   &rateOf,
                   [](BrushSettings& brush, float value) { brush.ratePerSecond = value; },
                   nullptr,
                   &doesOperatorFollowLine<Settings>,
                   [](const BrushSettings& brush) -> const void* { return &brush.as<Settings>(); },
                   [](BrushSettings& brush) -> void* { return &brush.as<Settings>(); }};
    if constexpr (requires(BrushSettings & brush) { Settings::prepare(brush); }) {
        type.prepare = [](BrushSettings& brush) { Settings::prepare(brush); };
    }
    if constexpr (requires { Settings::columnRanges(); }) {
        type.change = [](const ChangeRequest& request) {
            return changeRanges(request, request.settings.as<Settings>());
        };
        type.followsLine = [](const BrushSettings& brush) {
            const auto& settings = brush.as<Settings>();
            return std::ranges::any_of(Settings::columnRanges(), [&](const auto& range) {
                return settings.*range.isOn && operatorInfo(settings.*range.op).followsLine;
            });
        };
        type.take = [](BrushSettings& brush, const TakenFrom& from) {
            return takeRanges(brush.as<Settings>(), from);
        };
    } else if constexpr (requires(const ChangeRequest& request) { Settings::change(request); }) {
        type.change = [](const ChangeRequest& request) { return Settings::change(request); };
    }
    if constexpr (requires(BrushSettings & brush, const TakenFrom& from) {
                      Settings::take(brush, from);
                  }) {
        type.take = [](BrushSettings& brush, const TakenFrom& from) {
            return Settings::take(brush, from);
        };
    }
    if constexpr (requires(BrushSettings & brush) { Settings::mainNumber(brush); }) {
        type.mainNumber = [](const BrushSettings& brush) { return Settings::mainNumber(brush); };
        type.setMainNumber = [](BrushSettings& brush, float value) {
            Settings::setMainNumber(brush, value);
        };
    }
    return type;
}

const BrushInfo& infoOf(const BrushSettings& brush)
{
    return brushType(brush.kind()).info;
}

/// Whether dabs are applied one by one.
bool isDabbed(const BrushSettings& brush)
{
    return !brush.hasWholeArea() && !brush.followsLine();
}

template<class Brush>
auto headingIn(Brush& brush) -> decltype(brush.heading())
{
    if (auto* create = brush.template find<CreateSettings>()) {
        return &create->heading;
    }
    auto* orientation = brush.template find<OrientationSettings>();
    return orientation != nullptr ? &orientation->heading : nullptr;
}

template<class Brush>
auto placeIn(Brush& brush) -> decltype(brush.place())
{
    if (auto* path = brush.template find<PathSettings>()) {
        return path;
    }
    return brush.template find<EnvironmentSettings>();
}

} // namespace

BrushSettings::BrushSettings(BrushKind kind) : change(brushType(kind).make()) {}

void BrushSettings::setKind(BrushKind kind)
{
    if (kind != this->kind()) {
        change = brushType(kind).make();
    }
}

HeadingSettings* BrushSettings::heading()
{
    return headingIn(*this);
}

const HeadingSettings* BrushSettings::heading() const
{
    return headingIn(*this);
}

PlaceSettings* BrushSettings::place()
{
    return placeIn(*this);
}

const PlaceSettings* BrushSettings::place() const
{
    return placeIn(*this);
}

const TagSettings* BrushSettings::tag() const
{
    if (const auto* given = find<TagSettings>()) {
        return given;
    }
    return find<UntagSettings>();
}

MainNumber BrushSettings::mainNumber() const
{
    return brushType(kind()).mainNumber(*this);
}

BrushSettings BrushSettings::withMainNumber(double value) const
{
    BrushSettings changed = *this;
    const MainNumber number = mainNumber();
    // Turning on past the back comes out at the other side.
    const double kept = number.isCyclic ? std::remainder(value, number.high - number.low)
                                        : std::clamp(value, number.low, number.high);
    brushType(kind()).setMainNumber(changed, static_cast<float>(kept));
    return changed;
}

BrushSettings BrushSettings::resized(float deltaPixels) const
{
    BrushSettings changed = *this;
    changed.radiusPixels =
        std::clamp(radiusPixels + deltaPixels, kMinRadiusPixels, kMaxRadiusPixels);
    return changed;
}

bool BrushSettings::followsLine() const
{
    return brushType(kind()).followsLine(*this);
}

bool BrushSettings::isReevaluated() const
{
    const bool asksLine = followsLine() && infoOf(*this).family == StrokeFamily::People &&
                          !find<DeleteSettings>() && !find<EventSettings>();
    return hasWholeArea() || asksLine || infoOf(*this).isTogether;
}

std::span<const BrushType> brushTypes()
{
#define CROWD_BRUSH_TYPE(name, settings) typeOf<settings>(),
    static const std::array<BrushType, kBrushCount> kTypes{CROWD_BRUSHES(CROWD_BRUSH_TYPE)};
#undef CROWD_BRUSH_TYPE
    return kTypes;
}

const BrushType& brushType(BrushKind kind)
{
    assert(static_cast<std::size_t>(kind) < kBrushCount);
    return brushTypes()[static_cast<std::size_t>(kind)];
}

std::span<const BrushKind> shownBrushes()
{
    static const auto kShown = [] {
        std::array<BrushKind, kBrushCount> kinds{};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            kinds[i] = static_cast<BrushKind>(i);
        }
        std::ranges::stable_sort(kinds, {}, [](BrushKind kind) {
            return std::pair(brushType(kind).info.section, brushType(kind).info.order);
        });
        return kinds;
    }();
    return kShown;
}

BrushSettings initialBrush(BrushKind kind)
{
    BrushSettings brush(kind);
    brushType(kind).prepare(brush);
    return brush;
}

MainNumber rateOf(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Rate, a second"),
            QT_TRANSLATE_NOOP("BrushTexts", "Rate: %1 a second"),
            brush.ratePerSecond,
            1.0,
            500.0,
            5.0,
            0};
}

ValueRange movedTo(float low, const ValueRange& range)
{
    return {low, std::min(kMaxWalkingSpeed, std::max(low, low + range.high - range.low))};
}

bool hasReach(const BrushSettings& brush)
{
    return infoOf(brush).family == StrokeFamily::People;
}

bool canBuildUp(const BrushSettings& brush)
{
    return infoOf(brush).buildsUp && isDabbed(brush);
}

bool canFlow(const BrushSettings& brush)
{
    return infoOf(brush).flows && isDabbed(brush);
}

bool fillsArea(const FieldContext& context)
{
    return context.brush != nullptr && (context.brush->selection == BrushSelection::AllInCircle ||
                                        context.brush->hasWholeArea());
}

bool takesShare(const FieldContext& context)
{
    return context.brush != nullptr && context.brush->takesShare();
}

bool isDrawn(const FieldContext& context)
{
    return context.brush != nullptr && operatorInfo(context.brush->op).usesDistribution;
}

bool isGradient(const FieldContext& context)
{
    return context.brush != nullptr && operatorInfo(context.brush->op).followsLine;
}

bool spreads(const HeadingSettings& heading, const FieldContext& context)
{
    const bool isTurned = context.brush != nullptr && isDrawn(context) &&
                          context.brush->find<OrientationSettings>() != nullptr;
    return heading.mode == HeadingMode::Random || isTurned;
}

double DistributionCurve::sample(double u) const
{
    double total = 0.0;
    for (const float weight : weights) {
        total += std::max(0.0F, weight);
    }
    if (!(total > 0.0)) {
        return u;
    }
    double left = u * total;
    for (std::size_t bin = 0; bin < weights.size(); ++bin) {
        const double weight = std::max(0.0F, weights[bin]);
        if (left < weight) {
            return (static_cast<double>(bin) + left / weight) / static_cast<double>(weights.size());
        }
        left -= weight;
    }
    return 1.0;
}

} // namespace crowd::model
