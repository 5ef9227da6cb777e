// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "model/base/Result.h"
#include "model/gltf/GltfJson.h"

namespace crowd::model::gltf {

/// Checks on the raw JSON that stop at the first fault. Every check returns whether all is well;
/// after false, problem() begins with the place of the fault. Indices and lengths written as 3.0
/// become 3.
class JsonCheck
{
public:
    explicit JsonCheck(Json& root) : m_root(root) {}

    enum class Need { Optional, Required };

    [[nodiscard]] Json& root() { return m_root; }
    [[nodiscard]] const Message& problem() const { return m_problem; }

    /// Notes the fault, a message whose %1 is its place; always false.
    template<class... Arguments>
    bool fail(const std::string& where, const char* id, const Arguments&... arguments)
    {
        m_problem = Message(id, where, arguments...);
        return false;
    }
    /// value is an index into the top-level array `target`.
    bool indexValue(Json& value, const char* target, const std::string& where);
    /// object[key] is one.
    bool index(Json& object, const std::string& key, const char* target, const std::string& where,
               Need need = Need::Optional);
    /// object[key] is a list of them.
    bool indices(Json& object, const char* key, const char* target, const std::string& where,
                 Need need = Need::Optional);
    /// object[key] is a whole number from low to high.
    bool whole(Json& object, const char* key, const std::string& where, std::uint64_t low,
               std::uint64_t high, Need need = Need::Optional);
    /// object[key], where it is there, is a list of `count` numbers.
    bool numbers(const Json& object, const char* key, std::size_t count, const std::string& where);
    /// Runs check(object, place) over the list parent[key] of objects.
    template<class Check>
    bool each(Json& parent, const char* key, const std::string& prefix, Check check)
    {
        const auto found = parent.find(key);
        if (found == parent.end()) {
            return true;
        }
        if (!found->is_array()) {
            return fail(prefix + key, QT_TRANSLATE_NOOP("Messages", "%1 is not a list"));
        }
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string where = prefix + place(key, i);
            if (!(*found)[i].is_object()) {
                return fail(where, QT_TRANSLATE_NOOP("Messages", "%1 is not an object"));
            }
            if (!check((*found)[i], where)) {
                return false;
            }
        }
        return true;
    }

private:
    Json& m_root;
    Message m_problem;
};

} // namespace crowd::model::gltf
