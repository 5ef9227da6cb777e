// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushSettings.h"
#include "widgets/docks/BrushForm.h"

namespace crowd::widgets {

// What the files that fill a BrushForm share: a part of it for each topic.

/// The heading that a form sets, of a brush's several.
using Heading = model::HeadingSettings& (*)(model::BrushSettings&);

inline const ValueSlider::Range kPercent{0.0, 100.0, 5.0, 0, QStringLiteral(" %"), false};

inline float asFloat(double value)
{
    return static_cast<float>(value);
}

inline bool isRandom(const model::BrushSettings& s)
{
    return s.op == model::BrushOperator::Random;
}

/// A slider over a float that is shown as a multiple of what is stored.
void addFloat(BrushForm& form, const QString& label, const ValueSlider::Range& range, double scale,
              float& (*value)(model::BrushSettings&), const BrushForm::Condition& isShown = {});
void addFlag(BrushForm& form, const QString& label, const QString& tip,
             bool& (*value)(model::BrushSettings&), const BrushForm::Condition& isShown = {});

void addThrough(BrushForm& form, const QString& tip, const BrushForm::Condition& isShown = {});
void addHeading(BrushForm& form, EditorState& state, Heading heading,
                const BrushForm::Condition& isShown);
void addCreation(BrushForm& form, EditorState& state);
void addColour(BrushForm& form, const EditorState& state);
void addAnimation(BrushForm& form);
void addWalk(BrushForm& form, const EditorState& state);
void addStyle(BrushForm& form);
void addTag(BrushForm& form, const EditorState& state);
void addEvent(BrushForm& form, const EditorState& state);
void addPlaces(BrushForm& form, model::BrushKind kind);

} // namespace crowd::widgets
