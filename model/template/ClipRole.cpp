// SPDX-License-Identifier: MIT
#include "model/template/ClipRole.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QtGlobal>

namespace crowd::model {

const std::array<ClipRoleInfo, 6>& clipRoles()
{
    static const std::array<ClipRoleInfo, 6> kRoles{{
        {ClipRole::Idle, "idle", QT_TRANSLATE_NOOP("ClipRole", "Idle"),
         QT_TRANSLATE_NOOP("ClipRole", "What the character does while it stands")},
        {ClipRole::Walk, "walk", QT_TRANSLATE_NOOP("ClipRole", "Walk"),
         QT_TRANSLATE_NOOP("ClipRole", "How it gets on at its usual speed")},
        {ClipRole::Run, "run", QT_TRANSLATE_NOOP("ClipRole", "Run"),
         QT_TRANSLATE_NOOP("ClipRole", "How it gets on when it is in a hurry")},
        {ClipRole::Fly, "fly", QT_TRANSLATE_NOOP("ClipRole", "Fly"),
         QT_TRANSLATE_NOOP("ClipRole",
                           "How it gets on without touching the ground, at the clip's own pace")},
        {ClipRole::Sit, "sit", QT_TRANSLATE_NOOP("ClipRole", "Sit"),
         QT_TRANSLATE_NOOP("ClipRole", "What it does on a seat")},
        {ClipRole::Other, "other", QT_TRANSLATE_NOOP("ClipRole", "Other"),
         QT_TRANSLATE_NOOP("ClipRole", "Played only where a brush or a rule asks for it")},
    }};
    return kRoles;
}

const char* keyOf(ClipRole role)
{
    return std::ranges::find(clipRoles(), role, &ClipRoleInfo::role)->key;
}

std::optional<ClipRole> clipRoleOf(std::string_view key)
{
    const auto found = std::ranges::find_if(
        clipRoles(), [key](const ClipRoleInfo& info) { return key == info.key; });
    return found == clipRoles().end() ? std::nullopt : std::optional(found->role);
}

/// Creatures of any size walk and run at about the same Froude numbers, v² / (g · leg), after
/// Alexander, "Estimates of speeds of dinosaurs" (1976); a leg is about half of the height.
float usualSpeedOf(ClipRole role, float heightMetres)
{
    constexpr float kGravity = 9.81F;
    constexpr float kWalks = 0.2F;
    constexpr float kRuns = 1.0F;
    const float leg = 0.5F * std::max(heightMetres, 0.0F);
    return std::sqrt((role == ClipRole::Run ? kRuns : kWalks) * kGravity * leg);
}

} // namespace crowd::model
