// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "model/base/Result.h"
#include "model/project/RowParser.h"
#include "model/project/TreeBuilder.h"

namespace crowd::model {

/// The people of a state in a file: a table whose ids stand before it.
struct StateTable
{
    std::size_t state = 0; ///< which one in the file
    RowParser rows;
    std::vector<IndividualId> ids; ///< ascending

    /// Ids and columns, from the object of the state as far as it has been read.
    [[nodiscard]] Result<void> readHead(const nlohmann::json& object, std::size_t mostPeople);
};

/// The tables of all states of a file, one after the other as they come.
class StateTables
{
public:
    /// The rows of the state that the header is at: the last one of its list.
    [[nodiscard]] Result<StateTable*> begin(const TreeBuilder& header);
    /// Hands the people over to the states of the scene.
    [[nodiscard]] Result<void> fill(Scene& scene);

private:
    std::vector<std::unique_ptr<StateTable>> m_tables; ///< as far as they were read
};

/// A list of texts.
[[nodiscard]] bool areColumnNames(const nlohmann::json& names);

} // namespace crowd::model
