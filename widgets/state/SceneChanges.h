// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <variant>

#include "model/base/Overloaded.h"
#include "model/scene/SceneChange.h"

namespace crowd::widgets {

/// Calls the function that takes this kind of change; where none does, nothing happens.
template<class... Functions>
void visitChange(const model::SceneChange& change, Functions... functions)
{
    std::visit(
        [visitor = model::Overloaded{std::move(functions)...}]<class Change>(const Change& each) {
            if constexpr (std::is_invocable_v<const decltype(visitor)&, const Change&>) {
                visitor(each);
            }
        },
        change);
}

/// Whether it is of one of these kinds.
template<class... Kinds>
[[nodiscard]] bool isOneOf(const model::SceneChange& change)
{
    return std::visit(
        []<class Change>(const Change&) { return (std::is_same_v<Change, Kinds> || ...); }, change);
}

} // namespace crowd::widgets
