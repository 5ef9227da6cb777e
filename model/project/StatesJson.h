// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonFields.h"
#include "model/scene/SceneMembers.h"

/// States as a member of the project file (see MemberJson.h). Their people are a table each, which
/// is written and read row by row beside it: members "ids", "columns", "rows".
namespace crowd::model {

/// Without the tables.
[[nodiscard]] nlohmann::json memberJson(members::States, const Scene& scene);
void readMember(members::States, JsonFields& top, Scene& scene, Message& problem);

/// Ascending ids as text: "1-700,712".
[[nodiscard]] std::string idsText(const std::vector<IndividualId>& ids);
/// The other way. False where it is none, or of more than `most`.
[[nodiscard]] bool readIds(const std::string& text, std::size_t most,
                           std::vector<IndividualId>& ids);

} // namespace crowd::model
