// SPDX-License-Identifier: MIT
#include "app/python/BrushRules.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "model/scene/NearestPath.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr float kLargest = 1e6F;

/// Collects the first complaint.
class Complaint
{
public:
    void number(const char* name, float value, float low, float high)
    {
        if (!(value >= low && value <= high)) { // also when it is not a number
            std::ostringstream text;
            text.imbue(std::locale::classic());
            text << "brush." << name << " is " << value << "; it must lie from " << low << " to "
                 << high << ".";
            refuse(text.str());
        }
    }
    void range(const char* name, const ValueRange& range, float low, float high)
    {
        number(name, range.low, low, high);
        number(name, range.high, low, high);
        if (range.low > range.high) {
            refuse(std::string("brush.") + name + " runs from the lowest to the highest value.");
        }
    }
    void heading(const char* name, const HeadingSettings& heading)
    {
        number(name, heading.headingRadians, -kLargest, kLargest);
        number(name, heading.spreadRadians, -kLargest, kLargest);
        number(name, heading.turnRadians, -kLargest, kLargest);
        for (int axis = 0; axis < 3; ++axis) {
            number(name, heading.towardsPoint[axis], -kLargest, kLargest);
        }
    }
    void weights(const char* name, const std::vector<ClipWeight>& clips)
    {
        for (const ClipWeight& each : clips) {
            number(name, each.weight, 0.0F, kLargest);
        }
    }
    void refuse(const std::string& message)
    {
        if (m_first.empty()) {
            m_first = message;
        }
    }
    [[nodiscard]] Result<void> result() const
    {
        if (m_first.empty()) {
            return {};
        }
        return Error{m_first};
    }

private:
    std::string m_first;
};

void checkCreation(const Scene& scene, const CreateSettings& create, Complaint& complaint)
{
    for (const TemplateWeight& each : create.mix) {
        if (scene.findTemplate(each.id) == nullptr) {
            complaint.refuse("brush.create.mix names template " + std::to_string(each.id) +
                             ", which the scene does not have: take one of scene.templates.");
        }
        complaint.number("create.mix", each.weight, 0.0F, kLargest);
    }
    constexpr float kSmallestScale = 0.01F;
    constexpr float kLargestScale = 100.0F;
    complaint.number("create.minimal_distance", create.minimalDistance, 0.0F, kLargest);
    complaint.range("create.height", create.height, kSmallestScale, kLargestScale);
    complaint.range("create.girth", create.girth, kSmallestScale, kLargestScale);
    complaint.number("create.palette_strength", create.paletteStrength, 0.0F, 1.0F);
    complaint.range("create.phase", create.phase, 0.0F, 1.0F);
    complaint.weights("create.clips", create.clips);
    complaint.heading("create.facing", create.heading);
    complaint.number("create.density", create.density, 0.0F, 100.0F);
    complaint.number("create.seat_percent", create.seatPercent, 0.0F, 100.0F);
    if (!std::ranges::is_sorted(create.seats.ranks) ||
        !std::ranges::is_sorted(create.seats.wedges)) {
        complaint.refuse("brush.create.seats.ranks and .wedges must be in ascending order.");
    }
}

/// Those of the brush that paints; others keep what was good in other scenes.
void checkNames(const Scene& scene, const BrushSettings& brush, Complaint& complaint)
{
    const auto isKnown = [&scene](const ClipWeight& clip) {
        return std::ranges::any_of(scene.templates, [&clip](const TemplateEntry& entry) {
            return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
        });
    };
    const auto clips = [&](BrushKind kind, const char* name, const std::vector<ClipWeight>& all) {
        if (brush.kind == kind && !all.empty() && std::ranges::none_of(all, isKnown)) {
            complaint.refuse(std::string("brush.") + name + " names the clip \"" +
                             all.front().clip + "\", which no template of the scene has.");
        }
    };
    clips(BrushKind::Create, "create.clips", brush.create.clips);
    clips(BrushKind::Animation, "animation.clips", brush.animation.clips);
    clips(BrushKind::Style, "style.clips", brush.style.clips);
    const PathId path = brush.walk.path;
    if (brush.kind == BrushKind::Walk && path != 0 && path != kNearestPath &&
        scene.findPath(path) == nullptr) {
        complaint.refuse("brush.walk.path is " + std::to_string(path) +
                         ", which the scene does not have: take one of environment[\"paths\"].");
    }
}

void checkProperties(const BrushSettings& brush, Complaint& complaint)
{
    complaint.number("removal.percent", brush.removal.percent, 0.0F, 100.0F);
    complaint.number("colour.strength", brush.colour.strength, 0.0F, 1.0F);
    if (brush.colour.colors.empty()) {
        complaint.refuse("brush.colour.colors must hold at least one colour.");
    }
    complaint.heading("orientation.facing", brush.orientation.heading);
    complaint.weights("animation.clips", brush.animation.clips);
    complaint.range("animation.phase", brush.animation.phase, 0.0F, 1.0F);
    complaint.range("animation.speed", brush.animation.speed, 0.0F, 100.0F);
    complaint.range("walk.speed", brush.walk.speed, 0.0F, kMaxWalkingSpeed);
    complaint.weights("style.clips", brush.style.clips);
    complaint.range("style.speed", brush.style.speed, 0.0F, kMaxWalkingSpeed);
    complaint.number("tag", brush.tag.tag, 0.0F, static_cast<float>(kTagCount - 1));
}

} // namespace

/// Python makes members of an enumeration of any number.
void checkChoices(const BrushSettings& brush, Complaint& complaint)
{
    const auto choice = [&complaint](const char* name, auto value, auto last) {
        if (value > last) {
            complaint.refuse(std::string("brush.") + name + " is none of the choices there are.");
        }
    };
    choice("kind", brush.kind, BrushKind::Style);
    if (brush.kind == BrushKind::Event || brush.kind == BrushKind::Path ||
        brush.kind == BrushKind::Environment) {
        complaint.refuse("A brush of this kind makes no strokes in scripts: send events with "
                         "session.send, and change places and paths with set_environment.");
    }
    choice("selection", brush.selection, BrushSelection::Rectangle);
    choice("operator", brush.op, BrushOperator::Gradient);
    choice("create.facing.mode", brush.create.heading.mode, HeadingMode::TowardsViewer);
    choice("orientation.facing.mode", brush.orientation.heading.mode, HeadingMode::TowardsViewer);
}

Result<void> checkBrush(const Scene& scene, const BrushSettings& brush)
{
    constexpr float kHighestRate = 10'000.0F;
    Complaint complaint;
    checkChoices(brush, complaint);
    complaint.number("radius", brush.radiusPixels, kMinRadiusPixels, kMaxRadiusPixels);
    complaint.number("rate", brush.ratePerSecond, 0.0F, kHighestRate);
    complaint.number("flow", brush.flow, 0.0F, 1.0F);
    for (const float weight : brush.distribution.weights) {
        complaint.number("distribution", weight, 0.0F, kLargest);
    }
    checkCreation(scene, brush.create, complaint);
    checkProperties(brush, complaint);
    checkNames(scene, brush, complaint);
    return complaint.result();
}

} // namespace crowd::app
