// SPDX-License-Identifier: MIT
#include "app/record/StrokeScript.h"

#include "app/record/ScriptText.h"

namespace crowd::app {

using namespace model;

namespace {

struct BrushName
{
    const char* variable;
    const char* kind;
};

BrushName nameOf(BrushKind kind)
{
    switch (kind) {
    case BrushKind::Create:
        return {"create_brush", "CREATE"};
    case BrushKind::Delete:
        return {"delete_brush", "DELETE"};
    case BrushKind::Colour:
        return {"colour_brush", "COLOUR"};
    case BrushKind::Orientation:
        return {"orientation_brush", "ORIENTATION"};
    case BrushKind::Walk:
        return {"walk_brush", "WALK"};
    case BrushKind::Style:
        return {"style_brush", "STYLE"};
    case BrushKind::Tag:
        return {"tag_brush", "TAG"};
    case BrushKind::Untag:
        return {"untag_brush", "UNTAG"};
    case BrushKind::Animation:
    case BrushKind::Event:
    case BrushKind::Path:
    case BrushKind::Environment:
    case BrushKind::Script:
        break;
    }
    return {"animation_brush", "ANIMATION"};
}

std::string textOf(BrushSelection selection)
{
    constexpr const char* kNames[] = {"POINT", "SPRAY", "ALL_IN_CIRCLE", "RECTANGLE"};
    return std::string("crowdbrush.Selection.") + kNames[static_cast<int>(selection)];
}

std::string textOf(BrushOperator op)
{
    constexpr const char* kNames[] = {"UNIFORM", "RANDOM", "GRADIENT"};
    return std::string("crowdbrush.Operator.") + kNames[static_cast<int>(op)];
}

std::string textOf(HeadingMode mode)
{
    constexpr const char* kNames[] = {"DIRECTION", "RANDOM", "ALONG_STROKE", "TOWARDS_POINT",
                                      "TOWARDS_VIEWER"};
    return std::string("crowdbrush.Facing.") + kNames[static_cast<int>(mode)];
}

std::string textOf(const ValueRange& range)
{
    return '(' + pythonText(range.low) + ", " + pythonText(range.high) + ')';
}

std::string textOf(const std::vector<int>& numbers)
{
    std::vector<std::string> items;
    items.reserve(numbers.size());
    for (const int each : numbers) {
        items.push_back(pythonText(each));
    }
    return pythonList(items, 0);
}

std::string textOf(const std::vector<PaintColor>& colors)
{
    std::vector<std::string> items;
    items.reserve(colors.size());
    for (const PaintColor& each : colors) {
        items.push_back('(' + pythonText(each[0]) + ", " + pythonText(each[1]) + ", " +
                        pythonText(each[2]) + ')');
    }
    return pythonList(items, 0);
}

std::string textOf(const std::vector<ClipWeight>& clips)
{
    std::vector<std::string> items;
    items.reserve(clips.size());
    for (const ClipWeight& each : clips) {
        items.push_back(pythonText(each.clip) + ": " + pythonText(each.weight));
    }
    return pythonList(items, 0, '{', '}');
}

std::string textOf(const std::vector<TemplateWeight>& mix)
{
    std::vector<std::string> items;
    items.reserve(mix.size());
    for (const TemplateWeight& each : mix) {
        items.push_back(pythonText(each.id) + ": " + pythonText(each.weight));
    }
    return pythonList(items, 0, '{', '}');
}

std::string textOf(const DistributionCurve& curve)
{
    std::vector<std::string> items;
    for (const float each : curve.weights) {
        items.push_back(pythonText(each));
    }
    return pythonList(items, 0);
}

std::string textOf(const std::optional<bool>& value)
{
    return value ? pythonText(*value) : "None";
}

template<class T>
std::string textOf(const T& value)
{
    return pythonText(value);
}

/// Assignments of what differs between two settings.
class Differences
{
public:
    explicit Differences(std::string variable) : m_variable(std::move(variable)) {}

