// SPDX-License-Identifier: MIT
#include "model/rules/Rule.h"

namespace crowd::model {

std::vector<std::uint32_t> idsNamedIn(const Rule& rule, FieldRole role)
{
    std::vector<std::uint32_t> ids;
    forEachPart(rule, [&](const RuleKind& kind, const void* object) {
        for (const FieldInfo& field : kind.fields) {
            if (field.meta.role == role && field.meta.isStored) {
                const FieldValue value = field.get(object);
                ids.push_back(static_cast<std::uint32_t>(std::get<std::int64_t>(value)));
            }
        }
    });
    return ids;
}

} // namespace crowd::model
