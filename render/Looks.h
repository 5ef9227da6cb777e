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

enum class Look : std::uint8_t {
    Plain,
    Lit,
    Cartoon,
    Clay,
    Silhouettes,
    Blueprint,
    Wireframe,
    Property
};

/// One colour for all of a kind, whatever their materials are. sRGB, 0xRRGGBB.
struct LookPaint
{
    std::uint32_t people;
    std::uint32_t stage;
    std::uint32_t ground;
    std::uint32_t sky;
    std::uint32_t ink;
};

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
    const LookPaint* paint = nullptr; ///< null: the colours of the scene
    bool isWire = false;              ///< edges of triangles instead of surfaces
    /// The frame has a colour for each (model::paintedFrame()), in a light that leaves it as it is.
    bool isByProperty = false;
};

inline constexpr LookPaint kClayPaint{0xC9B8A6, 0xB4B1AC, 0xA9A7A3, 0xD3D6D8, 0x000000};
inline constexpr LookPaint kSilhouettesPaint{0x101114, 0x9AA0A6, 0xD9DCDF, 0xF2F3F4, 0x000000};
inline constexpr LookPaint kBlueprintPaint{0x2A5DA8, 0x1D4788, 0x173B75, 0x14356B, 0xE8F0FF};
inline constexpr LookPaint kWirePaint{0xF2B45A, 0x7C8794, 0x23262B, 0x1B1D21, 0x000000};
inline constexpr LookPaint kPropertyPaint{0xFFFFFF, 0xB9BCC0, 0xA6A9AD, 0xDDE1E4, 0x000000};

inline constexpr std::array kLooks{
    LookInfo{Look::Plain, "plain", QT_TRANSLATE_NOOP("Looks", "&Plain Colours"),
             QT_TRANSLATE_NOOP("Looks", "Base colours without light"), "", false, 0.0F},
    LookInfo{Look::Lit, "lit", QT_TRANSLATE_NOOP("Looks", "&Lit"),
             QT_TRANSLATE_NOOP("Looks", "Light of the sun and the sky"), "LIT ", true, 0.0F},
    LookInfo{Look::Cartoon, "cartoon", QT_TRANSLATE_NOOP("Looks", "&Cartoon"),
             QT_TRANSLATE_NOOP("Looks", "Ink lines, and light in three steps"), "LIT CARTOON ",
             true, 2.0F},
    LookInfo{Look::Clay, "clay", QT_TRANSLATE_NOOP("Looks", "Cl&ay"),
             QT_TRANSLATE_NOOP("Looks", "Shapes and light alone: everything of one material"),
             "LIT ", true, 0.0F, &kClayPaint},
    LookInfo{Look::Silhouettes, "silhouettes", QT_TRANSLATE_NOOP("Looks", "&Silhouettes"),
             QT_TRANSLATE_NOOP("Looks", "Dark people on a bright ground, as a crowd is read"), "",
             false, 0.0F, &kSilhouettesPaint},
    LookInfo{Look::Blueprint, "blueprint", QT_TRANSLATE_NOOP("Looks", "&Blueprint"),
             QT_TRANSLATE_NOOP("Looks", "Bright lines on blue, as a plan is drawn"), "", false,
             1.5F, &kBlueprintPaint},
    LookInfo{Look::Wireframe, "wireframe", QT_TRANSLATE_NOOP("Looks", "&Wireframe"),
             QT_TRANSLATE_NOOP("Looks", "Edges of the triangles that are drawn"), "", false, 0.0F,
             &kWirePaint, true},
    LookInfo{Look::Property, "property", QT_TRANSLATE_NOOP("Looks", "By P&roperty"),
             QT_TRANSLATE_NOOP("Looks", "A colour for each template, group, mood, density and "
                                        "more, with a legend"),
             "LIT OWN_COLOUR ", true, 0.0F, &kPropertyPaint, false, true}};

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
