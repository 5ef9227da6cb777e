// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace crowd::model {

/// What a clip is for: which clips somebody moves with, stands with and sits with.
enum class ClipRole : std::uint8_t {
    Other, ///< only plays where somebody asks for it
    Idle,
    Walk,
    Run,
    Fly, ///< moves over the ground without touching it: plays at its own pace
    Sit
};

/// Roles in the order in which they are offered.
struct ClipRoleInfo
{
    ClipRole role;
    const char* key;   ///< in files and scripts
    const char* label; ///< to be translated in the context "ClipRole"
    const char* tip;
};
[[nodiscard]] const std::array<ClipRoleInfo, 6>& clipRoles();
[[nodiscard]] const char* keyOf(ClipRole role);
/// Nothing for a word that is no key.
[[nodiscard]] std::optional<ClipRole> clipRoleOf(std::string_view key);

/// Whether people who go somewhere play such a clip.
[[nodiscard]] constexpr bool isGait(ClipRole role)
{
    return role == ClipRole::Walk || role == ClipRole::Run || role == ClipRole::Fly;
}

/// How fast a creature of that height usually is in such a gait, m/s: where its clip does not tell.
[[nodiscard]] float usualSpeedOf(ClipRole role, float heightMetres);

} // namespace crowd::model
