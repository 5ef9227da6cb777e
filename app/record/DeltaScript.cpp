// SPDX-License-Identifier: MIT
#include "app/record/DeltaScript.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numeric>
#include <span>

#include "app/record/FieldScript.h"
#include "app/record/RelationScript.h"
#include "app/record/ScriptText.h"
#include "app/record/StateScript.h"
#include "app/record/TakeScript.h"
#include "model/population/Properties.h"
#include "model/project/EnvironmentText.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr std::size_t kWidth = 92;

/// Arguments of a call, "name=value" each.
class Call
{
public:
    Call(std::string name, std::string first = {}) : m_name(std::move(name))
    {
        if (!first.empty()) {
            m_arguments.push_back(std::move(first));
        }
    }
    void add(std::string argument) { m_arguments.push_back(std::move(argument)); }
    void add(const std::string& name, const std::string& value) { add(name + '=' + value); }
    [[nodiscard]] bool hasArguments() const { return !m_arguments.empty(); }
    [[nodiscard]] std::string line() const
    {
        std::string text = std::string(kIndent, ' ') + m_name + '(';
        for (std::size_t i = 0; i < m_arguments.size(); ++i) {
            const bool isLong = text.size() - text.rfind('\n') - 1 + m_arguments[i].size() > kWidth;
            text += i == 0 ? "" : isLong ? ",\n" + std::string(2 * kIndent, ' ') : ", ";
            text += m_arguments[i];
        }
        return text + ")\n";
    }

private:
    std::string m_name;
    std::vector<std::string> m_arguments;
};

/// One value where all are the same.
std::vector<std::byte> folded(std::vector<std::byte> bytes, std::size_t stride)
{
    for (std::size_t at = stride; at < bytes.size(); at += stride) {
        if (std::memcmp(bytes.data(), &bytes[at], stride) != 0) {
            return bytes;
        }
    }
    bytes.resize(std::min(bytes.size(), stride));
    return bytes;
}

void addColumn(Call& call, ColumnId column, const std::vector<std::byte>& bytes)
{
    const ColumnInfo& info = columnInfo(column);
    call.add(std::string(info.name), pythonColumn(column, folded(bytes, info.stride), 2 * kIndent));
}

/// Whether some have a group or path that the scene does not have, as people who were in one that
/// was removed: scripts refuse that unless it is said.
bool namesMissing(ColumnId column, std::span<const std::byte> bytes, const Scene& scene)
{
    if (column != ColumnId::Group && column != ColumnId::Path) {
        return false;
    }
    std::vector<std::uint32_t> ids(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(ids.data(), bytes.data(), ids.size() * sizeof(std::uint32_t));
    return std::ranges::any_of(ids, [&](std::uint32_t id) {
        const bool isThere = column == ColumnId::Group ? scene.findGroup(id) != nullptr
                                                       : scene.findPath(id) != nullptr;
        return id != 0 && !isThere;
    });
}

void allowMissing(Call& call, bool isNeeded)
{
    if (isNeeded) {
        call.add("allow_missing", pythonText(true));
    }
}

/// Whether to say it of those who are added: it is suggested otherwise, or not the usual value.
bool isSaid(ColumnId column, const IndividualRows& rows, const IndividualRows& usual)
{
    return propertyInfo(column).traits.isSuggested ||
           rows.bytes[static_cast<std::size_t>(column)] !=
               usual.bytes[static_cast<std::size_t>(column)];
}

std::string createCall(const IndividualRows& rows, const Scene& after)
{
    bool isMissing = false;
    const IndividualRows usual = IndividualRows::withDefaults(rows.ids);
    Call call("scene.create");
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const auto column = static_cast<ColumnId>(c);
        if (isSaid(column, rows, usual)) {
            addColumn(call, column, rows.bytes[c]);
            isMissing = isMissing || namesMissing(column, rows.bytes[c], after);
        }
    }
    if (rows.ids.size() > 1) {
        call.add("count", pythonText(rows.ids.size())); // all columns may hold one value for all
    }
    allowMissing(call, isMissing);
    return call.line();
}

/// Ids that the edit gave out and took back: they are never given out again.
std::string spentIds(IndividualId from, IndividualId to, const Scene& after)
{
    if (from >= to || after.templates.empty()) {
        return {};
    }
    IndividualRows rows = IndividualRows::withDefaults(std::vector<IndividualId>(to - from));
    std::ranges::fill(rows.column(columns::templateId), after.templates.front().id);
    std::vector<IndividualId> ids(to - from);
    std::iota(ids.begin(), ids.end(), from);
    return createCall(rows, after) + Call("scene.remove", pythonIds(ids, kIndent)).line();
}

