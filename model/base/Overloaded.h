// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::model {

/// Several functions as one visitor, for std::visit.
template<class... Visitors>
struct Overloaded : Visitors...
{
    using Visitors::operator()...;
};
template<class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

} // namespace crowd::model
