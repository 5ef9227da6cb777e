// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Gives slots another one of their materials: textures and colours as the template has them.
struct MaterialSettings
{
    std::string slot;       ///< by name; empty: all
    bool sparesBody = true; ///< of all, not skin, hair and face, where there is anything else
    std::string choice; ///< by name; empty: those of the slot from first to last, by the operator
    bool eachSlotApart = true; ///< Random: another draw for each slot

    static const BrushInfo kInfo;
    static constexpr auto fields();
    template<class Brush>
    static void prepare(Brush& brush)
    {
        brush.selection = decltype(brush.selection)::AllInCircle;
        brush.op = decltype(brush.op)::Random;
    }
    template<class Request>
    static auto change(const Request& request);
    template<class Brush, class From>
    static std::string take(Brush& brush, const From& from);
    friend bool operator==(const MaterialSettings&, const MaterialSettings&) = default;
};

inline constexpr BrushInfo MaterialSettings::kInfo{
    .id = "material",
    .name = QT_TRANSLATE_NOOP("Tools", "Material Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Material (te&xtures)"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Give the characters under the brush other materials"),
    .shortcut = "M",
    .order = 34,
    .section = BrushSection::Look,
    .scriptKind = "MATERIAL",
    .scriptName = "material",
    .scriptClass = "MaterialSettings",
    .doc = "Which of its materials a slot has.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: give characters other materials"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters given another material"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Give %n character(s) another material"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already have this material"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the first to the last material along it.")};

constexpr auto MaterialSettings::fields()
{
    using S = MaterialSettings;
    return std::tuple(
        field(&S::slot, {.key = "slot",
                         .label = QT_TRANSLATE_NOOP("Fields", "Slot"),
                         .doc = "By name; empty: all slots.",
                         .role = FieldRole::Slot,
                         .section = QT_TRANSLATE_NOOP("Fields", "Material"),
                         .isRemembered = false}),
        field(&S::sparesBody,
              {.key = "spares_body",
               .doc = "Of all slots, not skin, hair and face, where there is anything else.",
               .isRemembered = false}),
        field(&S::choice, {.key = "choice",
                           .label = QT_TRANSLATE_NOOP("Fields", "Material"),
                           .doc = "By name; empty: any of the slot's, by the operator.",
                           .role = FieldRole::Material,
                           .isRemembered = false}),
        field(&S::eachSlotApart,
              {.key = "each_slot_apart",
               .label = QT_TRANSLATE_NOOP("Fields", "Each slot its own"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Another material for each slot of a character")})
            .when([](const S& s, const FieldContext&) { return s.choice.empty(); }));
}

/// The material of the chosen slot; where all are meant, of the first that has several.
template<class Brush, class From>
std::string MaterialSettings::take(Brush& brush, const From& from)
{
    auto& settings = brush.template as<MaterialSettings>();
    const auto& choices = from.scene.population.column(columns::materialChoices)[from.row];
    const auto& slots = from.entry.asset->slots;
    for (std::size_t i = 0; i < std::min(choices.size(), slots.size()); ++i) {
        const bool isMeant =
            settings.slot.empty() ? slots[i].choices.size() > 1 : slots[i].name == settings.slot;
        if (isMeant && choices[i] < slots[i].choices.size()) {
            settings.slot = slots[i].name;
            settings.choice = slots[i].choices[choices[i]].name;
            return settings.slot + " · " + settings.choice;
        }
    }
    return {};
}

/// The index of a slot's choice: the one of that name, or by the share where there is no name; as
/// many as there are where none is meant.
template<class Choices>
std::size_t chosenMaterial(const Choices& all, const std::string& name, double share)
{
    if (name.empty()) {
        return std::min(static_cast<std::size_t>(share * static_cast<double>(all.size())),
                        all.size() - 1);
    }
    return static_cast<std::size_t>(std::ranges::find(all, name, &Choices::value_type::name) -
                                    all.begin());
}

/// `Request` is ChangeRequest, which knows this brush: its tools are looked up when it is complete.
template<class Request>
auto MaterialSettings::change(const Request& request)
{
    using Tools = typename Request::Tools;
    const auto& settings = request.settings.template as<MaterialSettings>();
    const auto& scene = request.edit.scene();
    const auto templates = scene.population.column(columns::templateId);
    const auto choices = scene.population.column(columns::materialChoices);
    typename Tools::Shares shares(request);
    typename Tools::template Column<MaterialChoices> change;
    std::vector<std::vector<double>> draws;
    for (std::size_t index = 0; index < std::tuple_size_v<MaterialChoices>; ++index) {
        draws.push_back(
            shares
                .of(request.settings.op, "material.choice", settings.eachSlotApart ? index + 1 : 0)
                .shares);
    }
    bool hasSlot = false;
    bool hasMaterial = false;
    Tools::forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const auto* entry = scene.findTemplate(templates[row]);
        if (entry == nullptr || !entry->asset) {
            return;
        }
        typename Tools::Slots meant(*entry->asset, settings.slot, settings.sparesBody);
        MaterialChoices wanted = choices[row];
        for (std::size_t index = 0; index < std::min(wanted.size(), entry->asset->slots.size());
             ++index) {
            const auto& all = entry->asset->slots[index].choices;
            if (!meant.contains(entry->asset->slots[index])) {
                continue;
            }
            hasSlot = true;
            const std::size_t chosen = chosenMaterial(all, settings.choice, draws[index][i]);
            if (chosen < all.size()) {
                hasMaterial = true;
                wanted[index] = static_cast<std::uint8_t>(chosen);
            }
        }
        change.set(id, choices[row], wanted);
    });
    typename Tools::Result result;
    change.apply(request.edit, columns::materialChoices, result.changed);
    const bool lacksMaterial = hasSlot && !settings.choice.empty();
    result.reason = hasMaterial     ? Tools::Reason::Unchanged
                    : lacksMaterial ? Tools::Reason::NoSuchMaterial
                                    : Tools::Reason::NoSuchSlot;
    return result;
}

} // namespace crowd::model
