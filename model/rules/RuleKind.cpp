// SPDX-License-Identifier: MIT
#include "model/rules/RuleKind.h"

#include <algorithm>

namespace crowd::model {

void carryOver(std::span<const FieldInfo> from, const void* source, std::span<const FieldInfo> to,
               void* target)
{
    for (const FieldInfo& field : to) {
        const std::string_view key(field.meta.key);
        const auto former = std::ranges::find_if(from, [&](const FieldInfo& each) {
            return each.meta.isStored && each.type == field.type && key == each.meta.key;
        });
        if (field.meta.isStored && former != from.end()) {
            field.set(target, former->get(source));
        }
    }
}

std::size_t indexOfKind(std::span<const RuleKind> kinds, std::string_view key)
{
    const auto found =
        std::ranges::find_if(kinds, [key](const RuleKind& kind) { return key == kind.text.key; });
    return static_cast<std::size_t>(found - kinds.begin());
}

const RuleKind::AnySentence* sentenceOf(const RuleKind& kind, const void* object)
{
    for (const RuleKind::AnySentence& each : kind.sentences) {
        if (each.fits(object)) {
            return &each;
        }
    }
    return nullptr;
}

bool isShown(const FieldInfo& field, const void* object)
{
    return !field.isShown || field.isShown(object, {});
}

const FieldInfo* shownField(const RuleKind& kind, const void* object, std::string_view key)
{
    for (const FieldInfo& field : kind.fields) {
        if (key == field.meta.key && isShown(field, object)) {
            return &field;
        }
    }
    return nullptr;
}

} // namespace crowd::model
