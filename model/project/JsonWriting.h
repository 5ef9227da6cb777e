// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace crowd::model {

/// A float as the shortest decimal that reads back as the same float (a double would drag digits).
inline nlohmann::json number(float value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double shortest = 0.0;
    std::from_chars(text.data(), end, shortest);
    return shortest;
}

inline nlohmann::json numbers(const glm::vec3& v)
{
    return {number(v.x), number(v.y), number(v.z)};
}

inline nlohmann::json numbers(const glm::quat& q)
{
    return {number(q.x), number(q.y), number(q.z), number(q.w)};
}

/// The members known here over those that were kept unread.
inline nlohmann::json withUnknown(const std::string& unknownMembers, const nlohmann::json& known)
{
    if (unknownMembers.empty()) {
        return known;
    }
    nlohmann::json object = nlohmann::json::parse(unknownMembers);
    object.update(known);
    return object;
}

} // namespace crowd::model