IndividualRows slice(const IndividualRows& rows, std::size_t from, std::size_t to)
{
    IndividualRows part;
    part.ids.assign(rows.ids.begin() + static_cast<std::ptrdiff_t>(from),
                    rows.ids.begin() + static_cast<std::ptrdiff_t>(to));
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const std::size_t stride = columnInfo(static_cast<ColumnId>(c)).stride;
        const auto begin = rows.bytes[c].begin();
        part.bytes[c].assign(begin + static_cast<std::ptrdiff_t>(from * stride),
                             begin + static_cast<std::ptrdiff_t>(to * stride));
    }
    return part;
}

std::string creations(const SceneDelta& delta, const Scene& after)
{
    std::string text;
    IndividualId next = delta.nextIdBefore;
    const IndividualRows added = delta.added.unpacked();
    const std::vector<IndividualId>& ids = added.ids;
    for (std::size_t from = 0; from < ids.size();) {
        std::size_t to = from + 1;
        while (to < ids.size() && ids[to] == ids[to - 1] + 1) {
            ++to;
        }
        text += spentIds(next, ids[from], after) + createCall(slice(added, from, to), after);
        next = ids[to - 1] + 1;
        from = to;
    }
    return text + spentIds(next, delta.nextIdAfter, after);
}

/// A clip counts within its template: where both change, they change in one call.
std::vector<ColumnDelta> joined(const std::vector<ColumnDelta>& columns, const Scene& after)
{
    std::vector<ColumnDelta> result = columns;
    std::vector<IndividualId> ids;
    for (const ColumnDelta& each : columns) {
        if (each.column == ColumnId::Template || each.column == ColumnId::Clip) {
            std::vector<IndividualId> both;
            std::ranges::set_union(ids, each.ids, std::back_inserter(both));
            ids = std::move(both);
        }
    }
    const bool hasTemplate =
        std::ranges::find(columns, ColumnId::Template, &ColumnDelta::column) != columns.end();
    for (ColumnDelta& each : result) {
        if (hasTemplate && (each.column == ColumnId::Template || each.column == ColumnId::Clip)) {
            each.ids = ids;
            each.after = after.population.values(each.column, ids);
        }
    }
    return result;
}

std::string changes(const SceneDelta& delta, const Scene& after)
{
    std::vector<ColumnDelta> left = joined(delta.columns, after);
    std::string text;
    while (!left.empty()) {
        const std::vector<IndividualId> ids = left.front().ids;
        Call call("scene.change", pythonIds(ids, 2 * kIndent));
        bool isMissing = false;
        for (const ColumnDelta& each : left) {
            if (each.ids == ids) {
                addColumn(call, each.column, each.after);
                isMissing = isMissing || namesMissing(each.column, each.after, after);
            }
        }
        allowMissing(call, isMissing);
        std::erase_if(left, [&ids](const ColumnDelta& each) { return each.ids == ids; });
        text += call.line();
    }
    return text;
}

/// All in which two described objects differ.
template<class S>
void addFields(Call& call, const S& now, const S& was)
{
    for (const auto& [name, value] : fieldArguments(fieldsOf<S>(), &was, &now)) {
        call.add(name, value);
    }
}

void addSpeeds(Call& call, const std::vector<float>& speeds)
{
    std::vector<std::string> items;
    items.reserve(speeds.size());
    for (const float each : speeds) {
        items.push_back(std::isnan(each) ? std::string("None") : pythonText(each));
    }
    call.add("clip_speeds", pythonList(items, 2 * kIndent));
}

void addRoles(Call& call, const std::vector<std::optional<ClipRole>>& roles)
{
    std::vector<std::string> items;
    items.reserve(roles.size());
    for (const std::optional<ClipRole>& each : roles) {
        items.push_back(each ? pythonText(std::string(keyOf(*each))) : std::string("None"));
    }
    call.add("clip_roles", pythonList(items, 2 * kIndent));
}

