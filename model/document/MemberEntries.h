// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "model/describe/Field.h"
#include "model/scene/Scene.h"

/// What undo asks of the members of a scene: whether an edit changed them, and how much memory they
/// take. Structs that are described by fields (see Field.h) get both from their description.
namespace crowd::model {

/// Whether all fields are the same. Numbers are compared by their bits, as columns are: a
/// not-a-number is the same as itself, and 0 is not the same as -0, so that undo restores identical
/// bytes. So do all isSame().
[[nodiscard]] bool areFieldsSame(std::span<const FieldInfo> fields, const void* a, const void* b);
/// What the fields hold beside their struct.
[[nodiscard]] std::size_t bytesOfFields(std::span<const FieldInfo> fields, const void* object);

[[nodiscard]] bool isSame(const TemplateEntry& a, const TemplateEntry& b);
[[nodiscard]] bool isSame(const StageEntry& a, const StageEntry& b);
[[nodiscard]] bool isSame(const NamedCamera& a, const NamedCamera& b);
[[nodiscard]] bool isSame(const Place& a, const Place& b);
[[nodiscard]] bool isSame(const Path& a, const Path& b);
[[nodiscard]] bool isSame(const Rule& a, const Rule& b);
[[nodiscard]] bool isSame(const TagName& a, const TagName& b);
[[nodiscard]] bool isSame(const NumberName& a, const NumberName& b);
[[nodiscard]] bool isSame(const Cue& a, const Cue& b);
[[nodiscard]] bool isSame(const State& a, const State& b);
[[nodiscard]] bool isSame(const SurfaceSettings& a, const SurfaceSettings& b);
[[nodiscard]] inline bool isSame(std::uint32_t a, std::uint32_t b)
{
    return a == b;
}
[[nodiscard]] inline bool isSame(const RelationTable& a, const RelationTable& b)
{
    return a == b;
}
template<Described T>
[[nodiscard]] bool isSame(const T& a, const T& b)
{
    return areFieldsSame(fieldsOf<T>(), &a, &b) && a.unknownMembers == b.unknownMembers;
}
template<class Entry>
[[nodiscard]] bool isSame(const std::vector<Entry>& a, const std::vector<Entry>& b)
{
    return std::ranges::equal(a, b, [](const Entry& x, const Entry& y) { return isSame(x, y); });
}

/// In memory, with the struct itself and without assets, which are shared.
[[nodiscard]] std::size_t bytesOf(const TemplateEntry& entry);
[[nodiscard]] std::size_t bytesOf(const StageEntry& entry);
[[nodiscard]] std::size_t bytesOf(const NamedCamera& camera);
[[nodiscard]] std::size_t bytesOf(const Place& place);
[[nodiscard]] std::size_t bytesOf(const Path& path);
[[nodiscard]] std::size_t bytesOf(const Rule& rule);
[[nodiscard]] std::size_t bytesOf(const TagName& tag);
[[nodiscard]] std::size_t bytesOf(const NumberName& named);
[[nodiscard]] std::size_t bytesOf(const Cue& cue);
[[nodiscard]] std::size_t bytesOf(const State& state);
[[nodiscard]] std::size_t bytesOf(const SurfaceSettings& surface);
[[nodiscard]] inline std::size_t bytesOf(std::uint32_t value)
{
    return sizeof(value);
}
template<Described T>
[[nodiscard]] std::size_t bytesOf(const T& value)
{
    return sizeof(value) + bytesOfFields(fieldsOf<T>(), &value) + value.unknownMembers.size();
}
template<class Entry>
[[nodiscard]] std::size_t bytesOf(const std::vector<Entry>& entries)
{
    std::size_t total = 0;
    for (const Entry& entry : entries) {
        total += bytesOf(entry);
    }
    return total;
}

} // namespace crowd::model
