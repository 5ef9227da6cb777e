// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "model/base/Result.h"
#include "model/project/RowParser.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// What each row of the table of relations says, in this order.
inline constexpr std::array kLinkColumns{"from", "to", "kind", "strength"};

/// Takes the cells of the table of relations one after the other.
class LinkParser
{
public:
    static constexpr const char* kPlace = "relations";

    /// The names in the file, which must be kLinkColumns.
    [[nodiscard]] Result<void> begin(const nlohmann::json& names);
    /// Null when it fits, a message of what is expected otherwise.
    [[nodiscard]] const char* put(const CellValue& value);
    /// False where the row has not one value for each column.
    [[nodiscard]] bool endRow();
    [[nodiscard]] std::size_t rowCount() const { return m_relations.size(); }
    /// Column of the value that comes next.
    [[nodiscard]] std::size_t cell() const { return m_cell; }

    /// Relates the people of the scene. Relations of people or kinds that there are not, to
    /// oneself, and those that are there already are left out, with a warning.
    void fill(Scene& scene) const;

private:
    Relation m_next;
    std::size_t m_cell = 0;
    bool m_isBegun = false;
    std::vector<Relation> m_relations;
};

} // namespace crowd::model
