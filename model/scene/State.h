// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/population/ColumnSet.h"
#include "model/population/StoredRows.h"
#include "model/scene/UnknownColumn.h"

namespace crowd::model {

/// Stable name of a state within its scene. 0 is none.
using StateId = std::uint32_t;

/// What a state remembers of a template, so that clips, slots and parts are found again by name
/// when the template has others by then.
struct StateTemplate
{
    TemplateId id = 0;
    std::vector<std::string> clips; ///< as TemplateEntry::clipNames
    std::vector<std::string> slots; ///< the first 8; none: the file was missing
    std::vector<std::string> parts;
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const StateTemplate&, const StateTemplate&) = default;
};

/// How some people were in some of their properties: a named copy that can be given back. People
/// and templates may be gone by then. A plain value; copies share the people.
struct State
{
    StateId id = 0;
    std::string name;
    ColumnSet columns; ///< what is given back; `people` has the template beside it
    std::vector<StateTemplate> templates; ///< of these people, ascending ids
    std::shared_ptr<const StoredRows> people = std::make_shared<const StoredRows>();
    std::vector<UnknownColumn> unknownColumns; ///< of the table of people
    std::vector<std::string> unknownHolds;     ///< columns that this version does not know
    std::string unknownMembers;                ///< see Scene::unknownMembers

    /// The same bytes of the same people, whether shared or not.
    friend bool operator==(const State& a, const State& b);
};

} // namespace crowd::model
