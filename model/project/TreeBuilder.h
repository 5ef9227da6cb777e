// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace crowd::model {

/// Builds a small tree from events: the header, and cells of unknown columns.
class TreeBuilder
{
public:
    /// The finished value, when the last event completed one.
    [[nodiscard]] bool isComplete() const { return m_isComplete; }
    nlohmann::json take()
    {
        m_isComplete = false;
        return std::move(m_root);
    }
    /// A member of the unfinished object, null when it has not come yet.
    [[nodiscard]] const nlohmann::json* peek(const std::string& name) const
    {
        return m_root.is_object() && m_root.contains(name) ? &m_root[name] : nullptr;
    }
    /// What was built so far.
    [[nodiscard]] const nlohmann::json& root() const { return m_root; }
    /// What is open, the innermost.
    [[nodiscard]] const nlohmann::json& current() const { return *m_open.back(); }
    [[nodiscard]] std::size_t valueCount() const { return m_values; }
    /// False when the open object has this member already.
    [[nodiscard]] bool key(std::string name)
    {
        m_key = std::move(name);
        return !m_open.back()->contains(m_key);
    }
    void value(nlohmann::json item)
    {
        place(std::move(item));
        m_isComplete = m_open.empty();
    }
    void open(nlohmann::json container) { m_open.push_back(&place(std::move(container))); }
    void close()
    {
        m_open.pop_back();
        m_isComplete = m_open.empty();
    }

private:
    nlohmann::json& place(nlohmann::json item)
    {
        ++m_values;
        if (m_open.empty()) {
            m_root = std::move(item);
            return m_root;
        }
        nlohmann::json& container = *m_open.back();
        if (container.is_array()) {
            container.push_back(std::move(item));
            return container.back();
        }
        nlohmann::json& target = container[m_key];
        target = std::move(item);
        return target;
    }

    nlohmann::json m_root;
    std::vector<nlohmann::json*> m_open;
    std::string m_key;
    std::size_t m_values = 0;
    bool m_isComplete = false;
};

} // namespace crowd::model
