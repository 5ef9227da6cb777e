// SPDX-License-Identifier: MIT
#include <cmath>

#include "app/python/Binding.h"
#include "app/python/PythonBrush.h"
#include "model/scene/NearestPath.h"

namespace crowd::app {

using namespace model;

namespace {

using Range = std::pair<float, float>;

/// A range as the pair that scripts see. Owner: the bound class, where it is not the member's.
template<class Owner, class Base>
auto rangeGetter(ValueRange Base::*member)
{
    return
        [member](const Owner& owner) { return Range((owner.*member).low, (owner.*member).high); };
}
template<class Owner, class Base>
auto rangeSetter(ValueRange Base::*member)
{
    return [member](Owner& owner, const Range& range) {
        owner.*member = {range.first, range.second};
    };
}
template<class Owner>
auto rangeGetter(ValueRange Owner::*member)
{
    return rangeGetter<Owner, Owner>(member);
}
template<class Owner>
auto rangeSetter(ValueRange Owner::*member)
{
    return rangeSetter<Owner, Owner>(member);
}

/// Weighted clips as the dict of name → weight that scripts see.
py::dict clipsAsDict(const std::vector<ClipWeight>& weights)
{
    py::dict clips;
    for (const ClipWeight& each : weights) {
        clips[py::str(each.clip)] = each.weight;
    }
    return clips;
}

float weightFrom(const py::handle& given)
{
    const double weight = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred() != nullptr || !std::isfinite(weight) || weight < 0.0) {
        PyErr_Clear();
        throw ScriptError("A weight is a number from 0 on, not " + shortly(given) + ".");
    }
    return static_cast<float>(weight);
}

std::vector<ClipWeight> clipsFromDict(const py::dict& clips)
{
    std::vector<ClipWeight> weights;
    for (const auto& [name, weight] : clips) {
        if (!py::isinstance<py::str>(name)) {
            throw ScriptError("Clips are given by name, not by " + shortly(name) + ".");
        }
        weights.push_back({name.cast<std::string>(), weightFrom(weight)});
    }
    return weights;
}

py::dict mixOf(const PythonCreateSettings& create)
{
    py::dict mix;
    for (const TemplateWeight& each : create.mix) {
        mix[py::int_(each.id)] = each.weight;
    }
    return mix;
}

void setMix(PythonCreateSettings& create, const py::dict& mix)
{
    std::vector<TemplateWeight> weights;
    std::vector<std::weak_ptr<ScriptScene>> owners;
    for (const auto& [key, weight] : mix) {
        ScenePtr owner;
        if (py::isinstance<TemplateHandle>(key)) {
            owner = key.cast<const TemplateHandle&>().owner;
            owners.push_back(owner);
        }
        weights.push_back({templateIdOf(owner, key), weightFrom(weight)});
    }
    create.mix = std::move(weights);
    create.owners = std::move(owners);
}

void bindEnums(py::module_& module)
{
    py::enum_<BrushKind>(module, "BrushKind", "What a brush does.")
        .value("CREATE", BrushKind::Create)
        .value("DELETE", BrushKind::Delete)
        .value("COLOUR", BrushKind::Colour)
        .value("ORIENTATION", BrushKind::Orientation)
        .value("ANIMATION", BrushKind::Animation)
        .value("WALK", BrushKind::Walk)
        .value("STYLE", BrushKind::Style)
        .value("TAG", BrushKind::Tag)
        .value("UNTAG", BrushKind::Untag)
        .value("SCRIPT", BrushKind::Script);
    py::enum_<BrushSelection>(module, "Selection", "Screen area to individuals or points.")
        .value("POINT", BrushSelection::Point, "What is under the cursor.")
        .value("SPRAY", BrushSelection::Spray, "Random points of a circle, so many a second.")
        .value("ALL_IN_CIRCLE", BrushSelection::AllInCircle)
        .value("RECTANGLE", BrushSelection::Rectangle, "Between press and release.");
    py::enum_<BrushOperator>(module, "Operator", "How values vary over what is selected.")
        .value("UNIFORM", BrushOperator::Uniform)
        .value("RANDOM", BrushOperator::Random)
        .value("GRADIENT", BrushOperator::Gradient);
    py::enum_<HeadingMode>(module, "Facing", "Which way: a direction, or after something.")
        .value("DIRECTION", HeadingMode::Direction)
        .value("RANDOM", HeadingMode::Random)
        .value("ALONG_STROKE", HeadingMode::AlongStroke)
        .value("TOWARDS_POINT", HeadingMode::TowardsPoint)
        .value("TOWARDS_VIEWER", HeadingMode::TowardsViewer);
}

void bindParts(py::module_& module)
{
    py::class_<HeadingSettings>(module, "HeadingSettings", "Which way people face. Radians.")
        .def_readwrite("mode", &HeadingSettings::mode)
        .def_readwrite("heading", &HeadingSettings::headingRadians, "Radians, 0 faces +Z.")
        .def_readwrite("spread", &HeadingSettings::spreadRadians, "Radians to each side.")
        .def_readwrite("turn", &HeadingSettings::turnRadians,
                       "Radians, added where the heading follows something else.")
        .def_property(
            "towards_point",
            [](const HeadingSettings& h) {
                return std::array<float, 3>{h.towardsPoint.x, h.towardsPoint.y, h.towardsPoint.z};
            },
            [](HeadingSettings& h, const std::array<float, 3>& p) {
                h.towardsPoint = {p[0], p[1], p[2]};
            },
            "World frame, metres.");
    py::class_<SeatGridSettings>(module, "SeatGridSettings", "Which seats people come onto.")
        .def_readwrite("is_on", &SeatGridSettings::isOn, "Create on free seats only.")
        .def_readwrite("ranks", &SeatGridSettings::ranks, "Empty: all. Assign a whole list.")
        .def_readwrite("wedges", &SeatGridSettings::wedges, "Empty: all. Assign a whole list.");
    py::class_<PythonCreateSettings>(module, "CreateSettings", "Who is created, and how.")
        .def_property("mix", &mixOf, &setMix, "Template (or its id) → weight.")
        .def_readwrite("minimal_distance", &CreateSettings::minimalDistance, "Metres.")
        .def_property("height", rangeGetter<PythonCreateSettings>(&CreateSettings::height),
                      rangeSetter<PythonCreateSettings>(&CreateSettings::height),
                      "Scale, (lowest, highest).")
        .def_property("girth", rangeGetter<PythonCreateSettings>(&CreateSettings::girth),
                      rangeSetter<PythonCreateSettings>(&CreateSettings::girth),
                      "Scale, (lowest, highest).")
        .def_readwrite("palette", &CreateSettings::palette,
                       "List of (red, green, blue), 0–255. Assign a whole list.")
        .def_readwrite("palette_strength", &CreateSettings::paletteStrength, "0–1.")
        .def_readwrite("varies_outfit", &CreateSettings::variesOutfit,
                       "Any material of each slot, else the first.")
        .def_readwrite("varies_faces", &CreateSettings::variesFaces,
                       "Any skin, hair and face; None: as varies_outfit.")
        .def_readwrite("varies_parts", &CreateSettings::variesParts,
                       "Each part worn or not, else as the template has them.")
        .def_property("phase", rangeGetter<PythonCreateSettings>(&CreateSettings::phase),
                      rangeSetter<PythonCreateSettings>(&CreateSettings::phase))
        .def_property(
            "clips", [](const PythonCreateSettings& owner) { return clipsAsDict(owner.clips); },
            [](PythonCreateSettings& owner, const py::dict& clips) {
                owner.clips = clipsFromDict(clips);
            },
            "Name → weight; empty: what suits the place.")
        .def_readwrite("facing", &CreateSettings::heading)
        .def_readwrite("density", &CreateSettings::density, "Persons per m², rectangles.")
        .def_readwrite("seat_percent", &CreateSettings::seatPercent, "Per cent, rectangles.")
        .def_readwrite("seats", &CreateSettings::seats)
        .def_readwrite("anywhere", &CreateSettings::anywhere,
                       "Also on roofs, trees and wherever else nobody can walk to. False: only "
                       "where people can walk, which takes seconds to find on large stages.");
}

void bindChanges(py::module_& module)
{
    py::class_<DeleteSettings>(module, "DeleteSettings", "How many are removed.")
        .def_readwrite("percent", &DeleteSettings::percent, "Of those in the area.");
    py::class_<ColourSettings>(module, "ColourSettings", "Tints of slots.")
        .def_readwrite("slot", &ColourSettings::slot, "By name; empty: all tintable slots.")
        .def_readwrite("spares_body", &ColourSettings::sparesBody,
                       "Of all slots, not skin, hair and face, where there is anything else.")
        .def_readwrite("replaces", &ColourSettings::replaces,
                       "The colour itself, whatever the material's; else it multiplies that one.")
        .def_readwrite("colors", &ColourSettings::colors,
                       "List of (red, green, blue), 0–255. Assign a whole list.")
        .def_readwrite("strength", &ColourSettings::strength, "0–1.")
        .def_readwrite("blends", &ColourSettings::blends)
        .def_readwrite("each_slot_apart", &ColourSettings::eachSlotApart);
    py::class_<OrientationSettings>(module, "OrientationSettings", "Which way people are turned.")
        .def_readwrite("facing", &OrientationSettings::heading);
    py::class_<AnimationSettings>(module, "AnimationSettings", "What people do.")
        .def_property(
            "clips", [](const AnimationSettings& owner) { return clipsAsDict(owner.clips); },
            [](AnimationSettings& owner, const py::dict& clips) {
                owner.clips = clipsFromDict(clips);
            },
            "Name → weight; empty: unchanged.")
        .def_readwrite("sets_phase", &AnimationSettings::setsPhase)
        .def_property("phase", rangeGetter(&AnimationSettings::phase),
                      rangeSetter(&AnimationSettings::phase))
        .def_readwrite("sets_speed", &AnimationSettings::setsSpeed)
        .def_property("speed", rangeGetter(&AnimationSettings::speed),
                      rangeSetter(&AnimationSettings::speed));
}

void bindWalk(py::module_& module)
{
    module.attr("NEAREST_PATH") = kNearestPath;
    py::class_<WalkSettings>(module, "WalkSettings", "Which path people follow, and how fast.")
        .def_readwrite("sets_path", &WalkSettings::setsPath)
        .def_readwrite(
            "path", &WalkSettings::path,
            "Id of a path; 0: follow none; NEAREST_PATH: the one that each is nearest to.")
        .def_readwrite("sets_speed", &WalkSettings::setsSpeed)
        .def_property("speed", rangeGetter(&WalkSettings::speed), rangeSetter(&WalkSettings::speed),
                      "m/s, (lowest, highest).");
    py::class_<StyleSettings>(module, "StyleSettings", "How people walk, and how fast.")
        .def_readwrite("sets_style", &StyleSettings::setsStyle)
        .def_property(
            "clips", [](const StyleSettings& owner) { return clipsAsDict(owner.clips); },
            [](StyleSettings& owner, const py::dict& clips) { owner.clips = clipsFromDict(clips); },
            "Name → weight of clips to walk with; empty: what fits the speed.")
        .def_readwrite("sets_speed", &StyleSettings::setsSpeed)
        .def_property("speed", rangeGetter(&StyleSettings::speed),
                      rangeSetter(&StyleSettings::speed), "m/s, (lowest, highest).");
}

PythonBrush brushOf(BrushKind kind)
{
    PythonBrush brush;
    brush.kind = kind;
    return brush;
}

} // namespace

