// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtCore/QString>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// What a script says of a setting of its brush. Its type is that of its value.
struct ScriptField
{
    std::string name; ///< of a ScriptValue
    std::string label;
    double low = 0.0; ///< numbers
    double high = 1.0;
    double step = 0.1;
    int decimals = 2;
    std::vector<std::string> choices; ///< of a text: what it may be; empty: anything
};

using FieldList = std::shared_ptr<const std::vector<model::FieldInfo>>;

/// Descriptions of such settings, one for each value, over model::ScriptSettings. They own their
/// texts.
[[nodiscard]] FieldList describeScriptFields(std::vector<ScriptField> fields,
                                             const std::vector<model::ScriptValue>& values);

/// A brush that a script brings along, known by its name.
struct ScriptBrush
{
    QString tip;
    FieldList fields = std::make_shared<const std::vector<model::FieldInfo>>();
    /// As it is set now; its ScriptSettings have the name.
    model::BrushSettings settings{model::BrushKind::Script};
};

} // namespace crowd::widgets
