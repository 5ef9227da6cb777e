// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Takes people into a group, or out of all.
struct GroupSettings
{
    std::uint32_t group = 0; ///< GroupId; 0: none

    static const BrushInfo kInfo;
    static constexpr auto fields();
    template<class Request>
    static auto change(const Request& request);
    template<class Brush, class From>
    static std::string take(Brush& brush, const From& from);
    friend bool operator==(const GroupSettings&, const GroupSettings&) = default;
};

inline constexpr BrushInfo GroupSettings::kInfo{
    .id = "group",
    .name = QT_TRANSLATE_NOOP("Tools", "Group Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Group"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Take the characters under the brush into a group"),
    .shortcut = "Shift+G",
    .order = 150,
    .section = BrushSection::Mind,
    .scriptKind = "GROUP",
    .scriptName = "group",
    .scriptClass = "GroupSettings",
    .doc = "The group that people come into.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: take characters into the group"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters taken into the group"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Take %n character(s) into a group"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already are in this group")};

constexpr auto GroupSettings::fields()
{
    return std::tuple(
        field(&GroupSettings::group, {.key = "group",
                                      .label = QT_TRANSLATE_NOOP("Fields", "Group"),
                                      .doc = "Id of a group; 0: none.",
                                      .high = std::numeric_limits<std::uint32_t>::max(),
                                      .step = 1.0,
                                      .decimals = 0,
                                      .role = FieldRole::Group,
                                      .section = QT_TRANSLATE_NOOP("Fields", "Group"),
                                      .isRemembered = false,
                                      .zero = QT_TRANSLATE_NOOP("Fields", "none")}));
}

template<class Brush, class From>
std::string GroupSettings::take(Brush& brush, const From& from)
{
    const auto* group =
        from.scene.findGroup(from.scene.population.column(columns::group)[from.row]);
    if (group == nullptr) {
        return {};
    }
    brush.template as<GroupSettings>().group = group->id;
    return group->name;
}

/// `Request` is ChangeRequest, which knows this brush: its tools are looked up when it is complete.
template<class Request>
auto GroupSettings::change(const Request& request)
{
    using Tools = typename Request::Tools;
    const std::uint32_t group = request.settings.template as<GroupSettings>().group;
    const auto groups = request.edit.scene().population.column(columns::group);
    typename Tools::template Column<std::uint32_t> change;
    Tools::forEachRow(request, [&](std::size_t /*i*/, std::size_t row, IndividualId id) {
        change.set(id, groups[row], group);
    });
    typename Tools::Result result;
    change.apply(request.edit, columns::group, result.changed);
    result.reason = Tools::Reason::Unchanged;
    return result;
}

} // namespace crowd::model
