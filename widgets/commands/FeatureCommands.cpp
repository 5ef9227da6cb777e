// SPDX-License-Identifier: MIT
#include "widgets/commands/FeatureCommands.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>

#include "model/base/Random.h"
#include "model/brush/FeatureBrush.h"
#include "model/features/FeatureWriting.h"
#include "model/project/FeatureFile.h"
#include "widgets/state/FeatureTexts.h"
#include "widgets/state/ToolId.h"

namespace crowd::widgets {

using model::FeatureId;
using model::FeatureKind;
using model::FeatureKinds;
using model::FeatureValue;

using KindId = std::uint8_t; // lupdate takes std:: before a function for its context

namespace {

struct FeatureText
{
    Q_DECLARE_TR_FUNCTIONS(FeatureCommands)
};

/// Whether the step was made, or nothing had to be changed.
bool editKinds(EditorState& state, const QString& text,
               const std::function<void(FeatureKinds&)>& change, bool isWorn = false)
{
    FeatureKinds kinds = state.scene().features;
    change(kinds);
    const auto outcome = state.document().edit(
        text, [&](model::SceneEdit& edit) { changeFeatures(edit, std::move(kinds), isWorn); });
    return outcome != model::EditOutcome::Refused;
}

FeatureKind* kindIn(FeatureKinds& kinds, std::uint8_t id)
{
    const auto found = std::ranges::find(kinds, id, &FeatureKind::id);
    return found == kinds.end() ? nullptr : &*found;
}

/// Lets `act(values, index)` change the list in which a value is.
bool editValues(EditorState& state, const QString& text, FeatureId id,
                const std::function<void(std::vector<FeatureValue>&, std::size_t)>& act)
{
    const FeatureKind* kind = kindOf(state.scene().features, id);
    if (kind == nullptr) {
        return false;
    }
    return editKinds(state, text, [&, kindId = kind->id](FeatureKinds& kinds) {
        auto& values = kindIn(kinds, kindId)->values;
        const auto at = std::ranges::find(values, id, &FeatureValue::id);
        act(values, static_cast<std::size_t>(at - values.begin()));
    });
}

/// "Feature 3": a name that none of them has.
template<class Entries>
std::string freeName(const Entries& entries, const QString& pattern, std::size_t first)
{
    for (std::size_t number = first;; ++number) {
        std::string name = pattern.arg(number).toStdString();
        if (std::ranges::find(entries, name, &Entries::value_type::name) == entries.end()) {
            return name;
        }
    }
}

/// Simplified; empty where it is none, or taken.
template<class Entries>
std::string soundName(EditorState& state, const Entries& entries, const QString& name)
{
    std::string wanted = name.simplified().toStdString();
    if (wanted.empty()) {
        state.showStatus(FeatureText::tr("It needs a name."));
        return {};
    }
    const QString seen = featureText(wanted);
    if (std::ranges::any_of(entries, [&](const auto& each) {
            return each.name == wanted || featureText(each.name) == seen;
        })) {
        state.showStatus(FeatureText::tr("There is one of that name already."));
        return {};
    }
    return wanted;
}

FeatureId insertFeature(EditorState& state, const QString& text, std::uint8_t kind,
                        FeatureValue value, std::size_t place)
{
    value.id = model::freeFeatureId(state.scene());
    if (value.id == 0) {
        state.showStatus(FeatureText::tr("There are as many values as there can be."));
        return 0;
    }
    const bool isDone = editKinds(state, text, [&](FeatureKinds& kinds) {
        auto& values = kindIn(kinds, kind)->values;
        values.insert(values.begin() + static_cast<std::ptrdiff_t>(std::min(place, values.size())),
                      value);
    });
    return isDone ? value.id : FeatureId{0};
}

/// As states are kept: of all where nobody is selected.
std::vector<model::IndividualId> selectedOrAll(const EditorState& state)
{
    const auto selected = state.selection().ids();
    if (!selected.empty()) {
        return {selected.begin(), selected.end()};
    }
    std::vector<model::IndividualId> all;
    const model::Population& people = state.scene().population;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (state.scene().isTouchable(row)) {
            all.push_back(people.ids()[row]);
        }
    }
    return all;
}

/// 0: none of the kind.
void give(EditorState& state, const FeatureKind& kind, FeatureId id, const QString& name)
{
    const std::vector<model::IndividualId> people = selectedOrAll(state);
    if (people.empty()) {
        state.showStatus(FeatureText::tr("Nobody is there yet."));
        return;
    }
    std::size_t changed = 0;
    state.document().edit(FeatureText::tr("Give “%1”").arg(name), [&](model::SceneEdit& edit) {
        const std::vector<FeatureId> wanted(people.size(), id);
        const std::uint64_t seed = model::hashKeys(state.scene().seed, model::hashText("give"));
        changed = setFeature(edit, kind, people, wanted, seed).size();
    });
    const auto number = static_cast<int>(changed);
    state.showStatus(
        (state.selection().isEmpty()
             ? FeatureText::tr("“%1” for all, as nobody is selected: %n characters changed",
                               nullptr, number)
             : FeatureText::tr("“%1”: %n characters changed", nullptr, number))
            .arg(name));
}

} // namespace

