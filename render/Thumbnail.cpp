// SPDX-License-Identifier: MIT
#include "render/Thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/Renderer.h"

namespace crowd::render {

namespace {

constexpr float kFovRadians = 0.5F;
constexpr float kMargin = 1.08F;

/// Parts as the file shows them.
std::uint32_t defaultParts(const model::Template& asset)
{
    std::uint32_t parts = 0;
    for (std::size_t i = 0; i < asset.parts.size(); ++i) {
        parts |= asset.parts[i].shownByDefault ? 1U << i : 0U;
    }
    return parts;
}

/// Slightly from above, everything in the picture whatever way it turns.
model::Camera cameraFor(const model::Bounds& box)
{
    const glm::vec3 center(0.0F, box.center().y, 0.0F);
    const float side = std::max({-box.low.x, box.high.x, -box.low.z, box.high.z});
    const float half = std::max(box.size().y * 0.5F, side);
    const float distance = half * kMargin / std::tan(kFovRadians * 0.5F) + side;
    model::Camera camera = model::Camera::lookingAt(
        center + distance * glm::normalize(glm::vec3(0.0F, 0.16F, 1.0F)), center);
    camera.fovYRadians = kFovRadians;
    return camera;
}

} // namespace

model::View thumbnailView(const ThumbnailRequest& request)
{
    const model::Template& asset = *request.asset;
    model::Bounds box =
        asset.bounds.isEmpty() ? model::Bounds{glm::vec3(-1.0F), glm::vec3(1.0F)} : asset.bounds;
    if (request.showGround) {
        box.add(glm::vec3(0.0F)); // what floats or has sunk is seen to do so
    }
    return model::View(cameraFor(box), glm::vec2(static_cast<float>(request.size)));
}

model::Result<std::vector<std::uint8_t>> renderThumbnail(Renderer& renderer,
                                                         model::KeyframeStore& keyframes,
                                                         const ThumbnailRequest& request)
{
    const model::Template& asset = *request.asset;
    Ghost ghost;
    ghost.asset = request.asset;
    ghost.clip = request.clip >= 0 ? request.clip : asset.defaultClip;
    ghost.phase = request.phase;
    ghost.headingRadians = request.turnRadians;
    ghost.parts = defaultParts(asset);
    ghost.alpha = 1.0F;
    const std::array<Ghost, 1> ghosts{ghost};
    RenderInput input(thumbnailView(request), keyframes);
    input.ghosts = ghosts;
    input.showGround = request.showGround;
    input.lighting.showGroundGrid = request.showGround;
    input.background = request.background;
    if (auto drawn = renderer.draw(input); !drawn) {
        return drawn.error();
    }
    return renderer.readPixels();
}

} // namespace crowd::render
