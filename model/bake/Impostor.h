// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/template/Template.h"

/// Impostors: pictures of a template from all around, drawn on a card in place of its triangles
/// where it is small (P. Maciel and P. Shirley, 1995). They hold what a surface is, not its colour:
/// tints, materials and light are applied when the card is drawn.
namespace crowd::model {

/// Directions around the template that it is pictured from, anticlockwise seen from above, the
/// first from the front (+Z).
inline constexpr int kImpostorAzimuths = 32;

/// A range of heights that it is seen from.
struct ImpostorBand
{
    float radians = 0.0F; ///< above the horizon, that it is pictured from
    float endSine = 1.0F; ///< of the angle up to which these pictures are shown
};
inline constexpr std::array<ImpostorBand, 8> kImpostorBands{{{-0.43F, -0.21F},
                                                             {0.0F, 0.11F},
                                                             {0.22F, 0.32F},
                                                             {0.44F, 0.52F},
                                                             {0.66F, 0.70F},
                                                             {0.88F, 0.83F},
                                                             {1.1F, 0.95F},
                                                             {1.4F, 1.0F}}};

/// A texel of a card: one RG32UI texel.
struct ImpostorTexel
{
    /// From the lowest bits: u 8, v 8 (both of the whole picture, wrapped into it), normal 16 as of
    /// a PackedVertex.
    std::uint32_t surface = 0;
    /// From the lowest bits: depth 8, slot 6 (kNoSlot: nothing is there), part 6 (kNoPart: always
    /// shown), vertex colour 4 + 4 + 4, each the square root of it.
    std::uint32_t kind = std::uint32_t{kNoSlot} << 8U;

    static constexpr std::uint32_t kNoSlot = 63;
    static constexpr std::uint32_t kNoPart = 63;

    friend bool operator==(const ImpostorTexel&, const ImpostorTexel&) = default;
};
static_assert(sizeof(ImpostorTexel) == 8);

/// How the cards of a clip lie. A card's plane goes through `middle` of the template, facing the
/// direction it is pictured from; metres at scale 1.
struct ImpostorLayout
{
    int keyframesPerPhase = 1;
    int phases = 1;
    int layers = 1;       ///< 2: behind each card one without the parts that can be hidden
    glm::ivec2 texels{0}; ///< of a card; 0: there are none, it would take too many
    float middle = 0.0F;  ///< metres above the foot point
    glm::vec2 low{0.0F};  ///< metres from there to the card's lower left corner: right, up
    glm::vec2 size{0.0F};
    float nearest = 0.0F; ///< metres towards the eye of depth 0; depth 255 is `depth` behind it
    float depth = 0.0F;

    [[nodiscard]] bool isEmpty() const { return texels.x == 0; }
    [[nodiscard]] std::size_t cardCount() const
    {
        return static_cast<std::size_t>(phases) * kImpostorAzimuths;
    }
    /// Of whole cards; those of a set are fewer.
    [[nodiscard]] std::size_t texelCount() const
    {
        return cardCount() * static_cast<std::size_t>(layers) * static_cast<std::size_t>(texels.x) *
               static_cast<std::size_t>(texels.y);
    }
    [[nodiscard]] std::size_t mostBytes() const; ///< ImpostorSet::bytes() is never more
    /// Which phase is nearest to a keyframe and the share of the way to the next one.
    [[nodiscard]] int phaseOf(float keyframe, bool isLoop) const;
};

/// Where on a card something is, all layers together: only that is kept.
struct ImpostorCard
{
    glm::u8vec4 shown{0};    ///< texels from (x, y) up to before (z, w)
    std::uint32_t first = 0; ///< texel of the set: layer by layer, rows of what is shown from below
    /// The plane nearest to what it shows, which hides and is hidden in its stead: metres towards
    /// the eye in the middle of the card, and per metre right and up from there.
    glm::vec3 plane{0.0F};
};

inline std::size_t ImpostorLayout::mostBytes() const
{
    return texelCount() * sizeof(ImpostorTexel) + cardCount() * sizeof(ImpostorCard);
}

/// All cards of a clip in a band.
struct ImpostorSet
{
    int band = 0;
    ImpostorLayout layout;
    std::vector<ImpostorTexel> texels; ///< of what cards show, card by card
    std::vector<ImpostorCard> cards;   ///< phase by phase, azimuth by azimuth

    [[nodiscard]] std::size_t bytes() const
    {
        return texels.size() * sizeof(ImpostorTexel) + cards.size() * sizeof(ImpostorCard);
    }
};

/// What is seen through or cut out by its picture, and more slots than fit, have none.
[[nodiscard]] bool canHaveImpostors(const Template& asset);

/// Looks at some thousand of the clip's vertices.
[[nodiscard]] ImpostorLayout impostorLayout(const Template& asset, int clipIndex,
                                            const BakedClip& clip, int band);

/// Of the whole clip. Pure: the same bits on every thread. Asks `isCancelled` between cards and
/// returns null once it says yes.
[[nodiscard]] ImpostorSetPtr bakeImpostors(const Template& asset, int clipIndex,
                                           const BakedClip& clip, int band,
                                           const std::function<bool()>& isCancelled = {});

/// The axes of a card in the template's frame: unit vectors.
struct CardAxes
{
    glm::vec3 right{1.0F, 0.0F, 0.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    glm::vec3 towards{0.0F, 0.0F, 1.0F}; ///< the eye
};
[[nodiscard]] CardAxes cardAxes(int azimuth, int band);

} // namespace crowd::model
