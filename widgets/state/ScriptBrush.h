// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// How a setting that a script brush brings along is shown. Its kind is that of its value.
struct ScriptField
{
    std::string name; ///< of a ScriptValue
    QString label;
    double low = 0.0; ///< numbers
    double high = 1.0;
    double step = 0.1;
    int decimals = 2;
    QStringList choices; ///< of a text: what it may be; empty: anything
};

/// A brush that a script brings along, known by its name.
struct ScriptBrush
{
    QString tip;
    std::vector<ScriptField> fields; ///< one for each of settings.script.values
    model::BrushSettings settings;   ///< as it is set now; settings.script.brush is the name
};

} // namespace crowd::widgets