/// NaN, the file's own speed, equals itself.
bool sameBits(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Adds a template or stage, or changes it: what both have of the file that they come from.
template<class Entry>
Call assetCall(const EntryDelta<Entry>& delta, const std::string& kind)
{
    const Entry& now = *delta.after;
    const Entry was = delta.before.value_or(Entry{});
    Call call = delta.before ? Call("scene.change_" + kind, pythonText(now.id))
                             : Call("scene.add_" + kind, pythonText(now.path));
    if (!delta.before) {
        call.add("id", pythonText(now.id));
    } else if (now.path != was.path) {
        call.add("path", pythonText(now.path));
    }
    if (now.name != was.name) {
        call.add("name", pythonText(now.name));
    }
    return call;
}

std::string templateCall(const EntryDelta<TemplateEntry>& delta)
{
    if (!delta.after) {
        return Call("scene.remove_template", pythonText(delta.before->id)).line();
    }
    const TemplateEntry& now = *delta.after;
    const TemplateEntry was = delta.before.value_or(TemplateEntry{});
    Call call = assetCall(delta, "template");
    addFields(call, now.import, was.import);
    if (!std::ranges::equal(now.clipSpeeds, was.clipSpeeds, sameBits)) {
        addSpeeds(call, now.clipSpeeds);
    }
    if (now.clipRoles != was.clipRoles) {
        addRoles(call, now.clipRoles);
    }
    return call.line();
}

std::string stageCall(const EntryDelta<StageEntry>& delta)
{
    if (!delta.after) {
        return Call("scene.remove_stage", pythonText(delta.before->id)).line();
    }
    const StageEntry& now = *delta.after;
    const StageEntry was = delta.before.value_or(StageEntry{});
    Call call = assetCall(delta, "stage");
    addFields(call, now, was);
    return call.line();
}

/// Templates and stages: those that come before the people who need them, the others after.
std::string entries(const SceneDelta& delta, bool isComing)
{
    std::string text;
    for (const auto& each : delta.of<members::Templates>()) {
        text += each.after.has_value() == isComing ? templateCall(each) : std::string();
    }
    for (const auto& each : delta.of<members::Stages>()) {
        text += each.after.has_value() == isComing ? stageCall(each) : std::string();
    }
    return text;
}

std::string cameras(const std::vector<NamedCamera>& all, const Looks& looks)
{
    std::string ofLooks;
    for (const NamedCamera& each : all) {
        if (const LookPreset* look = findLook(looks, each.look)) {
            ofLooks += (ofLooks.empty() ? "" : ", ") + pythonText(each.name) + ": " +
                       pythonText(look->name);
        }
    }
    std::string text = std::string(kIndent, ' ') + "scene.set_cameras([\n";
    for (const NamedCamera& each : all) {
        text += std::string(2 * kIndent, ' ') + '(' + pythonText(each.name) + ", " +
                pythonText(each.camera) + "),\n";
    }
    text += std::string(kIndent, ' ') + ']';
    return text + (ofLooks.empty() ? "" : ", looks={" + ofLooks + "}") + ")\n";
}

std::string lightingCall(const Lighting& now)
{
    const Lighting usual;
    const std::string indent(kIndent, ' ');
    return indent + "light = crowdbrush.Lighting()\n" +
           fieldChanges(fieldsOf<Lighting>(), &usual, &now, indent + "light") +
           Call("scene.set_lighting", "light").line();
}

std::string environment(const SceneDelta& delta, const Scene& after)
{
    const MemberSet changed = delta.changedMembers();
    if (!changed.intersects(environmentMembers())) {
        return {};
    }
    // What is done by hand may name what is not there.
    Call call("scene.set_environment", pythonText(environmentText(after, changed)));
    call.add("strict", "False");
    return call.line();
}

} // namespace

std::string deltaScript(const SceneDelta& delta, const QString& undoText, const Scene& after)
{
    std::string text = "with scene.edit(" + pythonText(undoText.toStdString()) + "):\n";
    text += entries(delta, true) + environment(delta, after);
    if (!delta.removed.ids.empty()) {
        text += Call("scene.remove", pythonIds(delta.removed.ids, kIndent)).line();
    }
    text += creations(delta, after);
    text += changes(delta, after);
    text += entries(delta, false);
    for (const std::string& line : relationLines(delta.of<members::Relations>(), after)) {
        text += std::string(kIndent, ' ') + line;
    }
    if (const auto& changed = delta.of<members::Cameras>()) {
        text += cameras(changed->after, after.looks);
    }
    if (const auto& changed = delta.of<members::Light>()) {
        text += lightingCall(changed->after);
    }
    if (const auto& changed = delta.of<members::States>()) {
        for (const std::string& line : stateLines(changed->before, after)) {
            text += std::string(kIndent, ' ') + line;
        }
    }
    if (const auto& changed = delta.of<members::Takes>()) {
        for (const std::string& line : takeLines(changed->before, changed->after)) {
            text += std::string(kIndent, ' ') + line;
        }
    }
    return text;
}

} // namespace crowd::app
