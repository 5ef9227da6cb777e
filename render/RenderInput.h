// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "model/view/View.h"
#include "render/Looks.h"

/// What one picture is made of. All of it is read during Renderer::draw() only; spans and
/// references need to live no longer. World frame: right-handed, metres, Y up; colours sRGB 0..1.
namespace crowd::render {

/// A translucent character that is not there yet: the preview under the creation brush.
struct Ghost
{
    model::TemplatePtr asset; ///< nothing is drawn without one
    int clip = 0;
    float phase = 0.0F;       ///< 0..1 of the clip
    glm::vec3 position{0.0F}; ///< foot point
    float headingRadians = 0.0F;
    float height = 1.0F; ///< scale of Y
    float girth = 1.0F;  ///< scale of X and Z
    float lift = 0.0F;   ///< metres, as model::seatLift gives it
    std::array<model::Tint, 8> tints{};
    model::MaterialChoices materialChoices{};
    std::uint32_t parts = 0xFFFFFFFFU;
    float alpha = 0.5F;
};

/// A small disc that lies flat in the scene (free seats while the seat grid is shown), or a ring or
/// a part of one. What hides a ring, it shines through faintly.
struct Marker
{
    glm::vec3 position{0.0F};
    float radius = 0.12F; ///< metres
    glm::vec4 color{1.0F};
    float innerShare = 0.0F; ///< of the radius, left out; above zero: a ring
    float fromTurn = 0.0F;   ///< the part of the circle that is drawn
    float toTurn = 1.0F;
    float leastPixels = 0.0F; ///< radius that it has at least, logical pixels
};

/// A line over the scene, with a dark rim, so that it is seen on any ground. Hidden parts shine
/// through faintly.
struct OverlayLine
{
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F};
    glm::vec4 color{1.0F};
    float fromPixels = 2.0F; ///< width at its beginning, logical pixels
    float toPixels = 2.0F;   ///< and at its end: 0 for an arrow's head
};

/// A translucent part of an area that lies on the scene (paths, places). Where several cover a
/// pixel, the first of them colours it, the others do not. People are never covered. What the stage
/// hides shines through faintly, where nothing visible is in front of it.
struct OverlayTriangle
{
    std::array<glm::vec3, 3> corners{};
    glm::vec4 color{1.0F};
};

/// After the levels of the template: pictures on cards.
inline constexpr int kImpostorLevel = model::kMaxLevels;
inline constexpr int kDrawnLevels = kImpostorLevel + 1;

/// Projected heights in physical pixels below which the next coarser level is drawn.
struct LevelThresholds
{
    std::array<float, model::kMaxLevels - 1> pixels{60.0F, 35.0F, 18.0F};
    float hysteresis = 0.1F; ///< share by which a threshold must be passed to change the level
    /// Below which a picture on a card is drawn instead, where there is one; 0: never.
    float impostorPixels = 0.0F;
    /// Everybody at the finest level (measurements, final pictures).
    [[nodiscard]] static LevelThresholds fullDetail() { return {{0.0F, 0.0F, 0.0F}, 0.0F, 0.0F}; }
};

/// What is sharp in a picture, and how soft the rest. No effect on orthographic views.
struct Lens
{
    float focusMetres = 10.0F;   ///< along the view axis
    float radiusMetres = 0.025F; ///< of the opening that light comes through
};

/// Lines around things and along creases.
struct InkLine
{
    float pixels = 2.0F; ///< width, logical; 0: none
    glm::vec3 color{0.0F};
};

/// What was shown a moment before, and from where.
struct EarlierMoment
{
    model::CrowdFramePtr frame; ///< null: nobody was there
    model::Camera camera;
};

struct RenderInput
{
    RenderInput(const model::View& pictureView, model::KeyframeStore& store)
        : view(pictureView), keyframes(store)
    {
    }

