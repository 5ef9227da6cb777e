// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace crowd::model::gltf {

/// Makes names unique: the second "Walk" becomes "Walk 2".
class NameSet
{
public:
    [[nodiscard]] std::string unique(const std::string& name)
    {
        std::string candidate = name;
        while (!m_uses.try_emplace(candidate, 1).second) {
            candidate = name + " " + std::to_string(++m_uses[name]);
        }
        return candidate;
    }

private:
    std::map<std::string, int> m_uses; ///< how often each was asked for
};

} // namespace crowd::model::gltf