    template<class T>
    void add(const char* attribute, const T& was, const T& now)
    {
        if (!(was == now)) {
            m_text += m_variable + '.' + attribute + " = " + textOf(now) + '\n';
        }
    }
    void addHeading(const std::string& attribute, const HeadingSettings& was,
                    const HeadingSettings& now)
    {
        add((attribute + ".mode").c_str(), was.mode, now.mode);
        add((attribute + ".heading").c_str(), was.headingRadians, now.headingRadians);
        add((attribute + ".spread").c_str(), was.spreadRadians, now.spreadRadians);
        add((attribute + ".turn").c_str(), was.turnRadians, now.turnRadians);
        add((attribute + ".towards_point").c_str(), was.towardsPoint, now.towardsPoint);
    }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_variable;
    std::string m_text;
};

void addCreation(Differences& all, const CreateSettings& was, const CreateSettings& now)
{
    all.add("create.mix", was.mix, now.mix);
    all.add("create.minimal_distance", was.minimalDistance, now.minimalDistance);
    all.add("create.height", was.height, now.height);
    all.add("create.girth", was.girth, now.girth);
    all.add("create.palette", was.palette, now.palette);
    all.add("create.palette_strength", was.paletteStrength, now.paletteStrength);
    all.add("create.varies_outfit", was.variesOutfit, now.variesOutfit);
    all.add("create.varies_faces", was.variesFaces, now.variesFaces);
    all.add("create.varies_parts", was.variesParts, now.variesParts);
    all.add("create.phase", was.phase, now.phase);
    all.add("create.clips", was.clips, now.clips);
    all.addHeading("create.facing", was.heading, now.heading);
    all.add("create.density", was.density, now.density);
    all.add("create.seat_percent", was.seatPercent, now.seatPercent);
    all.add("create.seats.is_on", was.seats.isOn, now.seats.isOn);
    all.add("create.seats.ranks", was.seats.ranks, now.seats.ranks);
    all.add("create.seats.wedges", was.seats.wedges, now.seats.wedges);
    all.add("create.anywhere", was.anywhere, now.anywhere);
}

void addReach(Differences& all, const BrushSettings& was, const BrushSettings& now)
{
    all.add("selection", was.selection, now.selection);
    all.add("operator", was.op, now.op);
    all.add("radius", was.radiusPixels, now.radiusPixels);
    all.add("rate", was.ratePerSecond, now.ratePerSecond);
    all.add("through", was.through, now.through);
    all.add("build_up", was.buildUp, now.buildUp);
    all.add("flow", was.flow, now.flow);
    all.add("pressure_size", was.pressureSize, now.pressureSize);
    all.add("pressure_rate", was.pressureRate, now.pressureRate);
    all.add("distribution", was.distribution, now.distribution);
}

void addChanges(Differences& all, const BrushSettings& was, const BrushSettings& now)
{
    all.add("removal.percent", was.removal.percent, now.removal.percent);
    all.add("colour.slot", was.colour.slot, now.colour.slot);
    all.add("colour.spares_body", was.colour.sparesBody, now.colour.sparesBody);
    all.add("colour.replaces", was.colour.replaces, now.colour.replaces);
    all.add("colour.colors", was.colour.colors, now.colour.colors);
    all.add("colour.strength", was.colour.strength, now.colour.strength);
    all.add("colour.blends", was.colour.blends, now.colour.blends);
    all.add("colour.each_slot_apart", was.colour.eachSlotApart, now.colour.eachSlotApart);
    all.addHeading("orientation.facing", was.orientation.heading, now.orientation.heading);
    all.add("animation.clips", was.animation.clips, now.animation.clips);
    all.add("animation.sets_phase", was.animation.setsPhase, now.animation.setsPhase);
    all.add("animation.phase", was.animation.phase, now.animation.phase);
    all.add("animation.sets_speed", was.animation.setsSpeed, now.animation.setsSpeed);
    all.add("animation.speed", was.animation.speed, now.animation.speed);
    all.add("walk.sets_path", was.walk.setsPath, now.walk.setsPath);
    all.add("walk.path", was.walk.path, now.walk.path);
    all.add("walk.sets_speed", was.walk.setsSpeed, now.walk.setsSpeed);
    all.add("walk.speed", was.walk.speed, now.walk.speed);
    all.add("style.sets_style", was.style.setsStyle, now.style.setsStyle);
    all.add("style.clips", was.style.clips, now.style.clips);
    all.add("style.sets_speed", was.style.setsSpeed, now.style.setsSpeed);
    all.add("style.speed", was.style.speed, now.style.speed);
    all.add("tag", was.tag.tag, now.tag.tag);
}

std::string points(const std::vector<PointerInput>& inputs)
{
    std::vector<std::string> rows;
    for (const PointerInput& each : inputs) {
        const glm::dvec2 at = each.pixels();
        rows.push_back('(' + pythonText(at.x) + ", " + pythonText(at.y) + ", " +
                       pythonText(each.pressure) + ", " + pythonText(each.timeSeconds) + ", " +
                       pythonText(each.shownSeconds) + ')');
    }
    return pythonList(rows, 0);
}

} // namespace

std::string StrokeScript::brush(const BrushSettings& settings)
{
    const BrushName name = nameOf(settings.kind);
    std::string text;
    const auto known = m_said.find(settings.kind);
    BrushSettings was;
    if (known == m_said.end()) {
        text = std::string(name.variable) + " = crowdbrush.Brush(crowdbrush.BrushKind." +
               name.kind + ")\n";
        // Said whatever it is: it is what brushes of scripts and of the window begin with
        // differently.
        was.create.anywhere =
            settings.kind == BrushKind::Create ? !settings.create.anywhere : was.create.anywhere;
    } else {
        was = known->second;
    }
    Differences all(name.variable);
    addReach(all, was, settings);
    addCreation(all, was.create, settings.create);
    addChanges(all, was, settings);
    m_said[settings.kind] = settings;
    return text + all.text();
}

std::string StrokeScript::write(const RecordedStroke& stroke)
{
    std::string text = brush(stroke.settings);
    if (m_camera != stroke.camera) {
        m_camera = stroke.camera;
        text += "view = " + pythonText(stroke.camera) + '\n';
    }
    return text + "scene.stroke(" + nameOf(stroke.settings.kind).variable + ", " +
           points(stroke.inputs) + ", camera=view, size=(" + pythonText(stroke.viewSize.x) + ", " +
           pythonText(stroke.viewSize.y) + "), seed=" + pythonText(stroke.seed) + ")\n";
}

} // namespace crowd::app
