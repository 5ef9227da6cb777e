// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "model/describe/Field.h"

namespace crowd::model {

struct Light;

// One that shines to all sides has nothing that other lights have not.
inline constexpr FieldChoice kPointLight{"point", QT_TRANSLATE_NOOP("Fields", "Point light")};
/// It stands over what it lights, as a lantern does.
void beginPoint(Light& light, const glm::vec3& lit, const glm::vec3& seenFrom);

} // namespace crowd::model
