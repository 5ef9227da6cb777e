// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include <QtCore/QString>

#include "model/rules/RuleSequence.h"

class QHBoxLayout;
class QWidget;

namespace crowd::widgets {

/// Makes an undo step of a change of a rule.
using ApplyToRule = std::function<void(const std::function<void(model::Rule&)>&)>;

/// The order in which a rule lets people do things, and what belongs to what: the word before an
/// action, "do", "then", "either", "or".
[[nodiscard]] QString wordBefore(const model::Actions& actions, std::size_t index);

/// Buttons that move an action up and down; what they cannot do is off. They are `editor`'s.
void addMoveButtons(QHBoxLayout& row, QWidget& editor, const model::Actions& actions,
                    std::size_t index, const ApplyToRule& apply);

} // namespace crowd::widgets
