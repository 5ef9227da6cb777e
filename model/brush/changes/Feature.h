// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Gives people values of a kind of feature, with all that they do. Kinds and values go by name, so
/// that a brush serves every scene that has such.
struct FeatureSettings
{
    std::string kind = "emotion";
    /// Names of values. Uniform takes the first, Random any by weight, Gradient runs from first to
    /// last. Empty: all of the kind.
    std::vector<ClipWeight> values;
    bool takesOff = false; ///< of the kind they bear none any more; what it did is undone

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const FeatureSettings&, const FeatureSettings&) = default;
};

/// The same, with outfits at hand.
struct OutfitSettings : FeatureSettings
{
    OutfitSettings() { kind = "outfit"; }

    static const BrushInfo kInfo;
    friend bool operator==(const OutfitSettings&, const OutfitSettings&) = default;
};

inline constexpr BrushInfo FeatureSettings::kInfo{
    .id = "feature",
    .name = QT_TRANSLATE_NOOP("Tools", "Emotion Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Emotion"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Paint how the characters under the brush feel, or another "
                                        "feature"),
    .shortcut = "Shift+E",
    .order = 125,
    .section = BrushSection::Mind,
    .scriptKind = "FEATURE",
    .scriptName = "feature",
    .scriptClass = "FeatureSettings",
    .doc = "Which value of a kind of feature people bear.",
    .hint = QT_TRANSLATE_NOOP("BrushTool",
                              "Drag: paint what characters are like · Ctrl+click: take it"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "Feature of %n characters changed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Paint a feature of %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already are like that"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the first to the last value along it.")};

inline constexpr BrushInfo OutfitSettings::kInfo{
    .id = "outfit",
    .name = QT_TRANSLATE_NOOP("Tools", "Outfit Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Outfit"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Dress the characters under the brush"),
    .shortcut = "Shift+O",
    .order = 38,
    .section = BrushSection::Look,
    .scriptKind = "OUTFIT",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: dress characters · Ctrl+click: take the outfit"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters dressed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Dress %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already are dressed like that"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the first to the last value along it.")};

constexpr auto FeatureSettings::fields()
{
    using S = FeatureSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::kind, {.key = "kind",
                         .label = QT_TRANSLATE_NOOP("Fields", "Feature"),
                         .doc = "Name of a kind of feature: \"emotion\", \"outfit\".",
                         .role = FieldRole::FeatureKind,
                         .section = QT_TRANSLATE_NOOP("Fields", "Feature")}),
        field(&S::takesOff,
              {.key = "takes_off",
               .label = QT_TRANSLATE_NOOP("Fields", "Take it off"),
               .tip = QT_TRANSLATE_NOOP("Fields", "They bear none of it any more: what it did to "
                                                  "them is as their template has it"),
               .doc = "They bear no value of the kind any more; what it did to them is as their "
                      "template has it."}),
        field(&S::values, {.key = "values",
                           .label = QT_TRANSLATE_NOOP("Fields", "Values"),
                           .doc = "Name → weight; empty: all of the kind.",
                           .role = FieldRole::Feature,
                           .section = QT_TRANSLATE_NOOP("Fields", "Values (none: all of them)")})
            .when([](const S& s, const C&) { return !s.takesOff; }));
}

} // namespace crowd::model
