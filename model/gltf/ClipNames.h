// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/template/ClipRole.h"

namespace crowd::model::gltf {

/// What the name of a clip says about its use.
struct NamedUse
{
    enum class Kind : std::uint8_t {
        Unknown, ///< no word of it is known
        Action,  ///< something else than getting on, standing or sitting: a jump, an attack
        Plain,   ///< of `role`, and nothing beside
        Variant, ///< of `role`, with words that say more: "walk_gun"
        Weak     ///< may be of `role` where no other clip is: "crawl"
    };
    Kind kind = Kind::Unknown;
    ClipRole role = ClipRole::Other;

    [[nodiscard]] bool isOf(ClipRole wanted) const
    {
        return role == wanted && (kind == Kind::Plain || kind == Kind::Variant);
    }
};

/// By the words of each name, in the spellings that are usual: "Walk", "walk_01",
/// "Armature|Walking", "RunForward", "Rat_Walk", "walkcycle". Words that all names share say
/// nothing.
[[nodiscard]] std::vector<NamedUse> namedUses(const std::vector<std::string>& names);

} // namespace crowd::model::gltf
