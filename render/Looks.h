// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <QtCore/QtGlobal>

/// How the view is drawn. A look is a row of data: menus, the command line, scripts and what the
/// editor remembers follow from the table.
namespace crowd::render {

enum class Look : std::uint8_t { Plain, Lit, Cartoon };

/// Texts are literals: `label` and `tip` in the translation context "Looks".
struct LookInfo
{
    Look look;
    const char* key; ///< on the command line, in scripts and in settings; "look-KEY" is its action
    const char* label;
    const char* tip;
    const char* defines; ///< what the shaders of people and stages are compiled with
    bool isLit;          ///< ground and shadows follow the scene's light
    float inkPixels;     ///< width of lines around things and along creases, logical; 0: none
};

inline constexpr std::array kLooks{
    LookInfo{Look::Plain, "plain", QT_TRANSLATE_NOOP("Looks", "&Plain Colours"),
             QT_TRANSLATE_NOOP("Looks", "Base colours without light"), "", false, 0.0F},
    LookInfo{Look::Lit, "lit", QT_TRANSLATE_NOOP("Looks", "&Lit"),
             QT_TRANSLATE_NOOP("Looks", "Light of the sun and the sky"), "LIT ", true, 0.0F},
    LookInfo{Look::Cartoon, "cartoon", QT_TRANSLATE_NOOP("Looks", "&Cartoon"),
             QT_TRANSLATE_NOOP("Looks", "Ink lines, and light in three steps"), "LIT CARTOON ",
             true, 2.0F}};

namespace detail {

constexpr bool isEveryLookAtItsPlace()
{
    for (std::size_t i = 0; i < kLooks.size(); ++i) {
        if (kLooks[i].look != static_cast<Look>(i)) {
            return false;
        }
    }
    return true;
}
static_assert(isEveryLookAtItsPlace());

} // namespace detail

[[nodiscard]] constexpr const LookInfo& lookInfo(Look look)
{
    return kLooks[static_cast<std::size_t>(look)];
}

/// Nothing where there is no such look.
[[nodiscard]] constexpr std::optional<Look> lookOfKey(std::string_view key)
{
    for (const LookInfo& info : kLooks) {
        if (key == info.key) {
            return info.look;
        }
    }
    return std::nullopt;
}

/// "plain, lit".
[[nodiscard]] inline std::string lookKeys()
{
    std::string all;
    for (const LookInfo& info : kLooks) {
        all += (all.empty() ? "" : ", ") + std::string(info.key);
    }
    return all;
}

} // namespace crowd::render
