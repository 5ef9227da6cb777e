// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

namespace crowd::model::gltf {

/// Makes names unique: the second "Walk" becomes "Walk 2".
class NameSet
{
public:
    [[nodiscard]] std::string unique(const std::string& name)
    {
        std::string candidate = name;
        for (int number = 2; !m_names.insert(candidate).second; ++number) {
            candidate = name + " " + std::to_string(number);
        }
        return candidate;
    }

private:
    std::set<std::string> m_names;
};

} // namespace crowd::model::gltf