void bindBrushes(py::module_& module)
{
    bindEnums(module);
    bindParts(module);
    bindChanges(module);
    bindWalk(module);
    py::class_<PythonBrush>(module, "Brush", "A brush with the editor's own settings.")
        .def(py::init(&brushOf), py::arg("kind"))
        .def(
            "copy", [](const PythonBrush& brush) { return PythonBrush(brush); },
            "Another one, set the same.")
        .def(
            "__eq__",
            [](const PythonBrush& a, const PythonBrush& b) { return a.settings() == b.settings(); },
            py::is_operator())
        .def_readwrite("kind", &BrushSettings::kind)
        .def_readwrite("selection", &BrushSettings::selection)
        .def_readwrite("operator", &BrushSettings::op)
        .def_readwrite("radius", &BrushSettings::radiusPixels, "Logical pixels.")
        .def_readwrite("rate", &BrushSettings::ratePerSecond, "Spray: points a second.")
        .def_readwrite("through", &BrushSettings::through, "Also those hidden behind others.")
        .def_readwrite("build_up", &BrushSettings::buildUp)
        .def_readwrite("flow", &BrushSettings::flow)
        .def_readwrite("pressure_size", &BrushSettings::pressureSize)
        .def_readwrite("pressure_rate", &BrushSettings::pressureRate)
        .def_property(
            "distribution", [](const PythonBrush& b) { return b.distribution.weights; },
            [](PythonBrush& b, const std::array<float, 16>& weights) {
                b.distribution.weights = weights;
            },
            "16 weights over the range, for the random operator.")
        .def_readwrite("create", &PythonBrush::creation)
        .def_readwrite("removal", &BrushSettings::removal)
        .def_readwrite("colour", &BrushSettings::colour)
        .def_readwrite("orientation", &BrushSettings::orientation)
        .def_readwrite("animation", &BrushSettings::animation)
        .def_readwrite("walk", &BrushSettings::walk)
        .def_readwrite("style", &BrushSettings::style)
        .def_property(
            "tag", [](const PythonBrush& b) { return b.tag.tag; },
            [](PythonBrush& b, std::uint8_t tag) { b.tag.tag = tag; },
            "Of the tag brushes: the bit, 0–63.");
}

} // namespace crowd::app
