// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/scene/NearestPath.h"
#include "widgets/docks/BrushFormParts.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

namespace {

using model::BrushKind;
using model::BrushSettings;
using model::ValueRange;

} // namespace

void addWalk(BrushForm& form, const EditorState& state)
{
    QStringList names{BrushForm::tr("None: stay"), BrushForm::tr("The nearest")};
    std::vector<model::PathId> ids{0, model::kNearestPath};
    for (const model::Path& path : state.scene().paths) {
        names << QString::fromStdString(path.name);
        ids.push_back(path.id);
    }
    form.beginSection(BrushForm::tr("Path"), QStringLiteral("path"));
    addFlag(form, BrushForm::tr("Change the path"),
            BrushForm::tr("Characters walk along it when it plays"),
            [](BrushSettings& s) -> bool& { return s.walk.setsPath; });
    form.addChoice(
        BrushForm::tr("Follow"), names,
        [ids](const BrushSettings& s) {
            const auto found = std::ranges::find(ids, s.walk.path);
            return found == ids.end() ? 0 : static_cast<int>(found - ids.begin());
        },
        [ids](BrushSettings& s, int i) { s.walk.path = ids[static_cast<std::size_t>(i)]; },
        [](const BrushSettings& s) { return s.walk.setsPath; });
    form.beginSection(BrushForm::tr("Speed"), QStringLiteral("speed"));
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.walk.setsSpeed; });
    form.addRange(
        BrushForm::tr("Walking"), {0.0, 6.0, 0.1, 2, BrushForm::tr(" m/s"), false},
        [](BrushSettings& s) -> ValueRange& { return s.walk.speed; },
        [](const BrushSettings& s) { return s.walk.setsSpeed; });
}

void addStyle(BrushForm& form)
{
    form.beginSection(BrushForm::tr("Walk with"), QStringLiteral("style"));
    addFlag(form, BrushForm::tr("Change how they walk"),
            BrushForm::tr("With which clip characters walk. None: what fits the speed. A clip that "
                          "stays in place is left out."),
            [](BrushSettings& s) -> bool& { return s.style.setsStyle; });
    form.addClips(
        [](BrushSettings & s) -> auto& { return s.style.clips; }, ClipsOnOffer::Moving);
    form.beginSection(BrushForm::tr("Speed"), QStringLiteral("speed"));
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.style.setsSpeed; });
    form.addRange(
        BrushForm::tr("Walking"), {0.0, 6.0, 0.1, 2, BrushForm::tr(" m/s"), false},
        [](BrushSettings& s) -> ValueRange& { return s.style.speed; },
        [](const BrushSettings& s) { return s.style.setsSpeed; });
}

void addTag(BrushForm& form, const EditorState& state)
{
    form.beginSection(BrushForm::tr("Tag"), QStringLiteral("tag"));
    form.addSlider(
        BrushForm::tr("Tag"), {1.0, 64.0, 1.0, 0, {}, false},
        [](const BrushSettings& s) { return s.tag.tag + 1.0; },
        [](BrushSettings& s, double v) { s.tag.tag = static_cast<std::uint8_t>(v - 1.0); });
    form.addSwatch([&state](const BrushSettings& s) { return tagColor(state.scene(), s.tag.tag); },
                   [&state](const BrushSettings& s) {
                       const auto& tags = state.scene().tags;
                       const auto named = std::ranges::find(tags, s.tag.tag, &model::TagName::bit);
                       return named != tags.end() && !named->name.empty()
                                  ? QString::fromStdString(named->name)
                                  : BrushForm::tr("no name yet; the Rules panel gives it one");
                   });
    const std::vector<model::TagName>& tags = state.scene().tags;
    if (tags.empty()) {
        return;
    }
    QStringList names;
    std::vector<std::uint8_t> bits;
    for (const model::TagName& tag : tags) {
        names << QString::fromStdString(tag.name);
        bits.push_back(tag.bit);
    }
    form.addChoice(
        BrushForm::tr("Named"), names,
        [bits](const BrushSettings& s) {
            const auto found = std::ranges::find(bits, s.tag.tag);
            return found == bits.end() ? -1 : static_cast<int>(found - bits.begin());
        },
        [bits](BrushSettings& s, int i) { s.tag.tag = bits[static_cast<std::size_t>(i)]; });
}

void addEvent(BrushForm& form, const EditorState& state)
{
    form.beginSection(BrushForm::tr("Event"), QStringLiteral("event"));
    form.addText(
        BrushForm::tr("Name"), [](const BrushSettings& s) { return s.event.name; },
        [](BrushSettings& s, const std::string& text) { s.event.name = text; });
    QStringList names;
    for (const model::Rule& rule : state.scene().rules) {
        const QString name = QString::fromStdString(rule.trigger.event);
        if (rule.trigger.kind == model::TriggerKind::Event && !names.contains(name)) {
            names << name;
        }
    }
    if (!names.isEmpty()) {
        form.addChoice(
            BrushForm::tr("Known"), names,
            [names](const BrushSettings& s) {
                return static_cast<int>(names.indexOf(QString::fromStdString(s.event.name)));
            },
            [names](BrushSettings& s, int i) { s.event.name = names[i].toStdString(); });
    }
    addFloat(form, BrushForm::tr("Number"), {-10.0, 10.0, 0.1, 1, {}, false}, 1.0,
             [](BrushSettings& s) -> float& { return s.event.payload; });
    form.addNote(
        BrushForm::tr("Characters under the brush hear the event while it plays. Rules say "
                      "what they do then; the number can be a walking speed."));
}

void addPlaces(BrushForm& form, BrushKind kind)
{
    addFloat(form, BrushForm::tr("Radius"), {0.1, 50.0, 0.25, 2, BrushForm::tr(" m"), true}, 1.0,
             [](BrushSettings& s) -> float& { return s.place.radiusMetres; });
    addFlag(form, BrushForm::tr("Anywhere"),
            BrushForm::tr("Also on roofs, trees and wherever else nobody can walk to"),
            [](BrushSettings& s) -> bool& { return s.place.anywhere; });
    if (kind == BrushKind::Environment) {
        form.addChoice(
            BrushForm::tr("What"), placeRoleNames(),
            [](const BrushSettings& s) { return static_cast<int>(s.place.role); },
            [](BrushSettings& s, int i) { s.place.role = static_cast<model::PlaceRole>(i); });
        for (int role = 0; role <= static_cast<int>(model::PlaceRole::Preferred); ++role) {
            form.addNote(
                placeRoleTip(static_cast<model::PlaceRole>(role)),
                [role](const BrushSettings& s) { return static_cast<int>(s.place.role) == role; });
        }
    }
    if (kind == BrushKind::Path) {
        form.addChoice(
            BrushForm::tr("At the end"),
            {BrushForm::tr("Stop"), BrushForm::tr("On to the first place"),
             BrushForm::tr("Jump to the first place")},
            [](const BrushSettings& s) { return static_cast<int>(s.place.kind); },
            [](BrushSettings& s, int i) { s.place.kind = static_cast<model::PathKind>(i); });
        form.addNote(BrushForm::tr("Each click adds a place, Enter ends the path; a click on its "
                                   "first place closes it. The next click begins another one."));
    }
}

} // namespace crowd::widgets
