// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/population/Columns.h"

namespace crowd::model {

/// A column of a table in the project file that this version does not know: JSON text per
/// individual, kept so that saving loses nothing.
struct UnknownColumn
{
    std::string name;
    std::vector<std::pair<IndividualId, std::string>> values; ///< ascending ids
    friend bool operator==(const UnknownColumn&, const UnknownColumn&) = default;
};

} // namespace crowd::model
