// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Gives people another template and keeps what fits it: the clip by its name, tints and materials
/// by the names of slots and choices, parts by their names.
struct TemplateSettings
{
    /// Ids. Uniform takes the first, Random any, Gradient runs from first to last.
    std::vector<int> templates;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    friend bool operator==(const TemplateSettings&, const TemplateSettings&) = default;
};

inline constexpr BrushInfo TemplateSettings::kInfo{
    .id = "template",
    .name = QT_TRANSLATE_NOOP("Tools", "Template Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Te&mplate"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Exchange who the characters under the brush are"),
    .shortcut = "Shift+M",
    .order = 36,
    .section = BrushSection::Look,
    .scriptKind = "TEMPLATE",
    .scriptName = "template",
    .scriptClass = "TemplateSettings",
    .doc = "Who people become; what fits the new template stays.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: give characters another template"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters given another template"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Give %n character(s) another template"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already have this template"),
    .note =
        QT_TRANSLATE_NOOP("Fields", "Clips, colours, materials and parts of the same names stay."),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the first to the last template along it.")};

constexpr auto TemplateSettings::fields()
{
    using S = TemplateSettings;
    return std::tuple(field(&S::templates,
                            {.key = "templates",
                             .label = QT_TRANSLATE_NOOP("Fields", "Templates"),
                             .tip = QT_TRANSLATE_NOOP("Fields", "Who they become, by the operator"),
                             .doc = "Ids of templates. Assign a whole list.",
                             .high = std::numeric_limits<int>::max(),
                             .role = FieldRole::Template,
                             .section = QT_TRANSLATE_NOOP("Fields", "Template"),
                             .isRemembered = false,
                             .zero = QT_TRANSLATE_NOOP("Fields", "none chosen")}));
}

} // namespace crowd::model
