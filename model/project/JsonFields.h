// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "model/base/Message.h"
#include "model/base/ShownText.h"

namespace crowd::model {

/// Reads members of one JSON object into typed variables and remembers the first thing that is
/// wrong, with its place ("templates[2].path"). Missing members leave the variable as it is unless
/// they are required. What was never asked for is what this version does not know: unknown(). Files
/// keep it, since a later version may have written it; what is written by hand is another matter:
/// `tolerated` names the only members that may be unknown.
class JsonFields
{
public:
    using Tolerated = std::set<std::string>;

    JsonFields(const nlohmann::json& object, std::string place, Message& firstProblem,
               const Tolerated* tolerated = nullptr)
        : m_object(object), m_place(std::move(place)), m_problem(firstProblem),
          m_tolerated(tolerated)
    {
        if (!m_object.is_object()) {
            complain("", QT_TRANSLATE_NOOP("Messages", "%1 must be an object"));
        }
    }

    /// A member of this object, or of a list in it, which is as strict.
    [[nodiscard]] JsonFields part(const nlohmann::json& object, std::string place) const
    {
        return {object, std::move(place), m_problem, m_tolerated};
    }

    /// An object of a list that is a member.
    [[nodiscard]] JsonFields item(const nlohmann::json& object, const char* list,
                                  std::size_t index) const
    {
        return part(object, placeOf(list) + "[" + std::to_string(index) + "]");
    }
    /// The same object, with what is wrong told to somebody else.
    [[nodiscard]] JsonFields apart(Message& problem) const
    {
        return {m_object, m_place, problem, nullptr};
    }
    [[nodiscard]] std::string placeOf(std::string_view key) const
    {
        return m_place + (m_place.empty() ? "" : ".") + std::string(key);
    }
    [[nodiscard]] bool isSound() const { return m_problem.empty(); }

    template<class Target>
    void read(std::string_view key, Target& target)
    {
        if (const nlohmann::json* value = find(key); value != nullptr && !assign(*value, target)) {
            complain(key, expected(target));
        }
    }
    template<class Target>
    void require(std::string_view key, Target& target)
    {
        if (find(key) == nullptr) {
            complain(key, QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
        }
        read(key, target);
    }
    /// Null when it is missing.
    [[nodiscard]] const nlohmann::json* find(std::string_view key)
    {
        if (!m_object.is_object()) {
            return nullptr;
        }
        if (std::ranges::find(m_asked, key) == m_asked.end()) {
            m_asked.emplace_back(key);
        }
        const auto found = m_object.find(std::string(key));
        return found == m_object.end() ? nullptr : &*found;
    }
    /// A message whose %1 is the place of the member, or of this object where there is no key.
    template<class... Arguments>
    void complain(std::string_view key, const char* id, const Arguments&... arguments)
    {
        if (m_problem.empty()) {
            m_problem = Message(id, key.empty() ? m_place : placeOf(key), arguments...);
        }
    }

    /// JSON text of an object with the members nobody asked for; empty when there are none.
    /// Complains where they are not tolerated.
    [[nodiscard]] std::string unknown()
    {
        nlohmann::json unknown = nlohmann::json::object();
        for (const auto& [key, value] : m_object.items()) {
            if (m_object.is_object() && std::ranges::find(m_asked, key) == m_asked.end()) {
                unknown[key] = value;
                if (m_tolerated != nullptr && !m_tolerated->contains(key)) {
                    complain("", QT_TRANSLATE_NOOP("Messages", "%1 has no \"%2\": there are %3"),
                             shortened(key), allAsked());
                }
            }
        }
        return unknown.empty() ? std::string() : unknown.dump();
    }
    static bool isFinite(const nlohmann::json& value)
    {
        return value.is_number() &&
               std::abs(value.get<double>()) <= double{std::numeric_limits<float>::max()};
    }

private:
    [[nodiscard]] std::string allAsked() const
    {
        std::string all;
        for (const std::string& each : m_asked) {
            all += (all.empty() ? "" : ", ") + each;
        }
        return all;
    }
    static bool assign(const nlohmann::json& value, float& target)
    {
        if (!isFinite(value)) {
            return false;
        }
        target = value.get<float>();
        return true;
    }
    static bool assign(const nlohmann::json& value, bool& target)
    {
        if (!value.is_boolean()) {
            return false;
        }
        target = value.get<bool>();
        return true;
    }
    static bool assign(const nlohmann::json& value, std::string& target)
    {
        if (!value.is_string()) {
            return false;
        }
        target = value.get<std::string>();
        return true;
    }
    template<class Unsigned>
    requires std::is_unsigned_v<Unsigned>
    static bool assign(const nlohmann::json& value, Unsigned& target)
    {
        if (!value.is_number_unsigned() ||
            value.get<std::uint64_t>() > std::numeric_limits<Unsigned>::max()) {
            return false;
        }
        target = value.get<Unsigned>();
        return true;
    }
    static bool assign(const nlohmann::json& value, glm::vec3& target)
    {
        return assignNumbers(value, &target.x, 3);
    }
    /// x, y, z, w, as glTF writes it.
    static bool assign(const nlohmann::json& value, glm::quat& target)
    {
        float numbers[4];
        if (!assignNumbers(value, numbers, 4)) {
            return false;
        }
        target = glm::quat(numbers[3], numbers[0], numbers[1], numbers[2]);
        const float length = glm::length(target);
        return length > 0.5F && length < 2.0F;
    }
    static bool assignNumbers(const nlohmann::json& value, float* target, std::size_t count)
    {
        if (!value.is_array() || value.size() != count) {
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!assign(value[i], target[i])) {
                return false;
            }
        }
        return true;
    }
    static const char* expected(float)
    {
        return QT_TRANSLATE_NOOP("Messages", "%1 must be a finite number");
    }
    static const char* expected(bool)
    {
        return QT_TRANSLATE_NOOP("Messages", "%1 must be true or false");
    }
    static const char* expected(const std::string&)
    {
        return QT_TRANSLATE_NOOP("Messages", "%1 must be a text");
    }
    static const char* expected(const glm::vec3&)
    {
        return QT_TRANSLATE_NOOP("Messages", "%1 must be three finite numbers");
    }
    static const char* expected(const glm::quat&)
    {
        return QT_TRANSLATE_NOOP("Messages", "%1 must be a unit quaternion [x, y, z, w]");
    }
    template<class Unsigned>
    requires std::is_unsigned_v<Unsigned>
    static const char* expected(Unsigned)
    {
        return QT_TRANSLATE_NOOP(
            "Messages", "%1 must be a whole number that is not negative and not too large");
    }

    const nlohmann::json& m_object;
    std::string m_place;
    Message& m_problem;
    const Tolerated* m_tolerated;
    std::vector<std::string> m_asked;
};

} // namespace crowd::model
