// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include "model/bake/Impostor.h"
#include "model/bake/ImpostorRaster.h"

namespace crowd::model {

namespace {

constexpr float kTexelsPerHeight = 34.0F; ///< of what is shown of the template
constexpr int kMostTexels = 4096;         ///< of a card
constexpr float kMostAlongASide = 255.0F; ///< so that ImpostorCard::shown holds it
constexpr std::size_t kLookedAt = 20000;  ///< vertices, over all keyframes
constexpr float kMostMoved = 1.5F; ///< texels between two phases, nine tenths of the vertices
constexpr int kMostKeyframesPerPhase = 8;
constexpr float kHalf = 0.5F; ///< to the nearest: quicker than lround, for each of a crowd

/// Some of a clip's vertices, by which its cards are laid out.
class Sampled
{
public:
    Sampled(const BakedClip& clip, std::size_t vertices)
        : m_clip(clip), m_vertices(vertices),
          m_every(std::max<std::size_t>(1, vertices * static_cast<std::size_t>(clip.keyframes) /
                                               kLookedAt))
    {
    }

    /// Calls each(position) for vertices of every keyframe.
    template<class Each>
    void walk(Each&& each) const
    {
        for (int keyframe = 0; keyframe < m_clip.keyframes; ++keyframe) {
            for (std::size_t v = 0; v < m_vertices; v += m_every) {
                each(m_clip.position(0, keyframe, v));
            }
        }
    }

    /// How far vertices move from keyframe to keyframe on average, metres: nine tenths less.
    [[nodiscard]] float moved() const
    {
        std::vector<float> ways;
        for (std::size_t v = 0; v < m_vertices; v += m_every) {
            float way = 0.0F;
            for (int keyframe = 1; keyframe < m_clip.keyframes; ++keyframe) {
                way += glm::distance(m_clip.position(0, keyframe - 1, v),
                                     m_clip.position(0, keyframe, v));
            }
            ways.push_back(way / static_cast<float>(std::max(1, m_clip.keyframes - 1)));
        }
        const auto most = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() * 9 / 10);
        std::nth_element(ways.begin(), most, ways.end());
        return *most;
    }

private:
    const BakedClip& m_clip;
    std::size_t m_vertices;
    std::size_t m_every;
};

/// From the lowest to the highest value.
struct Range
{
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();

    void add(float from, float to)
    {
        low = std::min(low, from);
        high = std::max(high, to);
    }
};

/// Sums of points of a card by which the plane nearest to them is found: least squares, in metres
/// right, up and towards the eye.
class PlaneFit
{
public:
    void add(const glm::dvec2& at, double towards)
    {
        const glm::dvec3 point(1.0, at.x, at.y);
        m_points += glm::outerProduct(point, point);
        m_towards += point * towards;
    }

    /// Towards the eye at (0, 0), and per metre right and up. Upright where a card is too narrow to
    /// tell.
    [[nodiscard]] glm::vec3 plane() const
    {
        constexpr double kSteepest = 2.0;
        if (!(m_points[0][0] > 0.0)) {
            return glm::vec3(0.0F);
        }
        const double mean = m_towards[0] / m_points[0][0];
        const double spread = glm::determinant(m_points / m_points[0][0]);
        const glm::dvec3 found =
            spread > 1e-9 ? glm::inverse(m_points) * m_towards : glm::dvec3(mean, 0.0, 0.0);
        const glm::dvec2 slopes = glm::clamp(glm::dvec2(found.y, found.z), -kSteepest, kSteepest);
        // Through the middle of the points, whatever has become of the slopes.
        const glm::dvec2 middle = glm::dvec2(m_points[0][1], m_points[0][2]) / m_points[0][0];
        return {mean - glm::dot(slopes, middle), slopes};
    }

private:
    glm::dmat3 m_points{0.0};
    glm::dvec3 m_towards{0.0};
};

/// Of the layers of a card.
ImpostorCard cardOf(std::span<const ImpostorTexel> texels, const ImpostorLayout& layout)
{
    const glm::ivec2 size = layout.texels;
    glm::ivec2 low = size;
    glm::ivec2 high(0);
    PlaneFit fit;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if ((texels[i].kind >> 8U & ImpostorTexel::kNoSlot) == ImpostorTexel::kNoSlot) {
            continue;
        }
        const int at = static_cast<int>(i) % (size.x * size.y);
        const glm::ivec2 place(at % size.x, at / size.x);
        low = glm::min(low, place);
        high = glm::max(high, place + 1);
        const glm::vec2 share = (glm::vec2(place) + kHalf) / glm::vec2(size);
        const float depth = static_cast<float>(texels[i].kind & 0xFFU) / 255.0F;
        fit.add(layout.low + share * layout.size, layout.nearest - depth * layout.depth);
    }
    ImpostorCard card;
    card.shown = high.x > 0 ? glm::u8vec4(low.x, low.y, high.x, high.y) : glm::u8vec4(0);
    card.plane = fit.plane();
    return card;
}

/// Adds a card, of the texels of its layers what it shows.
void add(ImpostorSet& set, std::span<const ImpostorTexel> texels)
{
    ImpostorCard card = cardOf(texels, set.layout);
    card.first = static_cast<std::uint32_t>(set.texels.size());
    const glm::ivec2 size = set.layout.texels;
    const auto width = static_cast<std::size_t>(card.shown.z - card.shown.x);
    for (int layer = 0; layer < set.layout.layers; ++layer) {
        for (int y = card.shown.y; y < card.shown.w; ++y) {
            const int begin = (layer * size.y + y) * size.x + card.shown.x;
            const auto row = texels.subspan(static_cast<std::size_t>(begin), width);
            set.texels.insert(set.texels.end(), row.begin(), row.end());
        }
    }
    set.cards.push_back(card);
}