bool hasRoomForKind(EditorState& state)
{
    const bool hasRoom = model::freeKindId(state.scene()) != 0;
    if (!hasRoom) {
        state.showStatus(FeatureText::tr("A scene has at most %1 features: remove one first.")
                             .arg(model::kMostFeatureKinds));
    }
    return hasRoom;
}

QString freeKindName(const EditorState& state)
{
    return QString::fromStdString(freeName(state.scene().features, FeatureText::tr("Feature %1"),
                                           state.scene().features.size() + 1));
}

KindId addKind(EditorState& state, const QString& name)
{
    FeatureKind kind;
    kind.id = model::freeKindId(state.scene());
    kind.name = soundName(state, state.scene().features, name);
    if (!hasRoomForKind(state) || kind.name.empty()) {
        return 0;
    }
    const bool isDone =
        editKinds(state, FeatureText::tr("Add a feature"), [&](FeatureKinds& kinds) {
            kinds.insert(std::ranges::upper_bound(kinds, kind.id, {}, &FeatureKind::id), kind);
        });
    return isDone ? kind.id : std::uint8_t{0};
}

void removeKind(EditorState& state, std::uint8_t kind)
{
    const FeatureKind* gone = findKind(state.scene().features, kind);
    if (gone == nullptr) {
        return;
    }
    const QString name = featureText(gone->name);
    std::size_t bearers = 0; // each bears one value of a kind
    for (const FeatureValue& value : gone->values) {
        bearers += model::bearersOf(state.scene(), value.id).size();
    }
    const bool isDone =
        editKinds(state, FeatureText::tr("Remove a feature"), [kind](FeatureKinds& kinds) {
            std::erase_if(kinds, [kind](const FeatureKind& each) { return each.id == kind; });
        });
    if (isDone) {
        state.showStatus(FeatureText::tr("“%1” is gone; %n characters had a value of it", nullptr,
                                         static_cast<int>(bearers))
                             .arg(name));
    }
}

bool renameKind(EditorState& state, std::uint8_t kind, const QString& name)
{
    const FeatureKind* before = findKind(state.scene().features, kind);
    if (before == nullptr || featureText(before->name) == name) {
        return before != nullptr;
    }
    const std::string wanted = soundName(state, state.scene().features, name);
    return !wanted.empty() &&
           editKinds(state, FeatureText::tr("Rename a feature"),
                     [&](FeatureKinds& kinds) { kindIn(kinds, kind)->name = wanted; });
}

FeatureId addFeature(EditorState& state, std::uint8_t kind)
{
    const FeatureKind* found = findKind(state.scene().features, kind);
    if (found == nullptr) {
        return 0;
    }
    FeatureValue value;
    value.name = freeName(found->values, FeatureText::tr("Value %1"), found->values.size() + 1);
    return insertFeature(state, FeatureText::tr("Add a value"), kind, value, found->values.size());
}

FeatureId duplicateFeature(EditorState& state, FeatureId id)
{
    const FeatureKind* kind = kindOf(state.scene().features, id);
    if (kind == nullptr) {
        return 0;
    }
    const auto at = std::ranges::find(kind->values, id, &FeatureValue::id);
    FeatureValue copy = *at;
    const QString pattern = QString::fromStdString(copy.name) + QStringLiteral(" %1");
    copy.name = freeName(kind->values, pattern, 2);
    return insertFeature(state, FeatureText::tr("Duplicate a value"), kind->id, std::move(copy),
                         static_cast<std::size_t>(at - kind->values.begin()) + 1);
}

