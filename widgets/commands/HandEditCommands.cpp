// SPDX-License-Identifier: MIT
#include "widgets/commands/HandEditCommands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtCore/QStringList>

#include "model/document/SceneEdit.h"

namespace crowd::widgets {

namespace {

using model::HandEdit;
using model::HandEditKind;

constexpr double kStretchSeconds = 2.0; ///< of a new edit that ends by itself

struct HandText
{
    Q_DECLARE_TR_FUNCTIONS(HandEdits)
};

/// "0:05.0"
QString momentText(double seconds)
{
    const auto tenths = static_cast<qint64>(std::llround(seconds * 10.0));
    const qint64 whole = std::abs(tenths) / 10;
    return (tenths < 0 ? QStringLiteral("-") : QString()) +
           QStringLiteral("%1:%2%3%4")
               .arg(whole / 60)
               .arg(whole % 60, 2, 10, QLatin1Char('0'))
               .arg(QLocale().decimalPoint())
               .arg(std::abs(tenths) % 10);
}

QString metres(float value)
{
    return QLocale().toString(std::abs(static_cast<double>(value)), 'f', 1);
}

/// "somebody else: Woman, Man"
QString swapText(const HandEdit& edit, const model::Scene& scene)
{
    QStringList names;
    for (const int id : edit.templates) {
        if (const auto* entry = scene.findTemplate(static_cast<model::TemplateId>(id))) {
            names << QString::fromStdString(entry->name);
        }
    }
    return names.isEmpty()
               ? HandText::tr("somebody else: choose of which template")
               : HandText::tr("somebody else: %1").arg(names.join(QStringLiteral(", ")));
}

QString whatText(const HandEdit& edit, const model::Scene& scene)
{
    switch (edit.kind) {
    case HandEditKind::Shift: {
        const QString seconds = QLocale().toString(std::abs(edit.later), 'f', 1);
        return edit.later < 0.0 ? HandText::tr("%1 s earlier").arg(seconds)
                                : HandText::tr("%1 s later").arg(seconds);
    }
    case HandEditKind::Pace:
        return edit.pace <= 0.0F
                   ? HandText::tr("still")
                   : HandText::tr("at %1 % of the pace").arg(std::lround(100.0F * edit.pace));
    case HandEditKind::Aside:
        return edit.aside < 0.0F ? HandText::tr("%1 m to the left").arg(metres(edit.aside))
                                 : HandText::tr("%1 m to the right").arg(metres(edit.aside));
    case HandEditKind::Swap:
        return swapText(edit, scene);
    case HandEditKind::Hide:
        break;
    }
    return HandText::tr("hidden");
}

/// When it counts, within the take.
void putTimes(HandEdit& edit, const EditorState& state, const model::Take& take)
{
    const model::PlayRange& range = state.scene().playRange;
    const bool isRange = range.isSet() && range.begin < take.end && range.end > take.begin;
    const bool ends = edit.kind == HandEditKind::Pace;
    const double now = state.transport().seconds();
    const bool isWithin = isRange && now > range.begin && now < range.end;
    edit.begin = isRange && !isWithin ? range.begin : now; // what one sees is where it begins
    edit.end = isRange ? range.end : ends ? edit.begin + kStretchSeconds : 0.0;
    if (edit.kind == HandEditKind::Shift) {
        edit.begin = 0.0;
        edit.end = 0.0;
    }
}

void put(EditorState& state, const QString& text, model::Takes takes)
{
    state.document().edit(
        text, [&](model::SceneEdit& edit) { edit.set<model::members::Takes>(std::move(takes)); });
}

HandEdit wished(HandEditWish wish)
{
    HandEdit edit;
    switch (wish) {
    case HandEditWish::Later:
        edit.kind = HandEditKind::Shift;
        edit.later = 1.0;
        break;
    case HandEditWish::Slower:
        break;
    case HandEditWish::Still:
        edit.pace = 0.0F;
        break;
    case HandEditWish::Aside:
        edit.kind = HandEditKind::Aside;
        break;
    case HandEditWish::Hidden:
        edit.kind = HandEditKind::Hide;
        break;
    case HandEditWish::Swapped:
        edit.kind = HandEditKind::Swap;
        break;
    }
    return edit;
}

/// A first one that is not his own, where the scene has such.
std::vector<int> otherTemplates(const model::Scene& scene, model::IndividualId person)
{
    const std::size_t row = scene.population.rowOf(person);
    if (row == model::Population::npos) {
        return {};
    }
    const model::TemplateId own = scene.population.column(model::columns::templateId)[row];
    const auto other = std::ranges::find_if(
        scene.templates, [own](const model::TemplateEntry& each) { return each.id != own; });
    return other == scene.templates.end() ? std::vector<int>() : std::vector<int>{other->id};
}

} // namespace

QString handEditText(const HandEdit& edit, const model::Scene& scene)
{
    QString what = whatText(edit, scene);
    if (edit.kind == HandEditKind::Shift) {
        return what;
    }
    return edit.end > edit.begin
               ? HandText::tr("%1, %2–%3").arg(what, momentText(edit.begin), momentText(edit.end))
               : HandText::tr("%1, from %2 on").arg(what, momentText(edit.begin));
}

model::Takes withEdits(const EditorState& state,
                       const std::function<void(model::Take& take)>& change)
{
    model::Takes takes = state.scene().takes;
    const auto shown = std::ranges::find(takes, state.session().take(), &model::Take::id);
    if (shown != takes.end()) {
        change(*shown);
    }
    return takes;
}

bool addHandEdit(EditorState& state, HandEditWish wish)
{
    const model::Take* shown = model::findTake(state.scene().takes, state.session().take());
    if (shown == nullptr) {
        state.showStatus(HandText::tr("Keep what was played as a take and show it: then people of "
                                      "it can be edited by hand."));
        return false;
    }
    const auto& ids = state.selection().ids();
    if (ids.empty()) {
        state.showStatus(HandText::tr("Select those who are to be edited."));
        return false;
    }
    if (shown->edits.size() >= model::kMostHandEdits) {
        state.showStatus(HandText::tr("There are as many edits as a take can have. Delete some."));
        return false;
    }
    HandEdit edit = wished(wish);
    putTimes(edit, state, *shown);
    edit.people.assign(ids.begin(), ids.end());
    std::ranges::sort(edit.people);
    if (edit.kind == HandEditKind::Swap) {
        edit.templates = otherTemplates(state.scene(), ids.front());
    }
    const auto people = static_cast<int>(edit.people.size());
    put(state, HandText::tr("Edit %n character(s) of the take", nullptr, people),
        withEdits(state, [&edit](model::Take& take) {
            take.edits.push_back(edit);
            take.areEditsOn = true;
        }));
    state.showStatus(HandText::tr("%n character(s): %1.", nullptr, people)
                         .arg(handEditText(edit, state.scene())));
    return true;
}

void setHandEditOn(EditorState& state, std::size_t edit, bool isOn)
{
    put(state, isOn ? HandText::tr("Switch an edit on") : HandText::tr("Switch an edit off"),
        withEdits(state, [edit, isOn](model::Take& take) {
            if (edit < take.edits.size()) {
                take.edits[edit].isOn = isOn;
            }
        }));
}

void setHandEditsOn(EditorState& state, bool areOn)
{
    put(state,
        areOn ? HandText::tr("Switch the take's edits on")
              : HandText::tr("Switch the take's edits off"),
        withEdits(state, [areOn](model::Take& take) { take.areEditsOn = areOn; }));
}

void removeHandEdit(EditorState& state, std::size_t edit)
{
    put(state, HandText::tr("Delete an edit"), withEdits(state, [edit](model::Take& take) {
            if (edit < take.edits.size()) {
                take.edits.erase(take.edits.begin() + static_cast<std::ptrdiff_t>(edit));
            }
        }));
}

void selectPeopleOf(EditorState& state, std::size_t edit)
{
    const model::Take* shown = model::findTake(state.scene().takes, state.session().take());
    if (shown == nullptr || edit >= shown->edits.size()) {
        return;
    }
    std::vector<model::IndividualId> ids;
    for (const int id : shown->edits[edit].people) {
        const auto person = static_cast<model::IndividualId>(id);
        if (state.scene().population.rowOf(person) != model::Population::npos) {
            ids.push_back(person);
        }
    }
    state.selection().set(ids);
}

} // namespace crowd::widgets