bool isWrapped(const Template& asset)
{
    return std::ranges::all_of(asset.levels.front().uv, [](const glm::vec2& uv) {
        return uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F;
    });
}

} // namespace

int ImpostorLayout::phaseOf(float keyframe, bool isLoop) const
{
    const auto phase = static_cast<int>(keyframe / static_cast<float>(keyframesPerPhase) + kHalf);
    return phase < phases ? std::max(phase, 0) : isLoop ? phase % phases : phases - 1;
}

CardAxes cardAxes(int azimuth, int band)
{
    const float around =
        glm::two_pi<float>() * static_cast<float>(azimuth) / static_cast<float>(kImpostorAzimuths);
    const float above = kImpostorBands[static_cast<std::size_t>(band)].radians;
    CardAxes axes;
    axes.right = {std::cos(around), 0.0F, -std::sin(around)};
    axes.towards = {std::sin(around) * std::cos(above), std::sin(above),
                    std::cos(around) * std::cos(above)};
    axes.up = glm::cross(axes.towards, axes.right);
    return axes;
}

bool canHaveImpostors(const Template& asset)
{
    const bool isSolid = std::ranges::all_of(asset.slots, [](const Slot& slot) {
        return std::ranges::all_of(slot.choices, [](const MaterialChoice& choice) {
            return choice.alphaMode == AlphaMode::Opaque;
        });
    });
    const bool isRepeated = std::ranges::all_of(asset.slots, [](const Slot& slot) {
        return std::ranges::all_of(slot.choices, [](const MaterialChoice& choice) {
            return choice.wrapU == Wrap::Repeat && choice.wrapV == Wrap::Repeat;
        });
    });
    return isSolid && asset.slots.size() < ImpostorTexel::kNoSlot && !asset.levels.empty() &&
           !asset.levels.front().positions.empty() && (isRepeated || isWrapped(asset));
}

ImpostorLayout impostorLayout(const Template& asset, int clipIndex, const BakedClip& clip, int band)
{
    const float above = kImpostorBands[static_cast<std::size_t>(band)].radians;
    const float shown = std::min(asset.height, clip.bounds.size().y);
    const float texel = shown / kTexelsPerHeight;
    ImpostorLayout layout;
    if (!canHaveImpostors(asset) || !(texel > 0.0F) || clip.levels.empty()) {
        return layout;
    }
    layout.middle = clip.bounds.center().y;
    const Sampled sampled(clip, asset.levels.front().positions.size());
    float radius = 0.0F;
    Range up;
    Range towards;
    sampled.walk([&](const glm::vec3& p) {
        const float away = std::hypot(p.x, p.z);
        const float height = p.y - layout.middle;
        const float lean = away * std::abs(std::sin(above));
        const float reach = away * std::cos(above);
        radius = std::max(radius, away);
        up.add(height * std::cos(above) - lean, height * std::cos(above) + lean);
        towards.add(height * std::sin(above) - reach, height * std::sin(above) + reach);
    });
    const glm::vec2 size(2.0F * radius, up.high - up.low);
    const glm::vec2 texels =
        glm::ceil(size / texel) + 2.0F; // one around it, for what was not looked at
    if (!(texels.x * texels.y <= static_cast<float>(kMostTexels)) ||
        std::max(texels.x, texels.y) > kMostAlongASide) {
        return layout;
    }
    layout.texels = glm::ivec2(texels);
    layout.size = texels * texel;
    layout.low = glm::vec2(-0.5F * layout.size.x, 0.5F * (up.low + up.high - layout.size.y));
    layout.nearest = towards.high + texel;
    layout.depth = std::max(towards.high - towards.low, texel) + 2.0F * texel;
    layout.layers = asset.parts.empty() ? 1 : 2;
    const float perPhase = kMostMoved * texel / std::max(sampled.moved(), 1e-6F);
    layout.keyframesPerPhase =
        std::clamp(static_cast<int>(std::min(perPhase, static_cast<float>(kMostKeyframesPerPhase))),
                   1, kMostKeyframesPerPhase);
    const int intervals = clip.keyframes - 1;
    const bool isLoop = asset.clips[static_cast<std::size_t>(clipIndex)].loop;
    layout.phases =
        std::max(1, (intervals + layout.keyframesPerPhase - 1) / layout.keyframesPerPhase +
                        (isLoop ? 0 : 1));
    return layout;
}

ImpostorSetPtr bakeImpostors(const Template& asset, int clipIndex, const BakedClip& clip, int band,
                             const std::function<bool()>& isCancelled)
{
    auto set = std::make_shared<ImpostorSet>();
    set->band = band;
    set->layout = impostorLayout(asset, clipIndex, clip, band);
    if (set->layout.isEmpty()) {
        return set;
    }
    ImpostorRaster raster(asset, clip, set->layout);
    std::vector<ImpostorTexel> card(set->layout.texelCount() / set->layout.cardCount());
    set->cards.reserve(set->layout.cardCount());
    for (int phase = 0; phase < set->layout.phases; ++phase) {
        raster.take(std::min(phase * set->layout.keyframesPerPhase, clip.keyframes - 1));
        for (int azimuth = 0; azimuth < kImpostorAzimuths; ++azimuth) {
            if (isCancelled && isCancelled()) {
                return nullptr;
            }
            raster.draw(cardAxes(azimuth, band), card);
            add(*set, card);
        }
    }
    set->texels.shrink_to_fit();
    return set;
}

} // namespace crowd::model