void removeFeature(EditorState& state, FeatureId id)
{
    const FeatureValue* gone = findFeature(state.scene().features, id);
    const QString name = gone != nullptr ? featureText(gone->name) : QString();
    const auto bearers = static_cast<int>(model::bearersOf(state.scene(), id).size());
    const bool isDone =
        editValues(state, FeatureText::tr("Remove a value"), id,
                   [](std::vector<FeatureValue>& values, std::size_t at) {
                       values.erase(values.begin() + static_cast<std::ptrdiff_t>(at));
                   });
    if (isDone && bearers > 0) {
        state.showStatus(
            FeatureText::tr("“%1” is gone; %n characters had it", nullptr, bearers).arg(name));
    }
}

bool renameFeature(EditorState& state, FeatureId id, const QString& name)
{
    const FeatureKind* kind = kindOf(state.scene().features, id);
    if (kind == nullptr || featureText(findFeature(state.scene().features, id)->name) == name) {
        return kind != nullptr;
    }
    const std::string wanted = soundName(state, kind->values, name);
    return !wanted.empty() && editValues(state, FeatureText::tr("Rename a value"), id,
                                         [&](std::vector<FeatureValue>& values, std::size_t at) {
                                             values[at].name = wanted;
                                         });
}

void moveFeature(EditorState& state, FeatureId id, int by)
{
    (void)editValues(state, FeatureText::tr("Arrange values"), id,
                     [by](std::vector<FeatureValue>& values, std::size_t at) {
                         const auto to = static_cast<std::ptrdiff_t>(at) + by;
                         if (to >= 0 && to < static_cast<std::ptrdiff_t>(values.size())) {
                             std::swap(values[at], values[static_cast<std::size_t>(to)]);
                         }
                     });
}

void changeFeature(EditorState& state, const FeatureValue& value, bool isWorn)
{
    const auto bearers = static_cast<int>(model::bearersOf(state.scene(), value.id).size());
    const bool isDone = editKinds(
        state, FeatureText::tr("Change “%1”").arg(featureText(value.name)),
        [&value](FeatureKinds& kinds) {
            for (FeatureKind& kind : kinds) {
                std::ranges::replace_if(
                    kind.values, [&](const FeatureValue& each) { return each.id == value.id; },
                    value);
            }
        },
        isWorn);
    if (isDone && isWorn && bearers > 0) {
        state.showStatus(
            FeatureText::tr("“%1” changed, and %n characters with it", nullptr, bearers)
                .arg(featureText(value.name)));
    }
}

void giveFeature(EditorState& state, FeatureId id)
{
    if (const FeatureKind* kind = kindOf(state.scene().features, id)) {
        give(state, *kind, id, featureText(findFeature(state.scene().features, id)->name));
    }
}

void takeFeatureOff(EditorState& state, std::uint8_t kind)
{
    if (const FeatureKind* found = findKind(state.scene().features, kind)) {
        give(state, *found, 0, featureText(found->name));
    }
}

void paintFeature(EditorState& state, FeatureId id)
{
    const FeatureKind* kind = kindOf(state.scene().features, id);
    if (kind == nullptr) {
        return;
    }
    const model::BrushSettings outfits = state.brush(model::BrushKind::Outfit);
    const bool isOutfit = model::featureSettings(outfits)->kind == kind->name;
    const auto brushKind = isOutfit ? model::BrushKind::Outfit : model::BrushKind::Feature;
    model::BrushSettings brush = state.brush(brushKind);
    model::FeatureSettings& settings = *model::featureSettings(brush);
    settings.kind = kind->name;
    settings.values = {{findFeature(state.scene().features, id)->name, 1.0F}};
    settings.takesOff = false;
    state.setBrush(brush);
    state.setTool(toolOf(brushKind));
}

void selectBearers(EditorState& state, FeatureId id)
{
    const std::vector<model::IndividualId> bearers = bearersOf(state.scene(), id);
    if (bearers.empty()) {
        state.showStatus(FeatureText::tr("Nobody bears it."));
    }
    state.selection().set(bearers);
}

model::Result<void> exportKind(const EditorState& state, std::uint8_t kind, const QString& path)
{
    const FeatureKind* found = findKind(state.scene().features, kind);
    return found != nullptr ? model::writeFeatureFile({*found}, path) : model::Result<void>();
}

model::Result<void> importKinds(EditorState& state, const QString& path)
{
    auto read = model::readFeatureFile(path);
    if (!read) {
        return read.error();
    }
    auto kinds = model::withKinds(state.scene(), read.value());
    if (!kinds) {
        return kinds.error();
    }
    editKinds(state, FeatureText::tr("Take features from a file"),
              [&](FeatureKinds& all) { all = std::move(kinds).value(); });
    return {};
}

} // namespace crowd::widgets
