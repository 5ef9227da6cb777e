// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "model/brush/operators/Operators.h"
#include "model/population/Columns.h"

namespace crowd::model {

/// A range of a brush's settings that is written to a column of numbers. A settings struct with a
/// static columnRanges() of these needs no change() of its own: strokes write what each says, by
/// its operator, where it is on; with build up they go a share of the way.
template<class Settings>
struct ColumnRange
{
    bool Settings::*isOn;
    ValueRange Settings::*range;
    BrushOperator Settings::*op;
    ColumnKey<float> column;
    std::string_view draw; ///< names the draws: "scale.height"
};

} // namespace crowd::model