    model::CrowdFramePtr frame; ///< null: nobody
    model::View view;           ///< in logical pixels; of a part, what belongs to that is drawn
    glm::ivec2 pixelSize{0};    ///< physical pixels; 0: the view's size
    /// Of the framebuffer that the picture goes to, which it is scaled to; 0: it is as large.
    glm::ivec2 framebufferSize{0};
    model::KeyframeStore& keyframes;
    std::span<const model::StageEntry> stages;
    /// Scene::worldSeats(), ascending by id: lifts seated people. Change the version with it.
    std::span<const model::WorldSeat> seats;
    std::uint64_t seatsVersion = 0;
    model::Lighting lighting;
    /// Those that are on shine, at most model::kMostLightsDrawn, in looks that are lit.
    std::span<const model::Light> lights;
    Look look = Look::Lit;
    std::optional<InkLine> ink = std::nullopt; ///< instead of the look's
    bool isTwoTone = false;                    ///< the cartoon's light, instead of three steps
    /// What drawAovs() says motion against; none: nothing is said of it.
    std::optional<EarlierMoment> earlier = std::nullopt;
    LevelThresholds levels;
    int samples = 4; ///< per pixel; 0: no anti-aliasing
    /// Where edges are found in the finished picture they are drawn smooth: a fraction of the price
    /// of samples, and nothing to those that have some. Not where it is transparent.
    bool smoothsEdges = false;
    /// Pictures that follow each other while nothing changes ripen into one: the n-th of them, from
    /// 0, is seen through other parts of the pixels, and what is shown is the mean of all so far.
    /// None: a picture by itself.
    std::optional<int> ripeness = std::nullopt;
    /// Pictures that ripen are seen through another part of it each time, also the first; none:
    /// everything is sharp.
    std::optional<Lens> lens = std::nullopt;

    std::span<const model::IndividualId> selected; ///< ascending
    model::IndividualId hovered = 0;
    glm::vec3 selectionColor{1.0F, 0.62F, 0.10F};
    std::span<const Ghost> ghosts;
    std::span<const Marker> markers;
    std::span<const OverlayLine> lines;
    std::span<const OverlayTriangle> areas; ///< topmost first
    std::uint64_t areasVersion = 0;         ///< change it with the areas; 0: always sent anew
    /// The ground itself in a colour, below all areas and only where it is seen. No more than a
    /// hand's breadth from what it lies on.
    std::span<const OverlayTriangle> groundAreas;
    std::uint64_t groundAreasVersion = 0;
    bool showGround = true; ///< ground plane and grid; off for thumbnails
    bool showShadows = true;
    /// Background instead of the sky when its alpha is above zero.
    glm::vec4 background{0.0F};
    /// Neither sky nor ground plane: what nothing covers has alpha 0, and colours come times alpha.
    bool isTransparent = false;
    /// For those who go on working with it: linear light beyond 8 bits, and beyond white where no
    /// tone curve ends there. Edges are smoothed by samples alone, and nobody is outlined.
    bool isDeep = false;
};

/// What drawing the last picture took.
struct RenderStatistics
{
    int individuals = 0;
    int visible = 0;
    std::array<int, kDrawnLevels> byLevel{};
    int draws = 0;                    ///< GL draw calls, all passes
    std::int64_t triangles = 0;       ///< sent, all passes
    int uploadedPlacements = 0;       ///< rows whose static records were sent: where they stand
    int uploadedAppearances = 0;      ///< ... and how they look
    std::int64_t uploadedBytes = 0;   ///< of static records
    std::int64_t cardBytes = 0;       ///< on the graphics card, of all pictures of the program
    int reduction = 0;                ///< steps coarser than wished, for want of such memory
    bool areKeyframesMissing = false; ///< somebody's clip, or the one he comes from, is not ready
    double recordsMs = 0.0;           ///< CPU: static records of changed rows
    double planMs = 0.0;              ///< CPU: phase, cull, level, sort
    double submitMs = 0.0;            ///< CPU: uploads and GL calls
    double totalMs = 0.0;             ///< CPU: the whole draw() call
};

} // namespace crowd::render
