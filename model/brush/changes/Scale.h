// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/brush/changes/ColumnRange.h"
#include "model/brush/operators/Operators.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Makes people taller or smaller, stouter or slimmer: each by a range and an operator of its own.
struct ScaleSettings
{
    bool setsHeight = true;
    ValueRange height{0.9F, 1.1F}; ///< scale
    BrushOperator heightOperator = BrushOperator::Random;
    bool setsGirth = true;
    ValueRange girth{0.9F, 1.1F}; ///< scale
    BrushOperator girthOperator = BrushOperator::Random;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static constexpr auto columnRanges();
    template<class Brush>
    static MainNumber mainNumber(const Brush& brush)
    {
        return {QT_TRANSLATE_NOOP("BrushTexts", "Height"),
                QT_TRANSLATE_NOOP("BrushTexts", "Height: × %1"),
                brush.template as<ScaleSettings>().height.low,
                0.1,
                10.0,
                0.05,
                2};
    }
    template<class Brush>
    static void setMainNumber(Brush& brush, float value)
    {
        auto& settings = brush.template as<ScaleSettings>();
        settings.height = {value, value + settings.height.high - settings.height.low};
        settings.setsHeight = true;
    }
    friend bool operator==(const ScaleSettings&, const ScaleSettings&) = default;
};

inline constexpr BrushInfo ScaleSettings::kInfo{
    .id = "scale",
    .name = QT_TRANSLATE_NOOP("Tools", "Size Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Si&ze"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Make the characters under the brush taller or stouter"),
    .shortcut = "H",
    .order = 32,
    .section = BrushSection::Look,
    .scriptKind = "SCALE",
    .scriptName = "scale",
    .scriptClass = "ScaleSettings",
    .doc = "Height and girth, each with a range and an operator.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: scale characters · + −: how tall"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters scaled"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Scale %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already have this size"),
    .operatorPlace = OperatorPlace::CurveOnly,
    .buildsUp = true,
    .flows = true};

/// What the strokes write: a range of a column, by an operator, with a draw known by its name.
constexpr auto ScaleSettings::columnRanges()
{
    using S = ScaleSettings;
    return std::array{
        ColumnRange<S>{&S::setsHeight, &S::height, &S::heightOperator, columns::height,
                       "scale.height"},
        ColumnRange<S>{&S::setsGirth, &S::girth, &S::girthOperator, columns::girth, "scale.girth"}};
}

namespace detail {

constexpr FieldMeta scaleRange(const char* key, const char* label,
                               FieldRole role = FieldRole::Plain)
{
    return {.key = key,
            .label = label,
            .doc = "Scale, (lowest, highest).",
            .low = kMinScale,
            .high = kMaxScale,
            .sliderLow = 0.5,
            .sliderHigh = 2.0,
            .step = 0.01,
            .role = role};
}

constexpr FieldMeta scaleOperator(const char* key)
{
    return {.key = key,
            .label = QT_TRANSLATE_NOOP("Fields", "Values"),
            .doc = "How the values vary: lowest for all, drawn, or along the line.",
            .choices = kOperatorChoices};
}

} // namespace detail

constexpr auto ScaleSettings::fields()
{
    using S = ScaleSettings;
    using C = FieldContext;
    const auto withHeight = [](const S& s, const C&) { return s.setsHeight; };
    const auto withGirth = [](const S& s, const C&) { return s.setsGirth; };
    return std::tuple(
        field(&S::setsHeight, {.key = "sets_height",
                               .label = QT_TRANSLATE_NOOP("Fields", "Change the height"),
                               .section = QT_TRANSLATE_NOOP("Fields", "Height")}),
        field(&S::height, detail::scaleRange("height", QT_TRANSLATE_NOOP("Fields", "Height"),
                                             FieldRole::Stature))
            .when(withHeight),
        field(&S::heightOperator, detail::scaleOperator("height_operator")).when(withHeight),
        field(&S::setsGirth, {.key = "sets_girth",
                              .label = QT_TRANSLATE_NOOP("Fields", "Change the girth"),
                              .section = QT_TRANSLATE_NOOP("Fields", "Girth")}),
        field(&S::girth, detail::scaleRange("girth", QT_TRANSLATE_NOOP("Fields", "Girth")))
            .when(withGirth),
        field(&S::girthOperator, detail::scaleOperator("girth_operator")).when(withGirth));
}

} // namespace crowd::model
